#include "durero/composed/solid.hpp"

#include <algorithm>
#include <optional>

#include "composed/face.hpp"
#include "composed/random_solids.hpp"
#include "composed/solid_walk.hpp"
#include "durero/model/quadratic.hpp"
#include "support/catch.hpp"
#include "support/sanitized.hpp"

using namespace durero;
using namespace durero::test;
using composed::First;
using composed::SolidFigure;
using model::Rayo;
using number::Surd;
using Operation = scene::Compound::Operation;
using surface::exact::Segment;

namespace {

scene::Compound solid_of(const scene::Body& body) {
  if (const auto* const solid = std::get_if<scene::Compound>(&body.form)) return *solid;
  return {Operation::united, {body}};
}

scene::Body joined(Operation operation, std::vector<scene::Body> parts) {
  return {scene::Compound{operation, std::move(parts)}};
}
scene::Body sphere(glm::dvec3 c, double r) { return body_of(scene::Sphere{c, r}); }
scene::Body plane(glm::dvec3 c, glm::dvec3 d) { return body_of(scene::Plane{c, d}); }
scene::Body box(glm::dvec3 low, glm::dvec3 high) {
  return joined(Operation::intersected, {plane(low, {-1, 0, 0}), plane(low, {0, -1, 0}), plane(low, {0, 0, -1}),
                                         plane(high, {1, 0, 0}), plane(high, {0, 1, 0}), plane(high, {0, 0, 1})});
}

Rayo ray(glm::dvec3 p, glm::dvec3 v) { return {model::Punto(p), model::Vector(v)}; }

/// The first t, rounded; −1 on a miss, 0 without a least one.
double first_t(const scene::Body& body, const Rayo& rayo, bool on = false) {
  const First first = SolidFigure(solid_of(body)).first(rayo, on);
  return first.no_minimum ? 0 : first.t ? number::round_to_binary64(*first.t) : -1;
}

/// The ends of the stretches in the body, rounded; 0 for the origin, 99 where there is no end.
std::vector<double> stretches(const scene::Body& body, const Rayo& rayo) {
  std::vector<double> ends;
  for (const Segment& each : SolidFigure(solid_of(body)).inside(rayo, false)) {
    ends.push_back(each.begin ? number::round_to_binary64(*each.begin) : 0);
    ends.push_back(each.end ? number::round_to_binary64(*each.end) : 99);
  }
  return ends;
}

using Ends = std::vector<double>;

/// The roots t > 0 along a ray of what the text bounds a solid by, ascending, each once.
std::vector<Surd> roots_of(const model::Solido& solido, const Rayo& rayo, const model::Cuadricas& en) {
  std::vector<Surd> all;
  for (const model::Cuadrica& c : solido.cuadricas) {
    const auto value = [&](const model::ExactPoint& w) {
      return en.contains(c) ? model::valor(c, w) - model::valor(c, rayo.p()) : model::valor(c, w);
    };
    const auto q = model::restricted(value, rayo.p(), rayo.v());
    if (q.is_zero()) continue;
    for (Surd& t : model::roots(q))
      if (t > 0) all.push_back(std::move(t));
  }
  std::ranges::sort(all);
  const auto twice = std::ranges::unique(all);
  all.erase(twice.begin(), twice.end());
  return all;
}

/// A rational number between two surds, or beyond the last.
Surd between(const Surd& low, const std::optional<Surd>& high) {
  if (!high) return Surd(number::exact(number::round_to_binary64(low)) + 1);
  number::Rational from = number::exact(number::round_to_binary64(low)) - 1,
                   to = number::exact(number::round_to_binary64(*high)) + 1;
  for (;;) {
    const number::Rational middle = (from + to) / 2;
    if (Surd(middle) <= low)
      from = middle;
    else if (Surd(middle) >= *high)
      to = middle;
    else
      return Surd(middle);
  }
}

bool covers(const Segment& stretch, const Surd& t) {
  return (!stretch.begin || Surd(*stretch.begin) <= t) && (!stretch.end || t <= Surd(*stretch.end));
}

}  // namespace

