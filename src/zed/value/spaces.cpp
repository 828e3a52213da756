/// Sets of sets and of tuples are made here, and the constructors of free types.

#include <algorithm>

#include "durero/zed/value/undecided.hpp"
#include "zed/value/functions.hpp"
#include "zed/value/sets.hpp"
#include "zed/value/small_members.hpp"
#include "zed/value/toolkit_functions.hpp"

namespace durero::zed {
namespace {

constexpr std::size_t most_members = 1 << 20;
constexpr std::size_t most_listed_base =
    20;  // of a power set: 2^20 subsets take some 100 MiB, and those of 20 are not listed
constexpr std::size_t most_counted_base = 1
                                          << 16;  // the number of subsets of a greater set takes more than 2^16 digits

class PowerSet : public Set {
 public:
  PowerSet(Value base, PowerForm form) : base_(std::move(base)), form_(form) {}

  bool total() const override { return !form_.finite && !form_.nonempty && base_.set()->total(); }
  bool declares_sequences() const override { return base_.set()->declares_sequences(); }
  Value as_declared(const Value& member) const override {
    const auto* members = member.set() ? member.set()->members() : nullptr;
    if (!members || !declares_sequences()) return member;
    std::vector<Value> declared;
    for (const Value& each : *members) declared.push_back(base_.set()->as_declared(each));
    return Value::set(std::move(declared));
  }
  bool closed() const override { return zed::closed(base_); }

  Truth contains(const Value& value, Context& context) const override {
    const Set* set = value.set();
    if (!set) return lost(context);
    const auto* members = set->members();
    if (!members) {
      if (form_.finite)
        throw LackingEvaluation(Lack::members, "whether " + set->text() + " is finite cannot be decided");
      if (form_.nonempty)
        throw LackingEvaluation(Lack::members, "whether " + set->text() + " is empty cannot be decided");
      return subset(value, base_, context);
    }
    if (form_.nonempty && members->empty()) return Truth::no;
    return subset(value, base_, context);
  }

  std::size_t listed() const override { return members_ ? members_->set()->listed() : 0; }

  // The subsets stand in order of size, as sets are ordered.
  const std::vector<Value>* members() const override {
    const auto* base = base_.set()->members();
    if (!base || base->size() >= most_listed_base) return nullptr;
    if (!members_) {
      std::vector<Value> subsets;
      for (std::size_t bits = form_.nonempty ? 1 : 0; bits < (std::size_t{1} << base->size()); ++bits) {
        std::vector<Value> some;
        for (std::size_t i = 0; i < base->size(); ++i) {
          if ((bits >> i) & 1) some.push_back((*base)[i]);
        }
        subsets.push_back(finite(std::move(some)));
      }
      members_ = Value::set(std::move(subsets));
    }
    return members_->set()->members();
  }

  std::optional<Real> size() const override {
    const auto* base = base_.set()->family() ? nullptr : base_.set()->members();
    if (!base || base->size() > most_counted_base) return std::nullopt;
    Real size(form_.nonempty ? 0 : 1), power(1);
    for (std::size_t i = 0; i < base->size(); ++i) power = power + power;
    return form_.nonempty ? power - Real(1) : power;
  }

  std::vector<Value> some_members(const SmallScope& scope, Context& context) const override {
    return subsets_of(base_.set()->some_members(scope, context), scope.most, form_.nonempty);
  }

  std::optional<Value> members_up_to(std::size_t size, Context&) const override {
    const auto* base = base_.set()->family() ? nullptr : base_.set()->members();
    auto subsets = base ? all_subsets(*base, size) : std::nullopt;
    if (!subsets) return std::nullopt;
    if (form_.nonempty) std::erase_if(*subsets, [](const Value& each) { return each.set()->members()->empty(); });
    return Value::set(std::move(*subsets));
  }

  std::string spelled(Wording wording) const override { return symbol() + " " + base_.set()->spelled(wording); }

 private:
  std::string symbol() const { return std::string(form_.finite ? "𝔽" : "ℙ") + (form_.nonempty ? "₁" : ""); }

  Value base_;
  PowerForm form_;
  mutable std::optional<Value> members_;
};

class ProductSet : public Set {
 public:
  explicit ProductSet(std::vector<Value> factors) : factors_(std::move(factors)) {}

  bool total() const override {
    return std::all_of(factors_.begin(), factors_.end(), [](const Value& factor) { return factor.set()->total(); });
  }

  bool declares_sequences() const override {
    return std::any_of(factors_.begin(), factors_.end(),
                       [](const Value& factor) { return factor.set()->declares_sequences(); });
  }
  Value as_declared(const Value& member) const override {
    const auto* tuple = member.tuple();
    if (!tuple || tuple->parts.size() != factors_.size() || !declares_sequences()) return member;
    std::vector<Value> parts;
    for (std::size_t i = 0; i < factors_.size(); ++i) parts.push_back(factors_[i].set()->as_declared(tuple->parts[i]));
    return Value::tuple(std::move(parts));
  }

  Truth contains(const Value& value, Context& context) const override {
    const auto* tuple = value.tuple();
    if (!tuple) return lost(context);
    Truth result = Truth::yes;
    for (std::size_t i = 0; i < factors_.size() && result != Truth::no; ++i) {
      result = both(result, contains_value(factors_[i], tuple->parts[i], context));
    }
    return result;
  }

  bool closed() const override { return std::all_of(factors_.begin(), factors_.end(), zed::closed); }

  Value unknown(Context& context) const override {
    std::vector<Value> parts;
    parts.reserve(factors_.size());
    for (const Value& factor : factors_) parts.push_back(factor.set()->unknown(context));
    return Value::tuple(std::move(parts));
  }

