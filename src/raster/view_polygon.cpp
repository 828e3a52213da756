#include "durero/raster/view_polygon.hpp"

#include <algorithm>
#include <cmath>

#include "durero/polygon/pyramid.hpp"
#include "durero/raster/scene_polygons.hpp"

namespace durero::raster {
namespace {

using polygon::Rational;
using polygon::RationalPoint;

/// Each product has one rounding of the coefficient and one of its own, and a sum of three has two more: at most four
/// halves of a unit in the last place of what is summed, in size; the fifth is for the sum of the sizes itself. What
/// is lost below the normal numbers is less than the last term.
constexpr double rounding = 5 * 0x1p-53, lost = 0x1p-1020;

/// The plane of a polygon as one over the parameter at which a ray from the eye meets it; zero where it is edge-on.
RationalPoint nearness_of(const polygon::Polygon& corners, const polygon::Apex& eye) {
  const auto side = polygon::side_of(eye, corners);
  if (!side) return {};
  return (Rational(-1) / eye.depth_in(*side)) * side->normal;
}

std::vector<DirectionForm> edges_of(const polygon::Polygon& corners, const polygon::Apex& eye) {
  std::vector<DirectionForm> edges;
  for (const polygon::PlaneSide& edge : polygon::pyramid(eye, corners)) {
    const RationalPoint& n = edge.normal;
    const Rational size = std::max({abs(n.x), abs(n.y), abs(n.z)});
    edges.emplace_back((1 / size) * n);
  }
  return edges;
}

}  // namespace

DirectionForm::DirectionForm(RationalPoint coefficients)
    : exact_(std::move(coefficients)), rounded_(polygon::rounded(exact_)) {}

double DirectionForm::value(const glm::dvec3& direction, double& error) const {
  const glm::dvec3 each = rounded_ * direction;
  error = rounding * (std::abs(each.x) + std::abs(each.y) + std::abs(each.z)) + lost;
  return each.x + each.y + each.z;
}

int DirectionForm::sign(const glm::dvec3& direction) const {
  double error = 0;
  const double quick = value(direction, error);
  if (std::abs(quick) > error) return quick > 0 ? 1 : -1;
  return polygon::dot(exact_, polygon::exact(direction)).sign();
}

ViewPolygon::ViewPolygon(const polygon::Polygon& corners, const glm::dvec3& eye)
    : edges_(edges_of(corners, {polygon::exact(eye)})), nearness_(nearness_of(corners, {polygon::exact(eye)})) {}

bool ViewPolygon::is_met(const glm::dvec3& direction) const {
  return !is_edge_on() && nearness_.sign(direction) > 0 &&
         std::ranges::all_of(edges_, [&](const DirectionForm& edge) { return edge.sign(direction) >= 0; });
}

double ViewPolygon::parameter(const glm::dvec3& direction) const {
  double error = 0;
  return 1 / nearness_.value(direction, error);
}

bool ViewPolygon::is_before(const ViewPolygon& other, const glm::dvec3& direction) const {
  double error = 0, error_of_other = 0;
  const double own = nearness_.value(direction, error), others = other.nearness_.value(direction, error_of_other);
  if (std::abs(own - others) > 2 * (error + error_of_other)) return own > others;
  return polygon::dot(nearness_.exact() - other.nearness_.exact(), polygon::exact(direction)) > 0;
}

}  // namespace durero::raster
