/// A run of a search goes through the ways to make a goal hold: members of finite sets, values determined by equations,
/// and numbers that are bounded or tried.

#include <algorithm>
#include <cmath>
#include <utility>

#include "zed/evaluate/search.hpp"
#include "zed/value/growing_function.hpp"

namespace durero::zed {
namespace {

/// A supposition lasts for a scope: at its end the slots and the values found are as before.
class Supposed {
 public:
  explicit Supposed(Frame& frame) : frame_(frame), slots_(frame.slots), found_(frame.context.values_found) {}
  ~Supposed() {
    frame_.slots = slots_;
    frame_.context.values_found = found_;
  }
  Supposed(const Supposed&) = delete;
  Supposed& operator=(const Supposed&) = delete;

 private:
  Frame& frame_;
  decltype(Frame::slots) slots_;
  decltype(Context::values_found) found_;
};

constexpr int most_tries = 600;                // the most values tried for all variables of a search together
constexpr int most_beginnings = 1 << 19;       // of functions, for all variables of a search together
constexpr int most_some_beginnings = 1 << 15;  // at a time, of those that are not all
constexpr std::size_t most_values = 24;        // of a function with infinitely many

/// The growth of functions ends where it has gone through so many beginnings, or all steps are taken up to these.
struct Growth {
  int most_beginnings;
  std::uint64_t most_steps;
};

}  // namespace

/// A run is one call of each(), and knows where it is in the nest of finite sets.
struct Solver::Run {
  const Solver& search;
  Frame& frame;
  const Visit& visit;
  const Test& extra;
  bool any_one = false;  ///< one way is enough
  std::vector<Value> sets{};
  std::uint32_t first_unknown = 0;
  bool unknowns = false, enumerated = false, stopped = false, trying = false;
  int tries = 0, beginnings = 0;
  std::size_t share = 0;  // so many values are tried of each variable: those of all are within most_tries
  Truth result = Truth::no;
  std::vector<const Property*> conjuncts{};  // of the goal

  void from(std::size_t i) {
    if (stopped) return;
    frame.context.steps.take();
    if (i == search.variables_.size()) return complete();
    const Variable& variable = search.variables_[i];
    if (variable.value) return from(i + 1);
    Value& slot = frame.slots[variable.slot];
    const Set* set = sets[i].set();
    const auto* members = set ? set->members() : nullptr;
    if (!members) {
      unknowns = true;
      slot = set ? set->unknown(frame.context) : Value(Unknown{frame.context.fresh()});
      return from(i + 1);
    }
    enumerated = enumerated || members->size() > 1;
    for (const Value& member : *members) {
      slot = member;
      from(i + 1);
      if (stopped) return;
    }
  }

  // Every variable that is not determined has a value, or is unknown.
  void complete() {
    std::vector<Value> start;
    if (unknowns) {
      for (const Variable& variable : search.variables_) start.push_back(frame.slots[variable.slot]);
    }
    settle();
    for (std::size_t i = 0; i < start.size(); ++i) frame.slots[search.variables_[i].slot] = start[i];
    // Values found with these members of the finite sets need not hold with the next.
    auto& found = frame.context.values_found;
    std::fill(found.begin() + static_cast<std::ptrdiff_t>(first_unknown), found.end(), std::nullopt);
  }

  void settle() {
    Context& context = frame.context;
    const std::uint32_t outer = enumerated ? Context::none : context.necessary;
    const Necessary must(context, std::min(outer, unknowns ? first_unknown : Context::none));
    for (;;) {
      search.determine(frame);
      Truth here = search.holds(frame);
      if (here != Truth::no && extra) here = both(here, extra(frame));
      if (here == Truth::no) return;
      if (!unknowns || known()) return judge(here);
      if (!found_more()) return undecided(here);
    }
  }

