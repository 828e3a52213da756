#include "durero/written/moved_points.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "rough_roots.hpp"

namespace durero::written {

using number::Rational;
using number::RealBall;

namespace {

/// A formula in s by its coefficients: the exact part, and its spread, of which each row is FormulaSpread::linear() of
/// an error, and the last one FormulaSpread::rest().
struct InS {
  std::vector<Rational> exact;
  std::vector<std::vector<RealBall>> spread;

  explicit InS(const Formula& formula) : exact(size_of(formula), Rational(0)) {
    for (const auto& [exponents, coefficient] : formula.terms()) exact[exponents[0]] = coefficient;
    for (const auto& [error, terms] : formula.spread().linear()) take(terms);
    take(formula.spread().rest());
  }

  /// The derivative by s, which errors move as they move the formula.
  InS slope() const {
    InS other(*this);
    const auto derive = [](auto& row, auto times) {
      for (std::size_t i = 1; i < row.size(); ++i) row[i - 1] = times(row[i], i);
      row.back() = times(row.back(), 0);
    };
    derive(other.exact, [](const Rational& of, std::size_t i) { return of * Rational(i); });
    for (std::vector<RealBall>& row : other.spread)
      derive(row, [](const RealBall& of, std::size_t i) {
        return i == 0 ? RealBall(0.0) : brought_back(of * RealBall(static_cast<double>(i)));
      });
    return other;
  }
  /// The coefficients in the other order: at 1/s for s > 0 the polynomial has the sign of the given one at s.
  InS backwards() const {
    InS other(*this);
    std::ranges::reverse(other.exact);
    for (std::vector<RealBall>& row : other.spread) std::ranges::reverse(row);
    return other;
  }

