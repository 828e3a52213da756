#include "zed/value/rules.hpp"

#include <algorithm>

#include "durero/zed/value/undecided.hpp"
#include "zed/value/integer_lines.hpp"
#include "zed/value/sets.hpp"

namespace durero::zed {
namespace {

using Values = std::vector<Value>;
using Partners = std::optional<Values>;

/// The values, each once. Nothing where some of them are sets that nobody can compare.
Partners each_once(Values values) {
  if (values.size() > 1 && std::any_of(values.begin(), values.end(), has_intensional)) return std::nullopt;
  std::sort(values.begin(), values.end(), precedes);
  values.erase(std::unique(values.begin(), values.end(), same), values.end());
  return values;
}

/// The values for which the truth is yes. Nothing where one of the truths is open.
template <class Membership>
Partners kept(const Partners& values, Membership&& asked) {
  if (!values) return std::nullopt;
  Values some;
  for (const Value& value : *values) {
    const Truth here = asked(value);
    if (here == Truth::open) return std::nullopt;
    if (here == Truth::yes) some.push_back(value);
  }
  return some;
}

/// All partners in one relation of these values.
Partners partners_of_all(const Partners& values, const Set& relation, std::size_t part, Context& context) {
  if (!values) return std::nullopt;
  Values all;
  for (const Value& value : *values) {
    Partners some = relation.partners(value, part, context);
    if (!some) return std::nullopt;
    std::move(some->begin(), some->end(), std::back_inserter(all));
  }
  return each_once(std::move(all));
}

class Composition : public Set {
 public:
  Composition(Value first, Value then) : first_(std::move(first)), then_(std::move(then)) {}
  Partners partners(const Value& known, std::size_t part, Context& context) const override {
    const Set &near = *(part == 0 ? first_ : then_).set(), &far = *(part == 0 ? then_ : first_).set();
    return partners_of_all(near.partners(known, part, context), far, part, context);
  }
  // A value between is related to both parts of the pair: the values between are those of one of them.
  Truth contains(const Value& pair, Context& context) const override {
    if (!pair.tuple() || has_open(pair)) return lost(context);
    for (const std::size_t part : {0U, 1U}) {
      const Set &near = *(part == 0 ? first_ : then_).set(), &far = *(part == 0 ? then_ : first_).set();
      const Partners between = near.partners(pair.tuple()->parts[part], part, context);
      if (!between) continue;
      const Value& other = pair.tuple()->parts[1 - part];
      const Partners linked = kept(between, [&](const Value& value) {
        return far.contains(part == 0 ? Value::pair(value, other) : Value::pair(other, value), context);
      });
      return linked ? truth(!linked->empty()) : lost(context);
    }
    throw LackingEvaluation(Lack::members, "whether " + pair.text() + " is in " + text() + " cannot be decided");
  }
  bool closed() const override { return zed::closed(first_) && zed::closed(then_); }
  std::string spelled(Wording wording) const override {
    return "(" + first_.set()->spelled(wording) + " ⨾ " + then_.set()->spelled(wording) + ")";
  }

 private:
  Value first_, then_;
};

/// R ⊕ S relates a value as S does where S is defined, and else as R does.
class Overriding : public Set {
 public:
  Overriding(Value below, Value above) : below_(std::move(below)), above_(std::move(above)) {}
  Partners partners(const Value& known, std::size_t part, Context& context) const override {
    const Partners above = above_.set()->partners(known, part, context);
    if (!above || (part == 0 && !above->empty())) return above;
    if (part == 0) return below_.set()->partners(known, part, context);
    Partners below = kept(below_.set()->partners(known, part, context),
                          [&](const Value& first) { return !above_.set()->in_domain(first, context); });
    if (!below) return std::nullopt;
    below->insert(below->end(), above->begin(), above->end());
    return each_once(std::move(*below));
  }
  Truth contains(const Value& pair, Context& context) const override {
    if (!pair.tuple() || has_open(pair)) return lost(context);
    const Truth overridden = above_.set()->in_domain(first(pair), context);
    if (overridden == Truth::open) return overridden;
    return contains_value(overridden == Truth::yes ? above_ : below_, pair, context);
  }
  bool closed() const override { return zed::closed(below_) && zed::closed(above_); }
  std::string spelled(Wording wording) const override {
    return "(" + below_.set()->spelled(wording) + " ⊕ " + above_.set()->spelled(wording) + ")";
  }

