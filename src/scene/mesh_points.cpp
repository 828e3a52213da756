#include "durero/scene/mesh_points.hpp"

#include <algorithm>

namespace durero::scene {
namespace {

/// Whether each coordinate is a number of binary32. NaN is none.
bool is_exact_in_single(const glm::dvec3& point) { return glm::dvec3(glm::vec3(point)) == point; }

}  // namespace

MeshPoints::MeshPoints(const std::vector<glm::dvec3>& points) {
  if (std::ranges::all_of(points, is_exact_in_single)) {
    points_.emplace<Singles>(points.begin(), points.end());
  } else {
    points_.emplace<Doubles>(points);
  }
}

bool MeshPoints::operator==(const MeshPoints& other) const noexcept {
  if (size() != other.size()) return false;
  for (std::size_t number = 0; number < size(); ++number)
    if ((*this)[number] != other[number]) return false;
  return true;
}

void MeshPoints::reserve(std::size_t points) {
  std::visit([&](auto& all) { all.reserve(points); }, points_);
}

void MeshPoints::push_back(const glm::dvec3& point) {
  widen_for(point);
  std::visit([&](auto& all) { all.emplace_back(point); }, points_);
}

void MeshPoints::set(std::size_t number, const glm::dvec3& point) {
  widen_for(point);
  std::visit([&]<class Point>(std::vector<Point>& all) { all[number] = Point(point); }, points_);
}

std::size_t MeshPoints::bytes() const noexcept {
  return is_single() ? singles().capacity() * sizeof(glm::vec3) : doubles().capacity() * sizeof(glm::dvec3);
}

/// Widens all points where this one is not exact in binary32. Room for points stays.
void MeshPoints::widen_for(const glm::dvec3& point) {
  if (!is_single() || is_exact_in_single(point)) return;
  Doubles wide;
  wide.reserve(singles().capacity());
  wide.assign(singles().begin(), singles().end());
  points_ = std::move(wide);
}

}  // namespace durero::scene
