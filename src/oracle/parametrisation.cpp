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

/// A profile and the axis that it is turned around; a fan, and its normal.
struct Parametrisation::Profile {
  glm::dvec3 center, axis;
  std::variant<Arc, Segment, Fan> curve;
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
  Profile operator()(const scene::Disc& e) const { return {e.centro, e.vector, Segment{0, e.radio, 0}}; }
  /// From the vertex that is opposite to the shortest edge.
  Profile operator()(const scene::Triangle& e) const {
    const auto opposite = [&](std::size_t i) { return glm::length(e.vertices[(i + 2) % 3] - e.vertices[(i + 1) % 3]); };
    std::size_t at = 0;
    for (const std::size_t i : {1u, 2u})
      if (opposite(i) < opposite(at)) at = i;
    const Fan fan{e.vertices[(at + 1) % 3] - e.vertices[at], e.vertices[(at + 2) % 3] - e.vertices[at]};
    return {e.vertices[at], glm::cross(fan.first, fan.last), fan};
  }

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

void Parametrisation::measure(const Fan& fan) {
  length_ = std::max(glm::length(fan.first), glm::length(fan.last));
  widest_ = length_ / 2;
  size_ = 2 * length_;
}

// The normal of a fan that is thinner than rounding is any vector: `at` gives such a fan no point away from its edges.
void Parametrisation::set_frame(const glm::dvec3& axis) {
  const double length = glm::length(axis);
  axis_ = length > 0 ? axis / length : glm::dvec3(0, 0, 1);
  const glm::dvec3 other = std::abs(axis_.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  across_ = glm::normalize(glm::cross(axis_, other));
  sideways_ = glm::cross(axis_, across_);
}

// A point is centro and three products with vectors of length 1: its few dozen roundings, and those of sine, cosine and
// the frame, each move it by less than 2⁻⁵⁰ of |centro| + size.
double Parametrisation::rounding() const noexcept { return 0x1p-45 * (glm::length(center_) + size_); }

Parametrisation::Circle Parametrisation::circle(const Arc& arc, double u) {
  return {arc.radius * std::sin(pi * u), arc.radius * std::cos(pi * u)};
}

Parametrisation::Circle Parametrisation::circle(const Segment& s, double u) {
  return {(1 - u) * s.first_radius + u * s.last_radius, u * s.height};
}

glm::dvec3 Parametrisation::outwards(double v) const {
  return across_ * std::cos(2 * pi * v) + sideways_ * std::sin(2 * pi * v);
}

double Parametrisation::Fan::width() const { return glm::length(last - first); }

double Parametrisation::around(double u) const {
  return std::visit(Overloaded{[u](const Fan& fan) { return u * fan.width(); },
                               [u](const auto& turned) { return 2 * pi * circle(turned, u).radius; }},
                    profile_);
}

// Along a profile a radius changes by no more than the way; along the segments of a fan, whose opposite edge is no
// longer than they are, so does what lies between them.
double Parametrisation::around_within(double u, double way) const {
  if (const Fan* fan = std::get_if<Fan>(&profile_)) return std::min(fan->width(), around(u) + way);
  return std::min(2 * pi * widest_, around(u) + 2 * pi * way);
}

glm::dvec3 Parametrisation::middle(double u) const {
  return std::visit(Overloaded{[&](const Fan& fan) { return center_ + u / 2 * (fan.first + fan.last); },
                               [&](const auto& turned) { return center_ + axis_ * circle(turned, u).height; }},
                    profile_);
}

// What is turned has its middles on the axis, at a right angle to the circles.
double Parametrisation::reach(double u, const glm::dvec3& from) const {
  const double way = glm::length(from - middle(u));
  return std::visit(Overloaded{[&](const Fan& fan) { return way + u * fan.width() / 2; },
                               [&](const auto& turned) { return std::hypot(circle(turned, u).radius, way); }},
                    profile_);
}

glm::dvec3 Parametrisation::on(const Circle& circle, const glm::dvec3& outwards) const {
  return center_ + axis_ * circle.height + outwards * circle.radius;
}

glm::dvec3 Parametrisation::on(const Fan& fan, double u, double v) const {
  return center_ + u * ((1 - v) * fan.first + v * fan.last);
}

glm::dvec3 Parametrisation::point(double u, double v) const {
  return std::visit(Overloaded{[&](const Fan& fan) { return on(fan, u, v); },
                               [&](const auto& turned) { return on(circle(turned, u), outwards(v)); }},
                    profile_);
}

SurfacePoint Parametrisation::at(double u, double v) const {
  return std::visit([&](const auto& curve) { return at(curve, u, v); }, profile_);
}

SurfacePoint Parametrisation::at(const Arc& arc, double u, double v) const {
  const Circle here = circle(arc, u);
  const glm::dvec3 out = outwards(v);
  return {on(here, out), (out * here.radius + axis_ * here.height) / arc.radius, infinity, 1 / arc.radius};
}

SurfacePoint Parametrisation::at(const Segment& s, double u, double v) const {
  const Circle here = circle(s, u);
  const glm::dvec3 out = outwards(v);
  // The slope of the profile: how much of its length is height, and how much is radius.
  const double rise = s.height / length_, narrowing = (s.first_radius - s.last_radius) / length_;
  // The middle of a disc is no edge.
  const double edge = (rise == 0 && s.first_radius == 0 ? 1 - u : std::min(u, 1 - u)) * length_;
  // The generators are straight; around the axis the curvature is rise/radius, most where the circle is least; a disc
  // has none.
  const double least = here.radius - std::abs(narrowing) * edge / 2;
  const double curvature = rise == 0 ? 0 : least > 0 ? rise / least : infinity;
  return {on(here, out), out * rise + axis_ * narrowing, edge, curvature};
}

// The distance from each edge is a share of the height over it. Where a height is not far above the rounding of the
// area, the distance is not far above that of points, and no reach within it is asked about.
SurfacePoint Parametrisation::at(const Fan& fan, double u, double v) const {
  const glm::dvec3 opposite = fan.last - fan.first;
  const double area = glm::length(glm::cross(fan.first, fan.last));
  const double edge = std::min({(1 - u) * area / glm::length(opposite), u * (1 - v) * area / glm::length(fan.last),
                                u * v * area / glm::length(fan.first)});
  return {on(fan, u, v), axis_, 0.999 * edge, 0};
}

}  // namespace durero::oracle
