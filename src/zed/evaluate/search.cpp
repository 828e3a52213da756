#include "zed/evaluate/search.hpp"

#include <algorithm>

#include "zed/evaluate/bounds.hpp"
#include "zed/value/sets.hpp"

namespace durero::zed {
namespace {

bool contains(const std::vector<unsigned>& slots, unsigned slot) {
  return std::find(slots.begin(), slots.end(), slot) != slots.end();
}

/// Gives each variable the equation that determines it, where there is one, and returns the order of determination. An
/// equation may depend on variables determined before it. A `loose` one may also depend on variables that take their
/// values from their sets; such variables are determined by no equation themselves.
std::vector<std::size_t> ordered(std::vector<Variable>& variables, const std::vector<const Equation*>& equations) {
  std::vector<std::size_t> order;
  std::vector<unsigned> open, sources;
  for (const Variable& each : variables) open.push_back(each.slot);
  const auto determine = [&](std::size_t i, bool loose) {
    Variable& variable = variables[i];
    if (variable.value || contains(sources, variable.slot)) return false;
    for (const Equation* equation : equations) {
      if (equation->slot != variable.slot || contains(equation->reads, variable.slot)) continue;
      std::vector<unsigned> needs;
      std::copy_if(equation->reads.begin(), equation->reads.end(), std::back_inserter(needs),
                   [&](unsigned read) { return contains(open, read); });
      if (!loose && !needs.empty()) continue;
      variable.value = equation->value;
      sources.insert(sources.end(), needs.begin(), needs.end());
      std::erase(open, variable.slot);
      order.push_back(i);
      return true;
    }
    return false;
  };
  const auto any = [&](bool loose) {
    for (std::size_t i = 0; i < variables.size(); ++i) {
      if (determine(i, loose)) return true;
    }
    return false;
  };
  while (any(false) || any(true)) {
  }
  return order;
}

/// Returns a set that has the slot's value among its members wherever the property holds; null where none is stated. A
/// set that depends on a slot of `inside`, the variables of an ∃ further in, does not count.
Code set_of(const Property& property, unsigned slot, const std::vector<unsigned>& inside);

Code set_of_any(const Property& property, unsigned slot, const std::vector<unsigned>& inside) {
  std::vector<Code> sets;
  for (const Property& part : property.parts) {
    sets.push_back(set_of(part, slot, inside));
    if (!sets.back()) return {};
  }
  return [sets = std::move(sets)](Frame& frame) {
    Value whole = empty_set();
    for (const Code& code : sets) whole = set_union(whole, code(frame), frame.context);
    return whole;
  };
}

Code set_of_exists(const Solver& search, unsigned slot, std::vector<unsigned> inside) {
  for (const Variable& variable : search.variables()) inside.push_back(variable.slot);
  return contains(inside, slot) ? Code() : set_of(search.goal(), slot, inside);
}

Code set_of(const Property& property, unsigned slot, const std::vector<unsigned>& inside) {
  const auto from_inside = [&](unsigned read) { return contains(inside, read); };
  switch (property.kind) {
    case Property::Kind::all:
      for (const Property& part : property.parts) {
        if (Code code = set_of(part, slot, inside)) return code;
      }
      return {};
    case Property::Kind::any:
      return set_of_any(property, slot, inside);
    case Property::Kind::exists:
      return set_of_exists(*property.search, slot, inside);
    case Property::Kind::test:
      break;
  }
  const bool stated = property.set && property.declared == slot &&
                      std::none_of(property.reads.begin(), property.reads.end(), from_inside);
  return stated ? property.set : Code();
}

/// Adds each conjunct of the goal that is known to depend on none of these slots.
void add_apart(const Property& goal, const std::vector<unsigned>& slots, std::vector<Test>& to) {
  if (goal.kind == Property::Kind::all)
    for (const Property& part : goal.parts) add_apart(part, slots, to);
  const auto is_sought = [&](unsigned slot) { return contains(slots, slot); };
  if (goal.kind == Property::Kind::test && goal.depends &&
      std::none_of(goal.depends->begin(), goal.depends->end(), is_sought))
    to.push_back(goal.test);
}

}  // namespace

Solver::Solver(std::vector<Variable> variables, Property goal, std::vector<unsigned> wholes)
    : variables_(std::move(variables)), goal_(std::move(goal)), wholes_(std::move(wholes)) {
  std::vector<const Equation*> equations;
  std::vector<const Property*> declared;
  collect(goal_, equations, declared);
  for (Variable& variable : variables_) {
    if (variable.set) continue;
    variable.set = set_of(goal_, variable.slot, {});
    variable.checked = bool(variable.set);
  }
  order_ = ordered(variables_, equations);
  std::vector<unsigned> slots;
  slots.reserve(variables_.size());
  for (const Variable& variable : variables_) slots.push_back(variable.slot);
  add_apart(goal_, slots, apart_);
  collect_spans(goal_, spans_);
  bounds_ = collected_bounds(goal_);
  numbers_to_try_ = small_numbers(goal_);
}

bool Solver::enumerable(Frame& frame) const {
  return std::all_of(variables_.begin(), variables_.end(), [&](const Variable& variable) {
    if (variable.value) return true;
    if (!variable.set) return false;
    const Value set = variable.set(frame);
    return set.is_undefined() || (set.set() && set.set()->members());
  });
}

bool only_declarations(const Property& property) {
  if (property.kind == Property::Kind::test) return bool(property.set);
  return property.kind == Property::Kind::all &&
         std::all_of(property.parts.begin(), property.parts.end(), only_declarations);
}

bool Solver::total(Frame& frame) const {
  std::vector<const Equation*> equations;
  std::vector<const Property*> declared;
  collect(goal_, equations, declared);
  const auto total = [&](const Code& code) {
    const Value set = code(frame);
    return set.set() && set.set()->total();
  };
  return only_declarations(goal_) &&
         std::all_of(declared.begin(), declared.end(), [&](auto* variable) { return total(variable->set); }) &&
         std::all_of(variables_.begin(), variables_.end(),
                     [&](auto& variable) { return variable.set && total(variable.set); });
}

Truth Solver::holds(Frame& frame) const {
  Truth result = Truth::yes;
  for (const Variable& variable : variables_) {
    if (variable.checked || !variable.set) continue;
    result = both(result, contains_value(variable.set(frame), frame.slots[variable.slot], frame.context));
    if (result == Truth::no) return result;
  }
  return both(result, evaluate(goal_, frame));
}

void Solver::determine(Frame& frame) const {
  for (const std::size_t i : order_) frame.slots[variables_[i].slot] = variables_[i].value(frame);
}

}  // namespace durero::zed
