#pragma once
/// What spec/luz.tex asks of the materials and the lights of a stage, in each component of their colours.

#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "durero/model/luz.hpp"
#include "durero/scene/stage.hpp"

namespace durero::io {

/// The Material of the text that a material is in one component of its colours: 0 red, 1 green, 2 blue. Throws
/// std::domain_error for an infinity or a NaN.
model::Material material_of(const scene::Material& material, glm::length_t component);

/// Material.inv.1 to Material.inv.12, each over all materials in every component, where there are any; and
/// Fuente.inv.1 over all lights, where there are any.
model::Judgements stage_invariants(const scene::Stage& stage);

/// Something that is drawn as it stands, and may not be meant.
struct Warning {
  std::string message;  ///< what there is; what is expected
  std::string pointer;  ///< to the value in a scene file
};

/// One for each material that sends on more light than it receives (conserva.def.1), in their order.
std::vector<Warning> stage_warnings(const scene::Stage& stage);

}  // namespace durero::io
