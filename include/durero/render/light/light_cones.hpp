#pragma once
/// The cones that lights shine into: Cono_de_Luz and intensidad of spec/luz.tex, in binary64.

#include <cstddef>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "durero/scene/stage.hpp"

namespace durero::render {

/// A cone of light by its cosines.
struct CosineCone {
  glm::dvec3 axis;   ///< eje, a unit vector
  double full;       ///< pleno, the cosine up to which the light is full
  double edge;       ///< borde, the cosine beyond which there is none
  double tightness;  ///< estrechez
};

/// The cone of a light at that position.
CosineCone cosine_cone(const scene::LightCone& cone, const glm::dvec3& position);

/// The share of the light that goes along a unit vector away from it (intensidad.def.1).
double intensity(const CosineCone& cone, const glm::dvec3& away);

/// The cones of a stage's lights.
class LightCones {
 public:
  /// The cones of all lights.
  explicit LightCones(const scene::Stage& stage);

  /// The share of the light of that number that comes from the unit direction l: 1 of a light that shines all around.
  double share(std::size_t light, const glm::dvec3& l) const {
    return cones_[light] ? intensity(*cones_[light], -l) : 1;
  }

 private:
  std::vector<std::optional<CosineCone>> cones_;
};

}  // namespace durero::render
