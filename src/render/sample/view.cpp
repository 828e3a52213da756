#include "view.hpp"

#include <stdexcept>

#include "durero/scene/stage.hpp"

namespace durero::render {
namespace {

scene::PrimaryRays rays_of(const scene::Stage& stage, const RenderSettings& frame) {
  if (!stage.camera) throw std::domain_error("the scene has no camera; expected one");
  return {*stage.camera, frame.size.value_or(stage.resolution.value_or(default_resolution))};
}

/// The crop that is asked for, or the whole picture.
Crop crop_of(const RenderSettings& frame, scene::Resolution size) {
  const Crop crop = frame.crop.value_or(Crop{0, 0, size});
  const auto inside = [](std::uint32_t begin, std::uint32_t length, std::uint32_t whole) {
    return length > 0 && begin < whole && length <= whole - begin;
  };
  if (!inside(crop.x, crop.size.width, size.width) || !inside(crop.y, crop.size.height, size.height))
    throw std::out_of_range("the crop is not inside the picture");
  return crop;
}

}  // namespace

View::View(const scene::Scene& drawn, const engine::Engine& asked, const RenderSettings& frame)
    : scene(drawn),
      engine(asked),
      rays(rays_of(drawn.stage(), frame)),
      crop(crop_of(frame, rays.resolution())),
      limits{frame.max_depth.value_or(depth_of(drawn.stage())), frame.min_weight},
      follower(scene, engine, limits) {}

std::vector<PathRadiance> View::brought_by(std::span<const glm::dvec2> points) const {
  std::vector<scene::Query> queries;
  queries.reserve(points.size());
  for (const glm::dvec2& point : points) queries.push_back({rays.ray_at(point.x, point.y)});
  return follower.brought(queries);
}

}  // namespace durero::render
