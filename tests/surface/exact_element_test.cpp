#include "durero/surface/exact_element.hpp"

#include <boost/multiprecision/cpp_dec_float.hpp>

#include "durero/number/surd.hpp"
#include "support/catch.hpp"
#include "support/elements.hpp"
#include "support/property.hpp"
#include "support/shapes.hpp"

using namespace durero;
using namespace durero::surface::exact;
using namespace durero::test;
using number::Rational;
using number::Surd;

namespace {

/// The Z text's functions over surds, letter for letter: what the coefficients are checked against.
struct Point {
  Surd x, y, z;
};

Point at(const model::Rayo& ray, const Surd& t) {
  const auto coordinate = [&](double p, double v) { return Surd(p) + t * Surd(v); };
  return {coordinate(ray.p().x(), ray.v().x()), coordinate(ray.p().y(), ray.v().y()),
          coordinate(ray.p().z(), ray.v().z())};
}

Surd cuadrado(const Surd& a) { return a * a; }

Surd avance(const Point& w, const glm::dvec3& centro, const glm::dvec3& dir) {
  return (w.x - Surd(centro.x)) * Surd(dir.x) + (w.y - Surd(centro.y)) * Surd(dir.y) +
         (w.z - Surd(centro.z)) * Surd(dir.z);
}

Surd alejamiento(const Point& w, const glm::dvec3& centro, const glm::dvec3& dir) {
  const Surd s = avance(w, centro, dir);
  return cuadrado(w.x - (Surd(centro.x) + s * Surd(dir.x))) + cuadrado(w.y - (Surd(centro.y) + s * Surd(dir.y))) +
         cuadrado(w.z - (Surd(centro.z) + s * Surd(dir.z)));
}

Surd potencia(const scene::Sphere& s, const Point& w) {
  return cuadrado(w.x - Surd(s.centro.x)) + cuadrado(w.y - Surd(s.centro.y)) + cuadrado(w.z - Surd(s.centro.z)) -
         cuadrado(Surd(s.radio));
}
Surd potencia(const scene::Cylinder& c, const Point& w) {
  return alejamiento(w, c.centro, c.vector) - cuadrado(Surd(c.radio));
}
Surd potencia(const scene::Cone& c, const Point& w) {
  const Surd s = avance(w, c.centro, c.vector);
  return alejamiento(w, c.centro, c.vector) - cuadrado(Surd(c.proporcion) * s - Surd(c.altura) * Surd(c.proporcion));
}
Surd potencia(const scene::TruncatedCone& c, const Point& w) {
  const Surd s = avance(w, c.centro, c.vector);
  return alejamiento(w, c.centro, c.vector) - cuadrado(Surd(c.radio) + Surd(c.proporcion) * (Surd(c.altura) - s));
}
Surd potencia(const scene::Plane& c, const Point& w) { return avance(w, c.centro, c.vector); }
Surd potencia(const scene::Disc& c, const Point& w) { return avance(w, c.centro, c.vector); }

/// (q − p)·(s − r)
Surd escalar(const Point& p, const Point& q, const Point& r, const Point& s) {
  return (q.x - p.x) * (s.x - r.x) + (q.y - p.y) * (s.y - r.y) + (q.z - p.z) * (s.z - r.z);
}
Point point(const glm::dvec3& p) { return {Surd(p.x), Surd(p.y), Surd(p.z)}; }
Surd potencia(const scene::Triangle& t, const Point& w) {
  const Point a = point(t.vertices[0]), b = point(t.vertices[1]), c = point(t.vertices[2]);
  return (w.x - a.x) * ((b.y - a.y) * (c.z - a.z) - (b.z - a.z) * (c.y - a.y)) +
         (w.y - a.y) * ((b.z - a.z) * (c.x - a.x) - (b.x - a.x) * (c.z - a.z)) +
         (w.z - a.z) * ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
}

bool in_stretch(const scene::Sphere&, const Point&) { return true; }
bool in_stretch(const scene::Plane&, const Point&) { return true; }
bool in_stretch(const scene::Disc& d, const Point& w) {
  const Point c = point(d.centro);
  return escalar(c, w, c, w) <= cuadrado(Surd(d.radio));
}
bool in_stretch(const scene::Triangle& t, const Point& w) {
  for (std::size_t i = 0; i < 3; ++i) {
    const Point a = point(t.vertices[i]), b = point(t.vertices[(i + 1) % 3]), c = point(t.vertices[(i + 2) % 3]);
    if (number::sign(escalar(a, b, a, b) * escalar(a, w, a, c) - escalar(a, b, a, c) * escalar(a, w, a, b)) < 0)
      return false;
  }
  return true;
}
template <class Bounded>
bool in_stretch(const Bounded& c, const Point& w) {
  const Surd s = avance(w, c.centro, c.vector);
  return number::sign(s) >= 0 && s <= Surd(c.altura);
}

/// A line in the surface: what reach keeps of it is on the element's stretch, and what it leaves is not.
template <class Element>
void check_stretch(const Element& element, const model::Rayo& ray, const Reach& reached) {
  const auto kept = [&](const Surd& t) {
    if (number::sign(t) <= 0) return false;
    if (reached.count == 1) return t == Surd(reached.t[0]);
    if (!reached.segment) return false;
    const auto& [begin, end] = *reached.segment;
    return (!begin || Surd(*begin) <= t) && (!end || t <= Surd(*end));
  };
  const auto check_at = [&](const Surd& t) {
    RC_ASSERT(kept(t) == (number::sign(t) > 0 && in_stretch(element, at(ray, t))));
  };
  for (const double t : {0x1p-1000, 0x1p-20, 0.25, 0.5, 1.0, 2.0, 4.0, 0x1p20}) check_at(Surd(t));
  const auto around = [&](const Surd& t) {
    for (const double off : {-0x1p-1000, 0.0, 0x1p-1000}) check_at(t + Surd(off));
  };
  if (reached.count == 1) around(Surd(reached.t[0]));
  if (reached.segment && reached.segment->begin) around(Surd(*reached.segment->begin));
  if (reached.segment && reached.segment->end) around(Surd(*reached.segment->end));
}

/// Every rung on one element and ray: the roots are roots, they are all, and reach keeps the right ones.
template <class Element>
void check_rungs(const Element& element, const model::Rayo& ray, bool on) {
  const Coefficients f = coefficients(element, ray, on);
  const Surd at_origin = on ? potencia(element, at(ray, 0)) : Surd(0);
  const auto value = [&](const Surd& t) { return potencia(element, at(ray, t)) - at_origin; };

  // The coefficients, by the values of the quadratic at three parameters.
  const Rational A = f.A.rational(), B = f.B.rational(), C = f.C.rational();
  for (const int t : {0, 1, -2}) RC_ASSERT(value(t) == Surd(Rational(A * t * t + 2 * B * t + C)));

  // The roots, substituted back; their number, by the discriminant.
  const Roots found = roots(f);
  RC_ASSERT(found.every == (A == 0 && B == 0 && C == 0));
  for (const Parameter& t : found.values()) RC_ASSERT(number::sign(value(Surd(t))) == 0);
  if (found.count == 2) RC_ASSERT(std::is_lt(order(found.t[0], found.t[1])));
  const Rational D = B * B - A * C;
  if (A != 0) RC_ASSERT(found.count == 1 + D.sign());
  if (A == 0 && !found.every) RC_ASSERT(found.count == (B == 0 ? 0 : 1));

  // reach: the roots with t > 0 on the element's stretch, in their order; or the part of the line that is on it.
  const Reach reached = reach(f);
  if (found.every) return check_stretch(element, ray, reached);
  std::size_t next = 0;
  for (const Parameter& t : found.values()) {
    if (number::sign(Surd(t)) <= 0 || !in_stretch(element, at(ray, Surd(t)))) continue;
    RC_ASSERT(next < reached.points().size());
    RC_ASSERT(std::is_eq(order(reached.points()[next++], t)));
  }
  RC_ASSERT(next == reached.points().size());
}

template <class Element>
void rungs_property(const std::string& name, const rc::Gen<Element>& elements, const rc::Gen<model::Rayo>& some) {
  property(name, [&] { check_rungs(*elements, *some, *rc::gen::arbitrary<bool>()); });
}

constexpr glm::dvec3 x_axis(1, 0, 0), z_axis(0, 0, 1);

double rounded(const Parameter& t) { return number::round_to_binary64(t); }

}  // namespace

