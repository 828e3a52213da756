#include <algorithm>
#include <typeinfo>
#include <utility>

#include "durero/zed/value/undecided.hpp"
#include "zed/value/functions.hpp"
#include "zed/value/sets.hpp"
#include "zed/value/settled_functions.hpp"

namespace durero::zed {
namespace {

bool is_integer_from(const Value& number, int least) {
  const Real* real = number.real();
  return real && real->is_integer() && *real >= Real(least);
}

bool before_in_number(const Value& pair, const Value& number) { return compare(first(pair), number) < 0; }

std::string integers_text(int least) {
  if (least == 0) return "ℕ";
  if (least == 1) return "ℕ₁";
  return "{n : ℤ | n ≥ " + std::to_string(least) + "}";
}

/// Whether the set has every integer from `least` on; nothing where that is not known.
std::optional<bool> has_integers_from(const Value& set, int least) {
  if (set.set()->total()) return true;
  if (const std::optional<int>* from = integers_from(*set.set())) return !*from || **from <= least;
  if (set.set()->members()) return false;
  return std::nullopt;
}

/// Whether the function is defined at each member of the set; nothing where that is not known.
std::optional<Truth> is_defined_on(const SettledFunction& function, const Value& set, Context& context) {
  if (const auto* members = set.set()->members())
    return truth(std::all_of(members->begin(), members->end(),
                             [&](const Value& member) { return function.in_domain(member, context) == Truth::yes; }));
  const std::optional<int>* from = integers_from(*set.set());
  if (!from) return std::nullopt;
  if (!*from) return Truth::no;  // ℤ has no least member
  for (int number = **from; number < function.least(); ++number)
    if (function.at(Real(number)).is_undefined()) return Truth::no;
  return Truth::yes;
}

[[noreturn]] void undecided(const SettledFunction& function, const Value& set) {
  throw LackingEvaluation(Lack::members,
                          "whether " + function.text() + " is a function on " + set.text() + " is not known");
}

}  // namespace

SettledFunction::SettledFunction(int least, std::vector<Value> pairs, Value rest)
    : least_(least), pairs_(std::move(pairs)), rest_(std::move(rest)) {
  std::sort(pairs_.begin(), pairs_.end(), precedes);
  const auto has = [this](int number) {
    const auto at = std::lower_bound(pairs_.begin(), pairs_.end(), Value(Real(number)), before_in_number);
    return at != pairs_.end() && same(first(*at), Value(Real(number)));
  };
  while (has(least_ - 1)) --least_;
  std::erase_if(
      pairs_, [this](const Value& pair) { return is_integer_from(first(pair), least_) && same(second(pair), rest_); });
}

Value SettledFunction::at(const Value& number) const {
  const auto at = std::lower_bound(pairs_.begin(), pairs_.end(), number, before_in_number);
  if (at != pairs_.end() && same(first(*at), number)) return second(*at);
  return is_integer_from(number, least_) ? rest_ : Value();
}

Value SettledFunction::domain() const {
  std::vector<Value> others;
  for (const Value& pair : pairs_)
    if (!is_integer_from(first(pair), least_)) others.push_back(first(pair));
  const bool named = others.empty() && (least_ == 0 || least_ == 1);
  return named ? integers(integers_text(least_), least_) : Value();
}

Value SettledFunction::range() const {
  std::vector<Value> values{rest_};
  for (const Value& pair : pairs_) values.push_back(second(pair));
  return Value::set(std::move(values));
}

Truth SettledFunction::contains(const Value& pair, Context& context) const {
  if (!pair.tuple()) return lost(context);
  return equal(apply(first(pair), context), second(pair), context);
}

Value SettledFunction::apply(const Value& argument, Context&) const {
  if (argument.is_undefined()) return {};
  return has_open(argument) ? Value(Open{}) : at(argument);
}

Truth SettledFunction::in_domain(const Value& argument, Context& context) const {
  return has_open(argument) ? lost(context) : truth(!at(argument).is_undefined());
}

std::optional<std::vector<Value>> SettledFunction::partners(const Value& known, std::size_t part,
                                                            Context& context) const {
  if (part != 0 || has_open(known)) return Set::partners(known, part, context);
  const Value value = at(known);
  return value.is_undefined() ? std::vector<Value>() : std::vector<Value>{value};
}

std::string SettledFunction::spelled(Wording) const {
  const std::string most = "(λ n : " + integers_text(least_) + " • " + rest_.text() + ")";
  if (pairs_.empty()) return most;
  std::string others;
  for (const Value& pair : pairs_)
    others += (others.empty() ? "" : ", ") + first(pair).text() + " ↦ " + second(pair).text();
  return most + " ⊕ {" + others + "}";
}

Value settled_function(int least, std::vector<Value> pairs, Value rest) {
  return SetPtr(std::make_shared<const SettledFunction>(least, std::move(pairs), std::move(rest)));
}

// No class derives from it, so its exact type is asked for: that is quicker than a cast, and most sets are others.
const SettledFunction* settled(const Set& set) {
  return typeid(set) == typeid(SettledFunction) ? static_cast<const SettledFunction*>(&set) : nullptr;
}
const SettledFunction* settled(const Value& value) { return value.set() ? settled(*value.set()) : nullptr; }

std::strong_ordering compare_settled(const SettledFunction& a, const SettledFunction& b) {
  if (a.least() != b.least()) return a.least() <=> b.least();
  if (const auto order = compare(a.rest(), b.rest()); order != 0) return order;
  if (a.pairs().size() != b.pairs().size()) return a.pairs().size() <=> b.pairs().size();
  for (std::size_t i = 0; i < a.pairs().size(); ++i)
    if (const auto order = compare(a.pairs()[i], b.pairs()[i]); order != 0) return order;
  return std::strong_ordering::equal;
}

std::optional<Value> settled_overriding(const Value& a, const Value& b, Context& context) {
  const SettledFunction* f = settled(a);
  const auto* pairs = b.set() ? b.set()->members() : nullptr;
  if (!f || !pairs) return std::nullopt;
  const bool is_function = std::adjacent_find(pairs->begin(), pairs->end(), [](const Value& p, const Value& q) {
                             return same(first(p), first(q));
                           }) == pairs->end();
  if (!is_function) return std::nullopt;
  std::vector<Value> all;
  for (const Value& pair : f->pairs())
    if (b.set()->in_domain(first(pair), context) == Truth::no) all.push_back(pair);
  all.insert(all.end(), pairs->begin(), pairs->end());
  return settled_function(f->least(), std::move(all), f->rest());
}

// It has one value at infinitely many integers, so it is neither finite nor injective.
Truth settled_is_in(const SettledFunction& function, const Value& from, const Value& to, const Arrow& arrow,
                    Context& context) {
  if (arrow.finite || arrow.injective) return Truth::no;
  Truth inside = Truth::yes;
  for (const Value& pair : function.pairs()) inside = both(inside, contains_value(from, first(pair), context));
  const auto all = has_integers_from(from, function.least());
  if (!all) undecided(function, from);
  inside = both(inside, both(truth(*all), subset(function.range(), to, context)));
  if (inside != Truth::yes) return inside;
  if (arrow.total) {
    const auto defined = is_defined_on(function, from, context);
    if (!defined) undecided(function, from);
    inside = *defined;
  }
  return arrow.surjective ? both(inside, subset(to, function.range(), context)) : inside;
}

}  // namespace durero::zed
