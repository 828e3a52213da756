#include "durero/accel/mosaic.hpp"

#include <map>
#include <numbers>
#include <optional>

#include "durero/accel/touch.hpp"
#include "durero/number/rational.hpp"
#include "durero/surface/exact.hpp"
#include "support/catch.hpp"
#include "support/sanitized.hpp"
#include "support/scenes.hpp"
#include "support/shapes.hpp"

using namespace durero;
using namespace durero::test;
using accel::encloses;
using accel::Filling;
using accel::has_point_in;
using accel::Mosaic;
using accel::Voxel;
using number::Rational;
using surface::Box;

namespace {

/// How many of the finest cubes hold a point of a surface, and how many more lie inside a sphere.
struct Filled {
  std::uint64_t surface = 0, inside = 0;
};

Filled filled(const Mosaic& mosaic) {
  Filled sum;
  mosaic.for_each([&](const Voxel& voxel) {
    const auto side = static_cast<std::uint64_t>(mosaic.side(voxel));
    (voxel.surface.empty() ? sum.inside : sum.surface) += side * side * side;
  });
  return sum;
}

/// The surfaces of every finest cube of a mosaic that has one, by the number of the cube.
std::map<std::size_t, std::vector<std::uint32_t>> surfaces(const Mosaic& mosaic) {
  std::map<std::size_t, std::vector<std::uint32_t>> of;
  mosaic.for_each([&](const Voxel& voxel) {
    if (!voxel.surface.empty()) of[mosaic.finest().number(voxel.corner)] = {voxel.surface.begin(), voxel.surface.end()};
  });
  return of;
}

using RationalPoint = std::array<Rational, 3>;

/// What lies on one side of a plane across an axis, of a convex polygon.
std::vector<RationalPoint> clipped(const std::vector<RationalPoint>& polygon, int axis, const Rational& plane,
                                   int side) {
  std::vector<RationalPoint> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const RationalPoint &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const Rational to_a = (a[axis] - plane) * side, to_b = (b[axis] - plane) * side;
    if (to_a >= 0) kept.push_back(a);
    if (to_a * to_b >= 0) continue;
    RationalPoint crossing;
    for (int i3 = 0; i3 < 3; ++i3) crossing[i3] = a[i3] + (b[i3] - a[i3]) * (to_a / (to_a - to_b));
    kept.push_back(crossing);
  }
  return kept;
}

/// What is left of a triangle within a box is not nothing: it knows of no plane that parts two bodies.
bool has_rational_point(const scene::Triangle& triangle, const Box& box) {
  std::vector<RationalPoint> polygon;
  for (const glm::dvec3& w : triangle.vertices)
    polygon.push_back({number::exact(w.x), number::exact(w.y), number::exact(w.z)});
  for (int axis = 0; axis < 3; ++axis) {
    polygon = clipped(polygon, axis, number::exact(box.low[axis]), 1);
    polygon = clipped(polygon, axis, number::exact(box.high[axis]), -1);
  }
  return !polygon.empty();
}

bool holds(const Box& box, const model::Rayo& rayo, const surface::exact::Parameter& t) {
  for (int axis = 0; axis < 3; ++axis) {
    const auto x = number::linear(rayo.p().xyz()[axis], rayo.v().xyz()[axis], t);
    if (x < surface::exact::Parameter{box.low[axis]} || surface::exact::Parameter{box.high[axis]} < x) return false;
  }
  return true;
}

}  // namespace

// The cubes of side h that a sphere of radius r has a point in lie between the spheres of radius r ± √3·h, whose
// volumes differ by 8√3π(r²h + h³); so much at most is between the volume inside, and that together with those cubes.
TEST_CASE("the filled volume of a solid sphere goes to 4πr³/3, and what is in doubt is halved at each level") {
  const double r = 0.8, pi = std::numbers::pi, exact = 4 * pi * r * r * r / 3;
  scene::Scene scene;
  add(scene, scene::Sphere{{0.3, -0.1, 5}, r});
  double before = 0;
  for (int depth = 1; depth <= 7; ++depth) {
    const Mosaic mosaic(scene, depth, Filling::solid);
    const double h = mosaic.finest().h;
    const Filled cubes = filled(mosaic);
    const double inside = static_cast<double>(cubes.inside) * h * h * h;
    const double cut = static_cast<double>(cubes.surface) * h * h * h;
    INFO("depth " << depth << ": inside " << inside << ", cut " << cut);
    CHECK(inside < exact);
    CHECK(exact < inside + cut);
    CHECK(cut <= 8 * std::sqrt(3) * pi * (r * r * h + h * h * h));
    if (depth > 3) CHECK(std::abs(before / cut - 2) < 0.2);
    before = cut;
    CHECK(filled(Mosaic(scene, depth, Filling::surface)).surface == cubes.surface);
    CHECK(filled(Mosaic(scene, depth, Filling::surface)).inside == 0);
  }
}

