/// Relations are composed with themselves: closures, and so many times (ISO/IEC 13568, B.4 and B.8).

#include "zed/value/functions.hpp"
#include "zed/value/sets.hpp"
#include "zed/value/toolkit_functions.hpp"

namespace durero::zed {
namespace {

/// R ∗ is R ⁺ and the identity on the whole type, which nobody lists. R ↗ 0 ↙, which is that identity, is ∅ ∗.
class ReflexiveClosure : public Set {
 public:
  ReflexiveClosure(Value relation, Value closure) : relation_(std::move(relation)), closure_(std::move(closure)) {}

  Truth contains(const Value& pair, Context& context) const override {
    if (!pair.tuple()) return lost(context);
    const Necessary one_of_two(context, false);
    const Truth far = contains_value(closure_, pair, context), here = equal(first(pair), second(pair), context);
    return !both(!far, !here);
  }
  std::optional<Value> image(const Value& set, Context& context) const override { return reached(set, context); }
  Value apply(const Value& argument, Context& context) const override {
    if (has_open(argument)) return Open{};
    return reached(Value::set({argument}), context).set()->members()->size() == 1 ? argument : Value();
  }
  Truth in_domain(const Value&, Context&) const override { return Truth::yes; }
  std::optional<std::vector<Value>> partners(const Value& known, std::size_t part, Context& context) const override {
    if (part == 1) return std::nullopt;
    return enumerated(reached(Value::set({known}), context), "what is reached, of");
  }
  bool closed() const override { return zed::closed(relation_); }
  std::string spelled(Wording wording) const override { return "(" + relation_.set()->spelled(wording) + " ∗)"; }

 private:
  Value reached(const Value& set, Context& context) const {
    return set_union(set, functions::image(closure_, set, context), context);
  }

  Value relation_, closure_;
};

/// A relation that cannot be listed, so many times: it is known by its images.
class Iterated : public Set {
 public:
  Iterated(Value relation, Real times) : relation_(std::move(relation)), times_(std::move(times)) {}

  std::optional<Value> image(const Value& set, Context& context) const override { return reached(set, context); }
  Value apply(const Value& argument, Context& context) const override {
    if (has_open(argument)) return Open{};
    const Value all = reached(Value::set({argument}), context);
    const auto& results = enumerated(all, "what is reached, of");
    return results.size() == 1 ? results[0] : Value();
  }
  Truth contains(const Value& pair, Context& context) const override {
    if (!pair.tuple() || has_open(first(pair))) return lost(context);
    return contains_value(reached(Value::set({first(pair)}), context), second(pair), context);
  }
  Truth in_domain(const Value& argument, Context& context) const override {
    if (has_open(argument)) return lost(context);
    return truth(!enumerated(reached(Value::set({argument}), context), "what is reached, of").empty());
  }
  std::optional<std::vector<Value>> partners(const Value& known, std::size_t part, Context& context) const override {
    if (part == 1) return std::nullopt;
    return enumerated(reached(Value::set({known}), context), "what is reached, of");
  }
  bool closed() const override { return zed::closed(relation_); }
  std::string spelled(Wording wording) const override {
    return "(" + relation_.set()->spelled(wording) + " ↗ " + Value(times_).text() + " ↙)";
  }

 private:
  Value reached(const Value& set, Context& context) const {
    Value reached = set;
    const Real one(1);
    for (Real n = times_; sign(n) > 0; n = n - one) {
      context.steps.take(1 + steps_for(reached));
      reached = functions::image(relation_, reached, context);
    }
    return reached;
  }

  Value relation_;
  Real times_;
};

/// iter n, which is applied to a relation.
class Iteration : public Set {
 public:
  explicit Iteration(Value times) : times_(std::move(times)) {}
  Value apply(const Value& relation, Context& context) const override {
    return functions::iterated(relation, times_, context);
  }
  std::optional<std::vector<Value>> partners(const Value& known, std::size_t part, Context& context) const override {
    return part == 0 ? value_at(*this, known, context) : std::nullopt;
  }
  Truth in_domain(const Value& relation, Context& context) const override {
    return waiting(relation) ? lost(context) : truth(!relation.is_undefined());
  }
  Truth contains(const Value& pair, Context& context) const override {
    if (!pair.tuple()) return lost(context);
    return equal(apply(first(pair), context), second(pair), context);
  }
  std::string spelled(Wording) const override { return "(iter " + times_.text() + ")"; }

 private:
  Value times_;
};

/// Returns R so many times, once or more, by the binary digits of the number.
Value composed(Value relation, Real times, Context& context) {
  const Real two(2);
  std::optional<Value> whole;
  for (;;) {
    const Real half = integer_quotient(times, two);
    if (!(times == half + half)) whole = whole ? functions::forward_composition(*whole, relation, context) : relation;
    if (sign(half) == 0) return *whole;
    context.steps.take(1 + steps_for(relation));
    relation = functions::forward_composition(relation, relation, context);
    times = half;
  }
}

}  // namespace

namespace functions {

Value closure(const Value& relation, Context& context) {
  return with(relation, [&]() -> Value {
    enumerated(relation, "the closure of");
    Value closed = relation;
    for (;;) {
      Value more = set_union(closed, forward_composition(closed, relation, context), context);
      if (same(more, closed)) return closed;
      closed = std::move(more);
    }
  });
}

Value reflexive_closure(const Value& relation, Context& context) {
  return with(relation, [&]() -> Value {
    return SetPtr(std::make_shared<const ReflexiveClosure>(relation, closure(relation, context)));
  });
}

Value iterated(const Value& relation, const Value& times, Context& context) {
  return with(relation, times, [&]() -> Value {
    const Real& n = *times.real();
    if (!n.is_integer()) return {};
    if (sign(n) == 0) return reflexive_closure(empty_set(), context);
    if (sign(n) < 0) return iterated(inverse(relation, context), Real() - n, context);
    if (relation.set()->members()) return composed(relation, n, context);
    return SetPtr(std::make_shared<const Iterated>(relation, n));
  });
}

Value iteration(const Value& times, Context&) {
  return with(times, [&]() -> Value {
    if (!times.real()->is_integer()) return {};
    return SetPtr(std::make_shared<const Iteration>(times));
  });
}

}  // namespace functions
}  // namespace durero::zed
