#pragma once
/// The looks that programs for physical light have of materials: one colour by Lambert's law, mirrors and glass.

#include <cstdint>
#include <glm/vec3.hpp>

#include "durero/scene/stage.hpp"

namespace durero::io {

/// How a surface sends light on.
enum class SimpleKind : std::uint8_t { diffuse, mirror, glass };

/// A look of one kind.
struct SimpleLook {
  SimpleKind kind;
  glm::dvec3 color;  ///< the share of light that goes on
  double index = 1;  ///< of refraction, of glass
};

/// The look of what has no material, as a picture here shows it.
inline constexpr SimpleLook look_of_none{SimpleKind::diffuse, glm::dvec3(0.8)};

/// The look of the greatest of a material's shares.
SimpleLook simple_look(const scene::Material& material);

/// Whether a material is that look, perhaps with an emission: one that readers make of the look.
bool is_look(const SimpleLook& look, const scene::Material& material);

}  // namespace durero::io
