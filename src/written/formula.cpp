#include "durero/written/formula.hpp"

#include <algorithm>
#include <iterator>
#include <stdexcept>

namespace durero::written {

using number::Rational;

Formula::Formula(const Rational& value) { add({}, value); }

Formula Formula::coordinate(std::size_t axis) {
  Exponents one{};
  one.at(axis) = 1;
  Formula formula;
  formula.add(one, 1);
  return formula;
}

Formula Formula::off_by(const Rational& value, std::size_t error, const Rational& amount) {
  Formula formula(value);
  formula.spread_ = FormulaSpread(error, amount);
  return formula;
}

bool Formula::is_constant() const {
  const bool is_number = terms_.empty() || (terms_.size() == 1 && terms_.begin()->first == Exponents{});
  return is_number && spread_.is_constant();
}

std::optional<int> Formula::certain_sign() const {
  if (spread_.is_none()) return number::sign(constant());
  const number::RealBall value = constant() == 0 ? number::RealBall(0.0) : roughly(constant());
  const int sign = (value + spread_.at_origin()).decided_sign();
  return sign == 0 ? std::nullopt : std::optional(sign);
}

Rational Formula::constant() const {
  const auto found = terms_.find(Exponents{});
  return found == terms_.end() ? Rational(0) : found->second;
}

int Formula::degree() const {
  int greatest = 0;
  const auto take = [&](const auto& terms) {
    for (const auto& [exponents, coefficient] : terms)
      greatest = std::max(greatest, exponents[0] + exponents[1] + exponents[2]);
  };
  take(terms_);
  take(spread_.rest());
  for (const auto& [error, terms] : spread_.linear()) take(terms);
  return greatest;
}

Formula Formula::derivative(std::size_t axis) const {
  Formula formula;
  for (const auto& [exponents, coefficient] : terms_) {
    if (exponents.at(axis) == 0) continue;
    Exponents less = exponents;
    --less.at(axis);
    formula.add(less, coefficient * exponents.at(axis));
  }
  return formula;
}

void Formula::add(const Exponents& exponents, const Rational& coefficient) {
  const auto at = terms_.try_emplace(exponents, 0).first;
  at->second += coefficient;
  if (at->second == 0) {
    terms_.erase(at);
  } else if (msb(abs(numerator(at->second))) > max_bits || msb(denominator(at->second)) > max_bits) {
    throw std::length_error("a number of too many digits");
  }
}

Formula operator+(const Formula& a, const Formula& b) {
  Formula sum(a);
  for (const auto& [exponents, coefficient] : b.terms_) sum.add(exponents, coefficient);
  if (!b.spread_.is_none()) sum.spread_ = a.spread_ + b.spread_;
  return sum;
}

Formula operator-(const Formula& a, const Formula& b) {
  Formula difference(a);
  for (const auto& [exponents, coefficient] : b.terms_) difference.add(exponents, -coefficient);
  if (!b.spread_.is_none()) difference.spread_ = a.spread_ + -b.spread_;
  return difference;
}

Formula operator*(const Formula& a, const Formula& b) {
  if (a.degree() + b.degree() > Formula::max_degree) throw std::length_error("a polynomial of too high a degree");
  Formula product;
  for (const auto& [left, factor] : a.terms_) {
    for (const auto& [right, other] : b.terms_) {
      Exponents sum{};
      for (std::size_t axis = 0; axis < sum.size(); ++axis)
        sum[axis] = static_cast<std::uint8_t>(left[axis] + right[axis]);
      product.add(sum, factor * other);
    }
  }
  product.spread_ = of_product(a.terms_, a.spread_, b.terms_, b.spread_);
  return product;
}

Condition always(bool truth) { return {Condition::Kind::constant, truth, {}, {}, {}}; }

Condition compared(Formula formula, Signs signs) {
  const std::optional<int> sign = formula.is_constant() ? formula.certain_sign() : std::nullopt;
  if (sign) return always(signs.contains(*sign));
  return {Condition::Kind::comparison, true, std::move(formula), signs, {}};
}

bool holds_as_given(const Condition& of) {
  switch (of.kind) {
    case Condition::Kind::constant:
      return of.truth;
    case Condition::Kind::comparison:
      return of.formula.is_constant() && of.signs.contains(number::sign(of.formula.constant()));
    case Condition::Kind::all:
      return std::ranges::all_of(of.parts, holds_as_given);
    case Condition::Kind::any:
      return std::ranges::any_of(of.parts, holds_as_given);
  }
  __builtin_unreachable();  // a kind is one of its enumerators
}

namespace {

/// Joins two conditions. For `all`, true is neutral and false decides; for `any`, it is the other way round.
Condition joined(Condition::Kind kind, Condition a, Condition b) {
  const bool neutral = kind == Condition::Kind::all;
  if (a.is(!neutral) || b.is(neutral)) return a;
  if (b.is(!neutral) || a.is(neutral)) return b;
  Condition whole{kind, true, {}, {}, {}};
  for (Condition* part : {&a, &b}) {
    if (part->kind == kind) {
      std::ranges::move(part->parts, std::back_inserter(whole.parts));
    } else {
      whole.parts.push_back(std::move(*part));
    }
  }
  return whole;
}

}  // namespace

Condition both(Condition a, Condition b) { return joined(Condition::Kind::all, std::move(a), std::move(b)); }
Condition either(Condition a, Condition b) { return joined(Condition::Kind::any, std::move(a), std::move(b)); }

Condition negated(const Condition& of) {
  switch (of.kind) {
    case Condition::Kind::constant:
      return always(!of.truth);
    case Condition::Kind::comparison:
      return compared(of.formula, {!of.signs.negative, !of.signs.zero, !of.signs.positive});
    case Condition::Kind::all:
    case Condition::Kind::any: {
      const bool was_all = of.kind == Condition::Kind::all;
      Condition opposite{was_all ? Condition::Kind::any : Condition::Kind::all, true, {}, {}, {}};
      for (const Condition& part : of.parts) opposite.parts.push_back(negated(part));
      return opposite;
    }
  }
  __builtin_unreachable();  // a kind is one of its enumerators
}

}  // namespace durero::written
