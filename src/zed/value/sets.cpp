#include "zed/value/sets.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "durero/zed/value/undecided.hpp"
#include "zed/value/cuts.hpp"
#include "zed/value/number_sets.hpp"
#include "zed/value/settled_functions.hpp"

namespace durero::zed {
namespace {

/// The partners for which a pair is in the other set, or is not. Nothing where that is open.
std::optional<std::vector<Value>> partners_by(const std::optional<std::vector<Value>>& partners, const Value& known,
                                              std::size_t part, const Value& other, bool in, Context& context) {
  if (!partners) return std::nullopt;
  std::vector<Value> kept;
  for (const Value& each : *partners) {
    const Truth here = contains_value(other, part == 0 ? Value::pair(known, each) : Value::pair(each, known), context);
    if (here == Truth::open) return std::nullopt;
    if ((here == Truth::yes) == in) kept.push_back(each);
  }
  return kept;
}

/// Members of a set, not all, without those that another has, or does not have.
std::vector<Value> some_filtered(const Value& set, const Value& other, bool in, const SmallScope& scope,
                                 Context& context) {
  std::vector<Value> some = set.set()->some_members(scope, context);
  std::erase_if(some, [&](const Value& each) { return contains_value(other, each, context) != truth(in); });
  return some;
}

template <bool conjunctive>
class TwoSets : public Set {
 public:
  TwoSets(Value a, Value b, std::string symbol, Steps& steps)
      : a_(std::move(a)), b_(std::move(b)), symbol_(std::move(symbol)), steps_(steps) {}
  Truth contains(const Value& value, Context& context) const override {
    const Necessary keep(context, conjunctive);
    const Truth a = contains_value(a_, value, context);
    constexpr Truth settled = conjunctive ? Truth::no : Truth::yes;
    if (a == settled) return a;
    const Truth b = contains_value(b_, value, context);
    if (b == settled) return b;
    return a == Truth::open ? a : b;
  }
  // Where one of two sets is a curve, the points of it on the other may be few, and are then at hand.
  const std::vector<Value>* members() const override {
    if (!listed_) {
      listed_ = true;
      if (conjunctive && closed()) {
        points_ = listed_numbers(*this, steps_);
        if (!points_) points_ = points_in_common(*a_.set(), *b_.set(), steps_);
        if (!points_) points_ = points_in_common(*b_.set(), *a_.set(), steps_);
      }
    }
    return points_ ? points_->set()->members() : nullptr;
  }
  std::size_t listed() const override { return points_ ? points_->set()->listed() : 0; }
  Numbers numbers() const override {
    if (!conjunctive) return numbers_of_both(*a_.set(), *b_.set());
    return a_.set()->numbers() == Numbers::integers ? Numbers::integers : b_.set()->numbers();
  }
  std::vector<Value> some_members(const SmallScope& scope, Context& context) const override {
    if (conjunctive) return some_filtered(a_, b_, true, scope, context);
    std::vector<Value> some = a_.set()->some_members(scope, context), more = b_.set()->some_members(scope, context);
    std::move(more.begin(), more.end(), std::back_inserter(some));
    return some;
  }
  std::optional<std::vector<Value>> partners(const Value& known, std::size_t part, Context& context) const override {
    auto here = a_.set()->partners(known, part, context);
    if (conjunctive) return partners_by(here, known, part, b_, true, context);
    const auto there = b_.set()->partners(known, part, context);
    if (!here || !there) return std::nullopt;
    here->insert(here->end(), there->begin(), there->end());
    if (std::any_of(here->begin(), here->end(), has_intensional)) return std::nullopt;
    std::sort(here->begin(), here->end(), precedes);
    here->erase(std::unique(here->begin(), here->end(), same), here->end());
    return here;
  }
  Value unknown(Context& context) const override { return a_.set()->unknown(context); }
  bool closed() const override { return zed::closed(a_) && zed::closed(b_); }
  std::string spelled(Wording wording) const override {
    return "(" + a_.set()->spelled(wording) + " " + symbol_ + " " + b_.set()->spelled(wording) + ")";
  }

