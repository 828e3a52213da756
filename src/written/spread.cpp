#include "durero/written/spread.hpp"

#include <algorithm>
#include <cmath>

#include "rough_roots.hpp"

namespace durero::written {

using number::RealBall;

namespace {

void add(RoughTerms& to, const Exponents& exponents, const RealBall& more) {
  const auto [at, is_new] = to.try_emplace(exponents, more);
  if (!is_new) at->second = brought_back(at->second + more);
}

void add(RoughTerms& to, const RoughTerms& more) {
  for (const auto& [exponents, ball] : more) add(to, exponents, ball);
}

RoughTerms roughly(const ExactTerms& terms) {
  RoughTerms rough;
  for (const auto& [exponents, coefficient] : terms) rough.emplace(exponents, written::roughly(coefficient));
  return rough;
}

Exponents sum_of(const Exponents& a, const Exponents& b) {
  Exponents sum{};
  for (std::size_t axis = 0; axis < sum.size(); ++axis) sum[axis] = static_cast<std::uint8_t>(a[axis] + b[axis]);
  return sum;
}

/// Adds a product to a sum.
void add_product(RoughTerms& to, const RoughTerms& a, const RoughTerms& b) {
  for (const auto& [left, factor] : a)
    for (const auto& [right, other] : b) add(to, sum_of(left, right), brought_back(factor * other));
}

/// The sum of all gᵢ, each times an error of its own.
RoughTerms of_any_errors(const std::map<std::size_t, RoughTerms>& linear) {
  RoughTerms sum;
  for (const auto& [error, terms] : linear)
    for (const auto& [exponents, ball] : terms) add(sum, exponents, either_way(ball));
  return sum;
}

bool are_equal(const RoughTerms& a, const RoughTerms& b) {
  return std::ranges::equal(a, b, [](const auto& left, const auto& right) {
    const RealBall &x = left.second, &y = right.second;
    return left.first == right.first && x.middle == y.middle && x.radius == y.radius && x.exponent == y.exponent;
  });
}

bool is_constant(const RoughTerms& terms) {
  return std::ranges::all_of(terms, [](const auto& term) { return term.first == Exponents{}; });
}

}  // namespace

RealBall either_way(const RealBall& ball) {
  // One rounding errs by at most 2⁻⁵³ of the sum, which the next number above makes up for.
  return {0, std::nextafter(std::abs(ball.middle) + ball.radius, HUGE_VAL), ball.exponent};
}

RealBall roughly(const number::Rational& value) {
  const auto rough = [](const number::Integer& whole) { return RealBall(number::Dyadic(whole, 0)); };
  return rough(numerator(value)) / rough(denominator(value));
}

FormulaSpread::FormulaSpread(std::size_t error, const number::Rational& amount) {
  if (amount != 0) linear_[error].emplace(Exponents{}, written::roughly(amount));
}

bool FormulaSpread::is_constant() const {
  return written::is_constant(rest_) &&
         std::ranges::all_of(linear_, [](const auto& each) { return written::is_constant(each.second); });
}

RealBall FormulaSpread::at_origin() const {
  RoughTerms all = of_any_errors(linear_);
  add(all, rest_);
  const auto found = all.find(Exponents{});
  return found == all.end() ? RealBall(0.0) : either_way(found->second);
}

FormulaSpread operator+(const FormulaSpread& a, const FormulaSpread& b) {
  FormulaSpread sum(a);
  for (const auto& [error, terms] : b.linear_) add(sum.linear_[error], terms);
  add(sum.rest_, b.rest_);
  return sum;
}

FormulaSpread FormulaSpread::operator-() const {
  FormulaSpread opposite(*this);
  for (auto& [error, terms] : opposite.linear_)
    for (auto& [exponents, ball] : terms) ball = -ball;
  return opposite;
}

FormulaSpread of_product(const ExactTerms& f, const FormulaSpread& a, const ExactTerms& g, const FormulaSpread& b) {
  FormulaSpread product;
  if (a.is_none() && b.is_none()) return product;
  const RoughTerms rough_f = roughly(f), rough_g = roughly(g);
  for (const auto& [error, terms] : a.linear_) add_product(product.linear_[error], terms, rough_g);
  for (const auto& [error, terms] : b.linear_) add_product(product.linear_[error], rough_f, terms);
  add_product(product.rest_, rough_f, b.rest_);
  add_product(product.rest_, a.rest_, rough_g);
  RoughTerms of_a = of_any_errors(a.linear_), of_b = of_any_errors(b.linear_);
  add_product(product.rest_, of_a, b.rest_);
  add_product(product.rest_, a.rest_, of_b);
  add_product(product.rest_, a.rest_, b.rest_);
  add_product(product.rest_, of_a, of_b);
  return product;
}

bool FormulaSpread::operator==(const FormulaSpread& other) const {
  return are_equal(rest_, other.rest_) && std::ranges::equal(linear_, other.linear_, [](const auto& a, const auto& b) {
           return a.first == b.first && are_equal(a.second, b.second);
         });
}

}  // namespace durero::written
