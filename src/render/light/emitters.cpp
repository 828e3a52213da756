#include "emitters.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <optional>

#include "durero/render/sample/maps.hpp"
#include "durero/scene/stage.hpp"

namespace durero::render {
namespace {

using std::numbers::pi;

std::uint64_t key_of_element(scene::ElementRef e) { return (std::uint64_t(e.tipo) << 32) | e.index; }

/// @{ The area of a shape; 0 where it has no end.
double area_of(const scene::Sphere& s) { return 4 * pi * s.radio * s.radio; }
double area_of(const scene::Cylinder& s) { return 2 * pi * s.radio * s.altura; }
double area_of(const scene::Cone& s) { return pi * s.proporcion * s.altura * s.altura * std::hypot(1.0, s.proporcion); }
double area_of(const scene::TruncatedCone& s) {
  return pi * (2 * s.radio + s.proporcion * s.altura) * s.altura * std::hypot(1.0, s.proporcion);
}
double area_of(const scene::Plane&) { return 0; }
double area_of(const scene::Disc& s) { return pi * s.radio * s.radio; }
double area_of(const scene::Triangle& s) {
  const auto& [a, b, c] = s.vertices;
  return glm::length(glm::cross(b - a, c - a)) / 2;
}
/// @}

/// The point of a surface of revolution at that advance and radius, turned by a share of a whole turn.
glm::dvec3 around(const glm::dvec3& centro, const glm::dvec3& axis, double advance, double radius, double share) {
  const auto [u, v] = across(axis);
  return centro + advance * axis + radius * (std::cos(2 * pi * share) * u + std::sin(2 * pi * share) * v);
}

/// @{ A point of a shape, anywhere with equal density of area. The area of a cone grows with the square of its radius.
glm::dvec3 point_on(const scene::Sphere& s, const glm::dvec2& pair) { return s.centro + s.radio * on_sphere(pair); }
glm::dvec3 point_on(const scene::Cylinder& s, const glm::dvec2& pair) {
  return around(s.centro, s.vector, pair.x * s.altura, s.radio, pair.y);
}
glm::dvec3 point_on(const scene::Cone& s, const glm::dvec2& pair) {
  const double left = s.altura * std::sqrt(pair.x);  // up to the apex
  return around(s.centro, s.vector, s.altura - left, s.proporcion * left, pair.y);
}
glm::dvec3 point_on(const scene::TruncatedCone& s, const glm::dvec2& pair) {
  const double wide = s.radio + s.proporcion * s.altura;
  const double radius = std::sqrt(s.radio * s.radio + pair.x * (wide * wide - s.radio * s.radio));
  return around(s.centro, s.vector, (wide - radius) / s.proporcion, radius, pair.y);
}
glm::dvec3 point_on(const scene::Plane& s, const glm::dvec2&) { return s.centro; }
glm::dvec3 point_on(const scene::Disc& s, const glm::dvec2& pair) {
  const auto [u, v] = across(s.vector);
  const glm::dvec2 place = s.radio * in_disc(pair);
  return s.centro + place.x * u + place.y * v;
}
glm::dvec3 point_on(const scene::Triangle& s, const glm::dvec2& pair) {
  const auto& [a, b, c] = s.vertices;
  const glm::dvec2 weights = in_triangle(pair);
  return a + weights.x * (b - a) + weights.y * (c - a);
}
/// @}

/// The cone that a sphere fills, seen from a point.
struct SightCone {
  glm::dvec3 axis;  ///< unit vector
  double versine;
};

/// Nothing from a point on the sphere or within it.
std::optional<SightCone> seen(const scene::Scene& scene, scene::ElementRef element, const glm::dvec3& from,
                              const scene::ElementSet& en) {
  if (element.tipo != model::Tipo::soy_esfera || scene::Origin(en).contains(element)) return std::nullopt;
  const scene::Sphere& sphere = scene.shapes<scene::Sphere>()[element.index];
  const glm::dvec3 to = sphere.centro - from;
  const double square = glm::dot(to, to), sine_square = sphere.radio * sphere.radio / square;
  if (!(sine_square < 1)) return std::nullopt;
  return SightCone{to / std::sqrt(square), sine_square / (1 + std::sqrt(1 - sine_square))};
}

/// The density by solid angle of a point that is drawn by area.
double by_solid_angle(double area, const glm::dvec3& way, const glm::dvec3& normal) {
  const double square = glm::dot(way, way), cosine = std::abs(glm::dot(way, normal)) / std::sqrt(square);
  return cosine > 0 ? square / (cosine * area) : 0;
}

double power_of(const glm::dvec3& emission) { return std::max({emission.x, emission.y, emission.z}); }

}  // namespace

Emitters::Emitters(const scene::Scene& scene, const engine::Engine& engine) : scene_(scene), engine_(engine) {
  double sum = 0;
  scene.for_each([&](scene::ElementRef element, const auto& shape) {
    if (scene.body(element) != nullptr) return;  // its area is unknown: rays that happen to meet it bring its light
    const auto material = scene.material(element);
    const double area = area_of(shape);
    const double power = material ? area * power_of(scene.stage().materials[*material].emission) : 0;
    if (power > 0) all_.push_back({element, area, power, sum += power});
  });
  for (std::size_t i = 0; i < all_.size(); ++i) {
    all_[i].chance /= sum;
    all_[i].up_to /= sum;
    places_.emplace(key_of_element(all_[i].element), i);
  }
}

EmitterDraw Emitters::draw(const glm::dvec3& from, const scene::ElementSet& en, double choice,
                           const glm::dvec2& pair) const {
  const auto found = std::ranges::lower_bound(all_, choice, {}, &Emitter::up_to);
  const Emitter& one = found == all_.end() ? all_.back() : *found;
  if (const auto cone = seen(scene_, one.element, from, en))
    return {one.element, in_cone(pair, cone->axis, cone->versine), one.chance / (2 * pi * cone->versine), false, false};
  const glm::dvec3 point = scene_.visit(one.element, [&](const auto& shape) { return point_on(shape, pair); });
  const glm::dvec3 way = point - from;
  if (way == glm::dvec3(0)) return {one.element, way};
  const glm::dvec3 normal = engine_.normal(scene_, one.element, point);
  return {one.element, way, one.chance * by_solid_angle(one.area, way, normal), glm::dot(normal, way) > 0};
}

double Emitters::density(const glm::dvec3& from, const scene::ElementSet& en, scene::ElementRef element,
                         const glm::dvec3& point, const glm::dvec3& normal) const {
  const auto found = places_.find(key_of_element(element));
  if (found == places_.end()) return 0;
  const Emitter& one = all_[found->second];
  if (const auto cone = seen(scene_, element, from, en)) return one.chance / (2 * pi * cone->versine);
  return one.chance * by_solid_angle(one.area, point - from, normal);
}

}  // namespace durero::render
