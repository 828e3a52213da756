#pragma once
/// Symbolic evaluation turns Z terms into formulas in the coordinates of a point: an expression becomes a value made of
/// formulas, a predicate a condition on them. A term that it cannot evaluate is an error at its place, and never a
/// guess.

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "durero/written/formula.hpp"
#include "durero/zed/evaluate/evaluate.hpp"
#include "durero/zed/syntax/reader.hpp"
#include "durero/zed/types/typecheck.hpp"

namespace durero::written {

struct SymbolicScope;
using ScopePtr = std::shared_ptr<const SymbolicScope>;

/// A set or a function as the text writes it, with the names around it.
struct Suspended {
  zed::Term term;
  ScopePtr scope;
};

struct SymbolicValue;
using Tuple = std::vector<SymbolicValue>;
using Fields = std::map<zed::Name, SymbolicValue>;

struct SymbolicValue {
  std::variant<Formula, Tuple, Fields, Suspended> form;
};

/// The names that a term sees: local ones, and behind the last of these the globals of a section.
struct SymbolicScope {
  Fields names;
  ScopePtr outer;       ///< null: the globals come next
  std::string section;  ///< whose globals they are
};

/// The error of a term that cannot be evaluated, with its file.
struct Refusal {
  zed::Defect defect;
};

/// The error of an argument for which a predicate of a function's head is not true.
struct Outside {
  zed::Name parameter;   ///< the parameter in error; empty where it is several together
  std::string expected;  ///< Z, in Unicode
};

/// The definition of a function of the text: its parameters, in the order in which it takes them, and its value.
struct FunctionParameters {
  zed::SchemaText head;           ///< it declares them, and may state more of them
  std::vector<zed::Term> formal;  ///< the argument, or its parts: references, or θ S of an included S
  zed::Term body;                 ///< its value
  std::string section;            ///< the section of the definition
};

class Symbolic {
 public:
  /// An evaluation of this text. Both arguments must outlive it.
  Symbolic(const zed::Specification& specification, const zed::Typing& typing);

  /// The parameters of a global that the section sees; nothing where no equation defines it as a function.
  std::optional<FunctionParameters> parameters(const std::string& section, const zed::Name& function) const;
  /// From now on each numeral of a text is off by so much of itself; each that stands in it has an error of its own,
  /// numbered from `first` on. Nothing is off where it is 0.
  void let_numerals_be_off(const number::Rational& part, std::size_t first);
  /// The value f(arguments). Throws Outside where an argument is not in its set, Refusal where a term cannot be
  /// evaluated.
  SymbolicValue apply(const std::string& section, const zed::Name& function, const Tuple& arguments);
  /// Whether the value is a member of the set. Throws Refusal.
  Condition member(const SymbolicValue& value, const Suspended& set) { return member_of(value, set.term, set.scope); }

 private:
  [[noreturn]] void refuse(const ScopePtr& scope, const zed::Place& place, const std::string& what,
                           const std::string& expected) const;

  // Expressions: symbolic.cpp.
  SymbolicValue value(const zed::Term& term, const ScopePtr& scope);
  Formula numeral(const zed::Term& term);
  SymbolicValue reference(const zed::Term& term, const ScopePtr& scope);
  SymbolicValue constant(const zed::Term& term, const ScopePtr& scope);
  SymbolicValue converted(const zed::Value& known, const zed::Term& term, const ScopePtr& scope) const;
  SymbolicValue theta(const zed::Term& term, const ScopePtr& scope);
  SymbolicValue selected(const zed::Term& term, const ScopePtr& scope);
  SymbolicValue application(const zed::Term& term, const ScopePtr& scope);
  SymbolicValue arithmetic(const zed::Term& term, const ScopePtr& scope);
  SymbolicValue call(const FunctionParameters& function, const Tuple& arguments, const Fields& around);
  /// The part of a schema that the binding does not satisfy.
  Outside outside(const Fields& names, const zed::Term& schema, const ScopePtr& scope);
  ScopePtr let_scope(const zed::Term& term, const ScopePtr& scope);
  const Formula& formula(const SymbolicValue& value, const zed::Term& term, const ScopePtr& scope) const;

  // Predicates and sets: symbolic_sets.cpp.
  Condition condition(const zed::Term& term, const ScopePtr& scope);
  Condition relation(const std::string& word, const zed::Term& a, const zed::Term& b, const ScopePtr& scope);
  Condition equal(const SymbolicValue& a, const SymbolicValue& b, const zed::Term& term, const ScopePtr& scope) const;
  Condition member_of(const SymbolicValue& value, const zed::Term& set, const ScopePtr& scope);
  Condition member_of_name(const SymbolicValue& value, const zed::Term& set, const ScopePtr& scope);
  Condition member_of_application(const SymbolicValue& value, const zed::Term& set, const ScopePtr& scope);
  /// The condition that a value, the characteristic tuple of a comprehension or a schema's binding, satisfies the text.
  Condition satisfies(const SymbolicValue& value, const zed::SchemaText& text, bool is_schema, const zed::Term& set,
                      const ScopePtr& scope);
  Condition declared(const zed::Declaration& declaration, const Fields& names, const zed::Term& set,
                     const ScopePtr& scope);

  const zed::Paragraph* paragraph_of(const zed::Global& global) const;
  const zed::Global* global(const ScopePtr& scope, const zed::Name& name) const;

  const zed::Specification& specification_;
  const zed::Typing& typing_;
  zed::Steps steps_;
  zed::Evaluator evaluator_;
  unsigned depth_ = 0;
  number::Rational numeral_part_ = 0;
  std::size_t first_error_ = 0;
  std::map<const zed::Node*, std::size_t> numeral_errors_{};  // by the numeral, which the specification holds
};

}  // namespace durero::written
