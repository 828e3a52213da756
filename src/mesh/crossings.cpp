#include "crossings.hpp"

#include <algorithm>
#include <optional>

#include "apart.hpp"
#include "face_tree.hpp"
#include "hull.hpp"

namespace durero::mesh {
namespace {

bool has(const CornerNumbers& face, std::uint32_t corner) { return std::ranges::find(face, corner) != face.end(); }

/// The corners of two faces, told apart by their numbers.
SharedCorners shared(std::span<const glm::dvec3> vertices, const CornerNumbers& a, const CornerNumbers& b) {
  SharedCorners corners;
  for (std::size_t n = 0; n < 3; ++n) {
    if (std::find(a.begin(), a.begin() + n, a[n]) == a.begin() + n)
      (has(b, a[n]) ? corners.both : corners.first).push_back(vertices[a[n]]);
    if (std::find(b.begin(), b.begin() + n, b[n]) == b.begin() + n && !has(a, b[n]))
      corners.second.push_back(vertices[b[n]]);
  }
  return corners;
}

FewPoints all_corners(const FewPoints& both, const FewPoints& own) {
  FewPoints all = both;
  all.insert(all.end(), own.begin(), own.end());
  return all;
}

/// Looks among corners of what two faces have in common for the first that is not in their shared part. A corner of the
/// common part of two convex sets of corners, edges and faces lies on an edge of one of them.
class FirstOutside {
 public:
  explicit FirstOutside(const FewPoints& shared) : shared_(shared) {}

  void look_along_edges(const FewPoints& face, const Hull& other) {
    for (std::size_t n = 0; n < face.size(); ++n)
      if (const auto part = other.part_of(face[n], face[(n + 1) % face.size()]))
        for (const RatioPoint& end : *part) look_at(end);
  }
  const std::optional<RatioPoint>& found() const { return found_; }

 private:
  void look_at(const RatioPoint& p) {
    if (!shared_.contains(p) && (!found_ || p.is_before(*found_))) found_ = p;
  }

  Hull shared_;
  std::optional<RatioPoint> found_;
};

/// The first point by x, y and z among the corners of what two faces have in common, without what is between the
/// corners that they share; nothing where there is none. All that they have in common is in the shared part where its
/// corners are, since that is convex.
std::optional<RatioPoint> first_outside(const SharedCorners& corners) {
  const FewPoints a = all_corners(corners.both, corners.first), b = all_corners(corners.both, corners.second);
  FirstOutside first(corners.both);
  first.look_along_edges(a, Hull(b));
  first.look_along_edges(b, Hull(a));
  return first.found();
}

}  // namespace

std::vector<CrossingFaces> crossings(std::span<const glm::dvec3> vertices, std::span<const CornerNumbers> faces) {
  std::vector<CrossingFaces> found;
  FaceTree(vertices, faces).each_pair([&](std::uint32_t m, std::uint32_t n) {
    const SharedCorners corners = shared(vertices, faces[m], faces[n]);
    if (corners.first.empty() || corners.second.empty() || are_surely_apart(corners)) return;
    if (const auto place = first_outside(corners))
      found.push_back({{std::min(m, n), std::max(m, n)}, place->rounded()});
  });
  std::ranges::sort(found, {}, &CrossingFaces::faces);
  return found;
}

}  // namespace durero::mesh