TEST_CASE("roots satisfy the Z text exactly, and the clip keeps the right ones") {
  rungs_property("sphere, ordinary", spheres(moderate()), rays(moderate()));
  rungs_property("cylinder, ordinary", cylinders(moderate()), rays(moderate()));
  rungs_property("cone, ordinary", cones(moderate()), rays(moderate()));
  rungs_property("truncated cone, ordinary", truncated_cones(moderate()), rays(moderate()));
  rungs_property("plane, ordinary", planes(moderate()), rays(moderate()));
  rungs_property("plane, grid", planes(dyadicGrid()), rays(dyadicGrid()));
  rungs_property("disc, ordinary", discs(moderate()), rays(moderate()));
  rungs_property("disc, grid", discs(dyadicGrid()), rays(dyadicGrid()));
  rungs_property("triangle, ordinary", triangles(moderate()), rays(moderate()));
  rungs_property("triangle, grid", triangles(dyadicGrid()), rays(dyadicGrid()));
  rungs_property("sphere, grid", spheres(dyadicGrid()), rays(dyadicGrid()));
  rungs_property("cylinder, grid", cylinders(dyadicGrid()), rays(dyadicGrid()));
  rungs_property("cone, grid", cones(dyadicGrid()), rays(dyadicGrid()));
  rungs_property("truncated cone, grid", truncated_cones(dyadicGrid()), rays(dyadicGrid()));
}

