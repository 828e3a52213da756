#include "durero/scene/element_record.hpp"

#include <utility>

#include "durero/scene/edit.hpp"

namespace durero::scene {
namespace {

KeptElement kept(const GroupedScene& of, ElementRef element, const std::string& name) {
  const Scene& scene = of.scene;
  const Body* const body = scene.body(element);
  const glm::dvec3* const motion = scene.motion(element);
  return {scene.visit(element, [](const auto& shape) { return AnyShape(shape); }),
          scene.material(element),
          scene.wrap(element),
          scene.vertex_normals(element),
          motion == nullptr ? std::nullopt : std::optional(*motion),
          body == nullptr ? std::nullopt : std::optional(*body),
          std::string(of.groups.of_element(name))};
}

void remove_element(GroupedScene& of, const std::string& name) {
  if (of.scene.find(name)) of.apply_total(Edit{model::Eliminar_Elemento{model::Elemento(name)}, {}});
}

void add_kept(GroupedScene& of, const std::string& name, const KeptElement& element) {
  std::visit([&](const auto& shape) { of.scene.add(model::Elemento(name), shape, element.material); }, element.shape);
  const ElementRef added = of.scene.find(name).value();
  if (element.wrap) of.scene.set_wrap(added, *element.wrap);
  if (element.normals) of.scene.set_vertex_normals(added, *element.normals);
  if (element.motion) of.scene.set_motion(added, *element.motion);
  if (element.body) of.scene.set_body(added, *element.body);
  if (of.groups.table().contains(element.group)) of.groups.put(name, element.group);
}

}  // namespace

ElementRecord record_of(const GroupedScene& scene, const std::string& name) {
  const auto element = scene.scene.find(name);
  if (!element || scene.scene.face(*element)) return {name, std::nullopt};
  return {name, kept(scene, *element, name)};
}

void restore(GroupedScene& scene, const ElementRecord& record) {
  remove_element(scene, record.name);
  if (record.element) add_kept(scene, record.name, *record.element);
}

MeshRecord mesh_record_of(const GroupedScene& scene, const model::Elemento& m) {
  const Meshes& meshes = scene.scene.meshes();
  const auto place = meshes.find(m.name());
  return {m, place ? std::optional(meshes[*place]) : std::nullopt, scene.groups};
}

void restore(GroupedScene& scene, const MeshRecord& record) {
  const bool is_there = scene.scene.meshes().find(record.m.name()).has_value();
  if (is_there) scene.apply_total(MeshEdit(MeshRemoval{record.m}));
  if (record.mesh) scene.apply_total(MeshEdit(MeshAddition{*record.mesh}));
  scene.groups = record.groups;
}

}  // namespace durero::scene
