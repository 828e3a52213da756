#include "pov_shapes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "durero/model/tipos.hpp"
#include "io/losses.hpp"

namespace durero::io {
namespace {

/// Whether all but one of its components are 0: its length, and a multiple of it, are then exact.
bool is_along_an_axis(const glm::dvec3& v) { return (v.x == 0) + (v.y == 0) + (v.z == 0) >= 2; }

}  // namespace

PovShape PovShapes::read(std::string_view word) {
  using Reading = PovShape (PovShapes::*)();
  static constexpr Reading readings[] = {&PovShapes::sphere,         &PovShapes::cylinder, &PovShapes::cone,
                                         &PovShapes::disc,           &PovShapes::plane,    &PovShapes::triangle,
                                         &PovShapes::smooth_triangle};
  return (this->*readings[std::ranges::find(words, word) - words.begin()])();
}

PovShape PovShapes::sphere() {
  const glm::dvec3 center = in_.triple("sphere");
  in_.comma("sphere");
  return {scene::Sphere{center, in_.number("sphere")}};
}

PovShape PovShapes::cylinder() {
  const std::size_t at = in_.offset();
  const glm::dvec3 base = vertex("cylinder"), end = vertex("cylinder");
  const double radius = in_.number("cylinder");
  return along_axis("cylinder", at, {base, radius}, {end, radius});
}

PovShape PovShapes::cone() {
  const std::size_t at = in_.offset();
  End ends[2];
  for (End& end : ends) {
    end.at = vertex("cone");
    end.radius = in_.number("cone");
    if (&end == ends) in_.comma("cone");
  }
  const bool is_turned = ends[0].radius < ends[1].radius;  // the narrow end is written first
  return along_axis("cone", at, ends[is_turned ? 1 : 0], ends[is_turned ? 0 : 1]);
}

PovShape PovShapes::along_axis(std::string_view word, std::size_t at, const End& wide, const End& narrow) {
  const auto axis = axis_between(wide.at, narrow.at);
  if (!axis)
    in_.fail(at, fmt::format("the ends of {} give no axis", word), "expected two points, a finite distance apart");
  if (end_of(wide.at, *axis) != narrow.at) ++axes_;
  PovShape shape{wide.radius == narrow.radius
                     ? scene::AnyShape(scene::Cylinder{wide.at, wide.radius, axis->vector, axis->altura})
                     : narrowing(*axis, wide, narrow)};
  shape.is_closed = !in_.take("open");
  return shape;
}

scene::AnyShape PovShapes::narrowing(const Axis& axis, const End& wide, const End& narrow) {
  const double proportion = proportion_between(wide.radius, narrow.radius, axis.altura);
  if (narrow.radius + proportion * axis.altura != wide.radius) ++proportions_;
  if (narrow.radius == 0) return scene::Cone{wide.at, proportion, axis.vector, axis.altura};
  return scene::TruncatedCone{wide.at, narrow.radius, proportion, axis.vector, axis.altura};
}

PovShape PovShapes::disc() {
  const glm::dvec3 center = vertex("disc"), vector = direction("disc");
  const double radius = in_.number("disc");
  const std::size_t at = in_.offset();
  if (in_.take(",") && in_.number("disc") != 0)
    in_.fail(at, "a disc with a hole", "expected no second radius: no surface here has a hole");
  return {scene::Disc{center, radius, vector}};
}

/// It is as far from the origin as the number says, whatever the length of the normal.
PovShape PovShapes::plane() {
  const glm::dvec3 vector = direction("plane");
  const double distance = in_.number("plane");
  const bool is_moved = in_.take("translate");
  const glm::dvec3 by = is_moved ? in_.triple("translate") : glm::dvec3(0);
  if (distance == 0) return {scene::Plane{by, vector}};
  if (is_moved || !is_along_an_axis(vector)) ++planes_;
  return {scene::Plane{distance * vector + by, vector}};
}

PovShape PovShapes::triangle() {
  const glm::dvec3 a = vertex("triangle"), b = vertex("triangle");
  return {scene::Triangle{{a, b, in_.triple("triangle")}}};
}

PovShape PovShapes::smooth_triangle() {
  scene::Triangle triangle;
  scene::VertexNormals normals;
  for (std::size_t i = 0; i < normals.size(); ++i) {
    if (i > 0) in_.comma("smooth_triangle");
    triangle.vertices[i] = vertex("smooth_triangle");
    normals[i] = in_.triple("smooth_triangle");
  }
  if (scene::have_directions(normals)) return {.surface = triangle, .normals = normals};
  ++flat_;
  return {triangle};
}

glm::dvec3 PovShapes::vertex(std::string_view what) {
  const glm::dvec3 vertex = in_.triple(what);
  in_.comma(what);
  return vertex;
}

/// What is no unit vector is made one, with 64 bits of significand as axis_between() does: from the origin to its end.
glm::dvec3 PovShapes::direction(std::string_view what) {
  const std::size_t at = in_.offset();
  const glm::dvec3 normal = vertex(what);
  if (model::Unitario::contains(model::Vector{normal})) return normal;
  const auto axis = axis_between(glm::dvec3(0), normal);
  if (!axis)
    in_.fail(at, fmt::format("the normal of {} gives no direction", what),
             "expected a vector of finite length above 0");
  if (!is_along_an_axis(normal)) ++directions_;
  return axis->vector;
}

void PovShapes::name_losses(std::vector<std::string>& lost) const {
  add_loss(lost, axes_, "axis", "axes", "rounded: a scene holds a direction and a length");
  add_loss(lost, proportions_, "proportion", "proportions",
           "rounded: a scene holds how much a cone narrows by its height");
  add_loss(lost, directions_, "direction", "directions", "rounded: those of a scene have length 1");
  add_loss(lost, planes_, "plane", "planes", "rounded: a scene holds a point of it");
  add_loss(lost, flat_, "triangle", "triangles", "kept flat: a normal at a vertex has no direction");
}

}  // namespace durero::io
