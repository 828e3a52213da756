#include "hull.hpp"

#include <algorithm>

#include "orientation.hpp"

namespace durero::mesh {
namespace {

using number::Dyadic;
using ExactStep = SpaceStep<Dyadic>;

/// A parameter numerator/denominator of a segment; the denominator is positive.
struct SegmentPlace {
  Dyadic numerator, denominator;
  bool operator<(const SegmentPlace& other) const {
    return numerator * other.denominator < other.numerator * denominator;
  }
};

/// from + s · (to − from)
RatioPoint at_place(const glm::dvec3& from, const glm::dvec3& to, const SegmentPlace& s) {
  const ExactStep step(from, to);
  return {Dyadic(from.x) * s.denominator + step.x * s.numerator, Dyadic(from.y) * s.denominator + step.y * s.numerator,
          Dyadic(from.z) * s.denominator + step.z * s.numerator, s.denominator};
}

double rounded_ratio(const Dyadic& x, const Dyadic& w) {
  return number::round_to_binary64(number::Rational(x.rational() / w.rational()));
}

/// The points as a set: each once, and without one that lies between two others.
FewPoints extreme(FewPoints points) {
  FewPoints found;
  for (const glm::dvec3& p : points)
    if (std::ranges::find(found, p) == found.end()) found.push_back(p);
  if (found.size() < 3) return found;
  for (std::size_t n = 0; n < 3; ++n)
    if (lies_between(found[n], found[(n + 1) % 3], found[(n + 2) % 3])) return {found[(n + 1) % 3], found[(n + 2) % 3]};
  return found;
}

}  // namespace

bool RatioPoint::is_before(const RatioPoint& other) const {
  const auto orders = {(x * other.w) <=> (other.x * w), (y * other.w) <=> (other.y * w),
                       (z * other.w) <=> (other.z * w)};
  const auto* const first = std::ranges::find_if(orders, [](std::strong_ordering order) { return order != 0; });
  return first != orders.end() && *first < 0;
}

glm::dvec3 RatioPoint::rounded() const { return {rounded_ratio(x, w), rounded_ratio(y, w), rounded_ratio(z, w)}; }

Hull::Hull(FewPoints corners) : is_empty_(corners.empty()) {
  corners = extreme(corners);
  if (corners.size() == 1) bound_point(corners[0]);
  if (corners.size() == 2) bound_segment(corners[0], corners[1]);
  if (corners.size() == 3) bound_triangle(corners);
}

void Hull::bound_both(const Step& normal, const glm::dvec3& border) {
  bound(normal, border);
  bound(-normal, border);
}

void Hull::bound_point(const glm::dvec3& p) {
  for (const Step& axis : {Step(1, 0, 0), Step(0, 1, 0), Step(0, 0, 1)}) bound_both(axis, p);
}

void Hull::bound_segment(const glm::dvec3& p, const glm::dvec3& q) {
  const Step step(p, q);
  for (const Step& axis : {Step(1, 0, 0), Step(0, 1, 0), Step(0, 0, 1)}) bound_both(cross(step, axis), p);
  bound(step, p);
  bound(-step, q);
}

void Hull::bound_triangle(const FewPoints& corners) {
  const Step normal = cross(Step(corners[0], corners[1]), Step(corners[0], corners[2]));
  bound_both(normal, corners[0]);
  for (std::size_t n = 0; n < 3; ++n) bound(cross(normal, Step(corners[n], corners[(n + 1) % 3])), corners[n]);
}

bool Hull::contains(const RatioPoint& p) const {
  return !is_empty_ && std::ranges::all_of(bounds_, [&](const HalfSpace& each) {
    const glm::dvec3& b = each.border;
    return sign(dot(each.normal, Step(p.x - p.w * b.x, p.y - p.w * b.y, p.z - p.w * b.z))) >= 0;
  });
}

std::optional<std::array<RatioPoint, 2>> Hull::part_of(const glm::dvec3& from, const glm::dvec3& to) const {
  if (is_empty_) return std::nullopt;
  SegmentPlace least{0, 1}, greatest{1, 1};
  for (const HalfSpace& each : bounds_) {
    const Dyadic at_from = dot(each.normal, Step(each.border, from)), at_to = dot(each.normal, Step(each.border, to));
    if (sign(at_from) < 0 && sign(at_to) < 0) return std::nullopt;
    if (sign(at_from) < 0) least = std::max(least, {-at_from, at_to - at_from});
    if (sign(at_to) < 0) greatest = std::min(greatest, {at_from, at_from - at_to});
  }
  if (greatest < least) return std::nullopt;
  return {{at_place(from, to, least), at_place(from, to, greatest)}};
}

}  // namespace durero::mesh
