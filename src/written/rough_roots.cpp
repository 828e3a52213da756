#include "rough_roots.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace durero::written {
namespace {

using number::RealBall;

/// Polynomials of a greater degree are not asked. Up to it, factorials times binomials are whole numbers of binary64.
constexpr std::size_t greatest_degree = 8;
/// How often the stretch from 0 to 1 is halved.
constexpr int most_halvings = 6;

RealBall mean(const RealBall& a, const RealBall& b) {
  const RealBall sum = a + b;
  return brought_back({sum.middle, sum.radius, sum.exponent - 1});
}

/// The coefficients of Bernstein's form on 0 to 1, times n!. Σⱼ C(i, j)/C(n, j)·cⱼ is the one of place i, and
/// n!/C(n, j) is j!·(n − j)!.
RoughPolynomial bernstein(const RoughPolynomial& polynomial) {
  const std::size_t n = polynomial.size() - 1;
  std::array<double, greatest_degree + 1> factorial{1};
  for (std::size_t i = 1; i <= n; ++i) factorial[i] = factorial[i - 1] * static_cast<double>(i);
  RoughPolynomial form;
  for (std::size_t i = 0; i <= n; ++i) {
    RealBall sum(0.0);
    double choices = 1;  // C(i, j)
    for (std::size_t j = 0; j <= i; ++j) {
      sum = brought_back(sum + RealBall(choices * factorial[j] * factorial[n - j]) * polynomial[j]);
      choices = choices * static_cast<double>(i - j) / static_cast<double>(j + 1);
    }
    form.push_back(sum);
  }
  return form;
}

/// Whether the form may be 0 between 0 and 1. It lies between the least and the greatest of its coefficients, and the
/// first and the last are its values at the ends.
bool may_vanish(RoughPolynomial form, int halvings) {
  const auto has_sign = [&](int sign) {
    return std::ranges::all_of(form, [&](const RealBall& each) { return each.decided_sign() == sign; });
  };
  if (has_sign(1) || has_sign(-1)) return false;
  if (halvings == 0 || form.front().decided_sign() * form.back().decided_sign() < 0) return true;
  RoughPolynomial left;  // by de Casteljau's triangle, whose other side is the right half
  for (std::size_t rest = form.size(); rest > 0; --rest) {
    left.push_back(form[0]);
    for (std::size_t i = 0; i + 1 < rest; ++i) form[i] = mean(form[i], form[i + 1]);
  }
  return may_vanish(std::move(left), halvings - 1) || may_vanish(std::move(form), halvings - 1);
}

}  // namespace

RealBall brought_back(const RealBall& ball) {
  int places = 0;
  std::frexp(std::max(std::abs(ball.middle), ball.radius), &places);
  return {std::ldexp(ball.middle, -places), std::ldexp(ball.radius, -places), ball.exponent + places};
}

bool may_have_root(const RoughPolynomial& polynomial, RayPart part) {
  if (polynomial.empty() || polynomial.size() > greatest_degree + 1) return true;
  if (may_vanish(bernstein(polynomial), most_halvings)) return true;
  if (part == RayPart::to_one) return false;
  RoughPolynomial beyond = polynomial;  // a root t beyond one is a root 1/t of the coefficients backwards
  std::ranges::reverse(beyond);
  return may_vanish(bernstein(beyond), most_halvings);
}

}  // namespace durero::written
