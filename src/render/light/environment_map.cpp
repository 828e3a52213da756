#include "durero/render/light/environment_map.hpp"

#include <tbb/parallel_for.h>

#include <stdexcept>

#include "durero/render/light/environment.hpp"
#include "durero/scene/stage.hpp"

namespace durero::render {
namespace {

/// The rays through the middles of the texels of a row.
std::vector<scene::Query> row_of(scene::Surroundings kind, std::size_t picture, scene::Resolution size, std::uint32_t y,
                                 const glm::dvec3& from) {
  std::vector<scene::Query> row;
  row.reserve(size.width);
  for (std::uint32_t x = 0; x < size.width; ++x) {
    const glm::dvec2 at((x + 0.5) / size.width, 1 - (y + 0.5) / size.height);
    row.push_back({{model::Punto(from), model::Vector(direction_of(kind, {picture, at}))}});
  }
  return row;
}

}  // namespace

scene::Resolution size_of(scene::Surroundings kind, std::uint32_t width) {
  const bool is_panorama = kind == scene::Surroundings::equirectangular;
  return {width, is_panorama ? (width + 1) / 2 : width};
}

std::vector<Image> environment_map(const scene::Scene& scene, const engine::Engine& engine, scene::Surroundings kind,
                                   std::uint32_t width, const glm::dvec3& from, const PathLimits& limits) {
  const std::size_t count = pictures_of(kind);
  if (count == 0) throw std::domain_error("a gradient has no picture");
  const scene::Resolution size = size_of(kind, width);
  std::vector<Image> pictures(count, Image(size));
  tbb::parallel_for(std::size_t{0}, count * size.height, [&](std::size_t i) {
    const std::size_t picture = i / size.height;
    const auto y = static_cast<std::uint32_t>(i % size.height);
    const auto row = brought(scene, engine, row_of(kind, picture, size, y, from), limits);
    for (std::uint32_t x = 0; x < size.width; ++x) pictures[picture].set(x, y, row[x].color);
  });
  return pictures;
}

}  // namespace durero::render
