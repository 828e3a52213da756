/// The functions of the toolkit on sets and relations are here; those on numbers are in numbers.cpp.

#include "zed/value/functions.hpp"

#include <algorithm>

#include "durero/zed/value/undecided.hpp"
#include "zed/value/integer_lines.hpp"
#include "zed/value/number_sets.hpp"
#include "zed/value/rules.hpp"
#include "zed/value/sets.hpp"
#include "zed/value/settled_functions.hpp"
#include "zed/value/toolkit_functions.hpp"

namespace durero::zed {
namespace {

using Values = std::vector<Value>;

bool is_rule(const Value& relation) { return relation.set() && !relation.set()->members(); }

Value part_of(const Value& pair, std::size_t part) {
  if (pair.is_undefined()) return {};
  if (!pair.tuple() || may_be_undefined(pair)) return Open{};
  return pair.tuple()->parts[part];
}

/// The finitely many pairs of the function with these first parts.
Value restricted_to(const SettledFunction& function, const Values& arguments) {
  Values pairs;
  for (const Value& argument : arguments)
    if (Value value = function.at(argument); !value.is_undefined())
      pairs.push_back(Value::pair(argument, std::move(value)));
  return finite(std::move(pairs));
}

}  // namespace

Value restricted(const Value& relation, const Value& set, std::size_t part, bool in, Context& context) {
  return with(relation, set, [&]() -> Value {
    if (const auto* f = settled(relation); f && part == 0 && in && set.set() && set.set()->members())
      return restricted_to(*f, *set.set()->members());
    if (is_rule(relation)) return restricted_rule(relation, set, part, in, context);
    Values kept;
    for (const Value& pair : enumerated(relation, "the restriction of")) {
      const Truth inside = contains_value(set, pair.tuple()->parts[part], context);
      if (inside == Truth::open) return Open{};
      if ((inside == Truth::yes) == in) kept.push_back(pair);
    }
    return finite(std::move(kept));
  });
}

// R∼⦇S⦈ is { p : R | second p ∈ S • first p }, so R∼ need not be made.
Value inverse_image(const Value& relation, const Value& set, Context& context) {
  return with(relation, set, [&]() -> Value {
    if (is_rule(relation)) return functions::image(inverse_rule(relation), set, context);
    Values firsts;
    for (const Value& pair : enumerated(relation, "the inverse of")) {
      const Truth inside = contains_value(set, second(pair), context);
      if (inside == Truth::open) return Open{};
      if (inside == Truth::yes) firsts.push_back(first(pair));
    }
    return Value::set(std::move(firsts));
  });
}

namespace functions {

Value nothing() { return empty_set(); }

Value symmetric_difference(const Value& a, const Value& b, Context& context) {
  return set_union(set_difference(a, b, context), set_difference(b, a, context), context);
}

// Only a finite set has a size.
Value cardinality(const Value& set, Context& context) {
  return with(set, [&]() -> Value {
    if (const auto known = set.set() ? set.set()->size() : std::nullopt) return *known;
    if (is_infinite(set, context)) return {};
    const auto& members = enumerated(set, "the size of");
    if (set.set()->family() && members.size() > 1) {
      throw LackingEvaluation(Lack::members, "the size of " + set.text() + ": its members cannot be compared");
    }
    return Real(static_cast<double>(members.size()));
  });
}

Value maplet(const Value& a, const Value& b, Context&) { return Value::pair(a, b); }
Value first_of(const Value& pair, Context&) { return part_of(pair, 0); }
Value second_of(const Value& pair, Context&) { return part_of(pair, 1); }

Value identity(const Value& set, Context&) {
  return with(set, [&]() -> Value {
    if (is_rule(set)) return identity_rule(set);
    Values pairs;
    for (const Value& member : enumerated(set, "the identity on")) pairs.push_back(Value::pair(member, member));
    return finite(std::move(pairs));
  });
}

Value range(const Value& relation, Context&) {
  return with(relation, [&]() -> Value {
    if (const auto* f = settled(relation)) return f->range();
    if (is_rule(relation)) return range_of_rule(relation);
    Values seconds;
    for (const Value& pair : enumerated(relation, "the range of")) seconds.push_back(second(pair));
    return Value::set(std::move(seconds));
  });
}

Value inverse(const Value& relation, Context&) {
  return with(relation, [&]() -> Value {
    if (is_rule(relation)) return inverse_rule(relation);
    Values pairs;
    for (const Value& pair : enumerated(relation, "the inverse of")) {
      pairs.push_back(Value::pair(second(pair), first(pair)));
    }
    return Value::set(std::move(pairs));
  });
}

Value overriding(const Value& a, const Value& b, Context& context) {
  return with(a, b, [&] {
    if (auto overridden = settled_overriding(a, b, context)) return *std::move(overridden);
    if (is_rule(a) || is_rule(b)) return overriding_rules(a, b);
    return set_union(domain_subtraction(domain(b, context), a, context), b, context);
  });
}

Value image(const Value& relation, const Value& set, Context& context) {
  return with(relation, set, [&]() -> Value {
    Values reached;
    if (auto by_images = relation.set()->image(set, context)) return *std::move(by_images);
    if (is_rule(relation)) {
      for (const Value& argument : enumerated(set, "the image of")) {
        auto results = relation.set()->partners(argument, 0, context);
        if (!results)
          throw LackingEvaluation(Lack::members,
                                  "the image of " + argument.text() + " through " + relation.text() + " is not known");
        std::move(results->begin(), results->end(), std::back_inserter(reached));
      }
      return Value::set(std::move(reached));
    }
    for (const Value& pair : enumerated(relation, "the image through")) {
      const Truth inside = contains_value(set, first(pair), context);
      if (inside == Truth::open) return Open{};
      if (inside == Truth::yes) reached.push_back(second(pair));
    }
    return Value::set(std::move(reached));
  });
}

Value forward_composition(const Value& a, const Value& b, Context& context) {
  return with(a, b, [&]() -> Value {
    if (is_rule(a)) return composed_rules(a, b);
    Values pairs;
    for (const Value& from : enumerated(a, "the composition of")) {
      context.steps.take(1 + steps_for(b));
      if (has_intensional(second(from)))
        throw LackingEvaluation(
            Lack::members, "the composition through " + second(from).text() + ": its members cannot be enumerated");
      if (!b.set()->members()) {  // b is known by its images
        const Value reached = image(b, Value::set({second(from)}), context);
        for (const Value& to : enumerated(reached, "the composition with"))
          pairs.push_back(Value::pair(first(from), to));
        continue;
      }
      for (const Value& to : *b.set()->members()) {
        if (same(second(from), first(to))) pairs.push_back(Value::pair(first(from), second(to)));
      }
    }
    return Value::set(std::move(pairs));
  });
}

Value backward_composition(const Value& a, const Value& b, Context& context) {
  return forward_composition(b, a, context);
}

Value domain_restriction(const Value& set, const Value& relation, Context& context) {
  return restricted(relation, set, 0, true, context);
}
Value domain_subtraction(const Value& set, const Value& relation, Context& context) {
  return restricted(relation, set, 0, false, context);
}
Value range_restriction(const Value& relation, const Value& set, Context& context) {
  return restricted(relation, set, 1, true, context);
}
Value range_subtraction(const Value& relation, const Value& set, Context& context) {
  return restricted(relation, set, 1, false, context);
}

}  // namespace functions

std::optional<std::vector<Value>> value_at(const Set& function, const Value& argument, Context& context) {
  Value value = function.apply(argument, context);
  if (may_be_undefined(value) && !value.is_undefined()) return std::nullopt;
  return value.is_undefined() ? Values() : Values{std::move(value)};
}

namespace {

class FunctionValue : public Set, public LineSource {
 public:
  explicit FunctionValue(const OperatorRow& row) : row_(row) {}
  std::optional<IntegerLine> line(Context&) const override {
    if (row_.evaluation.unary != functions::successor) return std::nullopt;
    return IntegerLine{0, Real(1), Real(1)};
  }
  Value apply(const Value& argument, Context& context) const override {
    if (argument.is_undefined()) return {};
    const Computing value(context);
    if (row_.evaluation.unary) return row_.evaluation.unary(argument, context);
    if (!argument.tuple()) return Open{};
    return row_.evaluation.binary(first(argument), second(argument), context);
  }
  Truth in_domain(const Value& argument, Context& context) const override {
    const Value result = apply(argument, context);
    return result.is_open() ? lost(context) : truth(!result.is_undefined());
  }
  std::optional<Values> partners(const Value& known, std::size_t part, Context& context) const override {
    if (part == 0) return value_at(*this, known, context);
    if (row_.evaluation.unary != functions::successor || !known.real()) return std::nullopt;
    if (!known.real()->is_integer() || *known.real() < Real(1)) return Values();
    return Values{*known.real() - Real(1)};
  }
  Truth contains(const Value& pair, Context& context) const override {
    if (!pair.tuple()) return lost(context);
    return equal(apply(first(pair), context), second(pair), context);
  }
  std::string spelled(Wording) const override { return "(" + std::string(row_.name) + ")"; }

 private:
  const OperatorRow& row_;
};

}  // namespace

Value toolkit_function(const OperatorRow& row) { return SetPtr(std::make_shared<const FunctionValue>(row)); }

Value apply_value(const Value& function, const Value& argument, Context& context) {
  if (function.is_undefined() || argument.is_undefined()) return {};
  if (waiting(function)) return Open{};
  const Set* set = function.set();
  if (!set) throw EvaluationError(function.text() + " is no function");
  return set->apply(argument, context);
}

}  // namespace durero::zed
