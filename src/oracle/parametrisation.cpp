#include "durero/oracle/parametrisation.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

namespace durero::oracle {
namespace {

using std::numbers::pi;
constexpr double infinity = std::numeric_limits<double>::infinity();

template <class... Cases>
struct Overloaded : Cases... {
  using Cases::operator()...;
};
/// As the standard deduces them of an aggregate; Clang 16 does not.
template <class... Cases>
Overloaded(Cases...) -> Overloaded<Cases...>;

}  // namespace

/// A profile and the axis that it is turned around.
struct Parametrisation::Profile {
  glm::dvec3 center, axis;
  std::variant<Arc, Segment> curve;
  bool is_patch = false;
};

/// The profile of each shape.
struct Parametrisation::ProfileOf {
  Profile operator()(const scene::Sphere& e) const { return {e.centro, {0, 0, 1}, Arc{e.radio}}; }
  Profile operator()(const scene::Cylinder& e) const {
    return {e.centro, e.vector, Segment{e.radio, e.radio, e.altura}};
  }
  Profile operator()(const scene::Cone& e) const {
    return {e.centro, e.vector, Segment{e.proporcion * e.altura, 0, e.altura}};
  }
  Profile operator()(const scene::TruncatedCone& e) const {
    return {e.centro, e.vector, Segment{e.radio + e.proporcion * e.altura, e.radio, e.altura}};
  }
  Profile operator()(const scene::Plane& e) const { return {e.centro, e.vector, Segment{0, patch, 0}, true}; }

  double patch;
};

Parametrisation::Parametrisation(scene::ShapeView shape, double patch)
    : Parametrisation(shape.visit(ProfileOf{patch})) {}

Parametrisation::Parametrisation(const Profile& profile)
    : center_(profile.center), profile_(profile.curve), is_patch_(profile.is_patch) {
  std::visit([&](const auto& curve) { measure(curve); }, profile_);
  set_frame(profile.axis);
}

void Parametrisation::measure(const Arc& arc) {
  length_ = pi * arc.radius;
  widest_ = arc.radius;
  size_ = 2 * arc.radius;
}

void Parametrisation::measure(const Segment& segment) {
  length_ = std::hypot(segment.last_radius - segment.first_radius, segment.height);
  widest_ = std::max(segment.first_radius, segment.last_radius);
  size_ = widest_ + segment.height;
}

void Parametrisation::set_frame(const glm::dvec3& axis) {
  axis_ = glm::normalize(axis);
  const glm::dvec3 other = std::abs(axis_.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  across_ = glm::normalize(glm::cross(axis_, other));
  sideways_ = glm::cross(axis_, across_);
}

// A point is centro and three products with vectors of length 1: its few dozen roundings, and those of sine, cosine and
// the frame, each move it by less than 2⁻⁵⁰ of |centro| + size.
double Parametrisation::rounding() const noexcept { return 0x1p-45 * (glm::length(center_) + size_); }

Circle Parametrisation::circle(double u) const {
  return std::visit(Overloaded{[u](const Arc& arc) {
                                 return Circle{arc.radius * std::sin(pi * u), arc.radius * std::cos(pi * u)};
                               },
                               [u](const Segment& s) {
                                 return Circle{(1 - u) * s.first_radius + u * s.last_radius, u * s.height};
                               }},
                    profile_);
}

glm::dvec3 Parametrisation::outwards(double v) const {
  return across_ * std::cos(2 * pi * v) + sideways_ * std::sin(2 * pi * v);
}

glm::dvec3 Parametrisation::on(const Circle& circle, double v) const {
  return on_axis(circle.height) + outwards(v) * circle.radius;
}

SurfacePoint Parametrisation::at(double u, double v) const {
  const Circle here = circle(u);
  const glm::dvec3 outwards = this->outwards(v), point = on(here, v);
  return std::visit(
      Overloaded{[&](const Arc& arc) {
                   return SurfacePoint{point, (outwards * here.radius + axis_ * here.height) / arc.radius, infinity,
                                       1 / arc.radius};
                 },
                 [&](const Segment& s) {
                   // The slope of the profile: how much of its length is height, and how much is radius.
                   const double rise = s.height / length_, narrowing = (s.first_radius - s.last_radius) / length_;
                   // The middle of a disc is no edge.
                   const double edge = (rise == 0 && s.first_radius == 0 ? 1 - u : std::min(u, 1 - u)) * length_;
                   // The generators are straight; around the axis the curvature is rise/radius, most where the circle
                   // is least; a disc has none.
                   const double least = here.radius - std::abs(narrowing) * edge / 2;
                   const double curvature = rise == 0 ? 0 : least > 0 ? rise / least : infinity;
                   return SurfacePoint{point, outwards * rise + axis_ * narrowing, edge, curvature};
                 }},
      profile_);
}

}  // namespace durero::oracle
