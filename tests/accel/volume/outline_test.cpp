#include "durero/accel/volume/outline.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "durero/scene/shapes.hpp"
#include "support/catch.hpp"

using namespace durero;
using accel::Outline;
using accel::outline;
using accel::Slab;
using std::numbers::pi;

namespace {

/// The extent holds from low to high, and not much more.
void check_extent(const Outline& outline, const glm::dvec3& n, double low, double high) {
  const Slab slab = outline.extent(n);
  CHECK(slab.low <= low);
  CHECK(slab.high >= high);
  const double slack = 1e-5 * glm::length(n);  // a disc's on edge is 2⁻²³·⁵ of its radius
  CHECK(slab.low > low - slack);
  CHECK(slab.high < high + slack);
}

}  // namespace

TEST_CASE("extents are those of the element along any direction") {
  const Outline ball = outline(scene::Sphere{{1, 2, 3}, 5});
  check_extent(ball, {1, 0, 0}, -4, 6);
  check_extent(ball, {0, 3, 4}, 18 - 25, 18 + 25);
  const Outline wheel = outline(scene::Cylinder{{0, 0, -1}, 5, {0, 0, 1}, 2});
  check_extent(wheel, {0, 0, 1}, -1, 1);
  check_extent(wheel, {0, 1, 0}, -5, 5);
  check_extent(wheel, {3, 4, 0}, -25, 25);
  check_extent(wheel, {0, 4, 3}, -20 - 3, 20 + 3);
  const Outline cone = outline(scene::Cone{{0, 0, 0}, 0.5, {1, 0, 0}, 4});
  check_extent(cone, {1, 0, 0}, 0, 4);
  check_extent(cone, {0, 1, 0}, -2, 2);
  check_extent(cone, {3, 4, 0}, -8, 12);
  const Outline truncated = outline(scene::TruncatedCone{{0, 0, 0}, 1, 0.5, {0, 1, 0}, 4});
  check_extent(truncated, {1, 0, 0}, -3, 3);
  check_extent(truncated, {0, -1, 0}, -4, 0);
  const Outline disc = outline(scene::Disc{{0, 0, 7}, 5, {0, 0, 1}});
  check_extent(disc, {0, 0, 1}, 7, 7);
  check_extent(disc, {1, 0, 0}, -5, 5);
  check_extent(outline(scene::Triangle{{{{0, 0, 0}, {3, 0, 0}, {0, 4, 1}}}}), {1, 1, 1}, 0, 5);
}

TEST_CASE("surfaces and projections are those of the hull") {
  const Outline ball = outline(scene::Sphere{{1, 2, 3}, 2});
  CHECK(ball.surface() == Approx(16 * pi));
  CHECK(ball.projected({0, 0, 1}) == Approx(4 * pi));
  const Outline cylinder = outline(scene::Cylinder{{0, 0, -1}, 2, {0, 0, 1}, 3});
  CHECK(cylinder.surface() == Approx(2 * pi * 4 + 4 * pi * 3));
  CHECK(cylinder.projected({0, 0, 1}) == Approx(4 * pi));
  CHECK(cylinder.projected({0, 1, 0}) == 12);
  CHECK(cylinder.projected({0, 0.6, 0.8}) == Approx(4 * pi * 0.8 + 12 * 0.6));
  const Outline cone = outline(scene::Cone{{0, 0, 0}, 0.5, {1, 0, 0}, 4});
  CHECK(cone.surface() == Approx(4 * pi + 2 * pi * std::sqrt(20)));
  CHECK(cone.projected({0, 1, 0}) == Approx(8));
  CHECK(cone.projected({1, 0, 0}) == Approx(4 * pi));
  const Outline triangle = outline(scene::Triangle{{{{0, 0, 0}, {3, 0, 0}, {0, 4, 0}}}});
  CHECK(triangle.surface() == Approx(12));
  CHECK(triangle.projected({0, 0.6, 0.8}) == Approx(4.8));
  CHECK(outline(scene::Disc{{0, 0, 7}, 5, {0, 0, 1}}).projected({0, 0.6, 0.8}) == Approx(20 * pi));
}
