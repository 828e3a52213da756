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

Rational Formula::constant() const {
  const auto found = terms_.find(Exponents{});
  return found == terms_.end() ? Rational(0) : found->second;
}

int Formula::degree() const {
  int greatest = 0;
  for (const auto& [exponents, coefficient] : terms_)
    greatest = std::max(greatest, exponents[0] + exponents[1] + exponents[2]);
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
  return sum;
}

Formula operator-(const Formula& a, const Formula& b) {
  Formula difference(a);
  for (const auto& [exponents, coefficient] : b.terms_) difference.add(exponents, -coefficient);
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
  return product;
}

Condition always(bool truth) { return {Condition::Kind::constant, truth, {}, {}, {}}; }

Condition compared(Formula formula, Signs signs) {
  if (formula.is_constant()) return always(signs.contains(number::sign(formula.constant())));
  return {Condition::Kind::comparison, true, std::move(formula), signs, {}};
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
