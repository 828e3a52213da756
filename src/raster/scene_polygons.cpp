#include "durero/raster/scene_polygons.hpp"

#include <fmt/format.h>

#include <glm/geometric.hpp>
#include <stdexcept>
#include <string>
#include <string_view>

#include "durero/number/rational.hpp"
#include "durero/render/light/whitted.hpp"
#include "durero/scene/by_name.hpp"

namespace durero::raster {
namespace {

const scene::Material plain{.color = render::default_color};

/// The reason that a look is not drawn; empty where it is.
std::string_view not_drawn(const scene::Material& m, Opacity opacity) {
  if (m.k_ps > 0) return "is a mirror";
  if (m.textures.any()) return "has a texture";
  if (m.bump) return "has a relief";
  if (opacity == Opacity::opaque && m.k_t > 0) return "is seen through";
  if (m.k_t > 0 && m.index != 1) return "bends light";
  return {};
}

}  // namespace

std::vector<ScenePolygon> polygons_of(const scene::Scene& scene, Opacity opacity) {
  std::vector<ScenePolygon> polygons;
  for (const scene::ElementRef element : scene::elements_by_name(scene)) {
    scene.visit(element, [&]<class Shape>(const Shape& shape) {
      const std::string name = scene.name(element).name();
      if constexpr (std::is_same_v<Shape, scene::Triangle>) {
        const auto& [a, b, c] = shape.vertices;
        const auto material = scene.material(element);
        const scene::Material& look = material ? scene.stage().materials[*material] : plain;
        if (const std::string_view why = not_drawn(look, opacity); !why.empty())
          throw std::domain_error(fmt::format("element {} {}; expected looks that this technique draws", name, why));
        if (scene.vertex_normals(element))
          throw std::domain_error(
              fmt::format("element {} is shaded by normals of its own; expected flat triangles", name));
        polygons.push_back({element,
                            {polygon::exact(a), polygon::exact(b), polygon::exact(c)},
                            glm::normalize(glm::cross(b - a, c - a)),
                            look});
      } else {
        throw std::domain_error(
            fmt::format("element {} is of the type {}; expected triangles alone", name, Shape::word));
      }
    });
  }
  return polygons;
}

std::vector<polygon::Polygon> corners_of(const std::vector<ScenePolygon>& polygons) {
  std::vector<polygon::Polygon> corners;
  for (const ScenePolygon& one : polygons) corners.push_back(one.corners);
  return corners;
}

std::vector<polygon::Apex> apexes_of(const scene::Stage& stage) {
  std::vector<polygon::Apex> apexes;
  for (const scene::Light& light : stage.lights) apexes.push_back({polygon::exact(light.position)});
  for (const scene::DirectionalLight& light : stage.directional_lights)
    apexes.push_back({polygon::exact(-light.direction), true});
  return apexes;
}

}  // namespace durero::raster
