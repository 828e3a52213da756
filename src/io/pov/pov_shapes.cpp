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
  in_.comma();
  return {scene::Sphere{center, in_.number("sphere")}};
}

PovShape PovShapes::cylinder() {
  const glm::dvec3 base = vertex("cylinder"), end = vertex("cylinder");
  const double radius = in_.number("cylinder");
  return between({base, radius}, {end, radius});
}

PovShape PovShapes::cone() {
  RoundEnd ends[2];
  for (RoundEnd& end : ends) {
    end.at = vertex("cone");
    end.radius = in_.number("cone");
    if (&end == ends) in_.comma();
  }
  const bool is_turned = ends[0].radius < ends[1].radius;  // the narrow end is written first
  return between(ends[is_turned ? 1 : 0], ends[is_turned ? 0 : 1]);
}

PovShape PovShapes::between(const RoundEnd& one, const RoundEnd& other) {
  PovShape shape{scene::Cylinder{}};
  shape.ends = {one, other};
  shape.is_closed = !in_.take("open");
  return shape;
}

PovShape PovShapes::disc() {
  const glm::dvec3 center = vertex("disc"), vector = direction("disc");
  const double radius = in_.number("disc");
  PovShape shape{scene::Disc{center, radius, vector}};
  in_.comma();
  if (in_.here() != nullptr && begins_pov_expression(*in_.here())) shape.hole = in_.number("disc");
  return shape;
}

/// It is as far from the origin as the number says, whatever the length of the normal.
PovShape PovShapes::plane() {
  const glm::dvec3 vector = direction("plane");
  PovShape shape{scene::Plane{{}, vector}};
  shape.distance = in_.number("plane");
  return shape;
}

scene::Plane PovShapes::plane_at(std::size_t at, glm::dvec3 vector, double distance, const PovTransform& by) {
  const bool is_rounded = distance != 0 && (!by.is_identity() || !is_along_an_axis(vector));
  if (is_rounded) ++planes_;
  const glm::dvec3 point = distance == 0 ? by.shift : by.point(distance * vector);
  return {point, turned(at, "plane", vector, by)};
}

/// The direction across what becomes of a plane.
glm::dvec3 PovShapes::turned(std::size_t at, std::string_view word, const glm::dvec3& normal, const PovTransform& by) {
  if (by.is_shift()) return normal;
  const auto axis = axis_between(glm::dvec3(0), by.normal(normal));
  if (!axis)
    in_.fail(at, fmt::format("the normal of {} gives no direction", word), "expected a smaller transformation");
  if (!is_along_an_axis(axis->vector)) ++directions_;
  return axis->vector;
}

namespace {
/// Whether sums are what they would be without rounding.
bool is_exact_sum(const glm::dvec3& a, const glm::dvec3& b) {
  const glm::dvec3 sum = a + b;
  return sum - a == b && sum - b == a;
}
}  // namespace

std::optional<PovShape> PovShapes::placed(std::size_t at, std::string_view word, const PovShape& shape,
                                          const PovTransform& by) {
  PovShape made = shape;
  const auto moved = [&](const glm::dvec3& p) {
    if (!by.is_shift() || !is_exact_sum(p, by.shift)) ++moved_;
    return by.point(p);
  };
  if (shape.ends) {
    auto ends = *shape.ends;
    if (!by.scale) return std::nullopt;
    if (!by.is_identity())
      for (RoundEnd& end : ends) end = {moved(end.at), end.radius * *by.scale};
    const auto surface = surface_between(ends[0], ends[1], rounded_);
    if (!surface)
      in_.fail(at, fmt::format("the ends of {} give no axis", word), "expected two points, a finite distance apart");
    made.surface = *surface;
  } else if (shape.distance) {
    made.surface = plane_at(at, std::get<scene::Plane>(shape.surface).vector, *shape.distance, by);
  } else if (by.is_identity()) {
    return made;
  } else if (auto* const triangle = std::get_if<scene::Triangle>(&made.surface)) {
    for (glm::dvec3& vertex : triangle->vertices) vertex = moved(vertex);
    if (made.normals)
      for (glm::dvec3& normal : *made.normals) normal = by.normal(normal);
  } else if (!by.scale) {
    return std::nullopt;
  } else if (auto* const sphere = std::get_if<scene::Sphere>(&made.surface)) {
    *sphere = {moved(sphere->centro), sphere->radio * *by.scale};
  } else if (auto* const disc = std::get_if<scene::Disc>(&made.surface)) {
    *disc = {moved(disc->centro), disc->radio * *by.scale, turned(at, word, disc->vector, by)};
  }
  return made;
}

PovShape PovShapes::triangle() {
  const glm::dvec3 a = vertex("triangle"), b = vertex("triangle");
  return {scene::Triangle{{a, b, in_.triple("triangle")}}};
}

PovShape PovShapes::smooth_triangle() {
  scene::Triangle triangle;
  scene::VertexNormals normals;
  for (std::size_t i = 0; i < normals.size(); ++i) {
    if (i > 0) in_.comma();
    triangle.vertices[i] = vertex("smooth_triangle");
    normals[i] = in_.triple("smooth_triangle");
  }
  if (scene::have_directions(normals)) return {.surface = triangle, .normals = normals};
  ++flat_;
  return {triangle};
}

glm::dvec3 PovShapes::vertex(std::string_view what) {
  const glm::dvec3 vertex = in_.triple(what);
  in_.comma();
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
  rounded_.name_losses(lost);
  add_loss(lost, directions_, "direction", "directions", "rounded: those of a scene have length 1");
  add_loss(lost, planes_, "plane", "planes", "rounded: a scene holds a point of it");
  add_loss(lost, moved_, "point", "points", "moved by a transformation: rounded");
  add_loss(lost, flat_, "triangle", "triangles", "kept flat: a normal at a vertex has no direction");
}

}  // namespace durero::io
