#include "numbered_materials.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "durero/scene/by_name.hpp"
#include "durero/scene/stage.hpp"

namespace durero::io {

NumberedMaterials::Numbers NumberedMaterials::numbers_of(const scene::Material& m) {
  Numbers numbers{m.k_a, m.k_d, m.k_s, m.e, m.k_ps, m.k_t, m.index};
  auto next = numbers.begin() + 7;
  for (const glm::dvec3& color : {m.color, m.M_PS, m.M_T, m.emission, m.ambient})
    for (int k = 0; k < 3; ++k) *next++ = color[k];
  return numbers;
}

std::uint32_t NumberedMaterials::number(scene::Material look) {
  auto& materials = scene_.stage().materials;
  const auto [known, is_new] =
      known_.try_emplace({numbers_of(look), look.textures.names}, static_cast<std::uint32_t>(materials.size()));
  if (is_new) {
    look.name = fmt::format("f{}", known_.size());
    materials.push_back(std::move(look));
  }
  return known->second;
}

void NumberedMaterials::finish() {
  auto& materials = scene_.stage().materials;
  const auto by_number = materials;
  std::ranges::sort(materials, {}, &scene::Material::name);
  const auto place = [&](std::uint32_t number) {
    const auto found = std::ranges::lower_bound(materials, by_number[number].name, {}, &scene::Material::name);
    return static_cast<std::uint32_t>(found - materials.begin());
  };
  for (const scene::ElementRef element : scene::elements_by_name(scene_)) {
    if (const auto number = scene_.material(element)) scene_.set_material(element, place(*number));
  }
}

}  // namespace durero::io
