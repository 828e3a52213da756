#include "durero/scene/scene.hpp"

#include <stdexcept>

namespace durero::scene {

const Label& Scene::label(ElementRef element) const noexcept {
  switch (element.tipo) {
    case model::Tipo::soy_esfera:
      return spheres_.labels[element.index];
    case model::Tipo::soy_cilindro:
      return cylinders_.labels[element.index];
    case model::Tipo::soy_cono:
      break;
  }
  return cones_.labels[element.index];
}

const model::Elemento& Scene::name(ElementRef element) const noexcept { return label(element).name; }

std::optional<ElementRef> Scene::find(std::string_view text, NameIndex::hash_type hash) const noexcept {
  return index_.find(hash, [&](ElementRef place) { return label(place).name.name() == text; });
}

std::optional<ElementRef> Scene::find(std::string_view text) const noexcept {
  return find(text, NameIndex::hash(text));
}

std::optional<std::uint32_t> Scene::material(ElementRef element) const noexcept {
  const std::uint32_t material = label(element).material;
  if (material == no_material) return std::nullopt;
  return material;
}

void Scene::set_material(ElementRef element, std::optional<std::uint32_t> material) {
  if (material && *material >= stage_.materials.size()) throw std::out_of_range("no such material");
  const_cast<Label&>(label(element)).material = material.value_or(no_material);  // this scene is not a constant
}

}  // namespace durero::scene
