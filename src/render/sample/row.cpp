#include "row.hpp"

#include <algorithm>
#include <cmath>

#include "points.hpp"

namespace durero::render {

void add(PathRadiance& sum, const PathRadiance& more) {
  sum.color += more.color;
  sum.depth = std::max(sum.depth, more.depth);
  sum.rays += more.rays;
  sum.left_out += more.left_out;
}

void divide(PathRadiance& sum, std::uint32_t rays) {
  sum.color /= double(rays);
  sum.left_out /= double(rays);
}

PixelRow sampled(const View& view, const Samples& samples, std::span<const scene::Pixel> pixels) {
  const auto side = static_cast<std::uint32_t>(std::lround(std::sqrt(samples.most)));
  PixelRow row{.pixels = std::vector<PathRadiance>(pixels.size()),
               .samples = std::uint64_t{samples.most} * pixels.size()};
  std::vector<glm::dvec2> points(pixels.size());
  // Each turn takes one ray of each pixel: neighbours meet the same elements, and few rays wait.
  for (std::uint32_t i = 0; i < samples.most; ++i) {
    for (std::size_t k = 0; k < pixels.size(); ++k) {
      const auto [x, y] = pixels[k];
      const auto key = [&] { return key_of(view.crop.x + x, view.crop.y + y, 0); };
      points[k] = view.point(x, y, samples.sampling == Sampling::grid ? in_grid(side, i) : in_strata(side, i, key()));
    }
    const std::vector<PathRadiance> more = view.brought_by(points);
    for (std::size_t k = 0; k < pixels.size(); ++k) add(row.pixels[k], more[k]);
  }
  for (PathRadiance& pixel : row.pixels) divide(pixel, samples.most);
  return row;
}

}  // namespace durero::render
