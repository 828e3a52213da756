// (u, v) of the points of each surface, in POV-Ray's language.
#include <fmt/format.h>

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

template <class Round>
PovCoordinates coordinates_round(const Round& c) {
  return {turn(scene::axes_across(c.vector), c.centro), fmt::format("{}/{}", advance(c.vector, c.centro), c.altura)};
}

PovCoordinates coordinates_of(const scene::Cylinder& c) { return coordinates_round(c); }
PovCoordinates coordinates_of(const scene::Cone& c) { return coordinates_round(c); }
PovCoordinates coordinates_of(const scene::TruncatedCone& c) { return coordinates_round(c); }

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

}  // namespace

PovCoordinates pov_coordinates(const scene::Scene& scene, scene::ElementRef element) {
  return scene.visit(element, [](const auto& shape) { return coordinates_of(shape); });
}

}  // namespace durero::io
