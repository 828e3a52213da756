#pragma once
/// The looks of materials combine coefficients and textures; they are prepared once and evaluated at points.

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "durero/render/texture/coordinates.hpp"
#include "durero/scene/scene.hpp"
#include "durero/scene/stage.hpp"

namespace durero::render {

/// A look is the coefficients of a material at a point, by their names in scene::Material.
struct Look {
  explicit Look(const scene::Material& m);

  glm::dvec3 color;
  double k_a, k_d, k_s, e, k_ps;
  glm::dvec3 M_PS;
  double gloss;
  double k_t;
  glm::dvec3 M_T;
  double index;
  glm::dvec3 emission, ambient;

  /// Whether the look sends rays on, by mirroring or transparency.
  bool sends_rays_on() const noexcept { return k_ps > 0 || k_t > 0; }
  /// Whether the look sends some part of a light towards some ray.
  bool sends_light() const noexcept { return k_s > 0 || ((k_a != 0 || k_d != 0) && color != glm::dvec3(0)); }
};

/// A material with its textures. It refers to the stage.
struct TexturedMaterial {
  /// A material of the stage. Throws std::domain_error where the material names a texture that the stage has not.
  TexturedMaterial(const scene::Material& m, const scene::Stage& stage);

  Look plain;  ///< the look without textures
  std::array<const scene::Texture*, scene::coefficient_words.size()> textures{};
  bool varies = false;  ///< whether a coefficient has a texture
  const scene::Texture* relief = nullptr;
  double height = 0;
  std::optional<double> delta{};

  /// Whether the look and the normal are the same at each point.
  bool is_bare() const noexcept { return !varies && relief == nullptr; }
  /// The look at a point that is seen from that distance: each coefficient times its texture.
  Look look(const TextureCoordinates& at, double distance) const;
  /// The outer unit normal n as the relief turns it there. Precondition: the material has a relief.
  glm::dvec3 normal(const Tangents& tangents, const glm::dvec3& n, const TextureCoordinates& at) const;
};

class Looks {
 public:
  /// The looks of the stage's materials. The stage must outlive them and keep its textures where they are. Throws as
  /// Worn does.
  explicit Looks(const scene::Stage& stage);

  /// The look of a material by its number, or of an element without a material.
  const TexturedMaterial& of(std::optional<std::uint32_t> material) const {
    return worn_[material ? *material + 1 : 0];
  }

 private:
  std::vector<TexturedMaterial> worn_;
};

}  // namespace durero::render
