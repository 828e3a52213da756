#pragma once
/// Statistical antialiasing (Lee, Redner and Uselton, 1985) sends rays through a pixel until they tell its mean well
/// enough. The tests of the estimate are derived in docs/rendering-reference.md.

#include <algorithm>
#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "durero/render/render.hpp"
#include "durero/render/sample/sampling.hpp"
#include "row.hpp"
#include "view.hpp"

namespace durero::render {

/// The estimate of a pixel's mean from the first points of one net. They form blocks of as many consecutive points,
/// each of which is a net of its own.
struct Estimate {
  std::array<glm::dvec3, most_blocks> sums{};  ///< the sum of each block
  std::uint32_t points = 0;                    ///< 0, or a power of two from least_samples on
  PathRadiance all{};                          ///< the sums of all rays

  /// The number of blocks of all points so far.
  std::uint32_t blocks() const { return std::min(points, most_blocks); }
  /// Makes room for so many points, twice those of before: pairs of blocks are joined where there are most_blocks.
  void grow_to(std::uint32_t points_then);
  /// Adds the colour of point i. Precondition: i < points.
  void take(std::uint32_t i, const PathRadiance& brought);
};

/// The standard deviation of the means of the blocks, by component.
glm::dvec3 deviation(const Estimate& estimate);

/// A drawer of the rows of a view, which must outlive it.
class Statistical {
 public:
  /// Takes samples at the corners of all pixels.
  Statistical(const View& view, const Samples& samples);

  /// The colours of row y of the crop.
  PixelRow row(std::uint32_t y) const;
  /// The counts of the rays through the corners: samples and rays.
  const PathStatistics& reach_of_corners() const { return corner_reach_; }

 private:
  bool corners_agree(std::uint32_t x, std::uint32_t y, std::uint32_t around) const;
  bool is_believed(std::uint32_t x, std::uint32_t y, std::uint32_t points) const;
  bool is_settled(const Estimate& estimate) const;
  void take_points(std::uint32_t y, std::span<const std::uint32_t> open, std::vector<Estimate>& row) const;

  const View& view_;
  const Samples samples_;
  std::uint32_t most_points_;        // a power of two
  std::vector<double> half_widths_;  // at each look, for a deviation of 1, over the part of the width asked for
  std::uint32_t corners_in_row_;
  std::vector<glm::dvec3> corners_;  // of the pixels of the crop, and of those around it
  PathStatistics corner_reach_{};
};

}  // namespace durero::render