TEST_CASE("a lens of two balls is entered and left where the balls are, and has their normals") {
  const scene::Body lens = joined(Operation::intersected, {sphere({0, 0, -3}, 5), sphere({0, 0, 3}, 5)});
  CHECK(first_t(lens, ray({0, 0, -9}, {0, 0, 1})) == 7);
  CHECK(first_t(lens, ray({0, 0, 0}, {0, 0, 1})) == 2);
  CHECK(first_t(lens, ray({0, 5, -9}, {0, 0, 1})) == -1);
  CHECK(stretches(lens, ray({0, 0, -9}, {0, 0, 1})) == Ends{7, 11});
  CHECK(stretches(lens, ray({0, 4, -9}, {0, 0, 1})) == Ends{9, 9});  // the rim, a point
  const SolidFigure figure(solid_of(lens));
  CHECK(figure.normal({0, 0, -2}) == glm::dvec3(0, 0, -1));
  CHECK(figure.normal({0, 0, 2}) == glm::dvec3(0, 0, 1));
  CHECK(figure.size() == 2);
  CHECK(figure.hides(ray({0, 0, -9}, {0, 0, 8}), false));
  CHECK_FALSE(figure.hides(ray({0, 0, -9}, {0, 0, 7}), false));
}

TEST_CASE("what is taken away has its surface turned") {
  const scene::Body bowl = joined(Operation::subtracted, {sphere({0, 0, 0}, 2), sphere({0, 0, 2}, 1)});
  CHECK(first_t(bowl, ray({0, 0, 9}, {0, 0, -1})) == 8);
  CHECK(SolidFigure(solid_of(bowl)).normal({0, 0, 1}) == glm::dvec3(0, 0, 1));
  CHECK(SolidFigure(solid_of(bowl)).normal({0, 0, -2}) == glm::dvec3(0, 0, -1));
  CHECK(stretches(bowl, ray({0, 0, 9}, {0, 0, -1})) == Ends{8, 11});
}

TEST_CASE("a face that two parts share is inside of their union") {
  const scene::Body both = joined(Operation::united, {box({0, 0, 0}, {1, 1, 1}), box({1, 0, 0}, {2, 1, 1})});
  CHECK(stretches(both, ray({-1, 0.5, 0.5}, {1, 0, 0})) == Ends{1, 3});
  CHECK(first_t(both, ray({0.5, 0.5, 0.5}, {1, 0, 0})) == 1.5);
  CHECK(first_t(both, ray({1, 0.5, -1}, {0, 0, 1})) == 1);  // along the shared face
  CHECK(first_t(both, ray({1, 0.5, 0.5}, {0, 0, 1})) == 0.5);
  CHECK(SolidFigure(solid_of(both)).size() == 7);
  CHECK(SolidFigure(solid_of(both)).normal({1, 0.5, 1}) == glm::dvec3(0, 0, 1));  // above the shared face
  const scene::Body common = joined(Operation::intersected, {box({0, 0, 0}, {1, 1, 1}), box({1, 0, 0}, {2, 1, 1})});
  CHECK(stretches(common, ray({-1, 0.5, 0.5}, {1, 0, 0})).empty());
}

TEST_CASE("nothing is left of a face where it is taken away, nor of a solid of itself") {
  const scene::Body left = joined(Operation::subtracted, {box({0, 0, 0}, {1, 1, 1}), box({0, 0, 0}, {1, 1, 0.5})});
  CHECK(first_t(left, ray({0.5, 0.5, -1}, {0, 0, 1})) == 1.5);
  const scene::Body none = joined(Operation::subtracted, {sphere({0, 0, 0}, 1), sphere({0, 0, 0}, 1)});
  CHECK(first_t(none, ray({0, 0, -2}, {0, 0, 1})) == -1);
  CHECK(stretches(none, ray({-1, 1, 0}, {1, 0, 0})).empty());
}

TEST_CASE("balls that touch: a point of the surface of the union, and all of the intersection") {
  const std::vector<scene::Body> balls{sphere({0, 0, 0}, 1), sphere({2, 0, 0}, 1)};
  CHECK(stretches(joined(Operation::united, balls), ray({-2, 0, 0}, {1, 0, 0})) == Ends{1, 5});
  CHECK(first_t(joined(Operation::united, balls), ray({0, 0, 0}, {1, 0, 0})) == 1);
  CHECK(stretches(joined(Operation::intersected, balls), ray({-2, 0, 0}, {1, 0, 0})) == Ends{3, 3});
  CHECK(first_t(joined(Operation::intersected, balls), ray({1, -2, 0}, {0, 1, 0})) == 2);
}

