// Relations between answers that hold exactly by construction: what is done to the scene and the ray is done to the
// answer, and no number is rounded on the way.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include "changed.hpp"
#include "durero/surface/exact.hpp"
#include "durero/trace/analytic.hpp"
#include "hits.hpp"
#include "support/catch.hpp"
#include "support/shapes.hpp"

using namespace durero;
using namespace durero::test;
using conform::Case;
using conform::Family;
using conform::Random;

namespace {

/// Rounded at the precision of 53 bits, which a scaling keeps.
bool of_normal_numbers(const scene::Hit& hit) {
  const auto normal = [](double x) { return x == 0 || std::isnormal(x); };
  if (hit.resultado == model::Resultado::hit && hit.t == 0) return false;  // t > 0, too small for a binary64
  return normal(hit.t) && normal(hit.punto.x) && normal(hit.punto.y) && normal(hit.punto.z);
}

/// Both engines on both sides; equal as numbers, since −0 and +0 are one coordinate. Answers how many were compared:
/// not where a number of the scene, the ray or the answer could not be scaled exactly.
std::size_t compare(const Family& family, std::uint64_t seed, const Case& of, const Change& by, Scaling& scaling) {
  const scene::Scene other = changed(of.scene, by);
  if (!scaling.exact) return 0;
  std::size_t compared = 0;
  for (std::size_t i = 0; i < of.rays.size(); ++i) {
    scaling.exact = true;
    const scene::Hit before = surface::exact::first_hit(of.scene, of.rays[i].rayo, of.rays[i].en);
    const scene::Hit expected = changed(before, by);
    const model::Rayo rayo = test::ray(by.point(of.rays[i].rayo.p().xyz()), by.direction(of.rays[i].rayo.v().xyz()));
    if (!scaling.exact || !of_normal_numbers(before)) continue;
    const scene::Hit exact = surface::exact::first_hit(other, rayo, of.rays[i].en);
    const scene::Hit analytic = trace::first_hit(other, rayo, of.rays[i].en);
    ++compared;
    if (exact == expected && analytic == expected) continue;
    INFO(replay(family, seed, of.rays.size(), i));
    INFO("expected " << text(expected) << "\nexact    " << text(exact) << "\nanalytic " << text(analytic));
    CHECK(false);
  }
  return compared;
}

/// Each change on scenes of every family; the number of answers compared.
std::size_t on_every_family(const std::function<Change(Random&, Scaling&)>& some_change) {
  std::size_t compared = 0;
  for (const Family& family : conform::families_of_few()) {
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
      Random random(seed);
      Scaling scaling;
      const Case made = generate(family, seed, 40);
      const Change change = some_change(random, scaling);
      compared += compare(family, seed, made, change, scaling);
    }
  }
  return compared;
}

std::pair<scene::Scene, scene::ElementRef> alone_in_scene(const scene::Scene& scene, scene::ElementRef e) {
  scene::Scene alone;
  const scene::ElementRef only = scene.visit(e, [&](const auto& shape) { return add(alone, shape); });
  return {alone, only};
}

/// Of the ray that starts on the element.
surface::exact::Coefficients coefficients_of(const scene::Scene& scene, scene::ElementRef e, const model::Rayo& rayo) {
  return scene.visit(e, [&](const auto& shape) { return surface::exact::coefficients(shape, rayo, true); });
}

