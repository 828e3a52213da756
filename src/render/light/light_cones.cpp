#include "durero/render/light/light_cones.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "durero/render/light/directions.hpp"

namespace durero::render {

CosineCone cosine_cone(const scene::LightCone& cone, const glm::dvec3& position) {
  return {unit(cone.towards - position), std::cos(glm::radians(cone.inner)), std::cos(glm::radians(cone.outer)),
          cone.tightness};
}

double intensity(const CosineCone& cone, const glm::dvec3& away) {
  const double cosine = std::min(1.0, glm::dot(cone.axis, away));  // of two rounded unit vectors
  if (cosine < cone.edge) return 0;
  const double narrowed = cone.tightness > 0 ? std::pow(cosine, cone.tightness) : 1;
  if (cosine >= cone.full) return narrowed;
  const double x = (cosine - cone.edge) / (cone.full - cone.edge);
  return narrowed * (x * x * (3 - 2 * x));
}

LightCones::LightCones(const scene::Stage& stage) {
  for (const scene::Light& light : stage.lights)
    cones_.push_back(light.cone ? std::optional(cosine_cone(*light.cone, light.position)) : std::nullopt);
}

}  // namespace durero::render
