#include "durero/render/render.hpp"

#include <algorithm>
#include <mutex>
#include <span>
#include <utility>
#include <vector>

#include "durero/contract/contract.hpp"
#include "durero/scene/stage.hpp"
#include "render/sample/allotment.hpp"
#include "render/sample/by_rows.hpp"
#include "render/sample/row.hpp"
#include "render/sample/statistical.hpp"
#include "render/sample/tiles.hpp"
#include "render/sample/view.hpp"

namespace durero::render {
namespace {

void add_row(PathStatistics& reach, const PixelRow& row) {
  for (const PathRadiance& pixel : row.pixels) {
    ++reach.pixels;
    reach.rays += pixel.rays;
    reach.depths += pixel.depth;
    reach.left_out = std::max({reach.left_out, pixel.left_out.x, pixel.left_out.y, pixel.left_out.z});
  }
  reach.samples += row.samples;
  reach.in_doubt += row.in_doubt;
}

/// A picture and the counts of its rays, to which many threads add.
class PictureAccumulator {
 public:
  explicit PictureAccumulator(scene::Resolution size) : picture(size) {}

  /// Adds the colours and counts of these pixels.
  void add(std::span<const scene::Pixel> pixels, const PixelRow& row) {
    for (std::size_t i = 0; i < pixels.size(); ++i)
      picture.rgb[std::size_t(pixels[i].y) * picture.resolution.width + pixels[i].x] = row.pixels[i].color;
    const std::lock_guard lock(mutex_);
    add_row(reach, row);
  }

  Picture picture;
  PathStatistics reach{};

 private:
  std::mutex mutex_;
};

std::vector<scene::Pixel> pixels_of_row(std::uint32_t width, std::uint32_t y) {
  std::vector<scene::Pixel> pixels(width);
  for (std::uint32_t x = 0; x < width; ++x) pixels[x] = {x, y};
  return pixels;
}

void draw(const View& view, const Samples& samples, const Progress& progress, PictureAccumulator& drawn) {
  const scene::Resolution size = view.crop.size;
  switch (samples.sampling) {
    case Sampling::grid:
    case Sampling::stratified:
    case Sampling::net:
    case Sampling::independent:
      by_tiles(size, side_of_tile(view.scene.size(), size), progress,
               [&](const auto& pixels) { drawn.add(pixels, sampled(view, samples, pixels)); });
      return;
    case Sampling::allotted: {
      const Allotment allotment(view, samples);
      drawn.reach = allotment.around();
      by_tiles(size, side_of_tile(view.scene.size(), size), progress,
               [&](const auto& pixels) { drawn.add(pixels, allotment.row(pixels)); });
      return;
    }
    case Sampling::statistical: {
      const Statistical statistical(view, samples);
      drawn.reach = statistical.reach_of_corners();
      by_rows(size.height, progress,
              [&](std::uint32_t y) { drawn.add(pixels_of_row(size.width, y), statistical.row(y)); });
      return;
    }
  }
  contract::unreachable();
}

}  // namespace

Picture render(const scene::Scene& scene, const engine::Engine& engine, const Progress& progress,
               const RenderSettings& frame, PathStatistics* reach) {
  const View view(scene, engine, frame);
  PictureAccumulator drawn(view.crop.size);
  draw(view, frame.samples, progress, drawn);
  drawn.reach.max_depth = view.limits.max_depth;
  if (reach) *reach = drawn.reach;
  return std::move(drawn.picture);
}

}  // namespace durero::render