TEST_CASE("all points on a stretch: of a union those outside, and none where the ray runs along a face") {
  using surface::exact::RayStretch;
  const auto all = [](const scene::Body& body, const Rayo& rayo, RayStretch stretch) -> std::optional<Ends> {
    const auto met = SolidFigure(solid_of(body)).parameters(rayo, false, stretch);
    if (!met) return std::nullopt;
    Ends t;
    for (const auto& each : *met) t.push_back(number::round_to_binary64(each));
    return t;
  };
  const scene::Body two = joined(Operation::united, {sphere({0, 0, 0}, 1), sphere({1, 0, 0}, 1)});
  CHECK(all(two, ray({-3, 0, 0}, {1, 0, 0}), RayStretch::whole) == Ends{2, 5});
  CHECK(all(two, ray({-3, 0, 0}, {1, 0, 0}), RayStretch::segment) == Ends{});
  CHECK(all(two, ray({-3, 0, 0}, {4, 0, 0}), RayStretch::segment) == Ends{0.5});
  CHECK(all(two, ray({-3, 0, 0}, {5, 0, 0}), RayStretch::segment) == Ends{0.4});
  const scene::Body cube = box({0, 0, 0}, {1, 1, 1});
  CHECK(all(cube, ray({-1, 0.5, 1}, {1, 0, 0}), RayStretch::whole) == std::nullopt);
  CHECK(all(cube, ray({-1, 0.5, 1}, {1, 0, 0}), RayStretch::segment) == Ends{});
  CHECK(all(cube, ray({0.5, 0.5, 1}, {1, 0, 0}), RayStretch::segment) == std::nullopt);
}

TEST_CASE("a ray in a face: its edge is first; from the face on there is no first point") {
  const scene::Body cube = box({0, 0, 0}, {1, 1, 1});
  CHECK(first_t(cube, ray({-1, 0.5, 0}, {1, 0, 0})) == 1);
  CHECK(first_t(cube, ray({0.5, 0.5, 0}, {1, 0, 0})) == 0);
  CHECK(first_t(cube, ray({-1, 0, 0}, {1, 0, 0})) == 1);    // along an edge
  CHECK(first_t(cube, ray({-1, -1, -1}, {1, 1, 1})) == 1);  // through a corner
  CHECK(first_t(cube, ray({-1, -1, 0}, {1, 1, 0})) == 1);
  CHECK(first_t(cube, ray({-1, 1, 0.5}, {1, -1, 0})) == -1 + 2);  // touches an edge
  CHECK(first_t(cube, ray({-1, 0.5, -1}, {1, 0, 0})) == -1);
  const scene::Body half = plane({0, 0, 0}, {0, 0, 1});
  CHECK(first_t(half, ray({0, 0, 0}, {1, 0, 0})) == 0);
  CHECK(first_t(half, ray({0, 0, 1}, {1, 0, 0})) == -1);
}

TEST_CASE("a ray that touches a ball meets it in a point, and goes through what the ball is taken from") {
  CHECK(stretches(sphere({0, 0, 0}, 1), ray({-2, 1, 0}, {1, 0, 0})) == Ends{2, 2});
  const scene::Body drilled = joined(Operation::subtracted, {box({-3, -3, -3}, {3, 3, 3}), sphere({0, 0, 0}, 1)});
  CHECK(stretches(drilled, ray({-5, 1, 0}, {1, 0, 0})) == Ends{2, 8});
  CHECK(first_t(drilled, ray({-2, 1, 0}, {1, 0, 0})) == 2);  // the point where it touches is on the surface
}

TEST_CASE("a ray that starts on the surface does not meet the face that it leaves") {
  const scene::Body lens = joined(Operation::intersected, {sphere({0, 0, -3}, 5), sphere({0, 0, 3}, 5)});
  CHECK(first_t(lens, ray({0, 0, 2}, {0, 0, 1}), true) == -1);
  CHECK(first_t(lens, ray({0, 0, 2}, {0, 0, -1}), true) == 4);
  CHECK(first_t(box({0, 0, 0}, {1, 1, 1}), ray({0.3, 0.4, 1}, {0, 0, 1}), true) == -1);
  CHECK(first_t(box({0, 0, 0}, {1, 1, 1}), ray({0.3, 0.4, 1}, {0, 0, -1}), true) == 1);
  // From a point of the surface, rounded, to the light and inwards: no acne, whatever the rounding.
  SolidDraw draw(20261127, false);
  const SolidFigure figure(solid_of(lens));
  for (int i = 0; i < 2000; ++i) {
    CAPTURE(i);
    const Rayo into = ray({draw.real(-9, 9), draw.real(-9, 9), -9}, {0, 0, 1});
    const First met = figure.first(into, false);
    if (!met.t) continue;
    const glm::dvec3 at = into.p().xyz() + number::round_to_binary64(*met.t) * into.v().xyz();
    const glm::dvec3 point(at.x, at.y, number::round_to_binary64(number::linear(-9.0, 1.0, *met.t)));
    CHECK_FALSE(figure.first(ray(point, {0, 0, -1}), true).t);
    const First out = figure.first(ray(point, {0, 0, 1}), true);
    REQUIRE(out.t);
    CHECK(number::sign(*out.t) > 0);
    CHECK_FALSE(figure.hides(ray(point, figure.normal(point)), true));
  }
}

