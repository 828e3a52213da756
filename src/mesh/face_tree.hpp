#pragma once
/// A balanced tree of the boxes of faces, to find those that meet.

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "durero/mesh/audit.hpp"

namespace durero::mesh {

/// A box whose sides belong to it.
struct FaceBox {
  glm::dvec3 least, greatest;

  bool meets(const FaceBox& other) const {
    return least.x <= other.greatest.x && other.least.x <= greatest.x && least.y <= other.greatest.y &&
           other.least.y <= greatest.y && least.z <= other.greatest.z && other.least.z <= greatest.z;
  }
};

/// The faces are halved by the middles of their boxes, across the longest side, down to one.
class FaceTree {
 public:
  FaceTree(std::span<const glm::dvec3> vertices, std::span<const CornerNumbers> faces);

  /// Calls visit(m, n), or visit(n, m), once for each two faces whose boxes meet.
  template <class Visit>
  void each_pair(const Visit& visit) const {
    if (!numbers_.empty()) within({0, numbers_.size()}, visit);
  }

 private:
  struct Part {
    std::size_t begin, end;
    std::size_t size() const { return end - begin; }
    std::size_t middle() const { return begin + size() / 2; }
    Part left() const { return {begin, middle()}; }
    Part right() const { return {middle(), end}; }
  };

  void halve(Part part);
  const FaceBox& box(const Part& part) const { return part.size() == 1 ? leaves_[part.begin] : parts_[part.middle()]; }

  template <class Visit>
  void within(const Part& part, const Visit& visit) const {
    if (part.size() == 1) return;
    within(part.left(), visit);
    within(part.right(), visit);
    between(part.left(), part.right(), visit);
  }

  template <class Visit>
  void between(const Part& a, const Part& b, const Visit& visit) const {
    if (!box(a).meets(box(b))) return;
    if (a.size() < b.size()) return between(b, a, visit);
    if (a.size() == 1) return visit(numbers_[a.begin], numbers_[b.begin]);
    between(a.left(), b, visit);
    between(a.right(), b, visit);
  }

  std::vector<std::uint32_t> numbers_;
  std::vector<FaceBox> leaves_;  // of the face with the number that stands there
  std::vector<FaceBox> parts_;   // of the part with that middle
};

}  // namespace durero::mesh