  std::size_t listed() const override { return members_ ? members_->set()->listed() : 0; }

  const std::vector<Value>* members() const override {
    if (members_) return members_->set()->members();
    if (!is_listed()) return nullptr;
    std::vector<std::vector<Value>> rows{{}};
    if (std::any_of(factors_.begin(), factors_.end(), is_empty)) rows.clear();
    for (const Value& factor : factors_) {
      if (rows.empty()) break;
      std::vector<std::vector<Value>> longer;
      for (const auto& row : rows) {
        for (const Value& member : *factor.set()->members()) {
          longer.push_back(row);
          longer.back().push_back(member);
        }
      }
      rows = std::move(longer);
    }
    std::vector<Value> tuples;
    tuples.reserve(rows.size());
    for (auto& row : rows) tuples.push_back(Value::tuple(std::move(row)));
    members_ = Value::set(std::move(tuples));
    return members_->set()->members();
  }

  std::optional<Real> size() const override {
    Real size(1);
    for (const Value& factor : factors_) {
      if (is_empty(factor)) return Real();
      const auto of_factor = factor.set()->size();
      if (!of_factor) return std::nullopt;
      size = size * *of_factor;
    }
    return size;
  }

  std::vector<Value> some_members(const SmallScope& scope, Context& context) const override {
    return some_tuples(factors_, scope, context);
  }

  // A × B relates each member of A to all of B.
  std::optional<std::vector<Value>> partners(const Value& known, std::size_t part, Context& context) const override {
    if (factors_.size() != 2) return std::nullopt;
    const Truth in = contains_value(factors_[part], known, context);
    if (in == Truth::no) return std::vector<Value>();
    const auto* others = in == Truth::yes ? factors_[1 - part].set()->members() : nullptr;
    return others ? std::optional(*others) : std::nullopt;
  }
  Truth has_partner(const Value& known, std::size_t part, Context& context) const override {
    if (factors_.size() != 2) throw EvaluationError(text() + " is no relation");
    if (is_empty(factors_[1 - part])) return Truth::no;
    const auto* others = factors_[1 - part].set()->members();
    const Truth in = contains_value(factors_[part], known, context);
    if (in == Truth::yes && !others && factors_[1 - part].set()->numbers() == Numbers::none)
      throw LackingEvaluation(Lack::members, "whether " + factors_[1 - part].text() + " is empty cannot be decided");
    return in;
  }

  std::string spelled(Wording wording) const override {
    std::string text;
    for (const Value& factor : factors_) text += (text.empty() ? "" : " × ") + factor.set()->spelled(wording);
    return "(" + text + ")";
  }

 private:
  static bool is_empty(const Value& factor) { return factor.set()->members() && factor.set()->members()->empty(); }
  bool is_listed() const {
    if (std::any_of(factors_.begin(), factors_.end(), is_empty)) return true;
    std::size_t size = 1;
    for (const Value& factor : factors_) {
      const auto* members = factor.set()->members();
      if (!members || members->size() > most_members / size) return false;
      size *= members->size();
    }
    return true;
  }

  std::vector<Value> factors_;
  mutable std::optional<Value> members_;
};

class ConstructorFunction : public Set {
 public:
  ConstructorFunction(Atom name, Value arguments) : name_(std::move(name)), arguments_(std::move(arguments)) {}
  Value apply(const Value& argument, Context& context) const override {
    const Computing value(context);
    if (in_domain(argument, context) == Truth::no) return {};
    // Of what is not known the constructor is: so an equation finds x of `leaf x`, which is what it was applied to.
    return ConstructedPtr(std::make_shared<const Constructed>(Constructed{name_, argument}));
  }
  Truth in_domain(const Value& argument, Context& context) const override {
    return argument.is_undefined() ? Truth::no : contains_value(arguments_, argument, context);
  }
  Truth contains(const Value& pair, Context& context) const override {
    if (!pair.tuple()) return lost(context);
    return equal(apply(pair.tuple()->parts[0], context), pair.tuple()->parts[1], context);
  }
  // A constructor is an injection.
  std::optional<std::vector<Value>> partners(const Value& known, std::size_t part, Context& context) const override {
    if (part == 0) return value_at(*this, known, context);
    const auto* constructed = known.get<ConstructedPtr>();
    if (!constructed && !known.get<Atom>()) return std::nullopt;
    if (!constructed || compare((*constructed)->constructor, name_) != 0) return std::vector<Value>();
    return std::vector<Value>{(*constructed)->argument};
  }
  bool closed() const override { return zed::closed(arguments_); }
  std::string spelled(Wording) const override { return name_->text; }

 private:
  Atom name_;
  Value arguments_;
};

}  // namespace

Value constructor_function(std::string type, std::string name, std::uint32_t order, Value arguments) {
  const Value atom = Value::atom(std::move(type), std::move(name), order);
  return SetPtr(std::make_shared<const ConstructorFunction>(*atom.get<Atom>(), std::move(arguments)));
}

Value power_set(Value base, PowerForm form) {
  if (!base.set()) return base;
  return SetPtr(std::make_shared<const PowerSet>(std::move(base), form));
}

Value functions::nonempty_subsets(const Value& set, Context&) { return power_set(set, {.nonempty = true}); }
Value functions::finite_subsets(const Value& set, Context&) { return power_set(set, {.finite = true}); }
Value functions::nonempty_finite_subsets(const Value& set, Context&) {
  return power_set(set, {.finite = true, .nonempty = true});
}

Value product_set(std::vector<Value> factors) {
  for (const Value& factor : factors) {
    if (!factor.set()) return factor;
  }
  return SetPtr(std::make_shared<const ProductSet>(std::move(factors)));
}

}  // namespace durero::zed