TEST_CASE("a box holds the body, and is infinite where none does") {
  const auto box_of = [](const scene::Body& body) { return SolidFigure(solid_of(body)).box(); };
  const surface::Box cube = box_of(box({0, 0, 0}, {1, 2, 3}));
  CHECK(cube.low.x <= 0);
  CHECK(cube.low.x > -1e-300);
  CHECK(cube.high.z >= 3);
  CHECK(cube.high.z < 3.0000001);
  const surface::Box of_union = box_of(joined(Operation::united, {sphere({0, 0, 0}, 1), sphere({4, 0, 0}, 1)}));
  CHECK(of_union.low.x <= -1);
  CHECK(of_union.high.x >= 5);
  const surface::Box taken = box_of(joined(Operation::subtracted, {sphere({0, 0, 0}, 1), plane({0, 0, 0}, {0, 0, 1})}));
  CHECK(taken.high.x < 1.0000001);
  CHECK(std::isinf(box_of(joined(Operation::united, {sphere({0, 0, 0}, 1), plane({0, 0, 0}, {0, 0, 1})})).high.x));
  const surface::Box apart = box_of(joined(Operation::intersected, {sphere({0, 0, 0}, 1), sphere({4, 0, 0}, 1)}));
  CHECK(apart.low.x <= apart.high.x);
}

// On the grid faces coincide, touch and share edges, and rays run in faces and along edges: what the text says at each
// root, and between each two, is what the walk says.
TEST_CASE("superficie.def.1, superficie_desde.def.1: random trees on a grid, against the text at every root") {
  const auto trees = static_cast<std::uint64_t>(fewer_when_sanitized(120));
  std::size_t surfaces = 0, starts = 0;
  for (std::uint64_t seed = 1; seed <= trees; ++seed) {
    SolidDraw draw(seed, true);
    const RandomSolid random = draw.tree(3);
    const SolidFigure figure(solid_of(random.body));
    for (int i = 0; i < 8; ++i) {
      CAPTURE(seed, i);
      const Rayo rayo = draw.ray();
      const bool on = draw.whole(0, 1) == 1;
      model::Cuadricas en;
      for (const model::Cuadrica& c : random.solido.cuadricas)
        if (on && model::valor(c, rayo.p()) == Surd(0)) en.insert(c);
      if (!en.empty()) ++starts;
      const std::vector<Surd> roots = roots_of(random.solido, rayo, en);
      const auto is_surface = [&](const Surd& t) {
        return model::superficie_desde(random.solido, rayo, en, model::en_parametro(rayo, t));
      };
      const std::vector<Segment> inside = figure.inside(rayo, on);
      const auto is_right = [&](const Surd& t) {
        const model::ExactPoint w = model::en_parametro(rayo, t);
        const auto& cs = random.solido.cuadricas;
        const auto all =
            model::repartos(cs, model::dentro_desde(cs, rayo.p(), en, w), model::fuera_desde(cs, rayo.p(), en, w));
        return std::ranges::any_of(inside, [&](const Segment& each) { return covers(each, t); }) ==
               std::ranges::any_of(all, random.solido.contains);
      };
      const Surd start = between(Surd(0), roots.empty() ? std::nullopt : std::optional(roots[0]));
      CHECK(is_right(start));
      const First first = figure.first(rayo, on);
      CHECK(first.no_minimum == is_surface(start));
      std::optional<Surd> expected;
      for (std::size_t k = 0; k < roots.size(); ++k) {
        CHECK(is_right(roots[k]));
        CHECK(is_right(between(roots[k], k + 1 < roots.size() ? std::optional(roots[k + 1]) : std::nullopt)));
        if (!expected && is_surface(roots[k])) expected = roots[k];
      }
      if (first.no_minimum) continue;
      REQUIRE(first.t.has_value() == expected.has_value());
      if (expected) ++surfaces;
      if (expected) CHECK(Surd(*first.t) == *expected);
    }
  }
  CHECK(surfaces > trees);
  CHECK(starts > trees / 4);
}

namespace {

/// Whether a point that lies on no face is in a body: by lengths and advances alone.
bool holds(const scene::Body& body, const std::array<number::Rational, 3>& w);

struct Holds {
  std::array<number::Rational, 3> w;

