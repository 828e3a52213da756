/// This part of the search finds values that no equation gives: numbers along their line, and empty relations.

#include <algorithm>

#include "zed/evaluate/search.hpp"
#include "zed/value/cuts.hpp"
#include "zed/value/growing_function.hpp"
#include "zed/value/sets.hpp"

namespace durero::zed {
namespace {

/// A trial puts numbers in the place of an unknown for a scope.
class TentativeValue {
 public:
  TentativeValue(Frame& frame, unsigned slot)
      : frame_(frame), slots_(frame.slots), slot_(slot), id_(frame.slots[slot].get<Unknown>()->id) {}
  ~TentativeValue() {
    frame_.slots = slots_;
    frame_.context.values_found[id_].reset();
  }
  TentativeValue(const TentativeValue&) = delete;
  TentativeValue& operator=(const TentativeValue&) = delete;

  std::uint32_t id() const { return id_; }
  /// Returns the truth with that number; open where it cannot be decided.
  Truth at(const Real& t, const std::function<Truth()>& truth) {
    frame_.slots = slots_;
    frame_.slots[slot_] = t;
    frame_.context.values_found[id_] = t;
    const Necessary nothing_here(frame_.context, false);
    try {
      return truth();
    } catch (const EvaluationError&) {
      return Truth::open;
    }
  }

 private:
  Frame& frame_;
  decltype(Frame::slots) slots_;
  unsigned slot_;
  std::uint32_t id_;
};

/// Says whether a search goes through all members of a set, which are functions between finite sets.
bool is_whole_space(const Set& set, Context& context) {
  const std::vector<FunctionSpace> spaces = set.function_spaces({}, context);
  return spaces.size() == 1 && spaces.front().whole;
}

}  // namespace

void conjuncts_of(const Property& property, std::vector<const Property*>& to) {
  if (property.kind != Property::Kind::all && property.links.empty()) return to.push_back(&property);
  for (const Property& link : property.links) to.push_back(&link);
  for (const Property& part : property.parts) conjuncts_of(part, to);
}

void collect_spans(const Property& property, std::vector<Equation>& spans) {
  if (property.kind == Property::Kind::all)
    for (const Property& part : property.parts) collect_spans(part, spans);
  spans.insert(spans.end(), property.spans.begin(), property.spans.end());
}

// A relation whose domain is empty, or whose range is, has no pair.
bool Solver::determine_empty(Frame& frame) const {
  bool some = false;
  for (const Equation& span : spans_) {
    const auto* unknown = frame.slots[span.slot].get<Unknown>();
    if (!unknown) continue;
    const Value value = span.value(frame);
    if (!value.set() || !value.set()->members() || !value.set()->members()->empty()) continue;
    frame.context.values_found[unknown->id] = empty_set();
    frame.slots[span.slot] = empty_set();
    some = true;
  }
  return some;
}

Numbers Solver::numbers(Frame& frame) const {
  if (variables_.size() != 1 || !variables_[0].set || variables_[0].value) return Numbers::none;
  const Value set = variables_[0].set(frame);
  return set.set() ? set.set()->numbers() : Numbers::none;
}

bool Solver::may_be_listed(Frame& frame) const {
  if (only_declarations(goal_)) return false;
  bool some = false;
  for (const Variable& variable : variables_) {
    if (variable.value) continue;
    const Value set = variable.set ? variable.set(frame) : Value();
    if (!set.set()) return false;
    if (set.set()->members()) continue;
    const auto bounds_it = [&](const ValueBound& bound) { return bound.slot == variable.slot; };
    if (set.set()->numbers() == Numbers::none && std::none_of(bounds_.begin(), bounds_.end(), bounds_it) &&
        !is_whole_space(*set.set(), frame.context))
      return false;
    some = true;
  }
  return some;
}

std::optional<std::vector<Real>> Solver::candidates(const Variable& variable, const Set& set, Frame& frame,
                                                    const Test& extra) const {
  TentativeValue trial(frame, variable.slot);
  Context& context = frame.context;
  const auto in_set = [&] { return set.contains(frame.slots[variable.slot], context); };
  std::vector<const Property*> conjuncts, followed;
  conjuncts_of(goal_, conjuncts);
  const Property of_extra = test_of(extra ? extra : Test([](Frame&) { return Truth::yes; }));
  if (extra) conjuncts.push_back(&of_extra);
  auto cuts = cuts_of(trial.id(), set.numbers(), context, in_set);
  if (!cuts) return std::nullopt;
  for (const Property* conjunct : conjuncts) {
    const auto more = cuts_of(trial.id(), set.numbers(), context, [&] { return evaluate(*conjunct, frame); });
    if (!more) continue;
    followed.push_back(conjunct);
    cuts->insert(cuts->end(), more->begin(), more->end());
  }
  std::sort(cuts->begin(), cuts->end());
  cuts->erase(std::unique(cuts->begin(), cuts->end()), cuts->end());
  const auto all = [&] {
    Truth here = in_set();
    for (const Property* conjunct : followed) {
      if (here == Truth::no) break;
      here = both(here, evaluate(*conjunct, frame));
    }
    return here;
  };
  return every_number(set.numbers(), *cuts, [&](const Real& t) { return trial.at(t, all); });
}

std::optional<Truth> Solver::some_number(const Variable& variable, const Set& set, Frame& frame,
                                         const Test& extra) const {
  TentativeValue trial(frame, variable.slot);
  const auto whole = [&] {
    determine(frame);
    Truth here = set.contains(frame.slots[variable.slot], frame.context);
    if (here != Truth::no) here = both(here, holds(frame));
    return here != Truth::no && extra ? both(here, extra(frame)) : here;
  };
  const auto cuts = cuts_of(trial.id(), set.numbers(), frame.context, whole);
  if (!cuts) return std::nullopt;
  return zed::some_number(set.numbers(), *cuts, [&](const Real& t) { return trial.at(t, whole); });
}

}  // namespace durero::zed
