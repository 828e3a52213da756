#include "durero/scene/scene.hpp"

#include <stdexcept>
#include <tuple>

namespace durero::scene {
namespace {

/// What the visitor returns for the table that holds elements of this type.
template <class Tables, class Visitor>
decltype(auto) visit(model::Tipo tipo, Tables tables, Visitor&& visitor) {
  switch (tipo) {
    case model::Tipo::soy_esfera:
      return visitor(std::get<0>(tables));
    case model::Tipo::soy_cilindro:
      return visitor(std::get<1>(tables));
    case model::Tipo::soy_cono:
      break;
  }
  return visitor(std::get<2>(tables));
}

}  // namespace

const model::Elemento& Scene::name(ElementRef element) const noexcept {
  return visit(element.tipo, std::tie(spheres_, cylinders_, cones_),
               [&](const auto& table) -> const model::Elemento& { return table.names[element.index]; });
}

std::optional<ElementRef> Scene::find(std::string_view text, NameIndex::hash_type hash) const noexcept {
  return index_.find(hash, [&](ElementRef place) { return name(place).name() == text; });
}

std::optional<ElementRef> Scene::find(std::string_view text) const noexcept {
  return find(text, NameIndex::hash(text));
}

std::optional<std::uint32_t> Scene::material(ElementRef element) const noexcept {
  const std::uint32_t material = visit(element.tipo, std::tie(spheres_, cylinders_, cones_),
                                       [&](const auto& table) { return table.materials[element.index]; });
  if (material == no_material) return std::nullopt;
  return material;
}

void Scene::set_material(ElementRef element, std::optional<std::uint32_t> material) {
  if (material && *material >= stage_.materials.size()) throw std::out_of_range("no such material");
  visit(element.tipo, std::tie(spheres_, cylinders_, cones_),
        [&](auto& table) { table.materials[element.index] = material.value_or(no_material); });
}

}  // namespace durero::scene
