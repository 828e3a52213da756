#include "row.hpp"

#include <algorithm>
#include <cmath>

#include "points.hpp"

namespace durero::render {

void add(Brought& sum, const Brought& more) {
  sum.color += more.color;
  sum.depth = std::max(sum.depth, more.depth);
  sum.rays += more.rays;
  sum.left_out += more.left_out;
}

void divide(Brought& sum, std::uint32_t rays) {
  sum.color /= double(rays);
  sum.left_out /= double(rays);
}

Row sampled_row(const View& view, const Samples& samples, std::uint32_t y) {
  const std::uint32_t width = view.crop.size.width;
  const auto side = static_cast<std::uint32_t>(std::lround(std::sqrt(samples.most)));
  Row row{.pixels = std::vector<Brought>(width), .samples = std::uint64_t{samples.most} * width};
  std::vector<glm::dvec2> points(width);
  // A ray of each pixel at a time: neighbours meet the same things, and few rays wait.
  for (std::uint32_t i = 0; i < samples.most; ++i) {
    for (std::uint32_t x = 0; x < width; ++x) {
      const auto key = [&] { return key_of(view.crop.x + x, view.crop.y + y, 0); };
      points[x] = view.point(x, y, samples.sampling == Sampling::grid ? in_grid(side, i) : in_strata(side, i, key()));
    }
    const std::vector<Brought> more = view.brought_by(points);
    for (std::uint32_t x = 0; x < width; ++x) add(row.pixels[x], more[x]);
  }
  for (Brought& pixel : row.pixels) divide(pixel, samples.most);
  return row;
}

}  // namespace durero::render
