/// Other sets are made of these: finite sets, whole types and the integers.

#include <algorithm>

#include "durero/zed/value/undecided.hpp"
#include "zed/value/sets.hpp"

namespace durero::zed {
namespace {

class FiniteSet : public Set {
 public:
  explicit FiniteSet(std::vector<Value> sorted, bool is_sequence = false)
      : members_(std::move(sorted)),
        is_sequence_(is_sequence),
        family_(std::any_of(members_.begin(), members_.end(), has_intensional)),
        of_sets_(family_ && std::any_of(members_.begin(), members_.end(), has_intensional_argument)) {}

  const std::vector<Value>* members() const override { return &members_; }
  bool is_sequence() const override { return is_sequence_; }
  std::size_t listed() const override { return members_.size(); }
  bool family() const override { return family_; }
  Numbers numbers() const override {
    if (members_.empty() || !members_[0].real()) return Numbers::none;
    const auto is_whole = [](const Value& member) { return member.real()->is_integer(); };
    return std::all_of(members_.begin(), members_.end(), is_whole) ? Numbers::integers : Numbers::reals;
  }
  bool closed() const override {  // only sets among its members can hide an unknown: Value::set takes no others
    return !family_ || std::all_of(members_.begin(), members_.end(), zed::closed);
  }
  std::string spelled(Wording wording) const override {
    return wording == Wording::message && members_.size() > 8 ? "this finite set" : "{" + listed_members() + "}";
  }

  Truth contains(const Value& value, Context& context) const override {
    if (members_.empty()) return Truth::no;
    if (!family_ && !has_open(value))
      return truth(std::binary_search(members_.begin(), members_.end(), value, precedes));
    Truth some = Truth::no;
    const Necessary only(context, members_.size() == 1);
    for (const Value& member : members_) {
      const Truth here = equal(member, value, context);
      if (here == Truth::yes) return here;
      if (here == Truth::open) some = here;
    }
    return some;
  }

  // A function's pairs are sorted by their first parts. Where two pairs agree in it, the relation is no function
  // there, and its application has no value.
  Value apply(const Value& argument, Context&) const override {
    if (has_open(argument)) return Open{};
    refuse_sets(argument);
    const auto first = at(argument);
    if (first == members_.end() || !same(first->tuple()->parts[0], argument)) return {};
    const auto next = first + 1;
    if (next != members_.end() && same(next->tuple()->parts[0], argument)) return {};
    return first->tuple()->parts[1];
  }

  Truth in_domain(const Value& argument, Context& context) const override {
    if (has_open(argument)) return lost(context);
    refuse_sets(argument);
    const auto first = at(argument);
    return truth(first != members_.end() && same(first->tuple()->parts[0], argument));
  }

 private:
  static bool has_intensional_argument(const Value& pair) {
    return pair.tuple() && has_intensional(pair.tuple()->parts[0]);
  }
  // Whether sets that nobody can list are the same is not said by the order in which they stand.
  void refuse_sets(const Value& argument) const {
    if (of_sets_ || (family_ && has_intensional(argument)))
      throw LackingEvaluation(Lack::members,
                              "whether " + text() + " has a value at " + argument.text() +
                                  " cannot be decided: it depends on sets whose members cannot be enumerated");
  }
  std::vector<Value>::const_iterator at(const Value& argument) const {
    if (!members_.empty() && (!members_[0].tuple() || members_[0].tuple()->parts.size() != 2)) {
      throw EvaluationError(text() + " is no function");
    }
    return std::lower_bound(members_.begin(), members_.end(), argument, [](const Value& pair, const Value& sought) {
      return compare(pair.tuple()->parts[0], sought) < 0;
    });
  }
  std::string listed_members() const {
    std::string text;
    for (const Value& member : members_) text += (text.empty() ? "" : ", ") + member.text();
    return text;
  }

