#include "durero/render/coordinates.hpp"

#include <algorithm>
#include <cmath>
#include <concepts>
#include <glm/geometric.hpp>
#include <numbers>

#include "durero/scene/axes_across.hpp"

namespace durero::render {
namespace {

using scene::Cone;
using scene::Cylinder;
using scene::Disc;
using scene::Plane;
using scene::Sphere;
using scene::Triangle;
using scene::TruncatedCone;
using std::numbers::pi;

Tangents axes_across(const glm::dvec3& d) {
  const auto [first, second] = scene::axes_across(d);
  return {first, second};
}

/// The part of a whole turn, in [0, 1), from the first of two axes towards the second.
double turn(double first, double second) {
  if (first == 0 && second == 0) return 0;
  const double u = std::atan2(second, first) / (2 * pi);
  if (u >= 0) return u;
  return u + 1 < 1 ? u + 1 : 0;  // an angle just below 0 rounds to a whole turn
}

/// A cylinder, a cone and a piece of one are one: round about an axis, with a radius for each advance.
template <class Shape>
concept Round = std::same_as<Shape, Cylinder> || std::same_as<Shape, Cone> || std::same_as<Shape, TruncatedCone>;

double radius(const Cylinder& c, double) { return c.radio; }
double radius(const Cone& c, double v) { return c.proporcion * (c.altura * std::max(0.0, 1 - v)); }
double radius(const TruncatedCone& c, double v) { return c.radio + c.proporcion * (c.altura * (1 - v)); }
/// How much it grows from v = 0 to 1.
double growth(const Cylinder&) { return 0; }
double growth(const Cone& c) { return -c.proporcion * c.altura; }
double growth(const TruncatedCone& c) { return -c.proporcion * c.altura; }

glm::dvec3 around(const Tangents& axes, double u) {
  return std::cos(2 * pi * u) * axes.u + std::sin(2 * pi * u) * axes.v;
}

const glm::dvec3 up{0, 1, 0};

Coordinates coordinates_of(const Sphere& s, const glm::dvec3& p) {
  const glm::dvec3 q = p - s.centro;
  const Tangents axes = axes_across(up);
  const double x = glm::dot(q, axes.u), y = glm::dot(q, axes.v);
  return {turn(x, y), 0.5 + std::atan2(q.y, std::hypot(x, y)) / pi};
}

template <Round Shape>
Coordinates coordinates_of(const Shape& c, const glm::dvec3& p) {
  const glm::dvec3 q = p - c.centro;
  const Tangents axes = axes_across(c.vector);
  return {turn(glm::dot(q, axes.u), glm::dot(q, axes.v)), glm::dot(q, c.vector) / c.altura};
}

Coordinates coordinates_of(const Plane& plane, const glm::dvec3& p) {
  const Tangents axes = axes_across(plane.vector);
  return {glm::dot(p - plane.centro, axes.u), glm::dot(p - plane.centro, axes.v)};
}

Coordinates coordinates_of(const Disc& disc, const glm::dvec3& p) {
  const Tangents axes = axes_across(disc.vector);
  const glm::dvec3 q = (p - disc.centro) / disc.radio;
  return {0.5 + 0.5 * glm::dot(q, axes.u), 0.5 + 0.5 * glm::dot(q, axes.v)};
}

/// Of q = u·e + v·f: the areas of two triangles over that of the whole, by the normal e × f.
Coordinates coordinates_of(const Triangle& t, const glm::dvec3& p) {
  const glm::dvec3 e = t.vertices[1] - t.vertices[0], f = t.vertices[2] - t.vertices[0], q = p - t.vertices[0];
  const glm::dvec3 n = glm::cross(e, f);
  const double area = glm::dot(n, n);
  return {glm::dot(glm::cross(q, f), n) / area, glm::dot(glm::cross(e, q), n) / area};
}

glm::dvec3 point_of(const Sphere& s, const Coordinates& at) {
  const double latitude = (at.v - 0.5) * pi;
  return s.centro + s.radio * (std::cos(latitude) * around(axes_across(up), at.u) + std::sin(latitude) * up);
}

template <Round Shape>
glm::dvec3 point_of(const Shape& c, const Coordinates& at) {
  return c.centro + at.v * c.altura * c.vector + radius(c, at.v) * around(axes_across(c.vector), at.u);
}

glm::dvec3 point_of(const Plane& plane, const Coordinates& at) {
  const Tangents axes = axes_across(plane.vector);
  return plane.centro + at.u * axes.u + at.v * axes.v;
}

glm::dvec3 point_of(const Disc& disc, const Coordinates& at) {
  const Tangents axes = axes_across(disc.vector);
  return disc.centro + disc.radio * ((2 * at.u - 1) * axes.u + (2 * at.v - 1) * axes.v);
}

glm::dvec3 point_of(const Triangle& t, const Coordinates& at) {
  return t.vertices[0] + at.u * (t.vertices[1] - t.vertices[0]) + at.v * (t.vertices[2] - t.vertices[0]);
}

Tangents tangents_of(const Sphere& s, const Coordinates& at) {
  const Tangents axes = axes_across(up);
  const double latitude = (at.v - 0.5) * pi;
  // At the poles themselves, whose latitude is no binary64, the cosine is 0 all the same.
  const double cosine = at.v <= 0 || at.v >= 1 ? 0 : std::cos(latitude);
  const glm::dvec3 outwards = around(axes, at.u), onwards = around(axes, at.u + 0.25);
  return {2 * pi * s.radio * cosine * onwards,
          pi * s.radio * (std::cos(latitude) * up - std::sin(latitude) * outwards)};
}

template <Round Shape>
Tangents tangents_of(const Shape& c, const Coordinates& at) {
  const Tangents axes = axes_across(c.vector);
  return {2 * pi * radius(c, at.v) * around(axes, at.u + 0.25), c.altura * c.vector + growth(c) * around(axes, at.u)};
}

Tangents tangents_of(const Plane& plane, const Coordinates&) { return axes_across(plane.vector); }

Tangents tangents_of(const Disc& disc, const Coordinates&) {
  const Tangents axes = axes_across(disc.vector);
  return {2 * disc.radio * axes.u, 2 * disc.radio * axes.v};
}

Tangents tangents_of(const Triangle& t, const Coordinates&) {
  return {t.vertices[1] - t.vertices[0], t.vertices[2] - t.vertices[0]};
}

}  // namespace

Coordinates coordinates(const scene::Scene& scene, scene::ElementRef element, const glm::dvec3& point) {
  return scene.visit(element, [&](const auto& shape) { return coordinates_of(shape, point); });
}

glm::dvec3 point_at(const scene::Scene& scene, scene::ElementRef element, const Coordinates& at) {
  return scene.visit(element, [&](const auto& shape) { return point_of(shape, at); });
}

Tangents tangents(const scene::Scene& scene, scene::ElementRef element, const Coordinates& at) {
  return scene.visit(element, [&](const auto& shape) { return tangents_of(shape, at); });
}

}  // namespace durero::render
