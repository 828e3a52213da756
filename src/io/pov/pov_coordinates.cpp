// (u, v) of the points of each surface, in POV-Ray's language.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <variant>

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

/// What takes x, y, z and the origin to these vectors and this place; empty where binary64 has no way back.
std::string matrix(const glm::dvec3& x, const glm::dvec3& y, const glm::dvec3& z, const glm::dvec3& origin) {
  const double volume = glm::dot(glm::cross(x, y), z);
  if (!std::isnormal(volume) || !std::isfinite(glm::dot(origin, origin))) return "";
  const auto row = [](const glm::dvec3& v) { return fmt::format("{}, {}, {}", v.x + 0, v.y + 0, v.z + 0); };  // no −0
  return fmt::format("matrix <{}, {}, {}, {}>", row(x), row(y), row(z), row(origin));
}

/// What lays a unit square on a parallelogram of these sides, half a unit above it.
std::string laid(const glm::dvec3& corner, const glm::dvec3& u, const glm::dvec3& v) {
  const glm::dvec3 across = glm::cross(u, v), normal = across / glm::length(across);
  return matrix(u, v, normal, corner - 0.5 * normal);
}

/// What wraps a unit square about an axis of that length: POV-Ray's warps turn from x towards z, about y, and z is the
/// distance from the axis, or from the centre.
std::string warped(std::string_view warp, const glm::dvec3& centre, const glm::dvec3& axis, double length) {
  const scene::AxesAcross axes = scene::axes_across(axis);
  const std::string turned = matrix(axes.first, length * axis, axes.second, centre);
  return turned.empty() ? "" : fmt::format("warp {{ {} dist_exp 0 }} {}", warp, turned);
}

PovCoordinates coordinates_of(const scene::Sphere& s) {
  const glm::dvec3 up(0, 1, 0);
  const scene::AxesAcross axes = scene::axes_across(up);
  return {.u = turn(axes, s.centro),
          .v = fmt::format("Latitude({}, {}, {})", advance(axes.first, s.centro), advance(up, s.centro),
                           advance(axes.second, s.centro)),
          .place = warped("spherical", s.centro, up, 1),
          .depth = 2 * s.radio};
}

PovCoordinates coordinates_of(const scene::Cylinder& c) {
  return {.u = turn(scene::axes_across(c.vector), c.centro),
          .v = fmt::format("{}/{}", advance(c.vector, c.centro), c.altura),
          .place = warped("cylindrical", c.centro, c.vector, c.altura),
          .depth = 2 * c.radio};
}

/// With s = altura·v and the distance from the axis base − slope·v, v is also the advance along the generator, whose
/// gradient lies in the surface.
template <class Shape>
PovCoordinates narrowing(const Shape& c, double base) {
  const scene::AxesAcross axes = scene::axes_across(c.vector);
  const double slope = c.proporcion * c.altura, length = c.altura * c.altura + slope * slope;
  const std::string across =
      fmt::format("sqrt(pow({}, 2) + pow({}, 2))", advance(axes.first, c.centro), advance(axes.second, c.centro));
  return {.u = turn(axes, c.centro),
          .v = fmt::format("({}*{}-({})*({}-({})))/({})", c.altura, advance(c.vector, c.centro), slope, across, base,
                           length),
          .place = warped("cylindrical", c.centro, c.vector, c.altura),
          .depth = 2 * base};
}
PovCoordinates coordinates_of(const scene::Cone& c) { return narrowing(c, c.proporcion * c.altura); }
PovCoordinates coordinates_of(const scene::TruncatedCone& c) { return narrowing(c, c.radio + c.proporcion * c.altura); }

PovCoordinates coordinates_of(const scene::Plane& p) {
  const auto [first, second] = scene::axes_across(p.vector);
  return {.u = advance(first, p.centro), .v = advance(second, p.centro), .place = laid(p.centro, first, second)};
}

PovCoordinates coordinates_of(const scene::Disc& d) {
  const auto [first, second] = scene::axes_across(d.vector);
  const glm::dvec3 u = d.radio * first, v = d.radio * second;
  return {.u = fmt::format("0.5+0.5*{}/{}", advance(first, d.centro), d.radio),
          .v = fmt::format("0.5+0.5*{}/{}", advance(second, d.centro), d.radio),
          .place = laid(d.centro - u - v, 2.0 * u, 2.0 * v)};
}

/// Areas over that of the whole: ((p − a) × f)·n = (f × n)·(p − a), and likewise.
PovCoordinates coordinates_of(const scene::Triangle& t) {
  const glm::dvec3 e = t.vertices[1] - t.vertices[0], f = t.vertices[2] - t.vertices[0], n = glm::cross(e, f);
  const double area = glm::dot(n, n);
  return {.u = advance(glm::cross(f, n) / area, t.vertices[0]),
          .v = advance(glm::cross(n, e) / area, t.vertices[0]),
          .place = laid(t.vertices[0], e, f)};
}

/// How long a unit of v is on a surface.
double length_of(const scene::Sphere& s) { return std::numbers::pi * s.radio; }
double length_of(const scene::Cylinder& c) { return c.altura; }
double length_of(const scene::Cone& c) { return std::hypot(c.altura, c.proporcion * c.altura); }
double length_of(const scene::TruncatedCone& c) { return std::hypot(c.altura, c.proporcion * c.altura); }
double length_of(const scene::Plane&) { return 1; }
double length_of(const scene::Disc& d) { return 2 * d.radio; }
double length_of(const scene::Triangle& t) { return glm::distance(t.vertices[0], t.vertices[2]); }

/// Of a triangle whose vertices have coordinates: linear in its own. Where the coordinates of the vertices lie on one
/// line, no place of the unit square is that of a point alone.
PovCoordinates wrapped(const scene::Triangle& t, const PovCoordinates& own, const scene::Wrap& wrap) {
  const auto& [a, b, c] = wrap.uv;
  const auto linear = [&](int k) {
    return fmt::format("({})+({})*{}+({})*{}", a[k], b[k] - a[k], own.u, c[k] - a[k], own.v);
  };
  PovCoordinates at{.u = linear(0), .v = linear(1), .length = own.length / std::max(std::abs(c[1] - a[1]), 1e-6)};
  const glm::dvec2 e = b - a, f = c - a;
  const double turned = e.x * f.y - e.y * f.x;
  if (turned == 0) return at;
  const glm::dvec3 to_b = t.vertices[1] - t.vertices[0], to_c = t.vertices[2] - t.vertices[0];
  const glm::dvec3 u = (f.y * to_b - e.y * to_c) / turned, v = (e.x * to_c - f.x * to_b) / turned;
  at.place = laid(t.vertices[0] - a.x * u - a.y * v, u, v);
  return at;
}

template <class Shape>
PovCoordinates own_coordinates(const Shape& shape) {
  PovCoordinates at = coordinates_of(shape);
  at.length = length_of(shape);
  return at;
}

}  // namespace

PovCoordinates pov_coordinates(const scene::AnyShape& shape) {
  return std::visit([](const auto& one) { return own_coordinates(one); }, shape);
}

PovCoordinates pov_coordinates(const scene::Scene& scene, scene::ElementRef element) {
  const PovCoordinates own = scene.visit(element, [](const auto& shape) { return own_coordinates(shape); });
  const auto wrap = scene.wrap(element);
  return !wrap ? own : wrapped(scene.shapes<scene::Triangle>()[element.index], own, *wrap);
}

}  // namespace durero::io
