#include "looks.hpp"

#include <algorithm>
#include <stdexcept>

#include "durero/render/bump.hpp"
#include "durero/render/texture.hpp"

namespace durero::render {
namespace {

using scene::Coefficient;

const scene::Texture* find(const scene::Stage& stage, const std::string& name) {
  if (name.empty()) return nullptr;
  const auto found = std::ranges::find(stage.textures, name, &scene::Texture::name);
  if (found == stage.textures.end()) throw std::domain_error("a material names a texture that the scene has not");
  return &*found;
}

void multiply(scene::Material& m, Coefficient coefficient, const glm::dvec3& by) {
  switch (coefficient) {
    case Coefficient::color:
      m.color *= by;
      return;
    case Coefficient::k_a:
      m.k_a *= grey(by);
      return;
    case Coefficient::k_d:
      m.k_d *= grey(by);
      return;
    case Coefficient::k_s:
      m.k_s *= grey(by);
      return;
    case Coefficient::k_ps:
      m.k_ps *= grey(by);
      return;
    case Coefficient::M_PS:
      m.M_PS *= by;
      return;
    case Coefficient::k_t:
      m.k_t *= grey(by);
      return;
    case Coefficient::M_T:
      m.M_T *= by;
      return;
    case Coefficient::emission:
      m.emission *= by;
      return;
    case Coefficient::ambient:
      m.ambient *= by;
  }
}

}  // namespace

scene::Material Worn::look(const Coordinates& at, double distance) const {
  scene::Material m = plain;
  for (std::size_t i = 0; i < textures.size(); ++i)
    if (textures[i] != nullptr) multiply(m, static_cast<Coefficient>(i), texture_at(*textures[i], at, distance));
  return m;
}

glm::dvec3 Worn::normal(const Tangents& tangents, const glm::dvec3& n, const Coordinates& at) const {
  return relief == nullptr ? n : bumped(tangents, n, height * slopes(*relief, at, delta));
}

Looks::Looks(const scene::Stage& stage) {
  for (std::size_t i = 0; i < stage.materials.size(); ++i) {
    const scene::Material& m = stage.materials[i];
    if (!m.textures.any() && !m.bump) continue;
    Worn& worn = worn_[static_cast<std::uint32_t>(i)];
    worn.plain = m;
    worn.plain.textures = {};
    worn.plain.bump.reset();
    for (std::size_t c = 0; c < worn.textures.size(); ++c) worn.textures[c] = find(stage, m.textures.names[c]);
    if (!m.bump) continue;
    worn.relief = find(stage, m.bump->texture);
    worn.height = m.bump->height;
    worn.delta = m.bump->delta;
  }
}

}  // namespace durero::render
