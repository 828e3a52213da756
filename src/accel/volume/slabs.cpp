#include "durero/accel/volume/slabs.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace durero::accel {
namespace {

constexpr std::array<glm::dvec3, most_slabs> directions = {{{1, 0, 0},
                                                            {0, 1, 0},
                                                            {0, 0, 1},
                                                            {1, 1, 1},
                                                            {-1, 1, 1},
                                                            {1, -1, 1},
                                                            {1, 1, -1},
                                                            {1, 1, 0},
                                                            {1, -1, 0},
                                                            {1, 0, 1},
                                                            {1, 0, -1},
                                                            {0, 1, 1},
                                                            {0, 1, -1}}};

/// Σ|aᵢ·bᵢ|
double magnitude(const glm::dvec3& a, const glm::dvec3& b) {
  return std::abs(a.x * b.x) + std::abs(a.y * b.y) + std::abs(a.z * b.z);
}

BoxInterval common(const BoxInterval& a, const BoxInterval& b) {
  return {std::max(a.entry, b.entry), std::min(a.exit, b.exit)};
}

/// The vector without the components that are next to 0. Its exact direction does not matter.
glm::dvec3 plain(glm::dvec3 n) {
  for (int i = 0; i < 3; ++i)
    if (std::abs(n[i]) < 0x1p-60) n[i] = 0;
  return n;
}

}  // namespace

std::span<const glm::dvec3> slab_directions(std::size_t k) { return std::span(directions).first(k); }

Projection::Projection(const glm::dvec3& n, const trace::Ray& ray)
    : S_(glm::dot(n, ray.p)), slack_(0x1p-50 * magnitude(n, ray.p)) {
  const double speed = glm::dot(n, ray.v), doubt = 0x1p-50 * magnitude(n, ray.v);
  backwards_ = speed < 0;
  T_near_ = 1 / (std::abs(speed) + doubt) * (1 - 0x1p-50);
  T_far_ =
      std::abs(speed) > doubt ? 1 / (std::abs(speed) - doubt) * (1 + 0x1p-50) : std::numeric_limits<double>::infinity();
}

Projections::Projections(const trace::Ray& ray, std::size_t k) {
  for (std::size_t i = 0; i < k; ++i) all_[i] = Projection(directions[i], ray);
}

Slabs Slabs::moved(const glm::dvec3& delta) const {
  Slabs result = *this;
  for (std::size_t i = 0; i < along.size(); ++i) {
    const double by = glm::dot(directions[i], delta), slack = 0x1p-50 * magnitude(directions[i], delta);
    result.along[i].low += by - slack;
    result.along[i].high += by + slack;
    result.along[i].low -= 0x1p-50 * std::abs(result.along[i].low);
    result.along[i].high += 0x1p-50 * std::abs(result.along[i].high);
  }
  return result;
}

Slab slab_around(const Outline& outline, const glm::dvec3& n) {
  const Slab extent = outline.extent(n);
  return {extent.low - 0x1p-50 * std::abs(extent.low), extent.high + 0x1p-50 * std::abs(extent.high)};
}

Slabs slabs_around(const Outline& outline, std::size_t k) {
  Slabs slabs;
  for (const glm::dvec3& n : slab_directions(k)) slabs.along.push_back(slab_around(outline, n));
  return slabs;
}

OrientedBox oriented_box_around(const Outline& outline) {
  const glm::dvec3 d = outline.axis;
  const glm::dvec3 edge = outline.count == 3 ? outline.centre[1] - outline.centre[0] : glm::dvec3(0);
  const double length = glm::length(edge);
  // The axis of space that is farthest from the axis, where no edge lies across it.
  const glm::dvec3 other = std::abs(d.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  glm::dvec3 across = glm::cross(d, other);
  if (length > 0x1p-100 && std::abs(glm::dot(edge / length, d)) < 0.5) across = edge / length;
  OrientedBox box{};
  box.normal = {plain(d), plain(across), plain(glm::cross(d, across))};
  for (std::size_t i = 0; i < 3; ++i) box.along[i] = slab_around(outline, box.normal[i]);
  return box;
}

BoxInterval stretch(const Slabs& slabs, const Projections& projections) {
  BoxInterval result{0, never};
  for (std::size_t i = 0; i < slabs.along.size(); ++i) result = common(result, projections[i].within(slabs.along[i]));
  return result;
}

BoxInterval stretch(const OrientedBox& box, const trace::Ray& ray) {
  BoxInterval result{0, never};
  for (std::size_t i = 0; i < 3; ++i) result = common(result, Projection(box.normal[i], ray).within(box.along[i]));
  return result;
}

}  // namespace durero::accel
