#pragma once
/// A question of whole numbers: whether some values of quantified variables satisfy a predicate, as far as linear
/// comparisons in it decide that.
///
/// The predicate is read as conditions that follow from it (linear_conditions.hpp). A part that is no linear comparison
/// may be true or false, so nothing follows from it. Where no values satisfy the conditions, none satisfy the
/// predicate. Where some do, the text decides whether these satisfy the predicate.

#include <functional>
#include <memory>

#include "zed/evaluate/definitions.hpp"
#include "zed/evaluate/linear_conditions.hpp"
#include "zed/evaluate/search.hpp"

namespace durero::zed {

/// Computes a form; nothing where a part of it is no known whole number.
using FormCode = std::function<std::optional<IntegerForm>(Frame&)>;

/// A formula of linear conditions.
struct LinearFormula {
  enum class Kind { all, any, at_most, unknown, none_such };
  Kind kind = Kind::all;
  std::vector<LinearFormula> parts{};  ///< of all, and of any; of none_such one
  FormCode form{};                     ///< at_most states that it is at most 0
  std::vector<unsigned> bound{};       ///< none_such states that no values of these satisfy its part
};

/// The meanings of names around a quantifier.
struct LinearSurroundings {
  std::function<bool(const Name&)> is_toolkit;               ///< it means what it does in the toolkit
  std::function<const Term*(const Name&)> abbreviated;       ///< the term for which the text declares it; else null
  std::function<Components(const Declaration&)> components;  ///< the names that an included schema declares
  std::function<Code(const Term&)> code;                     ///< compiles an expression without quantified names
  std::function<unsigned(const Name&)> slot;                 ///< of a variable of the quantifier
  std::function<std::optional<Term>(const Node&)> just_one;  ///< what says the same as an ∃₁ (said_by_exists.hpp)
};

class LinearQuestion {
 public:
  LinearQuestion(LinearFormula formula, std::vector<std::pair<unsigned, unsigned>> slots, bool is_whole)
      : formula_(std::move(formula)), slots_(std::move(slots)), is_whole_(is_whole) {}

  /// Says whether some values of the variables satisfy the predicate: no where the conditions contradict, and yes where
  /// they give values of which `holds`, which finds them in their slots, says so.
  Truth some(Frame& frame, const Test& holds) const;

 private:
  bool is_witness(Frame& frame, const IntegerPoint& point, const Test& holds) const;
  LinearFormula formula_;
  std::vector<std::pair<unsigned, unsigned>> slots_;  // each variable that is a whole number, with its slot
  bool is_whole_;                                     // these are all variables
};

/// Reads the question whether some values satisfy the text of a quantifier and make its body true, for ∃, or false, for
/// ∀. Null where no variable is declared from ℤ, ℕ, ℕ₁ or a range of these.
std::shared_ptr<const LinearQuestion> linear_question(const Node& quantifier, const LinearSurroundings& around);

/// Returns what the first says or, where it leaves that open or cannot go on, what the second says.
template <class First, class Second>
Truth first_decided(const First& first, const Second& second) {
  try {
    if (const Truth here = first(); here != Truth::open) return here;
  } catch (const EvaluationError&) {
    if (const Truth here = second(); here != Truth::open) return here;
    throw;
  }
  return second();
}

/// Returns what a search finds. Where it leaves that open, or cannot go on, the question is asked, if there is one.
Truth searched(const std::function<Truth()>& search, const LinearQuestion* question, Frame& frame, const Test& holds);

}  // namespace durero::zed