 private:
  Value below_, above_;
};

class Restriction : public Set {
 public:
  Restriction(Value relation, Value set, std::size_t part, bool in)
      : relation_(std::move(relation)), set_(std::move(set)), part_(part), in_(in) {}
  Partners partners(const Value& known, std::size_t part, Context& context) const override {
    if (part == part_) {
      const Truth here = admits(known, context);
      if (here == Truth::no) return Values();
      return here == Truth::yes ? relation_.set()->partners(known, part, context) : std::nullopt;
    }
    return kept(relation_.set()->partners(known, part, context),
                [&](const Value& other) { return admits(other, context); });
  }
  Truth contains(const Value& pair, Context& context) const override {
    if (!pair.tuple()) return lost(context);
    const Truth here = admits(pair.tuple()->parts[part_], context);
    return here == Truth::no ? here : both(here, contains_value(relation_, pair, context));
  }
  bool closed() const override { return zed::closed(relation_) && zed::closed(set_); }
  std::string spelled(Wording wording) const override {
    const std::string relation = relation_.set()->spelled(wording), set = set_.set()->spelled(wording);
    if (part_ == 0) return "(" + set + (in_ ? " ◁ " : " ⩤ ") + relation + ")";
    return "(" + relation + (in_ ? " ▷ " : " ⩥ ") + set + ")";
  }

 private:
  Truth admits(const Value& value, Context& context) const {
    const Necessary one_part(context, false);
    const Truth here = contains_value(set_, value, context);
    return in_ ? here : !here;
  }
  Value relation_, set_;
  std::size_t part_;
  bool in_;
};

class Inverse : public Set {
 public:
  explicit Inverse(Value relation) : relation_(std::move(relation)) {}
  Partners partners(const Value& known, std::size_t part, Context& context) const override {
    return relation_.set()->partners(known, 1 - part, context);
  }
  Truth has_partner(const Value& known, std::size_t part, Context& context) const override {
    return relation_.set()->has_partner(known, 1 - part, context);
  }
  Truth contains(const Value& pair, Context& context) const override {
    if (!pair.tuple()) return lost(context);
    return contains_value(relation_, Value::pair(second(pair), first(pair)), context);
  }
  bool closed() const override { return zed::closed(relation_); }
  std::string spelled(Wording wording) const override { return "(" + relation_.set()->spelled(wording) + " ∼)"; }

 private:
  Value relation_;
};

class RangeOfRule : public Set {
 public:
  explicit RangeOfRule(Value relation) : relation_(std::move(relation)) {}
  Truth contains(const Value& value, Context& context) const override {
    const Necessary some_pair(context, false);
    return relation_.set()->has_partner(value, 1, context);
  }
  bool closed() const override { return zed::closed(relation_); }
  std::string spelled(Wording wording) const override { return "ran " + relation_.set()->spelled(wording); }

 private:
  Value relation_;
};

class Identity : public Set, public LineSource {
 public:
  explicit Identity(Value set) : set_(std::move(set)) {}
  std::optional<IntegerLine> line(Context&) const override {
    const auto* least = set_.set() ? integers_from(*set_.set()) : nullptr;
    return least ? std::optional(IntegerLine{*least, Real(1), Real()}) : std::nullopt;
  }
  Partners partners(const Value& known, std::size_t, Context& context) const override {
    return kept(Values{known}, [&](const Value& value) { return contains_value(set_, value, context); });
  }
  Truth has_partner(const Value& known, std::size_t, Context& context) const override {
    return contains_value(set_, known, context);
  }
  Truth contains(const Value& pair, Context& context) const override {
    if (!pair.tuple()) return lost(context);
    return both(contains_value(set_, first(pair), context), equal(first(pair), second(pair), context));
  }
  bool closed() const override { return zed::closed(set_); }
  std::string spelled(Wording wording) const override { return "(id " + set_.set()->spelled(wording) + ")"; }

 private:
  Value set_;
};

}  // namespace

Value composed_rules(const Value& first, const Value& then) {
  return SetPtr(std::make_shared<const Composition>(first, then));
}

Value overriding_rules(const Value& below, const Value& above) {
  return SetPtr(std::make_shared<const Overriding>(below, above));
}

Value inverse_rule(const Value& relation) { return SetPtr(std::make_shared<const Inverse>(relation)); }

Value range_of_rule(const Value& relation) { return SetPtr(std::make_shared<const RangeOfRule>(relation)); }

Value identity_rule(const Value& set) { return SetPtr(std::make_shared<const Identity>(set)); }

Value restricted_rule(const Value& relation, const Value& set, std::size_t part, bool in, Context& context) {
  const Value rule = SetPtr(std::make_shared<const Restriction>(relation, set, part, in));
  const auto* few = in && part == 0 && set.set() ? set.set()->members() : nullptr;
  if (!few || set.set()->family()) return rule;
  Values pairs;
  for (const Value& argument : *few) {
    context.steps.take();
    const Partners values = relation.set()->partners(argument, 0, context);
    if (!values) return rule;
    for (const Value& value : *values) pairs.push_back(Value::pair(argument, value));
  }
  return Value::set(std::move(pairs));
}

}  // namespace durero::zed