  // A value that no equation gives may be a number that the goal bounds; for a last number it may be known where on the
  // line the goal is true.
  void undecided(Truth here) {
    if (here == Truth::yes && !visit) return judge(here);
    const bool decides = !visit || any_one;
    if (search.determine_empty(frame)) return settle();
    const Variable* last = nullptr;
    std::size_t open = 0;
    for (std::size_t i = 0; i < search.variables_.size(); ++i) {
      const Variable& variable = search.variables_[i];
      if (!has_open(frame.slots[variable.slot])) continue;
      ++open;
      if (!is_number(i)) continue;
      last = &variable;
      if (const auto numbers = search.candidates(variable, *sets[i].set(), frame, extra))
        return each_of(variable, *numbers);
    }
    for (std::size_t i = 0; i < search.variables_.size(); ++i) {
      const Variable& variable = search.variables_[i];
      if (!frame.slots[variable.slot].get<Unknown>()) continue;
      if (const auto values = search.bounded(variable, sets[i], frame)) return each_of(variable, *values);
    }
    if (is_alone() && grows(true)) return;
    if (!visit && open == 1 && last) {
      const Set& set = *sets[static_cast<std::size_t>(last - search.variables_.data())].set();
      if (const auto some = search.some_number(*last, set, frame, extra)) {
        if (*some == Truth::no) return;
        if (*some == Truth::yes) return judge(*some);
      }
    }
    if (decides && is_alone()) {
      try_some(open);
      if (!stopped && !trying && open == 1) grows(false);
    }
    if (!stopped) judge(lost(frame.context));
  }

  /// Gives a variable the functions that its set has: where that has no other members, or else some of them. It takes
  /// at most half of the steps that are left, so that something else may decide the goal. Says whether nothing else
  /// needs to.
  bool grows(bool whole) {
    for (std::size_t i = 0; i < search.variables_.size(); ++i) {
      const Variable& variable = search.variables_[i];
      if (!frame.slots[variable.slot].get<Unknown>() || variable.value || !sets[i].set()) continue;
      const auto spaces = sets[i].set()->function_spaces({search.numbers_to_try(), most_values}, frame.context);
      if (spaces.empty() || spaces.front().whole != whole) continue;
      const Steps& steps = frame.context.steps;
      const Growth limit{whole ? most_beginnings : std::min(most_beginnings, beginnings + most_some_beginnings),
                         steps.taken() + (steps.most() - steps.taken()) / 2};
      for (const FunctionSpace& space : spaces) {
        GrowingFunction begun(space);
        if (begun.may_be_whole()) grow(i, begun, limit);
      }
      return stopped || (whole && beginnings <= limit.most_beginnings && steps.taken() <= limit.most_steps);
    }
    return false;
  }

  /// Goes through the functions that begin so, but for those that begin so that the goal is false.
  void grow(std::size_t i, GrowingFunction& begun, const Growth& limit) {
    if (stopped || ++beginnings > limit.most_beginnings || frame.context.steps.taken() > limit.most_steps) return;
    frame.context.steps.take();
    const Variable& variable = search.variables_[i];
    if (begun.is_whole()) return each_of(variable, std::vector<Value>{sets[i].set()->as_declared(begun.value())});
    if (is_false_with(variable, begun.value())) return;
    begun.each_way_on([&] { grow(i, begun, limit); });
  }

  /// Says whether some conjunct of the goal is false, whatever is not known. A conjunct that is not decided says
  /// nothing.
  bool is_false_with(const Variable& variable, Value value) {
    const Supposed supposed(frame);
    const Necessary not_here(frame.context, false);
    frame.slots[variable.slot] = std::move(value);
    const auto is_false = [this](const auto& asked) {
      try {
        return asked() == Truth::no;
      } catch (const EvaluationError&) {
        return false;
      }
    };
    if (conjuncts.empty()) conjuncts_of(search.goal_, conjuncts);
    const auto determined = [this] {
      search.determine(frame);
      return Truth::open;
    };
    is_false(determined);
    return std::any_of(conjuncts.begin(), conjuncts.end(),
                       [&](const Property* each) { return is_false([&] { return evaluate(*each, frame); }); }) ||
           (extra && is_false([&] { return extra(frame); }));
  }

  /// Says whether nothing but the variables is unknown.
  bool is_alone() const {
    const auto& found = frame.context.values_found;
    return !frame.context.watch && std::all_of(found.begin(), found.begin() + first_unknown,
                                               [](const auto& value) { return value.has_value(); });
  }