TEST_CASE("a mosaic is made of the octree's cubes that elements touch, named by their octal codes") {
  for (std::uint64_t seed = 1; seed <= fewer_when_sanitized(30); ++seed) {
    Random random(seed);
    const scene::Scene scene = random_scene(random, 6);
    const int depth = 4;
    const Mosaic mosaic(scene, depth, Filling::surface);
    const accel::Octree octree(scene, {.max_depth = depth, .max_objects = 0, .max_bytes = std::size_t{1} << 30});
    REQUIRE(octree.finest() == mosaic.finest());
    std::string last;
    mosaic.for_each([&](const Voxel& voxel) {
      REQUIRE(last < voxel.code);
      last = voxel.code;
      REQUIRE(voxel.code.size() == depth);
      for (int level = 1; level <= depth; ++level)
        REQUIRE(octree.octal_digit(voxel.corner, level) == static_cast<unsigned>(voxel.code[level - 1] - '0'));
    });
    const auto own = surfaces(mosaic);
    std::size_t touched = 0;
    for (std::size_t leaf = 0; leaf < octree.leaves().size(); ++leaf) {
      const auto list = octree.lists()[leaf];
      if (list.empty()) continue;
      const auto found = own.find(octree.finest().number(octree.leaves()[leaf].corner));
      touched += found != own.end();
      for (const std::uint32_t number : list) {
        const scene::ElementRef e = mosaic.contents().elements[number];
        const bool is_there = found != own.end() && std::ranges::binary_search(found->second, number);
        const bool has_point =
            scene.visit(e, [&](const auto& shape) { return has_point_in(shape, octree.box(octree.leaves()[leaf])); });
        REQUIRE(is_there == has_point);
        REQUIRE((is_there || accel::is_exact_in_mosaics(e.tipo)));
      }
    }
    REQUIRE(touched == own.size());
  }
}

TEST_CASE("a sphere has a point in a box, or encloses it, to the last bit") {
  const double more = std::nextafter(5.0, 6), less = std::nextafter(5.0, 4);
  const glm::dvec3 at(7, -2, 1);
  const Box outside{at + glm::dvec3(3, 4, 0), at + glm::dvec3(4, 9, 1)};
  const Box within{at + glm::dvec3(-1, -1, -0.5), at + glm::dvec3(3, 4, 0)};
  CHECK(has_point_in(scene::Sphere{at, 5}, outside));
  CHECK(has_point_in(scene::Sphere{at, more}, outside));
  CHECK_FALSE(has_point_in(scene::Sphere{at, less}, outside));
  CHECK(accel::touches(scene::Sphere{at, less}, outside));  // which need not be as exact
  const Box whole{at - glm::dvec3(3, 4, 0), at + glm::dvec3(3, 4, 0)};
  CHECK(has_point_in(scene::Sphere{at, 5}, whole));
  CHECK_FALSE(encloses(scene::Sphere{at, 5}, whole));
  CHECK_FALSE(has_point_in(scene::Sphere{at, more}, whole));
  CHECK(encloses(scene::Sphere{at, more}, whole));
  CHECK_FALSE(encloses(scene::Sphere{at, less}, whole));
  CHECK(encloses(scene::Sphere{at, 6}, within));
  CHECK_FALSE(encloses(scene::Cylinder{at - glm::dvec3(0, 0, 9), 6, {0, 0, 1}, 20}, within));
}