using Order = std::array<int, 3>;
constexpr std::array<Order, 6> orders{{{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};

scene::Scene with_vertices_in_order(const scene::Scene& of, const Order& order) {
  scene::Scene other;
  of.for_each([&]<class Shape>(scene::ElementRef, const Shape& shape) {
    Shape copy = shape;
    if constexpr (std::is_same_v<Shape, scene::Triangle>)
      for (std::size_t i = 0; i < 3; ++i) copy.vertices[i] = shape.vertices[static_cast<std::size_t>(order[i])];
    add(other, copy);
  });
  return other;
}

}  // namespace

TEST_CASE("every length times 2^k: the same t, the point times 2^k") {
  CHECK(on_every_family(
            [](Random& random, Scaling& scaling) { return scaled_whole(scaling, random.integer(-40, 40)); }) > 8000);
}

TEST_CASE("v times 2^k: t times 2^-k, the same point") {
  CHECK(on_every_family([](Random& random, Scaling& scaling) {
          const int k = random.integer(-60, 60);
          return Change{same, unchanged, unchanged, [k, &scaling](const glm::dvec3& v) { return scaling(v, k); },
                        [k, &scaling](double t) { return scaling(t, -k); }};
        }) > 8000);
}

TEST_CASE("coordinates exchanged: the point's coordinates exchanged") {
  CHECK(on_every_family([](Random& random, Scaling&) {
          const Order order = orders[random.below(orders.size())];
          const auto exchange = [order](const glm::dvec3& v) {
            return glm::dvec3(v[order[0]], v[order[1]], v[order[2]]);
          };
          return Change{same, exchange, exchange, exchange, same};
        }) > 9000);
}

TEST_CASE("coordinates negated: the point's coordinates negated") {
  CHECK(on_every_family([](Random& random, Scaling&) {
          const double x = random.sign(), y = random.sign(), z = random.sign();
          const auto negate = [x, y, z](const glm::dvec3& v) { return glm::dvec3(x * v.x, y * v.y, z * v.z); };
          return Change{same, negate, negate, negate, same};
        }) > 9000);
}

TEST_CASE("the vertices of a triangle in another order: the same hits") {
  std::size_t compared = 0;
  for (const char* name : {"edge", "sliver", "coplanar"}) {
    for (std::uint64_t seed = 0; seed < 30; ++seed) {
      const Case made = generate(*conform::find_family(name), seed, 40);
      const scene::Scene other = with_vertices_in_order(made.scene, orders[seed % orders.size()]);
      for (const scene::Query& ray : made.rays) {
        const scene::Hit hit = surface::exact::first_hit(made.scene, ray.rayo, ray.en);
        ++compared;
        INFO(name << ", seed " << seed << ": " << text(ray));
        CHECK(identical(surface::exact::first_hit(other, ray.rayo, ray.en), hit));
        CHECK(identical(trace::first_hit(other, ray.rayo, ray.en), hit));
      }
    }
  }
  CHECK(compared > 3000);
}

TEST_CASE("the opposite ray from beyond meets the same points in the opposite order") {
  std::size_t compared = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Case made = generate(*conform::find_family("grid_snapped"), seed, 100);
    for (const scene::Query& ray : made.rays) {
      const auto there = surface::exact::all_hits(made.scene, ray.rayo);
      const model::Rayo opposite = test::ray(ray.rayo.p().xyz() + 128.0 * ray.rayo.v().xyz(), -ray.rayo.v().xyz());
      const auto back = surface::exact::all_hits(made.scene, opposite);
      // Grid scenes lie within 128 steps of every ray's origin, so t there is 128 − t here.
      for (const auto& crossing : there) {
        if (!crossing.segment.begin || !crossing.segment.end) continue;
        const auto mirrored = number::linear(128, -1, *crossing.segment.end);
        const bool found = std::any_of(back.begin(), back.end(), [&](const auto& other) {
          return other.elemento == crossing.elemento && other.segment.begin && *other.segment.begin == mirrored;
        });
        CHECK(found);
        ++compared;
      }
    }
  }
  CHECK(compared > 300);
}

TEST_CASE("what leaves a convex element outwards never meets it again, at any scale and from any place") {
  // A sphere is convex, and so are a cylinder and a cone as seen from outside: from a point that is named as the
  // origin, no ray comes back that goes away from the inside, to first order (B > 0) or to second (B = 0 < A).
  std::size_t tried = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const Case made = generate(*conform::find_family("on_surface"), seed, 60);
    for (const scene::Query& ray : made.rays) {
      for (const scene::ElementRef e : ray.en) {
        const auto [alone, only] = alone_in_scene(made.scene, e);
        for (const double way : {1.0, -1.0}) {
          const model::Rayo rayo = test::ray(ray.rayo.p().xyz(), way * ray.rayo.v().xyz());
          const auto f = coefficients_of(alone, only, rayo);
          const int slope = number::sign(f.B);
          if (slope < 0 || (slope == 0 && number::sign(f.A) <= 0)) continue;
          ++tried;
          INFO("seed " << seed << ": " << text(ray) << ", v times " << way);
          CHECK(trace::first_hit(alone, rayo, only) == scene::Hit{});
          CHECK_FALSE(trace::occluded(alone, rayo, only));
          CHECK(surface::exact::reach(alone, only, rayo, only).empty());
        }
      }
    }
  }
  CHECK(tried > 5000);
}