 private:
  static std::size_t size_of(const Formula& formula) { return static_cast<std::size_t>(formula.degree()) + 1; }
  void take(const RoughTerms& terms) {
    std::vector<RealBall>& row = spread.emplace_back(exact.size(), RealBall(0.0));
    for (const auto& [exponents, ball] : terms) row[exponents[0]] = ball;
  }
};

RealBall rough_or_zero(const Rational& value) { return value == 0 ? RealBall(0.0) : roughly(value); }

/// The value of a polynomial.
template <class N>
N value_at(const std::vector<N>& coefficients, const N& s, N (*kept)(const N&)) {
  N value = coefficients.back();
  for (std::size_t i = coefficients.size() - 1; i-- > 0;) value = kept(value * s + coefficients[i]);
  return value;
}
RealBall value_at(const std::vector<RealBall>& coefficients, const RealBall& s) {
  return value_at<RealBall>(coefficients, s, brought_back);
}

/// The sum of the magnitudes of coefficients from the first one on, each times a power of a magnitude: both ways.
RealBall sum_of_magnitudes(const std::vector<RealBall>& coefficients, std::size_t first, const RealBall& magnitude) {
  std::vector<RealBall> all(coefficients.size(), RealBall(0.0));
  for (std::size_t i = first; i < all.size(); ++i) {
    const RealBall both_ways = either_way(coefficients[i]);
    all[i] = {both_ways.radius, 0, both_ways.exponent};
  }
  return either_way(value_at(all, magnitude));
}

Signs signs_of(const RealBall& ball) {
  const int sign = ball.decided_sign();
  return sign < 0 ? Signs{true, false, false} : sign > 0 ? Signs{false, false, true} : Signs{true, true, true};
}

/// How far the spread moves a formula at one s.
RealBall spread_at(const InS& formula, const Rational& s) {
  RealBall sum(0.0);
  for (const std::vector<RealBall>& row : formula.spread)
    sum = brought_back(sum + either_way(value_at(row, rough_or_zero(s))));
  return sum;
}

/// The signs that a formula may have at one s.
Signs signs_at(const InS& formula, const Rational& s) {
  const Rational exact = value_at<Rational>(formula.exact, s, [](const Rational& value) { return value; });
  return signs_of(brought_back(rough_or_zero(exact) + spread_at(formula, s)));
}

/// The coefficients of a polynomial by the powers of s − m.
std::vector<RealBall> about(std::vector<Rational> polynomial, const Rational& m) {
  for (std::size_t from = 0; from < polynomial.size(); ++from)
    for (std::size_t i = polynomial.size() - 1; i > from; --i) polynomial[i - 1] += polynomial[i] * m;
  std::vector<RealBall> rough;
  for (const Rational& coefficient : polynomial) rough.push_back(rough_or_zero(coefficient));
  return rough;
}

/// The signs that a formula may have in a stretch.
Signs signs_within(const InS& formula, const MovedStretch& stretch) {
  const auto& [begin, end] = stretch;
  if (begin == end) return signs_at(formula, begin);
  const std::vector<RealBall> exact = about(formula.exact, (begin + end) / 2);
  const RealBall reach = rough_or_zero((end - begin) / 2),
                 farthest = rough_or_zero(std::max<Rational>(abs(begin), abs(end)));
  RealBall value = brought_back(exact[0] + sum_of_magnitudes(exact, 1, reach));
  for (const std::vector<RealBall>& row : formula.spread)
    value = brought_back(value + sum_of_magnitudes(row, 0, farthest));
  return signs_of(value);
}

/// Whether a condition is true, where `holds` says so of each of its comparisons.
template <class Holds>
bool is_true(const Condition& of, const Holds& holds) {
  const auto part_is_true = [&](const Condition& part) { return is_true(part, holds); };
  switch (of.kind) {
    case Condition::Kind::constant:
      return of.truth;
    case Condition::Kind::comparison:
      return holds(of);
    case Condition::Kind::all:
      return std::ranges::all_of(of.parts, part_is_true);
    case Condition::Kind::any:
      return std::ranges::any_of(of.parts, part_is_true);
  }
  __builtin_unreachable();  // a kind is one of its enumerators
}

/// Whether a condition may hold, where `signs` gives the signs that a formula may have.
template <class SignsOf>
bool may_hold(const Condition& of, const SignsOf& signs) {
  return is_true(of, [&](const Condition& comparison) {
    const Signs may_be = signs(comparison.formula), &asked = comparison.signs;
    return (may_be.negative && asked.negative) || (may_be.zero && asked.zero) || (may_be.positive && asked.positive);
  });
}

/// Whether a condition holds on all of a stretch.
bool holds_on(const Condition& of, const MovedStretch& stretch) {
  return is_true(of, [&](const Condition& comparison) {
    const Signs may_be = signs_within(InS(comparison.formula), stretch), &asked = comparison.signs;
    return (!may_be.negative || asked.negative) && (!may_be.zero || asked.zero) && (!may_be.positive || asked.positive);
  });
}

bool has_opposite_signs(const Formula& formula, const MovedStretch& stretch) {
  const InS in_s(formula);
  const Signs begin = signs_at(in_s, stretch.begin), end = signs_at(in_s, stretch.end);
  constexpr Signs negative{true, false, false}, positive{false, false, true};
  return (begin == negative && end == positive) || (begin == positive && end == negative);
}

bool is_certain(const Condition& of, const MovedStretch& stretch) {
  switch (of.kind) {
    case Condition::Kind::constant:
      return false;
    case Condition::Kind::comparison:
      return of.is_equation() && has_opposite_signs(of.formula, stretch);
    case Condition::Kind::all:
      return std::ranges::any_of(of.parts, [&](const Condition& crossed) {
        return is_certain(crossed, stretch) && std::ranges::all_of(of.parts, [&](const Condition& beside) {
                 return &beside == &crossed || holds_on(beside, stretch);
               });
      });
    case Condition::Kind::any:
      return std::ranges::any_of(of.parts, [&](const Condition& part) { return is_certain(part, stretch); });
  }
  __builtin_unreachable();  // a kind is one of its enumerators
}

/// The comparisons of a condition by =.
void take_equations(const Condition& of, std::vector<const Formula*>& to) {
  if (of.is_equation()) to.push_back(&of.formula);
  for (const Condition& part : of.parts) take_equations(part, to);
}

std::vector<const Formula*> equations_of(const Condition& of) {
  std::vector<const Formula*> all;
  take_equations(of, all);
  return all;
}

/// The magnitude of a ball's numbers in binary64, and of a quotient of two.
double quotient(const RealBall& a, const RealBall& b) {
  const double low = std::abs(b.middle) - b.radius;
  const auto places = static_cast<int>(std::clamp<std::int64_t>(a.exponent - b.exponent, -2000, 2000));
  return low > 0 ? std::ldexp((std::abs(a.middle) + a.radius) / low, places) : std::numeric_limits<double>::infinity();
}

}  // namespace

bool MovedPoints::may_be_within(const MovedStretch& stretch) const {
  return may_hold(condition_, [&](const Formula& formula) { return signs_within(InS(formula), stretch); });
}

bool MovedPoints::may_be_from(const Rational& from) const {
  const MovedStretch stretch{0, 1 / from};
  return may_hold(condition_, [&](const Formula& formula) { return signs_within(InS(formula).backwards(), stretch); });
}

bool MovedPoints::is_certain_within(const MovedStretch& stretch) const { return is_certain(condition_, stretch); }

double MovedPoints::rough_reach() const {
  double least = 0;
  for (const Formula* const equation : equations_of(condition_)) {
    const InS in_s(*equation);
    if (in_s.exact.size() < 2 || in_s.exact[1] == 0) continue;
    const RealBall off = brought_back(spread_at(in_s, 0) + either_way(rough_or_zero(in_s.exact[0])));
    const double reach = quotient(off, roughly(in_s.exact[1]));
    if (reach > 0 && std::isfinite(reach) && (least == 0 || reach < least)) least = reach;
  }
  return least;
}

std::size_t MovedPoints::most_within(const MovedStretch& stretch) const {
  std::size_t sum = 0;
  for (const Formula* const equation : equations_of(condition_)) {
    const bool is_steep = !signs_within(InS(*equation).slope(), stretch).zero;
    sum += is_steep ? 1 : static_cast<std::size_t>(equation->degree());
  }
  return sum;
}

}  // namespace durero::written