 private:
  Value a_, b_;
  std::string symbol_;
  Steps& steps_;
  mutable bool listed_ = false;
  mutable std::optional<Value> points_;
};

class Difference : public Set {
 public:
  Difference(Value a, Value b, Steps& steps) : a_(std::move(a)), b_(std::move(b)), steps_(steps) {}
  const std::vector<Value>* members() const override {
    if (!std::exchange(listed_, true) && closed()) numbers_ = listed_numbers(*this, steps_);
    return numbers_ ? numbers_->set()->members() : nullptr;
  }
  std::size_t listed() const override { return numbers_ ? numbers_->set()->listed() : 0; }
  Truth contains(const Value& value, Context& context) const override {
    const Truth in = contains_value(a_, value, context);
    if (in == Truth::no) return in;
    const Necessary not_here(context, false);
    const Truth out = !contains_value(b_, value, context);
    if (out == Truth::no) return out;
    return in == Truth::open ? in : out;
  }
  Numbers numbers() const override { return a_.set()->numbers(); }
  std::vector<Value> some_members(const SmallScope& scope, Context& context) const override {
    return some_filtered(a_, b_, false, scope, context);
  }
  std::optional<std::vector<Value>> partners(const Value& known, std::size_t part, Context& context) const override {
    return partners_by(a_.set()->partners(known, part, context), known, part, b_, false, context);
  }
  Value unknown(Context& context) const override { return a_.set()->unknown(context); }
  bool closed() const override { return zed::closed(a_) && zed::closed(b_); }
  std::string spelled(Wording wording) const override {
    return "(" + a_.set()->spelled(wording) + " ∖ " + b_.set()->spelled(wording) + ")";
  }

 private:
  Value a_, b_;
  Steps& steps_;
  mutable bool listed_ = false;
  mutable std::optional<Value> numbers_;
};

class BigUnion : public Set {
 public:
  explicit BigUnion(Value sets) : sets_(std::move(sets)) {}
  Truth contains(const Value& value, Context& context) const override {
    return sets_.set()->some_contains(value, context);
  }
  Numbers numbers() const override {
    const auto* sets = sets_.set()->members();
    if (!sets) return Numbers::none;
    Value some = empty_set();
    for (const Value& each : *sets) {
      const Numbers kind = numbers_of_both(*some.set(), *each.set());
      if (kind == Numbers::none && !(each.set()->members() && each.set()->members()->empty())) return kind;
      if (kind != some.set()->numbers()) some = each;
    }
    return some.set()->numbers();
  }
  bool closed() const override { return zed::closed(sets_); }
  std::optional<Curve> curve(Context& context) const override { return sets_.set()->curve(context); }
  std::string spelled(Wording wording) const override { return "⋃ " + sets_.set()->spelled(wording); }

 private:
  Value sets_;
};

class Domain : public Set {
 public:
  explicit Domain(Value function) : function_(std::move(function)) {}
  Truth contains(const Value& value, Context& context) const override {
    return function_.set()->in_domain(value, context);
  }
  bool closed() const override { return zed::closed(function_); }
  std::string spelled(Wording wording) const override { return "dom " + function_.set()->spelled(wording); }