TEST_CASE("a triangle has a point in a box where something is left of it within the box") {
  Random random(1);
  std::size_t meeting = 0, close = 0, all = fewer_when_sanitized(20000);
  for (std::size_t i = 0; i < all; ++i) {
    const bool is_whole = random.chance(1, 2);
    const auto corner = [&] { return is_whole ? random.lattice_vector(3) : random.in_cube(2); };
    const scene::Triangle triangle{{corner(), corner(), corner()}};
    if (!model::Vertices::contains({model::Punto(triangle.vertices[0]), model::Punto(triangle.vertices[1]),
                                    model::Punto(triangle.vertices[2])}))
      continue;
    const glm::dvec3 low = corner();
    const Box box{low, low + (is_whole ? glm::dvec3(1) : glm::dvec3(0.5))};
    const bool expected = has_rational_point(triangle, box);
    INFO("triangle " << i);
    REQUIRE(has_point_in(triangle, box) == expected);
    meeting += expected;
    // An ulp beyond what it touches.
    Box moved = box;
    for (int axis = 0; axis < 3; ++axis) moved.low[axis] = std::nextafter(moved.low[axis], 9.0);
    REQUIRE(has_point_in(triangle, moved) == has_rational_point(triangle, moved));
    close += accel::touches(triangle, moved) && !has_rational_point(triangle, moved);
  }
  CHECK(meeting > all / 50);
  CHECK(close > all / 200);
}

TEST_CASE("what a ray meets lies in a cube of the mosaic, and no farther than that is the first one of the ray") {
  std::size_t hits = 0, before = 0;
  for (std::uint64_t seed = 1; seed <= fewer_when_sanitized(30); ++seed) {
    Random random(seed);
    const scene::Scene scene = random_scene(random, 4);
    const Mosaic mosaic(scene, 5, Filling::surface);
    const accel::Lattice& finest = mosaic.finest();
    const auto filled = surfaces(mosaic);
    for (int i = 0; i < 100; ++i) {
      const model::Rayo rayo = random_ray(random);
      const auto met = surface::exact::all_hits(scene, rayo);
      const auto first = std::ranges::find_if(met, [&](const auto& crossing) {
        return std::ranges::binary_search(mosaic.contents().elements, crossing.elemento);
      });
      if (first == met.end() || !first->segment.begin) continue;
      ++hits;
      std::size_t cubes = 0, holding = 0;
      accel::walk(accel::AxisRay(trace::Ray(rayo)), finest, [&](const accel::Cell& cell, const accel::PlaneCrossing&) {
        const auto found = filled.find(finest.number(cell));
        if (found == filled.end()) return false;
        ++cubes;
        holding = holds(finest.box(cell), rayo, *first->segment.begin);
        if (holding == 0) return false;
        const auto names = [&](std::uint32_t e) { return mosaic.contents().elements[e] == first->elemento; };
        REQUIRE(std::ranges::any_of(found->second, names));
        return true;
      });
      INFO("seed " << seed << ", ray " << i);
      REQUIRE(holding == 1);
      before += cubes > 1;
    }
  }
  CHECK(hits > fewer_when_sanitized(500));
  CHECK(before > hits / 10);  // surfaces that lie beside the ray
}

TEST_CASE("a mosaic has a depth that its numbers hold, and leaves out what has no bound") {
  scene::Scene scene;
  CHECK_THROWS_AS(Mosaic(scene, -1, Filling::solid), std::invalid_argument);
  CHECK_THROWS_AS(Mosaic(scene, Mosaic::deepest + 1, Filling::solid), std::invalid_argument);
  CHECK(filled(Mosaic(scene, 3, Filling::solid)).surface == 0);
  const scene::ElementRef floor = add(scene, scene::Plane{{0, 0, 0}, {0, 0, 1}});
  CHECK(filled(Mosaic(scene, 3, Filling::solid)).surface == 0);
  CHECK(Mosaic(scene, 3, Filling::solid).contents().apart == std::vector{floor});
  add(scene, scene::Sphere{{0, 0, 0}, 1});
  const Mosaic whole(scene, 0, Filling::solid);
  whole.for_each([&](const Voxel& voxel) {
    CHECK(voxel.code.empty());
    CHECK(whole.box(voxel).low == whole.finest().low);
  });
  CHECK(filled(whole).surface == 1);
  // Two spheres, one in the other: cubes between both are inside one, the middle inside both.
  add(scene, scene::Sphere{{0, 0, 0}, 0.5});
  std::size_t one = 0, both = 0;
  const Mosaic nested(scene, 6, Filling::solid);
  nested.for_each([&](const Voxel& voxel) {
    if (voxel.surface.empty()) ++(voxel.inside.size() == 2 ? both : one);
    if (voxel.inside.size() == 2) CHECK(voxel.inside[0] < voxel.inside[1]);
    for (const std::uint32_t e : voxel.inside)
      scene.visit(nested.contents().elements[e], [&](const auto& shape) { CHECK(encloses(shape, nested.box(voxel))); });
  });
  CHECK(one > 0);
  CHECK(both > 0);
}
