#include "pov_solids.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "durero/scene/scene.hpp"
#include "durero/scene/solids.hpp"
#include "io/losses.hpp"
#include "pov_mesh.hpp"
#include "pov_turned.hpp"

namespace durero::io {
namespace {

/// A `union` within a solid is one, too.
scene::Compound::Operation operation_of(std::string_view word) {
  if (word == "intersection") return scene::Compound::Operation::intersected;
  return word == "difference" ? scene::Compound::Operation::subtracted : scene::Compound::Operation::united;
}

}  // namespace

std::array<glm::dvec3, 2> PovSolids::box() {
  const glm::dvec3 a = in_.triple("box");
  in_.comma();
  return {a, in_.triple("box")};
}

bool PovSolids::is_solid(const PovObject& object) {
  if (object.is_left_out || object.is_inverse || object.is_clipped() || object.light) return false;
  if (object.box) return scene::box_between((*object.box)[0], (*object.box)[1]).has_value();
  if (object.shape) {
    const bool has_axis = object.shape->ends.has_value();
    return has_axis ? object.shape->is_closed : scene::bounds_a_solid(scene::unmoved(object.shape->surface));
  }
  return !is_of_triangles(object.word) && !is_turned(object.word) && !object.parts.empty() &&
         std::ranges::all_of(object.parts, is_solid);
}

const ObjectMaterial* PovSolids::first_look(const PovObject& object) {
  if (object.look.is_told) return &object.look;
  for (const PovObject& part : object.parts)
    if (const ObjectMaterial* const look = first_look(part)) return look;
  return nullptr;
}

scene::Body PovSolids::body(const PovObject& object, const ObjectMaterial& whole, const PovTransform& by) {
  if (object.look.is_told && object.look.material != whole.material) ++looks_;
  const PovTransform here = object.moved.then(by);
  if (object.shape) return body_of(object, *object.shape, here);
  if (object.box) return body_of(*object.box, here);
  scene::Compound solid{operation_of(object.word), {}};
  for (const PovObject& part : object.parts) solid.parts.push_back(body(part, whole, here));
  if (solid.parts.size() == 1) return std::move(solid.parts.front());
  return {std::move(solid)};
}

scene::Body PovSolids::body_of(const std::array<glm::dvec3, 2>& box, const PovTransform& by) const {
  const auto [a, b] = box;
  if (by.keeps_axes())
    if (auto moved = scene::box_between(by.point(a), by.point(b))) return {*std::move(moved)};
  return scene::copied(by.map(), {*scene::box_between(a, b)});
}

scene::Body PovSolids::body_of(const PovObject& object, const PovShape& shape, const PovTransform& by) {
  if (const auto placed = shapes_.placed(object.at, object.word, shape, by)) return checked_body(object, *placed);
  return scene::copied(by.map(), checked_body(object, *shapes_.placed(object.at, object.word, shape, {})));
}

/// The body of a shape that bounds a solid, where it stands.
scene::Body PovSolids::checked_body(const PovObject& object, const PovShape& shape) const {
  const auto add = [](const auto& s) { return scene::Scene().add(model::Elemento("part"), s); };
  const model::Answer answer = std::visit(add, shape.surface);
  if (!answer.ok())
    in_.fail(object.at, std::string(model::name(answer.r)),
             fmt::format("expected {} ({})", answer.violated->predicate, answer.violated->label), answer.violated);
  return scene::unmoved(shape.surface);
}

void PovSolids::name_losses(std::vector<std::string>& lost) const {
  add_loss(lost, looks_, "part", "parts", "of a solid without its own texture: a solid has one");
}

}  // namespace durero::io
