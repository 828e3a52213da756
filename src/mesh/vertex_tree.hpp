#pragma once
/// A balanced tree of points, halved across the longest side, to find those near a segment.

#include <cstdint>
#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace durero::mesh {

/// A segment, and a box that has a part of it.
struct SegmentPart {
  glm::dvec3 from, to;
  glm::dvec3 least, greatest;  ///< of the part, whose ends are rounded outwards

  /// The whole of a segment.
  SegmentPart(const glm::dvec3& a, const glm::dvec3& b)
      : from(a), to(b), least(glm::min(a, b)), greatest(glm::max(a, b)) {}

  /// The part up to a coordinate, which is below its greatest.
  SegmentPart below(int axis, double coordinate) const;
  /// The part from a coordinate on, which is above its least.
  SegmentPart above(int axis, double coordinate) const;
};

/// Points that stand far from a segment are passed over without a look at each.
class VertexTree {
 public:
  /// Of the vertices of these numbers. The vertices must outlive the tree.
  VertexTree(std::span<const glm::dvec3> vertices, std::vector<std::uint32_t> numbers);

  /// Calls visit(number) for each vertex on a segment, ends included, and for some others.
  template <class Visit>
  void along(const glm::dvec3& a, const glm::dvec3& b, const Visit& visit) const {
    descend(0, numbers_.size(), SegmentPart(a, b), visit);
  }

 private:
  void halve(std::size_t begin, std::size_t end);

  template <class Visit>
  void descend(std::size_t begin, std::size_t end, const SegmentPart& part, const Visit& visit) const {
    if (begin == end) return;
    const std::size_t middle = begin + (end - begin) / 2;
    const glm::dvec3& p = vertices_[numbers_[middle]];
    if (glm::clamp(p, part.least, part.greatest) == p) visit(numbers_[middle]);
    const int axis = axes_[middle];
    const double border = p[axis];
    if (border >= part.greatest[axis])
      descend(begin, middle, part, visit);
    else if (border >= part.least[axis])
      descend(begin, middle, part.below(axis, border), visit);
    if (border <= part.least[axis])
      descend(middle + 1, end, part, visit);
    else if (border <= part.greatest[axis])
      descend(middle + 1, end, part.above(axis, border), visit);
  }

  std::span<const glm::dvec3> vertices_;
  std::vector<std::uint32_t> numbers_;  // of a part, the one in the middle stands at the root
  std::vector<std::uint8_t> axes_;      // across which the part with that middle is halved
};

}  // namespace durero::mesh
