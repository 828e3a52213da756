#include "zed/evaluate/linear_conditions.hpp"

#include <algorithm>
#include <set>

namespace durero::zed {
namespace {

constexpr std::size_t most_linear_conditions = 400;  // of what elimination makes; more are not followed
constexpr int most_chosen_numbers = 500;             // while a point is looked for
constexpr int most_tried_steps = 12;                 // so far from the nearest to 0 numbers are tried

Integer floor_quotient(const Integer& a, const Integer& positive) {
  Integer quotient = a / positive;  // towards 0
  if (quotient * positive > a) --quotient;
  return quotient;
}

Integer ceiling_quotient(const Integer& a, const Integer& positive) { return -floor_quotient(-a, positive); }

/// The conditions without those that others imply at sight: of two with the same coefficients the greater constant says
/// more. Nothing where one of them has no variable, and is false.
class ConditionTable {
 public:
  /// Says whether the condition is not false by itself.
  bool add(IntegerForm form) {
    Integer divisor = 0;
    for (const auto& [variable, coefficient] : form.coefficients) divisor = gcd(divisor, coefficient);
    if (divisor == 0) return form.constant <= 0;
    for (auto& [variable, coefficient] : form.coefficients) coefficient /= divisor;
    form.constant = ceiling_quotient(form.constant, divisor);
    const auto [at, is_new] = strongest_.emplace(std::move(form.coefficients), form.constant);
    if (!is_new) at->second = std::max(at->second, form.constant);
    return true;
  }
  std::size_t size() const { return strongest_.size(); }
  LinearConditions conditions() const {
    LinearConditions all;
    for (const auto& [coefficients, constant] : strongest_) all.push_back({coefficients, constant});
    return all;
  }

 private:
  std::map<std::map<unsigned, Integer>, Integer> strongest_;
};

/// A variable with the conditions that bound it, in which no variable eliminated before it stands.
struct EliminatedVariable {
  unsigned variable = 0;
  LinearConditions below, above;  ///< its coefficient is negative, or positive
};

/// Parts conditions by how a variable stands in them, and adds those in which it does not stand to `rest`.
EliminatedVariable parted(const LinearConditions& conditions, unsigned variable, LinearConditions& rest) {
  EliminatedVariable gone{variable, {}, {}};
  for (const IntegerForm& each : conditions) {
    const auto at = each.coefficients.find(variable);
    (at == each.coefficients.end() ? rest : at->second < 0 ? gone.below : gone.above).push_back(each);
  }
  return gone;
}

/// Adds for each l − a·x ≤ 0 and b·x − u ≤ 0 the condition b·l − a·u ≤ 0.
void add_joined(const EliminatedVariable& gone, LinearConditions& rest, Steps& steps) {
  for (const IntegerForm& low : gone.below)
    for (const IntegerForm& high : gone.above) {
      const Integer a = -low.coefficients.at(gone.variable), b = high.coefficients.at(gone.variable);
      IntegerForm both;
      both.add(low, b);
      both.add(high, a);
      steps.take(1 + both.coefficients.size());
      rest.push_back(std::move(both));
    }
}

/// Says whether some whole number lies between the bounds wherever each lower one is at most each upper one.
bool is_exact(const EliminatedVariable& gone) {
  const auto units = [&](const LinearConditions& side, int unit) {
    return std::all_of(side.begin(), side.end(),
                       [&](const IntegerForm& each) { return each.coefficients.at(gone.variable) == unit; });
  };
  return units(gone.below, -1) || units(gone.above, 1);
}

/// Eliminates variables one after another.
class Elimination {
 public:
  explicit Elimination(Steps& steps) : steps_(steps) {}

  /// Says whether the conditions are contradictory; nothing where they become too many.
  std::optional<bool> contradicts(LinearConditions conditions) {
    for (;;) {
      ConditionTable table;
      for (IntegerForm& each : conditions)
        if (!table.add(std::move(each))) return true;
      if (table.size() == 0) return false;
      if (table.size() > most_linear_conditions) return std::nullopt;
      conditions = without_one(table.conditions());
    }
  }

  /// Chooses whole numbers for the variables, the last that was eliminated first.
  std::optional<IntegerPoint> point() {
    add_free();
    IntegerPoint chosen;
    return choose(eliminated_.size(), chosen) ? std::optional(chosen) : std::nullopt;
  }

