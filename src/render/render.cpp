#include "durero/render/render.hpp"

#include <algorithm>
#include <mutex>

#include "by_rows.hpp"
#include "durero/contract/contract.hpp"
#include "row.hpp"
#include "statistical.hpp"
#include "view.hpp"

namespace durero::render {
namespace {

void add_row(Reach& reach, const Row& row) {
  for (const Brought& pixel : row.pixels) {
    ++reach.pixels;
    reach.rays += pixel.rays;
    reach.depths += pixel.depth;
    reach.left_out = std::max({reach.left_out, pixel.left_out.x, pixel.left_out.y, pixel.left_out.z});
  }
  reach.samples += row.samples;
  reach.in_doubt += row.in_doubt;
}

/// Each row of the view by row_of(y).
template <class RowOf>
Picture drawn(const View& view, const Progress& progress, Reach& reach, RowOf&& row_of) {
  Picture picture(view.crop.size);
  std::mutex mutex;
  by_rows(view.crop.size.height, progress, [&](std::uint32_t y) {
    const Row row = row_of(y);
    auto* const pixels = &picture.rgb[std::size_t(y) * view.crop.size.width];
    for (std::size_t x = 0; x < row.pixels.size(); ++x) pixels[x] = row.pixels[x].color;
    const std::lock_guard lock(mutex);
    add_row(reach, row);
  });
  return picture;
}

Picture drawn(const View& view, const Samples& samples, const Progress& progress, Reach& reach) {
  switch (samples.sampling) {
    case Sampling::grid:
    case Sampling::stratified:
      return drawn(view, progress, reach, [&](std::uint32_t y) { return sampled_row(view, samples, y); });
    case Sampling::statistical: {
      const Statistical statistical(view, samples);
      reach = statistical.reach_of_corners();
      return drawn(view, progress, reach, [&](std::uint32_t y) { return statistical.row(y); });
    }
  }
  contract::unreachable();
}

}  // namespace

Picture render(const scene::Scene& scene, const engine::Engine& engine, const Progress& progress, const Frame& frame,
               Reach* reach) {
  const View view(scene, engine, frame);
  Reach found;
  Picture picture = drawn(view, frame.samples, progress, found);
  found.max_depth = view.limits.max_depth;
  if (reach) *reach = found;
  return picture;
}

}  // namespace durero::render
