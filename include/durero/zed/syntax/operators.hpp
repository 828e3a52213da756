#pragma once
/// Operator templates (ISO/IEC 13568, 12.2.8) make words of a text operators: behind `\relation (\_ \below \_)`,
/// `a \below b` is a predicate.

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "durero/zed/syntax/toolkit_sections.hpp"

namespace durero::zed {

/// The role of an operator's result: a value, a set, or a predicate.
enum class Role : unsigned char { function, generic, relation };

/// An operator template says how one operator is written, and how tightly it binds.
struct OperatorTemplate {
  Role role = Role::relation;  ///< it is announced by `function`, `generic` or `relation`
  /// Its words in order, among them `_` for each operand and `,,` for a list of them: {"_", "below", "_"}.
  std::vector<std::string> parts;
  int precedence = 0;  ///< infix functions and generics have one: a greater one binds tighter
  bool right = false;  ///< it associates to the right

  /// Says whether an operand stands before its first word.
  bool has_left() const { return parts.front() == "_"; }
  /// Says whether an operand stands behind its last word.
  bool has_right() const { return parts.back() == "_"; }
  /// Says whether it stands between two operands.
  bool is_infix() const { return parts.size() > 2 && has_left() && has_right(); }
  /// Returns the name that it is declared by: its parts with a space between them, which no other name has.
  std::string name() const;
};

/// A word of an operator is a token of its own, and no name.
struct OperatorWord {
  std::shared_ptr<const OperatorTemplate> of;  ///< it is of this operator; not null
  std::size_t part = 0;                        ///< and stands there among its parts

  /// Says whether the operator begins with it, but for an operand.
  bool first() const { return part == (of->has_left() ? 1U : 0U); }
  /// Says whether nothing but an operand is behind it.
  bool last() const { return part + (of->has_right() ? 2U : 1U) == of->parts.size(); }
};

/// The operators that the templates in scope give, by their words.
using Operators = std::map<std::string, OperatorWord, std::less<>>;

/// Adds an operator, and returns nothing; or returns the word of it that has another meaning already, and adds nothing.
/// A word of the toolkit has one where a section that is seen gives it.
std::string add_operator(Operators& to, OperatorTemplate added, ToolkitSections seen);

/// Returns a word of these operators that a section of the toolkit which is seen gives another meaning; nothing where
/// there is none.
std::string word_of_toolkit(const Operators& known, ToolkitSections seen);

/// Says whether a name is one that a template gives.
inline bool is_template_name(std::string_view name) { return name.find(' ') != name.npos; }

/// Returns the name of an infix operator, among these or among those of the sections of the toolkit that are seen,
/// which has the precedence of this one and associates to the other side: ISO/IEC 13568, 8.3, forbids the two in one
/// scope. Empty where there is none.
std::string otherwise_associated(const Operators& known, ToolkitSections seen, const OperatorTemplate& added);

}  // namespace durero::zed