  std::vector<Value> members_;
  bool is_sequence_;
  bool family_;
  bool of_sets_;  // some pair's first part cannot be compared
};

class Everything : public Set {
 public:
  Everything(std::string name, Numbers numbers) : name_(std::move(name)), numbers_(numbers) {}
  Truth contains(const Value&, Context&) const override { return Truth::yes; }
  bool total() const override { return true; }
  Numbers numbers() const override { return numbers_; }
  std::vector<Value> some_members(const SmallScope& scope, Context&) const override {
    if (numbers_ == Numbers::none) return {};
    const std::size_t most = std::min(scope.most, scope.numbers.size());
    return {scope.numbers.begin(), scope.numbers.begin() + static_cast<std::ptrdiff_t>(most)};
  }
  std::string spelled(Wording) const override { return name_; }

 private:
  std::string name_;
  Numbers numbers_;
};

/// A given set has members as a search supposes them, and none of its own.
class GivenSet : public Set {
 public:
  explicit GivenSet(std::string name) : name_(std::move(name)) {}
  Truth contains(const Value&, Context&) const override { return Truth::yes; }
  bool total() const override { return true; }
  std::vector<Value> some_members(const SmallScope& scope, Context&) const override {
    std::vector<Value> some;
    for (std::size_t i = 1; i <= scope.given; ++i) some.push_back(Value::atom(name_, name_ + "_" + std::to_string(i)));
    return some;
  }
  std::string spelled(Wording) const override { return name_; }

 private:
  std::string name_;
};

class Integers : public Set {
 public:
  Integers(std::string name, std::optional<int> least) : name_(std::move(name)), least_(least) {}
  Truth contains(const Value& value, Context& context) const override {
    if (const auto* real = value.real()) return truth(real->is_integer() && (!least_ || *real >= Real(*least_)));
    if (!is_whole(value, context.watch)) return lost(context);
    return least_ ? compared(value, Real(*least_), context) : Truth::yes;
  }
  Numbers numbers() const override { return Numbers::integers; }
  std::vector<Value> some_members(const SmallScope& scope, Context&) const override {
    std::vector<Value> some;
    for (const Real& number : scope.numbers)
      if (some.size() < scope.most && number.is_integer() && (!least_ || number >= Real(*least_)))
        some.emplace_back(number);
    return some;
  }
  std::string spelled(Wording) const override { return name_; }
  const std::optional<int>& least() const { return least_; }

 private:
  /// Says whether a value that is not known is a whole number whatever it depends on: the unknown that is watched,
  /// where that ranges over the integers, or a polynomial in it with whole coefficients.
  static bool is_whole(const Value& value, const Watch* watch) {
    if (!watch || watch->numbers != Numbers::integers) return false;
    if (const auto* unknown = value.get<Unknown>()) return watch->unknown == unknown->id;
    const auto* shared = value.get<PolynomialPtr>();
    if (!shared || (*shared)->unknown != watch->unknown) return false;
    const Polynomial& polynomial = **shared;
    return polynomial.constant.is_integer() && polynomial.slope.is_integer() && polynomial.square.is_integer();
  }

  std::string name_;
  std::optional<int> least_;
};

}  // namespace

Value finite(std::vector<Value> sorted) { return SetPtr(std::make_shared<const FiniteSet>(std::move(sorted))); }

Value finite_sequence(std::vector<Value> pairs) {
  return SetPtr(std::make_shared<const FiniteSet>(std::move(pairs), true));
}

const Value& empty_set() {
  static const Value empty = finite({});
  return empty;
}

Value everything(std::string name) {
  return SetPtr(std::make_shared<const Everything>(std::move(name), Numbers::none));
}

Value given_set(std::string name) { return SetPtr(std::make_shared<const GivenSet>(std::move(name))); }

Value reals(std::string name) { return SetPtr(std::make_shared<const Everything>(std::move(name), Numbers::reals)); }

Value integers(std::string name, std::optional<int> least) {
  return SetPtr(std::make_shared<const Integers>(std::move(name), least));
}

const std::optional<int>* integers_from(const Set& set) {
  const auto* known = dynamic_cast<const Integers*>(&set);
  return known ? &known->least() : nullptr;
}

}  // namespace durero::zed
