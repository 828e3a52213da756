#include "zed/value/functions.hpp"

#include <algorithm>
#include <unordered_map>

#include "zed/value/sets.hpp"

namespace durero::zed {
namespace {

using Values = std::vector<Value>;

Value of_pair(const Value& pair, std::size_t part) {
  if (pair.is_undefined()) return {};
  if (!pair.tuple()) return Open{};
  return pair.tuple()->parts[part];
}

Value range(const Value& relation, Context&) {
  return with(relation, [&]() -> Value {
    Values found;
    for (const Value& pair : enumerated(relation, "the range of")) found.push_back(second(pair));
    return Value::set(std::move(found));
  });
}

Value inverse(const Value& relation, Context&) {
  return with(relation, [&]() -> Value {
    Values found;
    for (const Value& pair : enumerated(relation, "the inverse of")) {
      found.push_back(Value::pair(second(pair), first(pair)));
    }
    return Value::set(std::move(found));
  });
}

}  // namespace

Value restricted(const Value& relation, const Value& set, std::size_t part, bool in, Context& context) {
  return with(relation, set, [&]() -> Value {
    Values kept;
    for (const Value& pair : enumerated(relation, "the restriction of")) {
      const Truth here = contains_value(set, pair.tuple()->parts[part], context);
      if (here == Truth::open) return Open{};
      if ((here == Truth::yes) == in) kept.push_back(pair);
    }
    return finite(std::move(kept));
  });
}

namespace {

Value overriding(const Value& a, const Value& b, Context& context) {
  return with(a, b, [&] { return set_union(restricted(a, domain(b, context), 0, false, context), b, context); });
}

Value image(const Value& relation, const Value& set, Context& context) {
  return with(relation, set, [&]() -> Value {
    Values found;
    if (relation.set() && !relation.set()->members()) {  // a function known by its values
      for (const Value& one : enumerated(set, "the image of")) {
        Value here = relation.set()->apply(one, context);
        if (!here.is_undefined()) found.push_back(std::move(here));
      }
      return Value::set(std::move(found));
    }
    for (const Value& pair : enumerated(relation, "the image through")) {
      const Truth here = contains_value(set, first(pair), context);
      if (here == Truth::open) return Open{};
      if (here == Truth::yes) found.push_back(second(pair));
    }
    return Value::set(std::move(found));
  });
}

}  // namespace

// R∼⦇S⦈ = { p : R | second p ∈ S • first p }, without R∼.
Value inverse_image(const Value& relation, const Value& set, Context& context) {
  return with(relation, set, [&]() -> Value {
    std::vector<Value> found;
    for (const Value& pair : enumerated(relation, "the inverse of")) {
      const Truth here = contains_value(set, second(pair), context);
      if (here == Truth::open) return Open{};
      if (here == Truth::yes) found.push_back(first(pair));
    }
    return Value::set(std::move(found));
  });
}

namespace {

/// a ⨾ b: first a, then b.
Value then(const Value& a, const Value& b, Context&) {
  return with(a, b, [&]() -> Value {
    Values found;
    for (const Value& one : enumerated(a, "the composition of")) {
      for (const Value& other : enumerated(b, "the composition with")) {
        if (same(second(one), first(other))) found.push_back(Value::pair(first(one), second(other)));
      }
    }
    return Value::set(std::move(found));
  });
}

Value closure(const Value& relation, Context& context) {
  return with(relation, [&]() -> Value {
    Value all = relation;
    for (;;) {
      Value more = set_union(all, then(all, relation, context), context);
      if (same(more, all)) return all;
      all = std::move(more);
    }
  });
}

Value cardinality(const Value& set, Context&) {
  return with(set, [&]() -> Value {
    const auto& members = enumerated(set, "the size of");
    if (set.set()->family() && members.size() > 1) {
      throw EvaluationError("the size of " + set.text() + ": its members cannot be compared");
    }
    return Real(static_cast<double>(members.size()));
  });
}

Value least(const Value& set, bool greatest) {
  return with(set, [&]() -> Value {
    const auto& members = enumerated(set, "the least member of");
    if (members.empty()) return {};
    return greatest ? members.back() : members.front();
  });
}

Value upto(const Value& a, const Value& b, Context&) {
  return with(a, b, [&]() -> Value {
    const Real &from = *a.real(), &to = *b.real();
    if (!from.is_integer() || !to.is_integer()) throw EvaluationError("‥ between numbers that are not integers");
    if (to - from > Real(1 << 20))
      throw EvaluationError(a.text() + "‥" + b.text() + " has more members than can be listed");
    Values members;
    for (Real one = from; one <= to; one = one + Real(1)) members.emplace_back(one);
    return finite(std::move(members));
  });
}

template <bool quotient>
Value divided(const Value& a, const Value& b, Context&) {
  return with(a, b, [&]() -> Value {
    const Real &n = *a.real(), &d = *b.real();
    if (sign(d) == 0 || !n.is_integer() || !d.is_integer()) return {};
    const Real q = integer_quotient(n, d);
    return quotient ? q : n - q * d;
  });
}

Value symmetric_difference(const Value& a, const Value& b, Context& c) {
  return set_union(set_difference(a, b, c), set_difference(b, a, c), c);
}

const std::unordered_map<std::string, ToolkitFunction>& functions() {
  static const std::unordered_map<std::string, ToolkitFunction> table{
      {"_+_", {.two = [](const Value& a, const Value& b, Context&) { return sum(a, b); }}},
      {"_-_", {.two = [](const Value& a, const Value& b, Context&) { return difference(a, b); }}},
      {"_*_", {.two = [](const Value& a, const Value& b, Context&) { return product(a, b); }}},
      {"-_", {.one = [](const Value& a, Context&) { return difference(Real(), a); }}},
      {"_div_", {.two = divided<true>}},
      {"_mod_", {.two = divided<false>}},
      {"_∪_", {.two = set_union}},
      {"_∩_", {.two = intersection}},
      {"_∖_", {.two = set_difference}},
      {"_⊖_", {.two = symmetric_difference}},
      {"⋃", {.one = big_union}},
      {"⋂", {.one = big_intersection}},
      {"#_", {.one = cardinality}},
      {"dom", {.one = domain}},
      {"ran", {.one = range}},
      {"_∼", {.one = inverse}},
      {"_⁺", {.one = closure}},
      {"_⦇_⦈", {.two = image}},
      {"_⊕_", {.two = overriding}},
      {"_⨾_", {.two = then}},
      {"_∘_", {.two = [](const Value& a, const Value& b, Context& c) { return then(b, a, c); }}},
      {"_◁_", {.two = [](const Value& s, const Value& r, Context& c) { return restricted(r, s, 0, true, c); }}},
      {"_⩤_", {.two = [](const Value& s, const Value& r, Context& c) { return restricted(r, s, 0, false, c); }}},
      {"_▷_", {.two = [](const Value& r, const Value& s, Context& c) { return restricted(r, s, 1, true, c); }}},
      {"_⩥_", {.two = [](const Value& r, const Value& s, Context& c) { return restricted(r, s, 1, false, c); }}},
      {"_↦_", {.two = [](const Value& a, const Value& b, Context&) { return Value::pair(a, b); }}},
      {"first", {.one = [](const Value& pair, Context&) { return of_pair(pair, 0); }}},
      {"second", {.one = [](const Value& pair, Context&) { return of_pair(pair, 1); }}},
      {"min", {.one = [](const Value& set, Context&) { return least(set, false); }}},
      {"max", {.one = [](const Value& set, Context&) { return least(set, true); }}},
      {"_‥_", {.two = upto}},
      {"⟨,,⟩", {.one = [](const Value& pairs, Context&) { return pairs; }}},
  };
  return table;
}

class FunctionValue : public Set {
 public:
  FunctionValue(std::string name, const ToolkitFunction& function) : name_(std::move(name)), function_(function) {}
  Value apply(const Value& argument, Context& context) const override {
    if (argument.is_undefined()) return {};
    if (function_.one) return function_.one(argument, context);
    if (!argument.tuple()) return Open{};
    return function_.two(first(argument), second(argument), context);
  }
  Truth in_domain(const Value& argument, Context& context) const override {
    const Value result = apply(argument, context);
    return result.is_open() ? Truth::open : truth(!result.is_undefined());
  }
  Truth contains(const Value& pair, Context& context) const override {
    if (!pair.tuple()) return Truth::open;
    return equal(apply(first(pair), context), second(pair), context);
  }
  std::string text() const override { return "(" + name_ + ")"; }

 private:
  std::string name_;
  const ToolkitFunction& function_;
};

}  // namespace

const ToolkitFunction* toolkit_function(const std::string& name) {
  const auto found = functions().find(name);
  return found == functions().end() ? sequence_function(name) : &found->second;
}

Value toolkit_value(const std::string& name) {
  return SetPtr(std::make_shared<const FunctionValue>(name, *toolkit_function(name)));
}

Value apply_value(const Value& function, const Value& argument, Context& context) {
  if (function.is_undefined() || argument.is_undefined()) return {};
  if (waiting(function)) return Open{};
  const Set* set = function.set();
  if (!set) throw EvaluationError(function.text() + " is no function");
  return set->apply(argument, context);
}

}  // namespace durero::zed
