#pragma once
/// What materials have of textures, made ready once: their look at a point.

#include <array>
#include <cstdint>
#include <map>
#include <optional>

#include "durero/render/coordinates.hpp"
#include "durero/scene/scene.hpp"

namespace durero::render {

/// A material with textures. It refers to the stage.
struct Worn {
  scene::Material plain;  ///< without them
  std::array<const scene::Texture*, scene::coefficient_words.size()> textures{};
  const scene::Texture* relief = nullptr;
  double height = 0;
  std::optional<double> delta{};

  /// At a point that is seen from that distance: each coefficient times its texture.
  scene::Material look(const Coordinates& at, double distance) const;
  /// The outer unit normal n, as the relief turns it there.
  glm::dvec3 normal(const Tangents& tangents, const glm::dvec3& n, const Coordinates& at) const;
};

class Looks {
 public:
  /// Of the materials of the stage, which must outlive it and keep its textures where they are. Throws
  /// std::domain_error where a material names a texture that it has not.
  explicit Looks(const scene::Stage& stage);

  /// Of a material, by its place; null where it has no textures.
  const Worn* of(std::optional<std::uint32_t> material) const {
    if (!material || worn_.empty()) return nullptr;
    const auto found = worn_.find(*material);
    return found == worn_.end() ? nullptr : &found->second;
  }

 private:
  std::map<std::uint32_t, Worn> worn_;
};

}  // namespace durero::render
