#include "row.hpp"

#include <algorithm>
#include <cmath>

#include "durero/contract/contract.hpp"
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

namespace {

/// The place of sample i of a pixel, from its centre.
glm::dvec2 place_of(const Samples& samples, std::uint32_t side, std::uint32_t i, std::uint64_t key) {
  switch (samples.sampling) {
    case Sampling::grid:
      return in_grid(side, i);
    case Sampling::stratified:
      return in_strata(side, i, key);
    case Sampling::net:
      return in_net(i, key);
    case Sampling::independent:
      return SampleSource{key, i, true}.pair(0) - 0.5;
    case Sampling::allotted:
    case Sampling::statistical:
      break;
  }
  contract::unreachable();
}

}  // namespace

PixelRow sampled(const View& view, const Samples& samples, std::span<const scene::Pixel> pixels) {
  const auto side = static_cast<std::uint32_t>(std::lround(std::sqrt(samples.most)));
  PixelRow row{.pixels = std::vector<PathRadiance>(pixels.size()),
               .samples = std::uint64_t{samples.most} * pixels.size()};
  std::vector<EyeSample> eye(pixels.size());
  // Each turn takes one ray of each pixel: neighbours meet the same elements, and few rays wait.
  for (std::uint32_t i = 0; i < samples.most; ++i) {
    for (std::size_t k = 0; k < pixels.size(); ++k) {
      const auto [x, y] = pixels[k];
      const std::uint64_t key = view.key(x, y);
      eye[k] = view.sample(x, y, place_of(samples, side, i, key), key, i);
    }
    const std::vector<PathRadiance> more = view.brought_by(eye);
    for (std::size_t k = 0; k < pixels.size(); ++k) add(row.pixels[k], more[k]);
  }
  for (PathRadiance& pixel : row.pixels) divide(pixel, samples.most);
  return row;
}

}  // namespace durero::render