  number::Rational advance(const glm::dvec3& c, const glm::dvec3& d) const {
    number::Rational sum = 0;
    for (int i = 0; i < 3; ++i) sum += (w[static_cast<std::size_t>(i)] - number::exact(c[i])) * number::exact(d[i]);
    return sum;
  }
  /// The squared length from the foot at that advance.
  number::Rational distance(const glm::dvec3& c, const glm::dvec3& d, const number::Rational& s) const {
    number::Rational sum = 0;
    for (int i = 0; i < 3; ++i) {
      const number::Rational part = w[static_cast<std::size_t>(i)] - number::exact(c[i]) - s * number::exact(d[i]);
      sum += part * part;
    }
    return sum;
  }
  bool operator()(const scene::Sphere& e) const {
    return distance(e.centro, {0, 0, 0}, 0) < number::exact(e.radio) * number::exact(e.radio);
  }
  bool operator()(const scene::Plane& e) const { return advance(e.centro, e.vector) < 0; }
  bool within(const glm::dvec3& c, const glm::dvec3& d, double h, double at_top, double slope) const {
    const number::Rational s = advance(c, d);
    if (s < 0 || s > number::exact(h)) return false;
    const number::Rational r = number::exact(at_top) + number::exact(slope) * (number::exact(h) - s);
    return distance(c, d, s) < r * r;
  }
  bool operator()(const scene::Cylinder& e) const { return within(e.centro, e.vector, e.altura, e.radio, 0); }
  bool operator()(const scene::Cone& e) const { return within(e.centro, e.vector, e.altura, 0, e.proporcion); }
  bool operator()(const scene::TruncatedCone& e) const {
    return within(e.centro, e.vector, e.altura, e.radio, e.proporcion);
  }
  bool operator()(const scene::Disc&) const { return false; }
  bool operator()(const scene::Triangle&) const { return false; }
  bool operator()(const scene::Instance& instance) const { return std::visit(*this, instance.shape); }
  bool operator()(const scene::Compound& solid) const {
    const auto has = [&](const scene::Body& part) { return holds(part, w); };
    switch (solid.operation) {
      case Operation::united:
        return std::ranges::any_of(solid.parts, has);
      case Operation::intersected:
        return std::ranges::all_of(solid.parts, has);
      case Operation::subtracted:
        return has(solid.parts[0]) && std::none_of(solid.parts.begin() + 1, solid.parts.end(), has);
    }
    return false;
  }
};

bool holds(const scene::Body& body, const std::array<number::Rational, 3>& w) {
  return std::visit(Holds{w}, body.form);
}

bool holds_at(const scene::Body& body, const Rayo& rayo, double t) {
  const glm::dvec3 &p = rayo.p().xyz(), &v = rayo.v().xyz();
  std::array<number::Rational, 3> w;
  for (int i = 0; i < 3; ++i)
    w[static_cast<std::size_t>(i)] = number::exact(p[i]) + number::exact(t) * number::exact(v[i]);
  return holds(body, w);
}

/// Rays against membership at points of them: in the body where the walk says so, before and after each end.
void compare_with_membership(std::uint64_t trees, int rays) {
  std::size_t ends = 0, all = 0;
  for (std::uint64_t seed = 1; seed <= trees; ++seed) {
    SolidDraw draw(seed, false);
    const scene::Body body = draw.tree(4).body;
    const SolidFigure figure(solid_of(body));
    for (int i = 0; i < rays; ++i) {
      CAPTURE(seed, i);
      const Rayo rayo = draw.ray();
      const std::vector<Segment> inside = figure.inside(rayo, false);
      std::vector<double> at;
      for (const Segment& each : inside) {
        if (each.begin) at.push_back(number::round_to_binary64(*each.begin));
        if (each.end) at.push_back(number::round_to_binary64(*each.end));
      }
      // Beside an end by more than its rounding, and points at random.
      std::vector<double> places;
      for (const double t : at) places.insert(places.end(), {t * (1 - 0x1p-40), t * (1 + 0x1p-40)});
      for (int k = 0; k < 6; ++k) places.push_back(draw.real(0x1p-20, 4));
      for (const double t : places) {
        const bool is_in = std::ranges::any_of(inside, [&](const Segment& each) { return covers(each, Surd(t)); });
        CHECK(holds_at(body, rayo, t) == is_in);
      }
      ends += at.size();
      const First first = figure.first(rayo, false);
      REQUIRE(first.t.has_value() == !at.empty());
      if (first.t) CHECK(number::round_to_binary64(*first.t) == at[0]);
      ++all;
    }
  }
  CHECK(ends > all / 8);
}

}  // namespace

TEST_CASE("random trees and rays: what is in the body is in the sets that are joined") {
  compare_with_membership(fewer_when_sanitized(500), 20);
}

TEST_CASE("100000 rays: what is in the body is in the sets that are joined", "[long]") {
  compare_with_membership(5000, 20);
}
