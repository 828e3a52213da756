#pragma once
/// One table has the operators and names of the standard toolkit (ISO/IEC 13568, annex B): a row has all that the
/// program knows of a name, from its spelling to its Coq. Whoever needs a column asks for the row by the name.

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "durero/zed/syntax/toolkit_sections.hpp"
#include "zed/syntax/symbols.hpp"

namespace durero::zed {

class Value;
struct Context;
enum class Truth : std::uint8_t;

/// Says how the evaluator computes what a name stands for: at most one of these is not null.
struct Evaluation {
  Value (*constant)() = nullptr;
  Value (*unary)(const Value&, Context&) = nullptr;
  Value (*binary)(const Value&, const Value&, Context&) = nullptr;
  Truth (*property)(const Value&, Context&) = nullptr;  ///< this is a relation of one operand
  Truth (*relation)(const Value&, const Value&, Context&) = nullptr;

  constexpr Evaluation() = default;
  constexpr Evaluation(Value (*f)()) : constant(f) {}
  constexpr Evaluation(Value (*f)(const Value&, Context&)) : unary(f) {}
  constexpr Evaluation(Value (*f)(const Value&, const Value&, Context&)) : binary(f) {}
  constexpr Evaluation(Truth (*f)(const Value&, Context&)) : property(f) {}
  constexpr Evaluation(Truth (*f)(const Value&, const Value&, Context&)) : relation(f) {}
  constexpr bool is_function() const { return unary || binary; }
};

/// Says which relations between two sets are in the set that an arrow such as `⇸` makes.
struct Arrow {
  bool function = true, total = false, injective = false, surjective = false, finite = false;
};

/// The name in Coq is a function of Toolkit.v, or, with a level, a notation between operands.
struct CoqNotation {
  std::string_view text;       ///< it is empty where no rule of translation covers the name
  int level = 0;               ///< a function has 0
  std::string_view of_sets{};  ///< it stands for the text where the operands are sets
  std::string_view graph{};    ///< the name alone is the graph of this function of Coq
};

/// A name has a role and binds more or less tightly; a plain name has no role.
struct Binding {
  std::optional<Role> role{};
  int precedence = 0;  ///< infix functions and generics have one: a greater one binds tighter
  bool right = false;  ///< it associates to the right
};

struct OperatorRow {
  std::string_view name;     ///< `_∪_`, `#_`, `_∼`, `dom` have an underscore for each operand
  std::string_view command;  ///< it has no backslash, and is empty where LaTeX writes the symbol as it is
  Binding binding;
  std::optional<ToolkitSection> section;  ///< the section of the toolkit that declares it, if one does
  std::string_view formals, type;         ///< it is declared from this set; each generic formal is one letter
  Evaluation evaluation{};                ///< arrows have none, nor has what is not evaluated
  CoqNotation coq{};                      ///< it has none where no rule of translation covers it
  std::string_view opposite{};            ///< this relation holds exactly where the row's does not
  std::optional<Arrow> arrow{};           ///< sets of relations and functions have one

  /// Returns the name without its underscores.
  std::string_view symbol() const;
  std::optional<Fixity> fixity() const;  ///< a plain name has none, nor has `_⦇_⦈`
};

/// Returns every row. The order says nothing.
std::span<const OperatorRow> operator_rows();

/// Returns the row of a name, or null.
const OperatorRow* operator_row(std::string_view name);

/// Returns the section of the toolkit that declares a name, or nothing where none does.
std::optional<ToolkitSection> toolkit_section_of(std::string_view name);

}  // namespace durero::zed
