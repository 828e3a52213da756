#include "looks.hpp"

#include <algorithm>
#include <stdexcept>

#include "durero/render/light/whitted.hpp"
#include "durero/render/texture/bump.hpp"
#include "durero/render/texture/texture.hpp"
#include "durero/scene/stage.hpp"

namespace durero::render {
namespace {

using scene::Coefficient;

const scene::Texture* find(const scene::Stage& stage, const std::string& name) {
  if (name.empty()) return nullptr;
  const auto found = std::ranges::find(stage.textures, name, &scene::Texture::name);
  if (found == stage.textures.end()) throw std::domain_error("a material names a texture that the scene has not");
  return &*found;
}

void multiply(Look& m, Coefficient coefficient, const glm::dvec3& by) {
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

Look::Look(const scene::Material& m)
    : color(m.color),
      k_a(m.k_a),
      k_d(m.k_d),
      k_s(m.k_s),
      e(m.e),
      k_ps(m.k_ps),
      M_PS(m.M_PS),
      gloss(m.gloss),
      k_t(m.k_t),
      M_T(m.M_T),
      index(m.index),
      emission(m.emission),
      ambient(m.ambient) {}

TexturedMaterial::TexturedMaterial(const scene::Material& m, const scene::Stage& stage)
    : plain(m), varies(m.textures.any()) {
  for (std::size_t c = 0; c < textures.size(); ++c) textures[c] = find(stage, m.textures.names[c]);
  if (!m.bump) return;
  relief = find(stage, m.bump->texture);
  height = m.bump->height;
  delta = m.bump->delta;
}

Look TexturedMaterial::look(const TextureCoordinates& at, double distance) const {
  Look look = plain;
  for (std::size_t i = 0; i < textures.size(); ++i)
    if (textures[i] != nullptr) multiply(look, static_cast<Coefficient>(i), texture_at(*textures[i], at, distance));
  return look;
}

glm::dvec3 TexturedMaterial::normal(const Tangents& tangents, const glm::dvec3& n, const TextureCoordinates& at) const {
  return bumped(tangents, n, height * slopes(*relief, at, delta));
}

Looks::Looks(const scene::Stage& stage) {
  worn_.reserve(stage.materials.size() + 1);
  worn_.emplace_back(scene::Material{.color = default_color}, stage);
  for (const scene::Material& m : stage.materials) worn_.emplace_back(m, stage);
}

}  // namespace durero::render
