#pragma once
/// The light_source of a POV-Ray text.

#include <string>
#include <variant>

#include "durero/scene/stage.hpp"
#include "pov_words.hpp"

namespace durero::io {

/// Reads what stands behind the { of a light_source, and its }. Throws InputError.
std::variant<scene::Light, scene::DirectionalLight> read_pov_light(PovWords& in);

/// A light as a statement. A shape is an area_light of a grid of lamps; a triangle, which the language has not, a
/// point.
std::string pov_light(const scene::Light& light);

}  // namespace durero::io
