#include "zed/evaluate/linear_question.hpp"

#include <algorithm>
#include <deque>

namespace durero::zed {
namespace {

constexpr int most_branches = 128;  // of the sides of disjunctions; more are not followed

using Pending = std::vector<const LinearFormula*>;

/// A conjunction of conditions, one of those of which a formula is the disjunction.
struct LinearBranch {
  LinearConditions conditions{};
  bool is_exact = true;  ///< the conditions say all that the formula does
};

/// Goes through the conjunctions of which a formula is the disjunction.
class LinearBranches {
 public:
  using Visited = std::function<bool(const LinearBranch&)>;  // it returns false to stop

  LinearBranches(Frame& frame, Visited visit) : frame_(frame), visit_(std::move(visit)) {}

  /// Says whether all were visited, but for those whose conditions contradict.
  bool visited(const LinearFormula& formula) { return go({}, {&formula}); }

 private:
  bool go(LinearBranch branch, Pending pending) {
    frame_.context.steps.take();
    Pending choices;
    while (!pending.empty()) {
      const LinearFormula& next = *pending.back();
      pending.pop_back();
      take(next, branch, pending, choices);
    }
    if (choices.empty()) return ++branches_ <= most_branches && visit_(branch);
    if (solved(branch.conditions, frame_.context.steps).is_impossible) return true;
    const LinearFormula& first = *choices.back();
    choices.pop_back();
    return std::all_of(first.parts.begin(), first.parts.end(), [&](const LinearFormula& side) {
      Pending rest = choices;
      rest.push_back(&side);
      return go(branch, std::move(rest));
    });
  }

  void take(const LinearFormula& formula, LinearBranch& branch, Pending& pending, Pending& choices) {
    switch (formula.kind) {
      case LinearFormula::Kind::all:
        for (const LinearFormula& part : formula.parts) pending.push_back(&part);
        return;
      case LinearFormula::Kind::any:
        return choices.push_back(&formula);
      case LinearFormula::Kind::at_most:
        if (auto form = formula.form(frame_)) return branch.conditions.push_back(std::move(*form));
        branch.is_exact = false;
        return;
      case LinearFormula::Kind::unknown:
        branch.is_exact = false;
        return;
      case LinearFormula::Kind::none_such:
        return pending.push_back(&without(formula, branch));
    }
  }

  /// No values of the bound variables satisfy the part: none satisfy any branch of it of which that is known.
  const LinearFormula& without(const LinearFormula& formula, LinearBranch& branch) {
    LinearFormula& none = made_.emplace_back();
    const auto deny = [&](const LinearBranch& each) {
      const auto rest = each.is_exact ? projected(each.conditions, formula.bound, frame_.context.steps) : std::nullopt;
      if (!rest) {
        branch.is_exact = false;
        return true;
      }
      LinearFormula denied{.kind = LinearFormula::Kind::any};
      for (const IntegerForm& condition : *rest) {
        IntegerForm more;  // c > 0 is 1 − c ≤ 0
        more.constant = 1;
        more.add(condition, -1);
        denied.parts.push_back({.kind = LinearFormula::Kind::at_most, .form = [more](Frame&) { return more; }});
      }
      none.parts.push_back(std::move(denied));
      return true;
    };
    if (!LinearBranches(frame_, deny).visited(formula.parts[0])) branch.is_exact = false;
    return none;
  }

  Frame& frame_;
  Visited visit_;
  std::deque<LinearFormula> made_;
  int branches_ = 0;
};

Value number_value(const Integer& number) { return Real(number::Surd(number::Rational(number))); }

}  // namespace

Truth LinearQuestion::some(Frame& frame, const Test& holds) const {
  const Necessary not_here(frame.context, false);
  bool is_impossible = true, found = false;
  LinearBranches branches(frame, [&](const LinearBranch& branch) {
    const LinearAnswer answer = solved(branch.conditions, frame.context.steps);
    is_impossible = is_impossible && answer.is_impossible;
    found = answer.point && is_witness(frame, *answer.point, holds);
    return !found;
  });
  const bool all = branches.visited(formula_);
  return found ? Truth::yes : all && is_impossible ? Truth::no : Truth::open;
}

bool LinearQuestion::is_witness(Frame& frame, const IntegerPoint& point, const Test& holds) const {
  if (!is_whole_) return false;
  const auto before = frame.slots;
  for (const auto& [variable, slot] : slots_) {
    const auto at = point.find(variable);
    frame.slots[slot] = number_value(at == point.end() ? Integer(0) : at->second);
  }
  bool is_one = false;
  try {
    is_one = holds(frame) == Truth::yes;
  } catch (const EvaluationError&) {  // of these values it is not known
  }
  frame.slots = before;
  return is_one;
}

Truth searched(const std::function<Truth()>& search, const LinearQuestion* question, Frame& frame, const Test& holds) {
  if (!question) return search();
  return first_decided(search, [&] { return question->some(frame, holds); });
}

}  // namespace durero::zed
