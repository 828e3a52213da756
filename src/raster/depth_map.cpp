#include "durero/raster/depth_map.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace durero::raster {
namespace {

constexpr std::array<glm::dvec3, 6> axes{glm::dvec3(1, 0, 0),  glm::dvec3(-1, 0, 0), glm::dvec3(0, 1, 0),
                                         glm::dvec3(0, -1, 0), glm::dvec3(0, 0, 1),  glm::dvec3(0, 0, -1)};

/// The face that a direction goes through: that of its greatest component.
std::size_t face_of(const glm::dvec3& direction) {
  const glm::dvec3 size = glm::abs(direction);
  const std::size_t axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  return 2 * axis + (direction[static_cast<int>(axis)] < 0 ? 1 : 0);
}

scene::Camera camera_of(const glm::dvec3& light, std::size_t face) {
  const glm::dvec3 up = face / 2 == 1 ? glm::dvec3(0, 0, 1) : glm::dvec3(0, 1, 0);
  return {light, light + axes[face], up, 90};
}

std::vector<double> distances(std::span<const polygon::Polygon> polygons, const RasterView& view) {
  const ZBuffer drawn = z_buffer(polygons, view);
  const auto [width, height] = view.resolution();
  std::vector<double> depths;
  for (std::uint32_t y = 0; y < height; ++y)
    for (std::uint32_t x = 0; x < width; ++x) {
      const std::uint32_t nearest = drawn.nearest[depths.size()];
      const glm::dvec3 v = view.direction(x, y);
      depths.push_back(nearest == ZBuffer::none ? std::numeric_limits<double>::infinity()
                                                : drawn.seen[nearest].parameter(v) * glm::length(v));
    }
  return depths;
}

}  // namespace

DepthMap::DepthMap(std::span<const polygon::Polygon> polygons, const glm::dvec3& light, std::uint32_t size)
    : light_(light) {
  for (std::size_t face = 0; face < axes.size(); ++face) {
    faces_.emplace_back(camera_of(light, face), scene::Resolution{size, size});
    depths_.push_back(distances(polygons, faces_.back()));
  }
}

DepthTexel DepthMap::texel_of(const glm::dvec3& point) const {
  const std::size_t face = face_of(point - light_);
  const glm::dvec2 place = faces_[face].place(point).value();
  const auto texel = [&](double at) {
    return static_cast<std::uint32_t>(std::clamp(std::floor(at + 0.5), 0.0, faces_[face].resolution().width - 1.0));
  };
  return {face, place, texel(place.x), texel(place.y)};
}

double DepthMap::depth(const DepthTexel& texel) const {
  return depths_[texel.face][std::size_t(texel.y) * faces_[texel.face].resolution().width + texel.x];
}

// The least distance of the polygon's plane over the middle and the corners of the texel: in its middle the plane has
// that of the map where nothing stands before it. 2⁻⁴⁰ of it is more than the rounding of both.
double DepthMap::biased(const ScenePolygon& polygon, const glm::dvec3& point, const DepthTexel& texel) const {
  double least = glm::distance(point, light_);
  const double height = glm::dot(point - light_, polygon.normal);
  for (const glm::dvec2 aside :
       {glm::dvec2(0), glm::dvec2(-0.5, -0.5), glm::dvec2(0.5, -0.5), glm::dvec2(-0.5, 0.5), glm::dvec2(0.5, 0.5)}) {
    const glm::dvec3 v = faces_[texel.face].direction_at(glm::dvec2(texel.x, texel.y) + aside);
    const double t = height / glm::dot(v, polygon.normal);
    if (t > 0) least = std::min(least, t * glm::length(v));
  }
  return least * (1 - 0x1p-40);
}

bool DepthMap::is_dark(const ScenePolygon& polygon, const glm::dvec3& point, DepthBias bias) const {
  if (point == light_) return false;
  const DepthTexel texel = texel_of(point);
  switch (bias) {
    case DepthBias::none:
      return depth(texel) < glm::distance(point, light_);
    case DepthBias::texel:
      return depth(texel) < biased(polygon, point, texel);
  }
  __builtin_unreachable();  // a bias is one of its enumerators
}

}  // namespace durero::raster
