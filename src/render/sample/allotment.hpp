#pragma once
/// Optimum allotment (Neyman, 1934) gives each pixel points in proportion to the deviation of what they bring: no other
/// way of sharing out as many rays leaves so small a squared error. The rule is derived in
/// docs/rendering-reference.md.

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "durero/render/render.hpp"
#include "durero/render/sample/sampling.hpp"
#include "durero/scene/camera.hpp"
#include "row.hpp"
#include "view.hpp"

namespace durero::render {

/// The number of points of a pixel near which colours have this mean and this variance: of `most` as many as the root
/// of the mean of variance/(mean + darkest_shade) says, but no fewer than first_points(most).
std::uint32_t allotted_points(const glm::dvec3& mean, const glm::dvec3& variance, std::uint32_t most);

/// The number of first points of each pixel, a sixteenth of `most`. Those of the 48 pixels around are three times
/// `most` together, and see what `most` points of a pixel would as a rule see.
std::uint32_t first_points(std::uint32_t most);

/// The term that is added to a mean before it divides: in the dark, where the mean is small, the eye tells no finer
/// shades.
inline constexpr double darkest_shade = 0.01;

/// The distance of the farthest pixels, along a row and along a column, whose first points count for a pixel.
inline constexpr std::uint32_t reach_of_first_points = 3;

/// The allotment of points to the pixels of a view, which must outlive it. A pixel's own points have no say in their
/// number, so its mean is without bias.
class Allotment {
 public:
  /// Takes the first points of all pixels of the crop, and of those around it.
  Allotment(const View& view, const Samples& samples);

  /// The row of these pixels of the crop, by all their points.
  PixelRow row(std::span<const scene::Pixel> pixels) const;
  /// The counts of the rays of pixels around the crop: samples and rays.
  PathStatistics around() const;

 private:
  struct FirstPoints {
    PathRadiance sum{};      // of what they bring
    glm::dvec3 variance{0};  // of their colours
  };

  const FirstPoints& first(std::uint32_t x, std::uint32_t y) const { return first_[std::size_t(y) * width_ + x]; }
  void take_first(std::span<const scene::Pixel> pixels);
  std::uint32_t points_of(const scene::Pixel& pixel) const;
  void take_more(std::span<const scene::Pixel> pixels, std::span<const std::uint32_t> points, PixelRow& row) const;

  const View& view_;
  const std::uint32_t most_, firsts_;
  std::uint32_t width_;
  std::vector<FirstPoints> first_;  // of the crop with a border around it, row by row
};

}  // namespace durero::render
