#include "durero/accel/volume/slabs.hpp"

#include <cmath>
#include <glm/geometric.hpp>

#include "durero/number/rational.hpp"
#include "durero/scene/shapes.hpp"
#include "support/catch.hpp"
#include "support/sanitized.hpp"
#include "support/scenes.hpp"
#include "support/shapes.hpp"

using namespace durero;
using namespace durero::test;
using accel::BoxInterval;
using accel::Projection;
using accel::Projections;
using accel::Slab;
using accel::Slabs;
using number::exact;
using number::Rational;

namespace {

Rational dot(const glm::dvec3& a, const glm::dvec3& b) {
  return exact(a.x) * exact(b.x) + exact(a.y) * exact(b.y) + exact(a.z) * exact(b.z);
}

BoxInterval within(const glm::dvec3& n, const Slab& slab, const glm::dvec3& p, const glm::dvec3& v) {
  return Projection(n, trace::Ray(ray(p, v))).within(slab);
}

/// Of two slabs in the plane, across x and across y.
BoxInterval of_figure(const glm::dvec3& p, const glm::dvec3& v) {
  return stretch(Slabs{{{1, 2}, {1, 2}}}, Projections(trace::Ray(ray(p, v)), 2));
}

}  // namespace

TEST_CASE("the rays of figure 7: one between no two pairs of planes at once, one from B1 to A2") {
  CHECK_FALSE(of_figure({0, 2.5, 0}, {1, 1, 0}).meets());
  const BoxInterval second = of_figure({0, -0.5, 0}, {1, 1, 0});  // across x at 1 and 2, across y at 1.5 and 2.5
  CHECK(second.meets());
  CHECK(second.entry == Approx(1.5));
  CHECK(second.exit == Approx(2));
}

TEST_CASE("the stretch holds the exact interval, and little more") {
  Random random(1);
  std::size_t doubtful = 0;
  for (std::size_t i = 0; i < fewer_when_sanitized(20000); ++i) {
    const glm::dvec3 n = i % 2 == 0 ? accel::slab_directions(13)[i % 13] : random.direction();
    const double far = random.chance(1, 3) ? 0x1p30 : 2;
    const glm::dvec3 p = random.in_cube(far), v = random.in_cube(1);
    const double a = random.uniform(-1, 1);
    const Slab slab{a - 0x1p-50 * std::abs(a), a + 0.25};
    const BoxInterval found = within(n, slab, p, v);
    const Rational S = dot(n, p), speed = dot(n, v);
    if (speed == 0) continue;
    Rational entry = (exact(a) - S) / speed, exit = (exact(a) + Rational(1, 4) - S) / speed;
    if (exit < entry) std::swap(entry, exit);
    if (entry < 0) entry = 0;
    if (exit < 0) {
      CHECK(found.exit < found.entry * 2);
      continue;
    }
    REQUIRE(exact(found.entry) <= entry);
    REQUIRE(exact(found.exit) >= exit);
    if (found.exit == accel::never) {
      ++doubtful;
      continue;
    }
    const Rational slack = (exact(far) * Rational(1, 1LL << 44)) / abs(speed) + exit * Rational(1, 1LL << 30);
    CHECK(exact(found.entry) > entry - slack);
    CHECK(exact(found.exit) < exit + slack);
  }
  CHECK(doubtful < 10);
}

TEST_CASE("planes that the ray touches exactly are met, however its numbers are rounded") {
  Random random(2);
  for (std::size_t i = 0; i < fewer_when_sanitized(20000); ++i) {
    const std::size_t k = random.below(13);
    const glm::dvec3 n = accel::slab_directions(13)[k], w = random.in_cube(1), v = random.in_cube(1);
    const glm::dvec3 p = w - v * double(random.integer(1, 1000));
    // The plane through the point where the ray is at some t, on either side, by exact arithmetic and rounded outwards.
    const Rational t(random.integer(1, 2000), 2), at = dot(n, p) + t * dot(n, v);
    const double rounded = number::round_to_binary64(at);
    const double above = std::nextafter(rounded, 10.0), below = std::nextafter(rounded, -10.0);
    for (const Slab& slab :
         {Slab{below - 0x1p-50 * std::abs(below), below + 3}, Slab{above - 3, above + 0x1p-50 * std::abs(above)}}) {
      const BoxInterval found = within(n, slab, p, v);
      REQUIRE(exact(found.entry) <= t);
      REQUIRE(exact(found.exit) >= t);
    }
  }
}