 private:
  Value function_;
};

const Set& as_set(const Value& value) {
  if (const Set* set = value.set()) return *set;
  throw EvaluationError(value.text() + " is no set");
}

bool missing(const Value& a, const Value& b) { return a.is_undefined() || b.is_undefined(); }

/// Returns the members of a finite set that are in another, or that are not.
Value filtered(const std::vector<Value>& members, const Value& other, bool in, Context& context) {
  std::vector<Value> kept;
  kept.reserve(members.size());
  for (const Value& member : members) {
    const Truth here = contains_value(other, member, context);
    if (here == Truth::open) return Open{};
    if ((here == Truth::yes) == in) kept.push_back(member);
  }
  return finite(std::move(kept));
}

}  // namespace

const std::vector<Value>& enumerated(const Value& value, const char* what) {
  const Set& set = as_set(value);
  if (const auto* members = set.members()) return *members;
  if (set.size()) throw TooManyMembers(set.text());
  throw LackingEvaluation(Lack::members, std::string(what) + " " + set.text() + ": its members cannot be enumerated");
}

Value set_union(const Value& a, const Value& b, Context& context) {
  if (missing(a, b)) return {};
  if (waiting(a) || waiting(b)) return Open{};
  const auto *x = as_set(a).members(), *y = as_set(b).members();
  if (!x || !y) return SetPtr(std::make_shared<const TwoSets<false>>(a, b, "∪", context.steps));
  std::vector<Value> merged;
  merged.reserve(x->size() + y->size());
  std::set_union(x->begin(), x->end(), y->begin(), y->end(), std::back_inserter(merged), precedes);
  return finite(std::move(merged));
}

Value intersection(const Value& a, const Value& b, Context& context) {
  if (missing(a, b)) return {};
  if (waiting(a) || waiting(b)) return Open{};
  if (const auto* x = as_set(a).members()) return filtered(*x, b, true, context);
  if (const auto* y = as_set(b).members()) return filtered(*y, a, true, context);
  return SetPtr(std::make_shared<const TwoSets<true>>(a, b, "∩", context.steps));
}

Value set_difference(const Value& a, const Value& b, Context& context) {
  if (missing(a, b)) return {};
  if (waiting(a) || waiting(b)) return Open{};
  if (const auto* x = as_set(a).members()) return filtered(*x, b, false, context);
  return SetPtr(std::make_shared<const Difference>(a, b, context.steps));
}

Value big_union(const Value& a, Context& context) {
  if (a.is_undefined()) return {};
  if (waiting(a)) return Open{};
  const auto* sets = as_set(a).members();
  if (!sets || as_set(a).family()) return SetPtr(std::make_shared<const BigUnion>(a));
  Value whole = empty_set();
  for (const Value& member : *sets) {
    whole = set_union(whole, member, context);
    context.steps.take(1 + steps_for(whole));
  }
  return whole;
}

Value big_intersection(const Value& a, Context& context) {
  if (a.is_undefined()) return {};
  if (waiting(a)) return Open{};
  const auto& sets = enumerated(a, "the intersection of");
  if (sets.empty())
    throw LackingEvaluation(Lack::members, "⋂ ∅ is every value of its type, which nobody can enumerate");
  Value common = sets[0];
  for (std::size_t i = 1; i < sets.size(); ++i) {
    context.steps.take(1 + steps_for(common));
    common = intersection(common, sets[i], context);
  }
  return common;
}

Value domain(const Value& relation, Context&) {
  if (relation.is_undefined()) return {};
  if (waiting(relation)) return Open{};
  const auto* pairs = as_set(relation).members();
  if (!pairs) {
    const SettledFunction* function = settled(relation);
    if (Value named = function ? function->domain() : Value(); named.set()) return named;
    return SetPtr(std::make_shared<const Domain>(relation));
  }
  std::vector<Value> firsts;
  firsts.reserve(pairs->size());
  for (const Value& pair : *pairs) {
    const auto& first = pair.tuple()->parts[0];
    if (firsts.empty() || !same(firsts.back(), first)) firsts.push_back(first);
  }
  return finite(std::move(firsts));
}

Truth subset(const Value& a, const Value& b, Context& context) {
  if (missing(a, b)) return Truth::no;
  if (waiting(a) || waiting(b)) return lost(context);
  if (as_set(b).total()) return Truth::yes;
  Truth result = Truth::yes;
  const Necessary no(context, false);
  if (!as_set(a).members())
    if (const auto of_numbers = numbers_are_among(a, b, context)) return *of_numbers;
  for (const Value& member : enumerated(a, "whether every member is in another set, for the set")) {
    const Truth here = contains_value(b, member, context);
    if (here == Truth::no) return here;
    if (here == Truth::open) result = here;
  }
  return result;
}

}  // namespace durero::zed
