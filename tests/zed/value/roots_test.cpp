#include "durero/zed/value/roots.hpp"

#include <vector>

#include "support/catch.hpp"

namespace durero::zed {
namespace {

Polynomial polynomial(Real constant, Real slope, Real square) {
  return {std::move(constant), std::move(slope), std::move(square), 0};
}

TEST_CASE("roots are exact, ascend, and stand there once") {
  const std::vector<Polynomial> some = {polynomial(-2, 0, 1), polynomial(6, -3, 0), polynomial(4, -4, 1),
                                        polynomial(1, 0, 1)};
  const auto found = roots(some);
  REQUIRE(found);
  CHECK(*found == Cuts{-square_root(Real(2)), square_root(Real(2)), 2});
}

TEST_CASE("a constant has no root, and a square with irrational coefficients has none that is told") {
  CHECK(roots(std::vector{polynomial(3, 0, 0)}) == Cuts{});
  CHECK_FALSE(roots(std::vector{polynomial(square_root(Real(2)), 0, -1)}));
  CHECK(roots(std::vector{polynomial(square_root(Real(2)), -1, 0)}) == Cuts{square_root(Real(2))});
}

TEST_CASE("numbers below, above and between, however near and large") {
  const Real root = square_root(Real(2)), far = Real(1e300), near = Real(1) + Real(1e-300);
  CHECK(floor_of(root) == 1);
  CHECK(floor_of(-root) == -2);
  CHECK(floor_of(Real(-3)) == -3);
  for (const Real& number : {root, -root, far, -far, Real(0), Real(-7)}) {
    CHECK(below(number) < number);
    CHECK(above(number) > number);
  }
  for (const auto& [low, high] : {std::pair{Real(1), near}, std::pair{root, Real(1.5)}, std::pair{-far, far}}) {
    const Real middle = between(low, high);
    CHECK(low < middle);
    CHECK(middle < high);
  }
}

}  // namespace
}  // namespace durero::zed
