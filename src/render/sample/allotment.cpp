#include "allotment.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "points.hpp"
#include "tiles.hpp"

namespace durero::render {
namespace {

constexpr std::uint32_t border = reach_of_first_points;

/// The size of a crop with its border.
scene::Resolution with_border(scene::Resolution size) { return {size.width + 2 * border, size.height + 2 * border}; }

/// The part that a pixel at that distance has in a mean of those around.
double weight_of(double dx, double dy) { return 1 / (dx * dx + dy * dy); }

/// The variance of so many numbers, whose squares and which themselves have these sums.
glm::dvec3 variance_of(const glm::dvec3& squares, const glm::dvec3& sum, double count) {
  return glm::max((squares - sum * sum / count) / (count - 1), glm::dvec3(0));
}

}  // namespace

std::uint32_t allotted_points(const glm::dvec3& mean, const glm::dvec3& variance, std::uint32_t most) {
  const glm::dvec3 of_shades = variance / (mean + darkest_shade);
  const double asked = most * std::sqrt((of_shades.x + of_shades.y + of_shades.z) / 3);
  // NaN, the product of a black material and an infinite light, is not below the most either.
  return asked < most ? std::max(first_points(most), static_cast<std::uint32_t>(std::ceil(asked))) : most;
}

std::uint32_t first_points(std::uint32_t most) { return std::max(least_samples, most / 16); }

Allotment::Allotment(const View& view, const Samples& samples)
    : view_(view), most_(samples.most), firsts_(first_points(most_)), width_(with_border(view.crop.size).width) {
  const scene::Resolution size = with_border(view.crop.size);
  first_.resize(std::size_t(width_) * size.height);
  by_tiles(size, side_of_tile(view.scene.size(), size), {}, [&](const auto& pixels) { take_first(pixels); });
}

void Allotment::take_first(std::span<const scene::Pixel> pixels) {
  std::vector<EyeSample> eye(pixels.size());
  std::vector<glm::dvec3> squares(pixels.size(), glm::dvec3(0));
  const auto of = [&](std::size_t k) -> FirstPoints& {
    return first_[std::size_t(pixels[k].y) * width_ + pixels[k].x];
  };
  for (std::uint32_t i = 0; i < firsts_; ++i) {
    for (std::size_t k = 0; k < pixels.size(); ++k) {
      const auto [x, y] = pixels[k];
      const std::uint64_t key = view_.key(x - border, y - border);
      eye[k] = view_.sample(x, y, in_net(i, key) - double(border), key, i);
    }
    const std::vector<PathRadiance> found = view_.brought_by(eye);
    for (std::size_t k = 0; k < pixels.size(); ++k) {
      add(of(k).sum, found[k]);
      squares[k] += found[k].color * found[k].color;
    }
  }
  for (std::size_t k = 0; k < pixels.size(); ++k) of(k).variance = variance_of(squares[k], of(k).sum.color, firsts_);
}

std::uint32_t Allotment::points_of(const scene::Pixel& pixel) const {
  constexpr std::uint32_t side = 2 * border + 1;
  glm::dvec3 mean(0), variance(0);
  double weights = 0;
  for (std::uint32_t i = 0; i < side * side; ++i) {
    const std::uint32_t x = i % side, y = i / side;
    if (x == border && y == border) continue;
    const double weight = weight_of(double(x) - border, double(y) - border);
    const FirstPoints& near = first(pixel.x + x, pixel.y + y);
    mean += weight / firsts_ * near.sum.color;
    variance += weight * near.variance;
    weights += weight;
  }
  return allotted_points(mean / weights, variance / weights, most_);
}

/// Takes turns, each of one more ray of each pixel that has points left; as many as there are pixels are asked
/// together.
void Allotment::take_more(std::span<const scene::Pixel> pixels, std::span<const std::uint32_t> points,
                          PixelRow& row) const {
  std::vector<EyeSample> eye;
  std::vector<std::size_t> of;
  const auto ask = [&] {
    const std::vector<PathRadiance> found = view_.brought_by(eye);
    for (std::size_t j = 0; j < of.size(); ++j) add(row.pixels[of[j]], found[j]);
    eye.clear();
    of.clear();
  };
  for (std::uint32_t i = firsts_; i < *std::ranges::max_element(points); ++i)
    for (std::size_t k = 0; k < pixels.size(); ++k) {
      if (points[k] <= i) continue;
      const auto [x, y] = pixels[k];
      const std::uint64_t key = view_.key(x, y);
      eye.push_back(view_.sample(x, y, in_net(i, key), key, i));
      of.push_back(k);
      if (of.size() == pixels.size()) ask();
    }
  ask();
}

PixelRow Allotment::row(std::span<const scene::Pixel> pixels) const {
  PixelRow row;
  std::vector<std::uint32_t> points;
  for (const scene::Pixel& pixel : pixels) {
    row.pixels.push_back(first(pixel.x + border, pixel.y + border).sum);
    points.push_back(points_of(pixel));
    row.samples += points.back();
  }
  take_more(pixels, points, row);
  for (std::size_t k = 0; k < pixels.size(); ++k) divide(row.pixels[k], points[k]);
  return row;
}

PathStatistics Allotment::around() const {
  PathStatistics reach;
  const std::uint32_t height = static_cast<std::uint32_t>(first_.size()) / width_;
  for (std::uint32_t y = 0; y < height; ++y)
    for (std::uint32_t x = 0; x < width_; ++x) {
      if (x - border < width_ - 2 * border && y - border < height - 2 * border) continue;
      reach.samples += firsts_;
      reach.rays += first(x, y).sum.rays;
    }
  return reach;
}

}  // namespace durero::render
