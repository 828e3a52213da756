#include "durero/render/render.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <mutex>
#include <span>
#include <stdexcept>
#include <vector>

#include "durero/render/whitted.hpp"
#include "durero/scene/camera.hpp"

namespace durero::render {
namespace {

/// The rays of row y of a crop.
std::vector<scene::Query> row_of(const scene::PrimaryRays& rays, const Crop& crop, std::uint32_t y) {
  std::vector<scene::Query> row;
  row.reserve(crop.size.width);
  for (std::uint32_t x = 0; x < crop.size.width; ++x) row.push_back({rays.ray(crop.x + x, crop.y + y)});
  return row;
}

/// The crop that is asked for, or the whole picture.
Crop crop_of(const Frame& frame, scene::Resolution size) {
  const Crop crop = frame.crop.value_or(Crop{0, 0, size});
  const auto inside = [](std::uint32_t begin, std::uint32_t length, std::uint32_t whole) {
    return length > 0 && begin < whole && length <= whole - begin;
  };
  if (!inside(crop.x, crop.size.width, size.width) || !inside(crop.y, crop.size.height, size.height))
    throw std::out_of_range("the crop is not inside the picture");
  return crop;
}

/// Gathers what the rows of a picture say, and tells how many are done.
class Rows {
 public:
  Rows(const Progress& progress, std::uint32_t rows) : progress_(progress), rows_(rows) {}

  void add(std::span<const Brought> row) {
    const std::lock_guard lock(mutex_);
    for (const Brought& pixel : row) {
      ++reach_.pixels;
      reach_.rays += pixel.rays;
      reach_.depths += pixel.depth;
      reach_.left_out = std::max({reach_.left_out, pixel.left_out.x, pixel.left_out.y, pixel.left_out.z});
    }
    ++done_;
    if (progress_) progress_(double(done_) / rows_);
  }

  const Reach& reach() const { return reach_; }

 private:
  const Progress& progress_;
  std::mutex mutex_;
  Reach reach_;
  std::uint32_t done_ = 0, rows_;
};

}  // namespace

Image render(const scene::Scene& scene, const engine::Engine& engine, const Progress& progress, const Frame& frame,
             Reach* reach) {
  if (!scene.stage().camera) throw std::domain_error("the scene has no camera; expected one");
  const scene::Resolution size = frame.size.value_or(scene.stage().resolution.value_or(default_resolution));
  const scene::PrimaryRays rays(*scene.stage().camera, size);
  const Crop crop = crop_of(frame, size);
  Image image(crop.size);
  const Limits limits{frame.max_depth.value_or(depth_of(scene.stage())), frame.min_weight};
  Rows all(progress, crop.size.height);
  tbb::parallel_for(tbb::blocked_range<std::uint32_t>(0, crop.size.height), [&](const auto& rows) {
    for (std::uint32_t y = rows.begin(); y != rows.end(); ++y) {
      const std::vector<Brought> row = brought(scene, engine, row_of(rays, crop, y), limits);
      for (std::uint32_t x = 0; x < crop.size.width; ++x) image.set(x, y, row[x].color);
      all.add(row);
    }
  });
  if (reach) {
    *reach = all.reach();
    reach->max_depth = limits.max_depth;
  }
  return image;
}

}  // namespace durero::render