  /// A value that makes the goal true is a witness; where no small one does, nothing is known. One variable is tried
  /// here, and for each value of it the next one.
  void try_some(std::size_t open) {
    if (share == 0)
      share = static_cast<std::size_t>(std::pow(most_tries, 1.0 / static_cast<double>(std::max<std::size_t>(open, 1))));
    const SmallScope scope{search.numbers_to_try(), share};
    for (std::size_t i = 0; i < search.variables_.size(); ++i) {
      const Variable& variable = search.variables_[i];
      if (!has_open(frame.slots[variable.slot]) || variable.value || !sets[i].set()) continue;
      const std::vector<Value> some = small_members(*sets[i].set(), scope);
      for (const Value& value : some) try_one(variable, sets[i], value);
      if (!some.empty()) return;
    }
  }

  std::vector<Value> small_members(const Set& set, const SmallScope& scope) {
    try {
      return set.some_members(scope, frame.context);
    } catch (const EvaluationError&) {  // none are known
      return {};
    }
  }

  void try_one(const Variable& variable, const Value& set, const Value& value) {
    if (stopped || ++tries > most_tries) return;
    const bool before = std::exchange(trying, true);
    try {
      if (contains_value(set, value, frame.context) == Truth::yes) each_of(variable, std::vector<Value>{value});
    } catch (const EvaluationError&) {  // of this one it is not known
    }
    trying = before;
  }

  bool is_number(std::size_t i) const {
    return frame.slots[search.variables_[i].slot].get<Unknown>() && sets[i].set() &&
           sets[i].set()->numbers() != Numbers::none;
  }

  template <class Values>
  void each_of(const Variable& variable, const Values& values) {
    const Unknown* unknown = frame.slots[variable.slot].get<Unknown>();
    const std::uint32_t id = unknown ? unknown->id : Context::none;
    enumerated = enumerated || values.size() > 1;
    for (std::size_t i = 0; i < values.size() && !stopped; ++i) {
      frame.context.steps.take();
      const Supposed supposed(frame);
      frame.slots[variable.slot] = values[i];
      if (id != Context::none) frame.context.values_found[id] = values[i];
      settle();
    }
  }

  bool known() const {
    return std::none_of(search.variables_.begin(), search.variables_.end(),
                        [&](const Variable& variable) { return has_open(frame.slots[variable.slot]); });
  }

  bool found_more() {
    bool more = false;
    for (const Variable& variable : search.variables_) {
      Value& slot = frame.slots[variable.slot];
      if (!has_open(slot)) continue;
      Value now = resolved(slot, frame.context);
      more = more || !same(now, slot);
      slot = std::move(now);
    }
    return more;
  }

  void judge(Truth here) {
    if (here == Truth::open) {
      if (visit || result == Truth::no) result = here;
      return;
    }
    if (!visit || result != Truth::open) result = Truth::yes;
    stopped = !visit || !visit(frame);
  }
};

/// Says whether the goal is false whatever the variables are. An undecided conjunct refutes nothing here: it is asked
/// again with the rest of the goal.
bool Solver::refuted(Frame& frame) const {
  const Necessary not_here(frame.context, false);
  return std::any_of(apart_.begin(), apart_.end(), [&](const Test& test) {
    try {
      return test(frame) == Truth::no;
    } catch (const EvaluationError&) {
      return false;
    }
  });
}

Truth Solver::each(Frame& frame, const Visit& visit, const Test& extra) const {
  if (refuted(frame)) return Truth::no;
  Run run{*this, frame, visit, extra};
  return all_of_run(run);
}

Truth Solver::first(Frame& frame, const Visit& visit) const {
  if (refuted(frame)) return Truth::no;
  bool found = false;
  const Visit once = [&](Frame& inside) {
    found = true;
    visit(inside);
    return false;
  };
  const Test nothing_more;
  Run run{*this, frame, once, nothing_more, true};
  const Truth result = all_of_run(run);
  return found ? Truth::yes : result == Truth::yes ? Truth::open : result;
}

Truth Solver::all_of_run(Run& run) const {
  Frame& frame = run.frame;
  for (const unsigned slot : wholes_) frame.slots[slot] = Value();
  run.first_unknown = static_cast<std::uint32_t>(frame.context.values_found.size());
  for (const Variable& variable : variables_) {
    run.sets.push_back(variable.set && !variable.value ? variable.set(frame) : Value());
    if (variable.set && !variable.value && run.sets.back().is_undefined()) return Truth::no;
  }
  run.from(0);
  frame.context.values_found.resize(run.first_unknown);
  return run.result;
}

}  // namespace durero::zed