TEST_CASE(
    "a ray between the planes and parallel to them is not cut; one outside never meets them; zeros have no sign") {
  for (const double zero : {0.0, -0.0}) {
    const BoxInterval inside = within({1, 0, 0}, {-1, 1}, {zero, 5, 5}, {zero, 1, 0});
    CHECK(inside.entry == 0);
    CHECK(inside.exit == accel::never);
    CHECK(within({1, 0, 0}, {-1, 1}, {1, 5, 5}, {zero, 1, 0}).meets());
    CHECK_FALSE(within({1, 0, 0}, {-1, 1}, {2, 5, 5}, {zero, 1, 0}).meets());
    CHECK_FALSE(within({1, 0, 0}, {-1, 1}, {-2, 5, 5}, {zero, 1, 0}).meets());
    CHECK(within({1, 1, 0}, {0, 1}, {0, 0, 0}, {1, -1, zero}).meets());
    CHECK(within({1, 1, 0}, {2, 3}, {zero, zero, 0}, {1, -1, zero}).entry > 0x1p48);  // as nearly as can be told
  }
}

TEST_CASE("a slab behind the ray is not met") {
  CHECK_FALSE(within({1, 0, 0}, {-1, 1}, {2, 0, 0}, {1, 0, 0}).meets());
  CHECK_FALSE(within({1, 0, 0}, {-1, 1}, {-2, 0, 0}, {-1, 0, 0}).meets());
  CHECK(within({1, 0, 0}, {-1, 1}, {2, 0, 0}, {-1, 0, 0}).meets());
}

TEST_CASE("slabs that are moved hold the moved element as tightly as slabs made anew") {
  Random random(3);
  for (int i = 0; i < 200; ++i) {
    const scene::Sphere sphere{random.in_cube(1), 0.5};
    const glm::dvec3 delta = random.lattice_vector(8);
    const scene::Sphere moved{sphere.centro + delta, 0.5};
    const Slabs by_shift = slabs_around(accel::outline(sphere), 13).moved(delta);
    const Slabs anew = slabs_around(accel::outline(moved), 13);
    for (std::size_t k = 0; k < 13; ++k) {
      const glm::dvec3 n = accel::slab_directions(13)[k];
      const double reach = 0.5 * std::sqrt(glm::dot(n, n)) * (1 - 0x1p-50);
      CHECK(exact(by_shift.along[k].low) <= dot(n, moved.centro) - exact(reach));
      CHECK(exact(by_shift.along[k].high) >= dot(n, moved.centro) + exact(reach));
      CHECK(std::abs(by_shift.along[k].low - anew.along[k].low) < 1e-11);
      CHECK(std::abs(by_shift.along[k].high - anew.along[k].high) < 1e-11);
    }
  }
}

TEST_CASE("an oriented box fits a cylinder across the axes of space twice as well as a box along them") {
  const double half = std::sqrt(0.5);
  const accel::Outline around = accel::outline(scene::Cylinder{{0, 0, 0}, 0.25, {half, half, 0}, 4});
  const accel::OrientedBox box = oriented_box_around(around);
  double volume = 1;
  for (std::size_t i = 0; i < 3; ++i) volume *= (box.along[i].high - box.along[i].low) / glm::length(box.normal[i]);
  CHECK(volume == Approx(4 * 0.5 * 0.5));
  const Slabs along = slabs_around(around, 3);
  double upright = 1;
  for (const Slab& slab : along.along) upright *= slab.high - slab.low;
  CHECK(upright / volume > 1.5);
}
