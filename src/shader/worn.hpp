#pragma once
/// The looks of a shader: materials as constants, and textures as functions that multiply coefficients.

#include <string>

#include "durero/scene/scene.hpp"

namespace durero::shader {

/// The looks of the elements of a scene, as parts of a shader's text.
struct WornText {
  std::string tables;     ///< constants, and which functions are needed
  std::string functions;  ///< look_of(material, element, at)
};

/// Throws std::domain_error of a material that a shader cannot hold, as fragment_shader() does.
WornText worn_text(const scene::Scene& scene, std::uint32_t depth);

}  // namespace durero::shader
