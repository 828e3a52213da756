#pragma once
/// Statistical antialiasing (Lee, Redner and Uselton, 1985): rays are sent through a pixel until what they brought
/// tells its mean well enough. The tests of the estimate, and what they rest on, are derived in docs/rendering.md.

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "durero/render/render.hpp"
#include "durero/render/sampling.hpp"
#include "row.hpp"
#include "view.hpp"

namespace durero::render {

/// The mean of a pixel as far as it is known.
struct Estimate {
  std::array<glm::dvec3, replicas> sums{};  ///< of each replica
  std::uint32_t points = 0;                 ///< of each replica, a power of two
  Brought all{};                            ///< the sums of all rays
};

/// The standard deviation of the means of the replicas, by component, estimated without bias of its square.
glm::dvec3 deviation(const Estimate& estimate);

/// Draws the rows of a view, which outlives it.
class Statistical {
 public:
  /// Looks at the corners of all pixels.
  Statistical(const View& view, const Samples& samples);

  /// Row y of the crop.
  Row row(std::uint32_t y) const;
  /// What the rays through the corners were: samples and rays.
  const Reach& reach_of_corners() const { return corner_reach_; }

 private:
  bool corners_agree(std::uint32_t x, std::uint32_t y) const;
  void take_points(std::uint32_t y, std::span<const std::uint32_t> open, std::vector<Estimate>& row) const;
  bool is_settled(const Estimate& estimate, bool plain) const;

  const View& view_;
  const Samples samples_;
  std::uint32_t most_points_;  // of a replica, a power of two
  double factor_;
  std::vector<glm::dvec3> corners_;  // rows of one more than the width, one more of them than the height
  Reach corner_reach_{};
};

}  // namespace durero::render
