#include "vertex_tree.hpp"

#include <algorithm>

namespace durero::mesh {
namespace {

std::uint8_t longest(const glm::dvec3& sides) {
  if (sides.x >= sides.y && sides.x >= sides.z) return 0;
  return sides.y >= sides.z ? 1 : 2;
}

}  // namespace

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
