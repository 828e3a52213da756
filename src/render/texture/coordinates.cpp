#include "durero/render/texture/coordinates.hpp"

#include <algorithm>
#include <cmath>
#include <concepts>
#include <glm/geometric.hpp>
#include <numbers>

#include "durero/scene/axes_across.hpp"

namespace durero::render {
namespace {

using scene::axes_across;
using scene::AxesAcross;
using scene::Cone;
using scene::Cylinder;
using scene::Disc;
using scene::Plane;
using scene::Sphere;
using scene::Triangle;
using scene::TruncatedCone;
using std::numbers::pi;

/// The part of a whole turn, in [0, 1), from the first of two axes towards the second.
double turn(double first, double second) {
  if (first == 0 && second == 0) return 0;
  const double u = std::atan2(second, first) / (2 * pi);
  if (u >= 0) return u;
  return u + 1 < 1 ? u + 1 : 0;  // an angle just below 0 rounds to a whole turn
}

/// A cylinder, a cone and a truncated cone have one form here: round about an axis, with a radius for each advance.
template <class Shape>
concept Round = std::same_as<Shape, Cylinder> || std::same_as<Shape, Cone> || std::same_as<Shape, TruncatedCone>;

double radius(const Cylinder& c, double) { return c.radio; }
double radius(const Cone& c, double v) { return c.proporcion * (c.altura * std::max(0.0, 1 - v)); }
double radius(const TruncatedCone& c, double v) { return c.radio + c.proporcion * (c.altura * (1 - v)); }
/// The growth of the radius from v = 0 to 1.
double growth(const Cylinder&) { return 0; }
double growth(const Cone& c) { return -c.proporcion * c.altura; }
double growth(const TruncatedCone& c) { return -c.proporcion * c.altura; }

glm::dvec3 around(const AxesAcross& axes, double u) {
  return std::cos(2 * pi * u) * axes.first + std::sin(2 * pi * u) * axes.second;
}

const glm::dvec3 up{0, 1, 0};
const AxesAcross across_up = axes_across(up);

TextureCoordinates coordinates_of(const Sphere& s, const glm::dvec3& p) {
  const glm::dvec3 q = p - s.centro;
  const double x = glm::dot(q, across_up.first), y = glm::dot(q, across_up.second);
  return {turn(x, y), 0.5 + std::atan2(q.y, std::hypot(x, y)) / pi};
}

template <Round Shape>
TextureCoordinates coordinates_of(const Shape& c, const glm::dvec3& p) {
  const glm::dvec3 q = p - c.centro;
  const auto [first, second] = axes_across(c.vector);
  return {turn(glm::dot(q, first), glm::dot(q, second)), glm::dot(q, c.vector) / c.altura};
}

TextureCoordinates coordinates_of(const Plane& plane, const glm::dvec3& p) {
  const auto [first, second] = axes_across(plane.vector);
  return {glm::dot(p - plane.centro, first), glm::dot(p - plane.centro, second)};
}

TextureCoordinates coordinates_of(const Disc& disc, const glm::dvec3& p) {
  const auto [first, second] = axes_across(disc.vector);
  const glm::dvec3 q = (p - disc.centro) / disc.radio;
  return {0.5 + 0.5 * glm::dot(q, first), 0.5 + 0.5 * glm::dot(q, second)};
}

/// The coordinates of q = u·e + v·f: the areas of two triangles over that of the whole, by the normal e × f.
TextureCoordinates coordinates_of(const Triangle& t, const glm::dvec3& p) {
  const glm::dvec3 e = t.vertices[1] - t.vertices[0], f = t.vertices[2] - t.vertices[0], q = p - t.vertices[0];
  const glm::dvec3 n = glm::cross(e, f);
  const double area = glm::dot(n, n);
  return {glm::dot(glm::cross(q, f), n) / area, glm::dot(glm::cross(e, q), n) / area};
}

glm::dvec3 point_of(const Sphere& s, const TextureCoordinates& at) {
  const double latitude = (at.v - 0.5) * pi;
  return s.centro + s.radio * (std::cos(latitude) * around(across_up, at.u) + std::sin(latitude) * up);
}

template <Round Shape>
glm::dvec3 point_of(const Shape& c, const TextureCoordinates& at) {
  return c.centro + at.v * c.altura * c.vector + radius(c, at.v) * around(axes_across(c.vector), at.u);
}

glm::dvec3 point_of(const Plane& plane, const TextureCoordinates& at) {
  const auto [first, second] = axes_across(plane.vector);
  return plane.centro + at.u * first + at.v * second;
}

glm::dvec3 point_of(const Disc& disc, const TextureCoordinates& at) {
  const auto [first, second] = axes_across(disc.vector);
  return disc.centro + disc.radio * ((2 * at.u - 1) * first + (2 * at.v - 1) * second);
}

glm::dvec3 point_of(const Triangle& t, const TextureCoordinates& at) {
  return t.vertices[0] + at.u * (t.vertices[1] - t.vertices[0]) + at.v * (t.vertices[2] - t.vertices[0]);
}

Tangents tangents_of(const Sphere& s, const TextureCoordinates& at) {
  const double latitude = (at.v - 0.5) * pi;
  // At the poles themselves, whose latitude is no binary64, the cosine is 0 all the same.
  const double cosine = at.v <= 0 || at.v >= 1 ? 0 : std::cos(latitude);
  const glm::dvec3 outwards = around(across_up, at.u), onwards = around(across_up, at.u + 0.25);
  return {2 * pi * s.radio * cosine * onwards,
          pi * s.radio * (std::cos(latitude) * up - std::sin(latitude) * outwards)};
}

template <Round Shape>
Tangents tangents_of(const Shape& c, const TextureCoordinates& at) {
  const AxesAcross axes = axes_across(c.vector);
  return {2 * pi * radius(c, at.v) * around(axes, at.u + 0.25), c.altura * c.vector + growth(c) * around(axes, at.u)};
}

Tangents tangents_of(const Plane& plane, const TextureCoordinates&) {
  const auto [first, second] = axes_across(plane.vector);
  return {first, second};
}

Tangents tangents_of(const Disc& disc, const TextureCoordinates&) {
  const auto [first, second] = axes_across(disc.vector);
  return {2 * disc.radio * first, 2 * disc.radio * second};
}

Tangents tangents_of(const Triangle& t, const TextureCoordinates&) {
  return {t.vertices[1] - t.vertices[0], t.vertices[2] - t.vertices[0]};
}

/// A triangle whose vertices have coordinates. Within it they are linear: (u, v) = a + M·(r, s), where (r, s) are the
/// triangle's own.
class Wrapped {
 public:
  Wrapped(const Triangle& triangle, const scene::Wrap& wrap)
      : triangle_(triangle),
        wrap_(wrap),
        first_(wrap.uv[1] - wrap.uv[0]),
        second_(wrap.uv[2] - wrap.uv[0]),
        determinant_(first_.x * second_.y - second_.x * first_.y) {}