TEST_CASE("roots satisfy the Z text exactly over the whole range of binary64") {
  rungs_property("sphere", spheres(anyFinite()), rays(anyFinite()));
  rungs_property("cylinder", cylinders(anyFinite()), rays(anyFinite()));
  rungs_property("cone", cones(anyFinite()), rays(anyFinite()));
  rungs_property("truncated cone", truncated_cones(anyFinite()), rays(anyFinite()));
  rungs_property("plane", planes(anyFinite()), rays(anyFinite()));
  rungs_property("disc", discs(anyFinite()), rays(anyFinite()));
  rungs_property("triangle", triangles(anyFinite()), rays(anyFinite()));
}

TEST_CASE("a disc is met on its rim, and not beside it") {
  const scene::Disc disc{{0, 0, 0}, 1, {0, 0, 1}};
  const auto meets = [&](double x) { return !reach(disc, model::Rayo({x, 0, -2}, {1, 0, 1})).empty(); };
  CHECK(meets(-3));  // at (−1, 0, 0)
  CHECK(meets(-2));
  CHECK(meets(-1));
  CHECK_FALSE(meets(-3 - 0x1p-51));
  CHECK_FALSE(meets(-1 + 0x1p-53));
}

TEST_CASE("in its plane a flat element is met in a segment, a point or nothing") {
  const scene::Disc disc{{0, 0, 0}, 1, {0, 0, 1}};
  const scene::Triangle triangle{{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}}};
  const auto of = [](const auto& shape, const glm::dvec3& p, const glm::dvec3& v) {
    return reach(shape, model::Rayo{model::Punto(p), model::Vector(v)});
  };
  const auto is = [](const Reach& reached, std::optional<Surd> begin, const Surd& end) {
    if (!reached.segment || !reached.segment->end || !(Surd(*reached.segment->end) == end)) return false;
    return begin ? reached.segment->begin && Surd(*reached.segment->begin) == *begin : !reached.segment->begin;
  };
  const Surd half_root3(0, Rational(1, 2), 3);
  CHECK(is(of(disc, {-2, 0.5, 0}, x_axis), Surd(2) - half_root3, Surd(2) + half_root3));
  CHECK(is(of(disc, {0, 0.5, 0}, x_axis), std::nullopt, half_root3));
  const Reach touched = of(disc, {-2, 1, 0}, x_axis);
  CHECK(touched.count == 1);
  CHECK(rounded(touched.t[0]) == 2);
  CHECK(of(disc, {-2, 1.5, 0}, x_axis).empty());
  CHECK(of(disc, {2, 0.5, 0}, x_axis).empty());

  CHECK(is(of(triangle, {-1, 1, 0}, x_axis), Surd(1), Surd(4)));
  CHECK(is(of(triangle, {5, 6, 0}, {-1, -1, 0}), Surd(Rational(7, 2)), Surd(5)));
  CHECK(is(of(triangle, {6, 5, 0}, {-1, -1, 0}), Surd(Rational(7, 2)), Surd(5)));
  CHECK(is(of(triangle, {1, 1, 0}, x_axis), std::nullopt, Surd(2)));
  CHECK(is(of(triangle, {0, -1, 0}, {0, 1, 0}), Surd(1), Surd(5)));  // along an edge
  CHECK(of(triangle, {-1, 4.5, 0}, x_axis).empty());                 // it would leave before it enters
  const Reach at_vertex = of(triangle, {-1, 4, 0}, x_axis);
  CHECK(at_vertex.count == 1);
  CHECK(rounded(at_vertex.t[0]) == 1);
  // Beside the plane, and known to start on the element.
  const auto beside = reach(triangle, model::Rayo({1, 1, 0x1p-60}, {1, 0, 0}), true);
  CHECK(is(beside, std::nullopt, Surd(2)));
  CHECK(reach(triangle, model::Rayo({1, 1, 0x1p-60}, {1, 0, 0}), false).empty());
}

