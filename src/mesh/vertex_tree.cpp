#include "vertex_tree.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

namespace durero::mesh {
namespace {

std::uint8_t longest(const glm::dvec3& sides) {
  if (sides.x >= sides.y && sides.x >= sides.z) return 0;
  return sides.y >= sides.z ? 1 : 2;
}

/// A number, and what it may be off by.
struct Crossed {
  double value, off;
};

/// The coordinate along an axis at which a segment has one along another. The parameter has three roundings, two
/// differences and a quotient; the difference that it multiplies, the product and the sum are three more, so that it is
/// off by less than 8 · 2⁻⁵³ times the magnitudes of the ends; twice that has room for the sums with it. What is
/// subnormal is off by 2⁻¹⁰⁷⁴ at most. Where the difference overflows that is multiplied, the bound is infinite too.
Crossed crossed_at(const SegmentPart& part, int axis, double coordinate, int other) {
  const double a = part.from[other], b = part.to[other];
  const double parameter = (coordinate - part.from[axis]) / (part.to[axis] - part.from[axis]);
  return {a + parameter * (b - a), 0x1p-49 * (std::abs(a) + std::abs(b)) + 0x1p-1073};
}

/// Draws the box of a part in, where it is cut at a coordinate that is within it. Along another axis, the crossing
/// bounds it on that side where the kept end of the segment is not, unless the bound is infinite.
void draw_in(SegmentPart& part, int axis, double coordinate, bool is_low_kept) {
  if (!std::isfinite(part.to[axis] - part.from[axis])) return;
  const bool is_rising = part.to[axis] > part.from[axis];
  for (int other = 0; other < 3; ++other) {
    if (other == axis) continue;
    const Crossed crossed = crossed_at(part, axis, coordinate, other);
    const bool is_rising_too = (part.to[other] > part.from[other]) == is_rising;
    if (is_rising_too == is_low_kept)
      part.greatest[other] = std::min(part.greatest[other], crossed.value + crossed.off);
    else
      part.least[other] = std::max(part.least[other], crossed.value - crossed.off);
  }
}

}  // namespace

SegmentPart SegmentPart::below(int axis, double coordinate) const {
  SegmentPart part = *this;
  part.greatest[axis] = coordinate;
  if (coordinate > least[axis]) draw_in(part, axis, coordinate, true);
  return part;
}

SegmentPart SegmentPart::above(int axis, double coordinate) const {
  SegmentPart part = *this;
  part.least[axis] = coordinate;
  if (coordinate < greatest[axis]) draw_in(part, axis, coordinate, false);
  return part;
}

VertexTree::VertexTree(std::span<const glm::dvec3> vertices, std::vector<std::uint32_t> numbers)
    : vertices_(vertices), numbers_(std::move(numbers)), axes_(numbers_.size()) {
  halve(0, numbers_.size());
}

void VertexTree::halve(std::size_t begin, std::size_t end) {
  if (end - begin < 2) return;
  glm::dvec3 least = vertices_[numbers_[begin]], greatest = least;
  for (std::size_t i = begin; i < end; ++i) {
    least = glm::min(least, vertices_[numbers_[i]]);
    greatest = glm::max(greatest, vertices_[numbers_[i]]);
  }
  const std::uint8_t axis = longest(greatest * 0.5 - least * 0.5);  // halved first, so that no side overflows
  const auto at = [&](std::size_t i) { return numbers_.begin() + static_cast<std::ptrdiff_t>(i); };
  const std::size_t middle = begin + (end - begin) / 2;
  std::nth_element(at(begin), at(middle), at(end),
                   [&](std::uint32_t a, std::uint32_t b) { return vertices_[a][axis] < vertices_[b][axis]; });
  axes_[middle] = axis;
  halve(begin, middle);
  halve(middle + 1, end);
}

}  // namespace durero::mesh
