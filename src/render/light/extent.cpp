#include "durero/render/light/extent.hpp"

#include "durero/contract/contract.hpp"
#include "durero/render/light/directions.hpp"
#include "durero/render/sample/maps.hpp"

namespace durero::render {

glm::dvec3 point_of(const scene::Light& light, const glm::dvec2& pair) {
  const scene::LightExtent& extent = light.extent;
  const auto& [first, second] = extent.edges;
  switch (extent.shape) {
    case scene::LightShape::point:
      return light.position;
    case scene::LightShape::disc: {
      const auto [u, v] = across(unit(extent.normal));
      const glm::dvec2 place = extent.radius * in_disc(pair);
      return light.position + place.x * u + place.y * v;
    }
    case scene::LightShape::sphere:
      return light.position + extent.radius * on_sphere(pair);
    case scene::LightShape::triangle: {
      const glm::dvec2 weights = in_triangle(pair);
      return light.position + weights.x * first + weights.y * second;
    }
    case scene::LightShape::rectangle:
      return light.position + (pair.x - 0.5) * first + (pair.y - 0.5) * second;
  }
  contract::unreachable();
}

}  // namespace durero::render
