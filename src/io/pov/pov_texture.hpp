#pragma once
/// Materials as POV-Ray has them.

#include <string>

#include "durero/scene/stage.hpp"
#include "pov_pattern.hpp"

namespace durero::io {

/// The attributes of an object of that material, whose textures stand at these coordinates: texture and, of glass,
/// interior.
std::string pov_attributes(const scene::Material& material, const PovPatterns& patterns, const PovCoordinates& at);

}  // namespace durero::io
