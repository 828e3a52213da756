#include "pov_solids.hpp"

#include <fmt/format.h>

#include <utility>

#include "durero/scene/scene.hpp"
#include "durero/scene/solids.hpp"
#include "io/losses.hpp"

namespace durero::io {
namespace {

/// A `union` within a solid is one, too.
scene::Compound::Operation operation_of(std::string_view word) {
  if (word == "intersection") return scene::Compound::Operation::intersected;
  return word == "difference" ? scene::Compound::Operation::subtracted : scene::Compound::Operation::united;
}

}  // namespace

scene::Compound PovSolids::box(std::size_t at) {
  const glm::dvec3 a = in_.triple("box");
  in_.comma("box");
  auto box = scene::box_between(a, in_.triple("box"));
  if (!box)
    in_.fail(at, "the corners of box lie in one plane across an axis", "expected two that differ in x, y and z");
  return *std::move(box);
}

const ObjectMaterial* PovSolids::first_look(const PovObject& object) {
  if (object.look.is_told) return &object.look;
  for (const PovObject& part : object.parts)
    if (const ObjectMaterial* const look = first_look(part)) return look;
  return nullptr;
}

scene::Body PovSolids::body(const PovObject& object, const ObjectMaterial& whole) {
  if (object.look.is_told && object.look.material != whole.material) ++looks_;
  if (object.shape) return body(object, *object.shape);
  if (object.box) return {*object.box};
  if (object.word == "mesh") in_.fail(object.at, "a mesh in a solid", "expected what bounds a solid, as a sphere does");
  if (object.parts.empty()) in_.fail(object.at, fmt::format("{} has no parts", object.word), "expected some");
  scene::Compound solid{operation_of(object.word), {}};
  for (const PovObject& part : object.parts) solid.parts.push_back(body(part, whole));
  if (solid.parts.size() == 1) return std::move(solid.parts.front());
  return {std::move(solid)};
}

scene::Body PovSolids::body(const PovObject& object, const PovShape& shape) const {
  scene::Body body = scene::unmoved(shape.surface);
  if (!scene::bounds_a_solid(body))
    in_.fail(object.at, fmt::format("a {} in a solid", object.word), "expected what bounds a solid, as a sphere does");
  const bool has_axis = std::visit([](const auto& s) { return requires { s.altura; }; }, shape.surface);
  if (has_axis && !shape.is_closed)
    in_.fail(object.at, fmt::format("an open {} in a solid", object.word), "expected one with its caps");
  const auto add = [](const auto& s) { return scene::Scene().add(model::Elemento("part"), s); };
  const model::Answer answer = std::visit(add, shape.surface);
  if (!answer.ok())
    in_.fail(object.at, std::string(model::name(answer.r)),
             fmt::format("expected {} ({})", answer.violated->predicate, answer.violated->label), answer.violated);
  return body;
}

void PovSolids::name_losses(std::vector<std::string>& lost) const {
  add_loss(lost, looks_, "part", "parts", "of a solid without its own texture: a solid has one");
}

}  // namespace durero::io
