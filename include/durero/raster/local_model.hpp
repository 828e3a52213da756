#pragma once
/// The local model of a raster: the colour of a point of a polygon, without a ray.

#include <glm/vec3.hpp>
#include <vector>

#include "durero/raster/scene_polygons.hpp"
#include "durero/scene/stage.hpp"

namespace durero::raster {

/// A point of a polygon, as the eye sees it.
struct RasterPoint {
  const ScenePolygon* polygon;  ///< which it is of
  glm::dvec3 point;             ///< where it lies, rounded
  glm::dvec3 direction;         ///< in which the eye sees it, of any length but 0
};

/// How bright each light of a stage is at a point, the point lights before the directional ones: S, and black where it
/// is not seen.
using LightColors = std::vector<glm::dvec3>;

/// The colours of the lights themselves, in that order.
LightColors colors_of(const scene::Stage& stage);

/// The colour of a point in the light of those: M_E + A_G + Σ S·(k_a·C + k_d·C·max(0, n·l) + k_s·max(0, r·v)^e, where
/// n·l > 0), as directa.def.1, aportacion.def.1 and radiancia.def.1 say; n lies on the side of the eye.
glm::dvec3 local_color(const scene::Stage& stage, const RasterPoint& at, const LightColors& lights);

}  // namespace durero::raster
