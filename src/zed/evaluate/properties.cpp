/// Evaluates compiled predicates, and tells what their conjuncts state.

#include <algorithm>
#include <iterator>

#include "zed/evaluate/linear_question.hpp"

namespace durero::zed {
namespace {

Truth evaluate_any(const Property& property, Frame& frame) {
  const Necessary keep(frame.context, property.parts.size() == 1);
  Truth some = Truth::no;
  for (const Property& part : property.parts) {
    const Truth here = evaluate(part, frame);
    if (here == Truth::yes) return here;
    if (here == Truth::open) some = here;
  }
  return some;
}

Truth evaluate_all(const Property& property, Frame& frame) {
  Truth result = Truth::yes;
  for (const Property& part : property.parts) {
    result = both(result, evaluate(part, frame));
    if (result == Truth::no) return result;
  }
  return result;
}

Truth evaluate_whole(const Property& property, Frame& frame) {
  const BindingValue* binding = frame.slots[*property.whole].binding();
  if (!binding) return evaluate_all(property, frame);
  if (binding->satisfies == property.schema) return Truth::yes;
  const Truth here = evaluate_all(property, frame);
  if (here == Truth::yes) binding->satisfies = property.schema;
  return here;
}

Truth evaluate_exists(const Property& property, Frame& frame) {
  const Solver& search = *property.search;
  if (!property.linear) return search.exists(frame);
  return searched([&] { return search.exists(frame); }, property.linear.get(), frame,
                  [&](Frame& inside) { return search.holds(inside); });
}

}  // namespace

Property all_of(std::vector<Property> parts) {
  if (parts.size() == 1) return std::move(parts[0]);
  Property property;
  property.parts = std::move(parts);
  return property;
}

Property test_of(Test test, Term term) {
  Property property;
  property.kind = Property::Kind::test;
  property.test = std::move(test);
  property.term = std::move(term);
  return property;
}

Truth evaluate(const Property& property, Frame& frame) {
  switch (property.kind) {
    case Property::Kind::test:
      return property.test(frame);
    case Property::Kind::any:
      return evaluate_any(property, frame);
    case Property::Kind::exists:
      return evaluate_exists(property, frame);
    case Property::Kind::all:
      break;
  }
  return property.whole ? evaluate_whole(property, frame) : evaluate_all(property, frame);
}

namespace {

// The equation x = e of ∃ y • x = e ∧ P holds outside the ∃ too, if e does not depend on y.
void collect_outer(const Solver& search, std::vector<const Equation*>& equations) {
  std::vector<const Equation*> inside;
  std::vector<const Property*> declared;
  collect(search.goal(), inside, declared);
  for (const Equation* equation : inside) {
    const auto is_about = [equation](const Variable& variable) {
      return equation->slot == variable.slot ||
             std::find(equation->reads.begin(), equation->reads.end(), variable.slot) != equation->reads.end();
    };
    if (std::none_of(search.variables().begin(), search.variables().end(), is_about)) equations.push_back(equation);
  }
}

}  // namespace

void collect(const Property& property, std::vector<const Equation*>& equations,
             std::vector<const Property*>& declared) {
  if (property.kind == Property::Kind::all) {
    for (const Property& part : property.parts) collect(part, equations, declared);
  } else if (property.kind == Property::Kind::test) {
    for (const Equation& equation : property.equations) equations.push_back(&equation);
    if (property.set) declared.push_back(&property);
  } else if (property.kind == Property::Kind::exists) {
    collect_outer(*property.search, equations);
  }
}

std::vector<Property> sides_of(const Property& property) {
  if (property.kind == Property::Kind::any) {
    std::vector<Property> sides;
    for (const Property& part : property.parts) {
      auto of_part = sides_of(part);
      std::move(of_part.begin(), of_part.end(), std::back_inserter(sides));
    }
    return sides.size() <= most_sides ? std::move(sides) : std::vector<Property>{property};
  }
  if (property.kind != Property::Kind::all) return {property};
  std::vector<Property> sides{Property()};
  for (const Property& part : property.parts) {
    auto of_part = sides_of(part);
    if (sides.size() * of_part.size() > most_sides) return {property};
    if (of_part.size() == 1) {
      for (std::size_t i = 1; i < sides.size(); ++i) sides[i].parts.push_back(of_part[0]);
      sides[0].parts.push_back(std::move(of_part[0]));
      continue;
    }
    std::vector<Property> more;
    for (const Property& side : sides)
      for (const Property& one : of_part) {
        more.push_back(side);
        more.back().parts.push_back(one);
      }
    sides = std::move(more);
  }
  return sides;
}

Property exists_property(std::vector<Variable> variables, Property property) {
  if (property.kind == Property::Kind::any) {
    for (Property& part : property.parts) part = exists_property(variables, std::move(part));
    return property;
  }
  if (auto sides = sides_of(property); sides.size() > 1) {
    Property any;
    any.kind = Property::Kind::any;
    for (Property& side : sides) any.parts.push_back(exists_property(variables, std::move(side)));
    return any;
  }
  Property conjunct;
  conjunct.kind = Property::Kind::exists;
  conjunct.search = std::make_shared<const Solver>(std::move(variables), std::move(property));
  return conjunct;
}

}  // namespace durero::zed
