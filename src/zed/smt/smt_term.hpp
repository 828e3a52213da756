#pragma once
/// Terms of SMT-LIB stand for expressions of Z. A tuple and a binding are translated part by part, a member of a given
/// set or of an enumerated free type is its place there, and a set is the list of the members that it may have, each
/// with the condition on which it has it. Each term has the condition on which it has a value.

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "durero/zed/syntax/ast.hpp"
#include "durero/zed/value/value.hpp"

namespace durero::zed {

/// The error of a term that has no translation. It names the term.
class Untranslated : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The sort of a term. Members of given sets and free types are whole numbers to the solver.
enum class SmtSort : std::uint8_t { integer, real, atom, tuple, binding, set };

/// The translation of an expression.
struct SmtTerm {
  SmtSort sort = SmtSort::integer;
  std::string text{};            ///< in SMT-LIB; a tuple, a binding and a set have none
  std::string defined = "true";  ///< the expression has a value where this holds
  std::string type{};            ///< an atom is a member of the set of this name
  std::vector<SmtTerm> parts{};  ///< of a tuple or a binding; or the members that a set may have, which have values
  std::vector<Name> names{};     ///< of a binding, sorted, in step with the parts
  std::vector<std::string> present{};  ///< of a set, in step with the parts: this one is a member where it holds
  bool function = false;               ///< a set: members that begin alike are equal
  bool sequence = false;               ///< a set: it is a function from 1‥n
};

constexpr std::size_t most_smt_text = 4'000'000;  ///< characters of one term, so that no operation outgrows memory
/// Throws Untranslated where a text of so many characters is too long.
void limit_text(std::size_t characters);
/// Returns the number of characters in a term and its parts.
std::size_t text_size(const SmtTerm& term);

/// The translation of a membership: it is true where both hold.
struct SmtMembership {
  std::string holds = "true";
  std::string defined = "true";  ///< the set has a value where this holds
};

/// @{ Makes formulas. A part that is `true` or `false` is simplified away.
std::string smt_all(const std::vector<std::string>& parts);
std::string smt_any(const std::vector<std::string>& parts);
std::string smt_not(const std::string& formula);
/// @}
/// Applies an operator to terms, `(+ a b)`.
std::string smt_call(const std::string& of, const std::vector<std::string>& terms);
/// Says that one formula implies another.
std::string smt_implied(const std::string& from, const std::string& to);
/// Chooses one of two texts.
std::string smt_choice(const std::string& condition, const std::string& yes, const std::string& no);

/// Returns a whole number that a number is, which has no value where it is none.
SmtTerm as_integer(const SmtTerm& number);
/// Returns a number as a real one.
SmtTerm as_real(const SmtTerm& number);
/// Brings two numbers to one sort. Throws Untranslated where one of them is no number.
void bring_together(SmtTerm& a, SmtTerm& b);
/// Says that two terms of one type are equal, whether or not they have values.
std::string smt_equal(SmtTerm a, SmtTerm b);
/// Compares two whole numbers, or two real ones, by `<` or `<=`. Numerals are compared at once.
std::string smt_compare(const std::string& by, const std::string& a, const std::string& b);
/// @{ Adds and subtracts whole numbers. Of two numerals the result is one.
std::string smt_plus(const std::string& a, const std::string& b);
std::string smt_minus(const std::string& a, const std::string& b);
/// @}
/// Chooses one of two terms of a sort; their parts are chosen likewise.
SmtTerm smt_chosen(const std::string& condition, SmtTerm yes, SmtTerm no);
/// Translates a rational number. Throws Untranslated for any other.
SmtTerm smt_number(const Real& number);
/// Returns the number that a text of smt_number() or as_real() is; nothing where it is none.
std::optional<Real> smt_constant(const std::string& text);

}  // namespace durero::zed
