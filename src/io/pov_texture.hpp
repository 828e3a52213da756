#pragma once
/// Materials as POV-Ray has them.

#include <string>

#include "durero/scene/stage.hpp"

namespace durero::io {

/// The attributes of an object of that material: texture and, of glass, interior.
std::string pov_attributes(const scene::Material& material);

}  // namespace durero::io