TEST_CASE("the order of two roots agrees with 400 digits of floating point where those are apart") {
  using Float = boost::multiprecision::number<boost::multiprecision::cpp_dec_float<400>, boost::multiprecision::et_off>;
  const auto digits = [](const Parameter& t) {
    const auto value = [](const Dyadic& x) { return static_cast<Float>(x.rational()); };
    return Float((value(t.x) + value(t.y) * sqrt(value(t.delta))) / value(t.w));
  };
  property("roots of two elements", [&] {
    const model::Rayo ray = *rays(moderate());
    const Roots one = roots(coefficients(*cones(moderate()), ray));
    const Roots other = roots(coefficients(*spheres(moderate()), ray));
    for (const Parameter& a : one.values()) {
      for (const Parameter& b : other.values()) {
        const Float difference = digits(a) - digits(b);
        if (abs(difference) < Float("1e-300")) continue;
        RC_ASSERT(std::is_lt(order(a, b)) == (difference < 0));
      }
    }
  });
}

TEST_CASE("a ray through a sphere, tangent to it, and starting on it") {
  const scene::Sphere sphere{{0, 0, 5}, 1};
  const Reach through = reach(coefficients(sphere, ray({0, 0, 0}, {0, 0, 1})));
  REQUIRE(through.count == 2);
  CHECK(rounded(through.t[0]) == 4);
  CHECK(rounded(through.t[1]) == 6);
  const Reach tangent = reach(coefficients(sphere, ray({1, 0, 0}, {0, 0, 2})));
  REQUIRE(tangent.count == 1);
  CHECK(rounded(tangent.t[0]) == 2.5);
  CHECK(reach(coefficients(sphere, ray({1.0000000000000002, 0, 0}, {0, 0, 2}))).empty());
  CHECK(reach(coefficients(sphere, ray({0, 0, 6}, {0, 0, 1}), true)).empty());
  const Reach across = reach(coefficients(sphere, ray({0, 0, 4}, {0, 0, 1}), true));
  REQUIRE(across.count == 1);
  CHECK(rounded(across.t[0]) == 2);
}

TEST_CASE("both rims belong to a cylinder, its caps do not") {
  const scene::Cylinder cylinder{{0, 0, 0}, 1, z_axis, 2};
  const auto at_height = [&](double z) { return reach(coefficients(cylinder, ray({-3, 0, z}, x_axis))).count; };
  CHECK(at_height(0) == 2);
  CHECK(at_height(2) == 2);
  CHECK(at_height(-0x1p-1074) == 0);
  CHECK(at_height(2.0000000000000004) == 0);
  CHECK(reach(coefficients(cylinder, ray({0, 0, -1}, z_axis))).empty());
}

TEST_CASE("a line inside a cylinder: a segment, part of it, no minimum, nothing") {
  const scene::Cylinder cylinder{{0, 0, 0}, 1, z_axis, 2};
  const auto along = [&](double z, double vz) { return reach(coefficients(cylinder, ray({1, 0, z}, {0, 0, vz}))); };
  const Reach whole = along(-1, 0.5);
  REQUIRE(whole.segment);
  CHECK(rounded(*whole.segment->begin) == 2);
  CHECK(rounded(*whole.segment->end) == 6);
  const Reach inside = along(1, 0.5);
  CHECK(inside.no_minimum());
  CHECK(rounded(*inside.segment->end) == 2);
  CHECK(along(0, 1).no_minimum());
  CHECK(along(2, -1).no_minimum());
  CHECK(along(2, 1).empty());
  CHECK(along(3, 1).empty());
  CHECK(rounded(along(3, -1).first()) == 1);
}

TEST_CASE("a ray parallel to a generator of a cone meets it once; along it, in a segment") {
  const scene::Cone cone{{0, 0, 0}, 1, z_axis, 4};
  const Coefficients parallel = coefficients(cone, ray({-3, 0, 0}, {1, 0, 1}));
  CHECK(number::sign(parallel.A) == 0);
  const Reach once = reach(parallel);
  REQUIRE(once.count == 1);
  CHECK(rounded(once.t[0]) == 3.5);
  const Reach inside = reach(coefficients(cone, ray({0, 0, 0}, {-1, 0, 1})));
  REQUIRE(inside.count == 1);
  CHECK(rounded(inside.t[0]) == 2);
  const Reach along = reach(coefficients(cone, ray({-5, 0, -1}, {1, 0, 1})));
  REQUIRE(along.segment);
  CHECK(rounded(*along.segment->begin) == 1);
  CHECK(rounded(*along.segment->end) == 5);
}

TEST_CASE("the apex belongs to a cone, the mirrored nappe does not") {
  const scene::Cone cone{{0, 0, 0}, 0.5, z_axis, 4};
  const Reach apex = reach(coefficients(cone, ray({-3, 0, 4}, x_axis)));
  REQUIRE(apex.count == 1);
  CHECK(rounded(apex.t[0]) == 3);
  CHECK(reach(coefficients(cone, ray({-3, 0, 5}, x_axis))).empty());
  const Reach axis = reach(coefficients(cone, ray({0, 0, -1}, z_axis)));
  REQUIRE(axis.count == 1);
  CHECK(rounded(axis.t[0]) == 5);
}
