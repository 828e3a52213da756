#pragma once
/// The light_source of a POV-Ray text.

#include <optional>
#include <string>
#include <variant>

#include "durero/scene/stage.hpp"
#include "pov_transform.hpp"
#include "pov_words.hpp"

namespace durero::io {

/// A light_source as a scene has it.
struct PovLight {
  std::optional<std::variant<scene::Light, scene::DirectionalLight>> light;  ///< nothing where no scene has such
  std::size_t left_out;                                                      ///< parts that are none here
};

/// Reads what stands behind the { of a light_source, and its }. Throws InputError.
PovLight read_pov_light(PovWords& in);
/// The light, moved by what it stands in.
void move_light(std::variant<scene::Light, scene::DirectionalLight>& light, const PovTransform& by);

/// A light as a statement. A shape is an area_light of a grid of lamps; a triangle, which the language has not, a
/// point.
std::string pov_light(const scene::Light& light);

}  // namespace durero::io
