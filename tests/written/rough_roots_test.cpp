// Roots by about 50 bits: what is said to have none has none, and little is left open.
#include "written/rough_roots.hpp"

#include <algorithm>

#include "durero/algebra/root.hpp"
#include "support/catch.hpp"
#include "support/scenes.hpp"

namespace durero::written {
namespace {

using number::Dyadic;
using number::RealBall;

RoughPolynomial roughly(const algebra::Polynomial& polynomial) {
  RoughPolynomial rough;
  for (const Dyadic& each : polynomial) rough.emplace_back(each);
  return rough;
}

/// c times the product of t − r for each root r and of (t − a)² + b² for each pair.
algebra::Polynomial with_roots(const std::vector<double>& roots, const std::vector<std::pair<double, double>>& pairs) {
  algebra::Polynomial product{Dyadic(3.0)};
  const auto times = [&](const algebra::Polynomial& factor) {
    algebra::Polynomial result(product.size() + factor.size() - 1);
    for (std::size_t i = 0; i < product.size(); ++i)
      for (std::size_t j = 0; j < factor.size(); ++j) result[i + j] += product[i] * factor[j];
    product = result;
  };
  for (const double root : roots) times({Dyadic(-root), Dyadic(1.0)});
  for (const auto& [a, b] : pairs) times({Dyadic(a * a + b * b), Dyadic(-2 * a), Dyadic(1.0)});
  return product;
}

TEST_CASE("A polynomial without a root on a part has one nowhere there, and most such are found") {
  test::Random random(3);
  std::size_t without = 0, found = 0;
  for (int turn = 0; turn < 4000; ++turn) {
    std::vector<double> roots;
    std::vector<std::pair<double, double>> pairs;
    const double scale = std::ldexp(1.0, static_cast<int>(random.uniform(-60, 60)));
    for (int i = 0; i < 2; ++i) {
      const double middle = static_cast<float>(scale * random.uniform(-3, 3));
      const double beside = static_cast<float>(scale * random.uniform(0.01, 2));
      if (random.uniform(0, 1) < 0.3)
        roots.push_back(middle);
      else
        pairs.emplace_back(middle, beside);
    }
    const algebra::Polynomial polynomial = with_roots(roots, pairs);
    for (const RayPart part : {RayPart::to_one, RayPart::whole}) {
      const bool has_root =
          std::ranges::any_of(roots, [&](double t) { return t > 0 && (t < 1 || part == RayPart::whole); });
      const bool may = may_have_root(roughly(polynomial), part);
      if (has_root) REQUIRE(may);
      without += !has_root;
      found += !has_root && !may;
    }
  }
  CAPTURE(without, found);
  CHECK(without > 3000);
  CHECK(2 * found > without);
}

TEST_CASE("A double root, one at an end, and a polynomial that is 0 are left to exact numbers") {
  for (const RayPart part : {RayPart::to_one, RayPart::whole}) {
    CHECK(may_have_root(roughly(with_roots({0.375, 0.375}, {})), part));
    CHECK(may_have_root(roughly(with_roots({1}, {})), part));
    CHECK(may_have_root({RealBall(0.0), RealBall(0.0)}, part));
    CHECK(may_have_root({}, part));
    CHECK_FALSE(may_have_root(roughly(with_roots({-2}, {})), part));
    CHECK(may_have_root(RoughPolynomial(12, RealBall(1.0)), part));  // of a degree that is not asked
  }
  CHECK(may_have_root(roughly(with_roots({1e30}, {})), RayPart::whole));
  CHECK_FALSE(may_have_root(roughly(with_roots({1e30}, {})), RayPart::to_one));
}

TEST_CASE("A ball that is brought back is the same ball, of no great middle or radius") {
  for (const RealBall& ball :
       {RealBall(0x1p60, 3, 7), RealBall(0x1p-60, 0x1p-90, 0), RealBall(0, 0x1p9, 1), RealBall(0.0)}) {
    const RealBall same = brought_back(ball);
    CHECK(std::abs(same.middle) <= 1);
    CHECK(same.radius <= 1);
    const int shift = static_cast<int>(same.exponent - ball.exponent);
    CHECK(std::ldexp(same.middle, shift) == ball.middle);
    CHECK(std::ldexp(same.radius, shift) == ball.radius);
  }
}

}  // namespace
}  // namespace durero::written
