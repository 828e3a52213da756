// (u, v) of the points of each surface, in POV-Ray's language.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "durero/scene/axes_across.hpp"
#include "pov_pattern.hpp"

namespace durero::io {
namespace {

/// direction·(p − from), for the point p = (x, y, z).
std::string advance(const glm::dvec3& direction, const glm::dvec3& from) {
  return fmt::format("(({})*(x-({}))+({})*(y-({}))+({})*(z-({})))", direction.x, from.x, direction.y, from.y,
                     direction.z, from.z);
}

/// The part of a whole turn from the first axis towards the second. Turn() is declared by PovPatterns.
std::string turn(const scene::AxesAcross& axes, const glm::dvec3& centre) {
  return fmt::format("Turn({}, {})", advance(axes.first, centre), advance(axes.second, centre));
}

PovCoordinates coordinates_of(const scene::Sphere& s) {
  const scene::AxesAcross axes = scene::axes_across({0, 1, 0});
  return {turn(axes, s.centro), fmt::format("Latitude({}, {}, {})", advance(axes.first, s.centro),
                                            advance({0, 1, 0}, s.centro), advance(axes.second, s.centro))};
}

PovCoordinates coordinates_of(const scene::Cylinder& c) {
  return {turn(scene::axes_across(c.vector), c.centro), fmt::format("{}/{}", advance(c.vector, c.centro), c.altura)};
}

/// With s = altura·v and the distance from the axis base − slope·v, v is also the advance along the generator, whose
/// gradient lies in the surface.
template <class Shape>
PovCoordinates narrowing(const Shape& c, double base) {
  const scene::AxesAcross axes = scene::axes_across(c.vector);
  const double slope = c.proporcion * c.altura, length = c.altura * c.altura + slope * slope;
  const std::string across =
      fmt::format("sqrt(pow({}, 2) + pow({}, 2))", advance(axes.first, c.centro), advance(axes.second, c.centro));
  return {turn(axes, c.centro), fmt::format("({}*{}-({})*({}-({})))/({})", c.altura, advance(c.vector, c.centro), slope,
                                            across, base, length)};
}
PovCoordinates coordinates_of(const scene::Cone& c) { return narrowing(c, c.proporcion * c.altura); }
PovCoordinates coordinates_of(const scene::TruncatedCone& c) { return narrowing(c, c.radio + c.proporcion * c.altura); }

PovCoordinates coordinates_of(const scene::Plane& p) {
  const auto [first, second] = scene::axes_across(p.vector);
  return {advance(first, p.centro), advance(second, p.centro)};
}

PovCoordinates coordinates_of(const scene::Disc& d) {
  const auto [first, second] = scene::axes_across(d.vector);
  return {fmt::format("0.5+0.5*{}/{}", advance(first, d.centro), d.radio),
          fmt::format("0.5+0.5*{}/{}", advance(second, d.centro), d.radio)};
}

/// Areas over that of the whole: ((p − a) × f)·n = (f × n)·(p − a), and likewise.
PovCoordinates coordinates_of(const scene::Triangle& t) {
  const glm::dvec3 e = t.vertices[1] - t.vertices[0], f = t.vertices[2] - t.vertices[0], n = glm::cross(e, f);
  const double area = glm::dot(n, n);
  return {advance(glm::cross(f, n) / area, t.vertices[0]), advance(glm::cross(n, e) / area, t.vertices[0])};
}

/// How long a unit of v is on a surface.
double length_of(const scene::Sphere& s) { return std::numbers::pi * s.radio; }
double length_of(const scene::Cylinder& c) { return c.altura; }
double length_of(const scene::Cone& c) { return std::hypot(c.altura, c.proporcion * c.altura); }
double length_of(const scene::TruncatedCone& c) { return std::hypot(c.altura, c.proporcion * c.altura); }
double length_of(const scene::Plane&) { return 1; }
double length_of(const scene::Disc& d) { return 2 * d.radio; }
double length_of(const scene::Triangle& t) { return glm::distance(t.vertices[0], t.vertices[2]); }

/// Of a triangle whose vertices have coordinates: linear in its own.
PovCoordinates wrapped(const PovCoordinates& own, const scene::Wrap& wrap) {
  const auto& [a, b, c] = wrap.uv;
  const auto linear = [&](int k) {
    return fmt::format("({})+({})*{}+({})*{}", a[k], b[k] - a[k], own.u, c[k] - a[k], own.v);
  };
  return {linear(0), linear(1), own.length / std::max(std::abs(c[1] - a[1]), 1e-6)};
}

}  // namespace

PovCoordinates pov_coordinates(const scene::Scene& scene, scene::ElementRef element) {
  const PovCoordinates own = scene.visit(element, [](const auto& shape) {
    PovCoordinates at = coordinates_of(shape);
    at.length = length_of(shape);
    return at;
  });
  const scene::Wrap* const wrap = scene.wrap(element);
  return wrap == nullptr ? own : wrapped(own, *wrap);
}

}  // namespace durero::io
