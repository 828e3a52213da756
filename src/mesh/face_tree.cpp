#include "face_tree.hpp"

#include <algorithm>
#include <glm/common.hpp>
#include <numeric>

namespace durero::mesh {
namespace {

FaceBox box_of(std::span<const glm::dvec3> vertices, const CornerNumbers& face) {
  const glm::dvec3 &a = vertices[face[0]], &b = vertices[face[1]], &c = vertices[face[2]];
  return {glm::min(glm::min(a, b), c), glm::max(glm::max(a, b), c)};
}

FaceBox joined(const FaceBox& a, const FaceBox& b) {
  return {glm::min(a.least, b.least), glm::max(a.greatest, b.greatest)};
}

/// The middle of a box; halved first, so that it does not overflow.
glm::dvec3 middle_of(const FaceBox& box) { return box.least * 0.5 + box.greatest * 0.5; }

int longest_side(const FaceBox& box) {
  const glm::dvec3 halves = box.greatest * 0.5 - box.least * 0.5;
  if (halves.x >= halves.y && halves.x >= halves.z) return 0;
  return halves.y >= halves.z ? 1 : 2;
}

}  // namespace

FaceTree::FaceTree(std::span<const glm::dvec3> vertices, std::span<const CornerNumbers> faces)
    : numbers_(faces.size()), leaves_(faces.size()), parts_(faces.size()) {
  std::iota(numbers_.begin(), numbers_.end(), 0U);
  // Until the numbers have found their places, a box stands at the number of its face.
  for (std::size_t n = 0; n < faces.size(); ++n) leaves_[n] = box_of(vertices, faces[n]);
  if (!faces.empty()) halve({0, faces.size()});
  std::vector<FaceBox> placed(faces.size());
  std::ranges::transform(numbers_, placed.begin(), [&](std::uint32_t n) { return leaves_[n]; });
  leaves_ = std::move(placed);
}

void FaceTree::halve(Part part) {
  if (part.size() == 1) return;
  FaceBox box = leaves_[numbers_[part.begin]], middles{middle_of(box), middle_of(box)};
  for (std::size_t i = part.begin; i < part.end; ++i) {
    const FaceBox& each = leaves_[numbers_[i]];
    box = joined(box, each);
    middles = joined(middles, {middle_of(each), middle_of(each)});
  }
  parts_[part.middle()] = box;
  const int axis = longest_side(middles);
  const auto at = [&](std::size_t i) { return numbers_.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(part.begin), at(part.middle()), at(part.end), [&](std::uint32_t a, std::uint32_t b) {
    return middle_of(leaves_[a])[axis] < middle_of(leaves_[b])[axis];
  });
  halve(part.left());
  halve(part.right());
}

}  // namespace durero::mesh
