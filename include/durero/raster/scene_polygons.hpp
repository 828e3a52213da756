#pragma once
/// The polygons that a raster draws are the triangles of a scene.

#include <glm/vec3.hpp>
#include <vector>

#include "durero/polygon/convex.hpp"
#include "durero/polygon/pyramid.hpp"
#include "durero/scene/element_ref.hpp"
#include "durero/scene/scene.hpp"
#include "durero/scene/stage.hpp"

namespace durero::raster {

/// A triangle of a scene.
struct ScenePolygon {
  scene::ElementRef element;  ///< of the scene
  polygon::Polygon corners;   ///< its vertices
  glm::dvec3 normal;          ///< across it, of length 1
  scene::Material material;   ///< its look; the default where it has none
};

/// The opacity of the polygons that a technique draws.
enum class Opacity {
  opaque,      ///< nothing is seen through any, nor in any
  transparent  ///< what lies behind may be seen, straight on, and nothing in any
};

/// The triangles of a scene, ascending by name. Throws std::domain_error, with the half of a message before its file's
/// name: for another shape, for normals of vertices, and for a look that the technique does not draw (a mirror, a
/// texture, a relief, glass).
std::vector<ScenePolygon> polygons_of(const scene::Scene& scene, Opacity opacity);

/// The corners alone, in their order.
std::vector<polygon::Polygon> corners_of(const std::vector<ScenePolygon>& polygons);

/// The apexes of the lights of a stage: the point lights in their order, then the directional ones.
std::vector<polygon::Apex> apexes_of(const scene::Stage& stage);

}  // namespace durero::raster
