#pragma once
/// A balanced tree of points, halved across the longest side, to find those in a box.

#include <cstdint>
#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace durero::mesh {

/// The points that are in no part of a box are passed over without a look at each.
class VertexTree {
 public:
  /// Of the vertices of these numbers. The vertices must outlive the tree.
  VertexTree(std::span<const glm::dvec3> vertices, std::vector<std::uint32_t> numbers);

  /// Calls visit(number) for each vertex in the box, sides included.
  template <class Visit>
  void in_box(const glm::dvec3& least, const glm::dvec3& greatest, const Visit& visit) const {
    descend(0, numbers_.size(), least, greatest, visit);
  }

 private:
  void halve(std::size_t begin, std::size_t end);

  template <class Visit>
  void descend(std::size_t begin, std::size_t end, const glm::dvec3& least, const glm::dvec3& greatest,
               const Visit& visit) const {
    if (begin == end) return;
    const std::size_t middle = begin + (end - begin) / 2;
    const glm::dvec3& p = vertices_[numbers_[middle]];
    if (glm::clamp(p, least, greatest) == p) visit(numbers_[middle]);
    const int axis = axes_[middle];
    if (p[axis] >= least[axis]) descend(begin, middle, least, greatest, visit);
    if (p[axis] <= greatest[axis]) descend(middle + 1, end, least, greatest, visit);
  }

  std::span<const glm::dvec3> vertices_;
  std::vector<std::uint32_t> numbers_;  // of a part, the one in the middle stands at the root
  std::vector<std::uint8_t> axes_;      // across which the part with that middle is halved
};

}  // namespace durero::mesh