 private:
  /// Eliminates the variable of which the fewest conditions are made.
  LinearConditions without_one(const LinearConditions& conditions) {
    std::map<unsigned, std::pair<std::size_t, std::size_t>> sides;
    for (const IntegerForm& each : conditions)
      for (const auto& [variable, coefficient] : each.coefficients)
        ++(coefficient < 0 ? sides[variable].first : sides[variable].second);
    const auto made = [](const auto& side) { return side.second.first * side.second.second; };
    const auto fewest =
        std::min_element(sides.begin(), sides.end(), [&](const auto& a, const auto& b) { return made(a) < made(b); });
    LinearConditions rest;
    eliminated_.push_back(parted(conditions, fewest->first, rest));
    add_joined(eliminated_.back(), rest, steps_);
    return rest;
  }

  /// Adds the variables that stood in bounds of others alone, and are without bounds themselves.
  void add_free() {
    std::set<unsigned> free;
    for (const EliminatedVariable& each : eliminated_)
      for (const LinearConditions* side : {&each.below, &each.above})
        for (const IntegerForm& condition : *side)
          for (const auto& [variable, coefficient] : condition.coefficients) free.insert(variable);
    for (const EliminatedVariable& each : eliminated_) free.erase(each.variable);
    for (const unsigned variable : free) eliminated_.push_back({variable, {}, {}});
  }

  /// The value of the rest of a condition, in which all other variables have numbers.
  static Integer rest_of(const IntegerForm& form, unsigned variable, const IntegerPoint& chosen) {
    Integer sum = form.constant;
    for (const auto& [each, coefficient] : form.coefficients)
      if (each != variable) sum += coefficient * chosen.at(each);
    return sum;
  }

  /// Numbers between the bounds, to be tried: the nearest to 0 with its neighbours, and the bounds.
  static std::vector<Integer> tried(const std::optional<Integer>& low, const std::optional<Integer>& high) {
    Integer nearest = 0;
    if (low && *low > 0) nearest = *low;
    if (high && *high < 0) nearest = *high;
    std::vector<Integer> some;
    const auto add = [&](const Integer& number) {
      if (!(low && number < *low) && !(high && number > *high) &&
          std::find(some.begin(), some.end(), number) == some.end())
        some.push_back(number);
    };
    add(nearest);
    for (int step = 1; step <= most_tried_steps; ++step) {
      add(nearest + step);
      add(nearest - step);
    }
    if (low) add(*low);
    if (high) add(*high);
    return some;
  }

  bool choose(std::size_t left, IntegerPoint& chosen) {
    if (left == 0) return true;
    const EliminatedVariable& gone = eliminated_[left - 1];
    std::optional<Integer> low, high;
    for (const IntegerForm& each : gone.below) {
      const Integer least =
          ceiling_quotient(rest_of(each, gone.variable, chosen), -each.coefficients.at(gone.variable));
      if (!low || least > *low) low = least;
    }
    for (const IntegerForm& each : gone.above) {
      const Integer most = floor_quotient(-rest_of(each, gone.variable, chosen), each.coefficients.at(gone.variable));
      if (!high || most < *high) high = most;
    }
    for (const Integer& number : tried(low, high)) {
      if (++choices_ > most_chosen_numbers) return false;
      steps_.take();
      chosen[gone.variable] = number;
      if (choose(left - 1, chosen)) return true;
    }
    return false;
  }

  Steps& steps_;
  std::vector<EliminatedVariable> eliminated_;
  int choices_ = 0;
};

}  // namespace

void IntegerForm::add(const IntegerForm& other, const Integer& times) {
  constant += other.constant * times;
  for (const auto& [variable, coefficient] : other.coefficients) {
    Integer& sum = coefficients[variable];
    sum += coefficient * times;
    if (sum == 0) coefficients.erase(variable);
  }
}

LinearAnswer solved(const LinearConditions& conditions, Steps& steps) {
  Elimination elimination(steps);
  const auto contradicts = elimination.contradicts(conditions);
  if (!contradicts) return {};
  if (*contradicts) return {true, {}};
  return {false, elimination.point()};
}

std::optional<LinearConditions> projected(const LinearConditions& conditions, const std::vector<unsigned>& variables,
                                          Steps& steps) {
  const LinearConditions contradiction{{{}, 1}};
  LinearConditions now = conditions;
  std::vector<unsigned> left = variables;
  for (;;) {
    ConditionTable table;
    for (IntegerForm& each : now)
      if (!table.add(std::move(each))) return contradiction;
    now = table.conditions();
    if (left.empty()) return now;
    if (now.size() > most_linear_conditions) return std::nullopt;
    const auto next = std::find_if(left.begin(), left.end(), [&](unsigned variable) {
      LinearConditions others;
      return is_exact(parted(now, variable, others));
    });
    if (next == left.end()) return std::nullopt;
    LinearConditions rest;
    add_joined(parted(now, *next, rest), rest, steps);
    left.erase(next);
    now = std::move(rest);
  }
}

}  // namespace durero::zed