  TextureCoordinates at(const TextureCoordinates& own) const {
    const glm::dvec2 uv = wrap_.uv[0] + own.u * first_ + own.v * second_;
    return {uv.x, uv.y};
  }
  /// The triangle's own coordinates (r, s); those of the first vertex where the coordinates of the vertices have no
  /// area.
  TextureCoordinates own(const TextureCoordinates& at) const {
    if (!has_area()) return {0, 0};
    const glm::dvec2 from = glm::dvec2(at.u, at.v) - wrap_.uv[0];
    return {(from.x * second_.y - second_.x * from.y) / determinant_,
            (first_.x * from.y - from.x * first_.y) / determinant_};
  }
  /// The tangents; null where the coordinates of the vertices have no area.
  Tangents tangents(const TextureCoordinates& at) const {
    if (!has_area()) return {glm::dvec3(0), glm::dvec3(0)};
    const auto [e, f] = tangents_of(triangle_, at);
    if (wrap_.tangents) return in_between(own(at), glm::normalize(glm::cross(e, f)));
    return {(second_.y * e - first_.y * f) / determinant_, (first_.x * f - second_.x * e) / determinant_};
  }

 private:
  bool has_area() const { return determinant_ != 0 && std::isfinite(determinant_); }
  /// The tangents of the vertices, interpolated linearly and freed of their parts along the unit normal.
  Tangents in_between(const TextureCoordinates& own, const glm::dvec3& n) const {
    const auto of = [&](std::size_t which) {
      const auto& [a, b, c] = *wrap_.tangents;
      const glm::dvec3 t = (1 - own.u - own.v) * a[which] + own.u * b[which] + own.v * c[which];
      return t - glm::dot(t, n) * n;
    };
    return {of(0), of(1)};
  }

  const Triangle& triangle_;
  const scene::Wrap& wrap_;
  const glm::dvec2 first_, second_;
  const double determinant_;
};

/// Calls of_wrapped(wrapped, triangle) where the vertices have coordinates, else of_shape(shape).
template <class OfWrapped, class OfShape>
auto visit(const scene::Scene& scene, scene::ElementRef element, OfWrapped&& of_wrapped, OfShape&& of_shape) {
  if (const auto wrap = scene.wrap(element))
    return of_wrapped(Wrapped(scene.shapes<Triangle>()[element.index], *wrap), scene.shapes<Triangle>()[element.index]);
  return scene.visit(element, of_shape);
}

}  // namespace

TextureCoordinates coordinates(const scene::Scene& scene, scene::ElementRef element, const glm::dvec3& point) {
  return visit(
      scene, element,
      [&](const Wrapped& wrapped, const auto& shape) { return wrapped.at(coordinates_of(shape, point)); },
      [&](const auto& shape) { return coordinates_of(shape, point); });
}

TextureCoordinates own_coordinates(const scene::Scene& scene, scene::ElementRef element, const glm::dvec3& point) {
  return scene.visit(element, [&](const auto& shape) { return coordinates_of(shape, point); });
}

glm::dvec3 point_at(const scene::Scene& scene, scene::ElementRef element, const TextureCoordinates& at) {
  return visit(
      scene, element, [&](const Wrapped& wrapped, const auto& shape) { return point_of(shape, wrapped.own(at)); },
      [&](const auto& shape) { return point_of(shape, at); });
}

Tangents tangents(const scene::Scene& scene, scene::ElementRef element, const TextureCoordinates& at) {
  return visit(
      scene, element, [&](const Wrapped& wrapped, const auto&) { return wrapped.tangents(at); },
      [&](const auto& shape) { return tangents_of(shape, at); });
}

}  // namespace durero::render
