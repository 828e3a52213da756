#include "solid_leaf.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <stdexcept>

namespace durero::oracle {

/// The inside of each shape.
struct SolidLeaf::InsideOf {
  using Inside = decltype(SolidLeaf::inside_);

  Inside operator()(const scene::Sphere& e) const { return Ball{e.centro, e.radio}; }
  Inside operator()(const scene::Cylinder& e) const {
    return Turned{e.centro, glm::normalize(e.vector), e.radio, e.radio, e.altura};
  }
  Inside operator()(const scene::Cone& e) const {
    return Turned{e.centro, glm::normalize(e.vector), e.proporcion * e.altura, 0, e.altura};
  }
  Inside operator()(const scene::TruncatedCone& e) const {
    return Turned{e.centro, glm::normalize(e.vector), e.radio + e.proporcion * e.altura, e.radio, e.altura};
  }
  Inside operator()(const scene::Plane& e) const {
    return HalfSpace{by.point(e.centro), glm::normalize(by.normal(e.vector))};
  }
  Inside operator()(const scene::Disc&) const { throw std::logic_error("a disc bounds no solid"); }
  Inside operator()(const scene::Triangle&) const { throw std::logic_error("a triangle bounds no solid"); }

  const Placement& by;
};

SolidLeaf::SolidLeaf(const scene::Instance& instance)
    : shape_(instance.shape), by_(instance.mapa), inside_(std::visit(InsideOf{by_}, shape_)) {}

double SolidLeaf::margin(const glm::dvec3& w) const {
  return std::visit([&](const auto& inside) { return margin_of(inside, w); }, inside_);
}

// The map makes each distance at least `least` times as long.
double SolidLeaf::margin_of(const Ball& ball, const glm::dvec3& w) const {
  return by_.least() * (glm::length(by_.original(w) - ball.center) - ball.radius);
}

// A point is outside by the farthest of the three lines that bound the profile, and no side of a convex figure is
// nearer than its line.
double SolidLeaf::margin_of(const Turned& turned, const glm::dvec3& w) const {
  const glm::dvec3 q = by_.original(w) - turned.center;
  const double along = glm::dot(q, turned.axis), across = glm::length(q - turned.axis * along);
  const double widens = turned.last_radius - turned.first_radius;
  const double beyond_side =
      ((across - turned.first_radius) * turned.height - widens * along) / std::hypot(turned.height, widens);
  return by_.least() * std::max({-along, along - turned.height, beyond_side});
}

double SolidLeaf::margin_of(const HalfSpace& half, const glm::dvec3& w) const {
  return glm::dot(w - half.point, half.normal);
}

Parametrisation SolidLeaf::side() const {
  return std::visit([](const auto& shape) { return Parametrisation(scene::ShapeView(shape)); }, shape_);
}

std::vector<PlacedSurface> SolidLeaf::surfaces(const Extent& seen) const {
  if (const HalfSpace* const half = plane()) {
    const glm::dvec3 foot = seen.center - half->normal * margin_of(*half, seen.center);
    const double off = 0x1p-48 * (glm::length(half->point) + glm::length(seen.center) + seen.radius);
    return {PlacedSurface(Parametrisation(scene::ShapeView(scene::Plane{foot, half->normal}), seen.radius), {}, off)};
  }
  std::vector<PlacedSurface> surfaces{PlacedSurface(side(), by_)};
  if (const Turned* const turned = std::get_if<Turned>(&inside_)) add_lids(surfaces, *turned);
  return surfaces;
}

// A lid is where the side ends, but for a rounding that is one of the side.
void SolidLeaf::add_lids(std::vector<PlacedSurface>& surfaces, const Turned& turned) const {
  const double off = surfaces.front().original().rounding();
  const auto add = [&](double radius, double height) {
    if (radius == 0) return;  // an apex
    const scene::Disc lid{turned.center + turned.axis * height, radius, turned.axis};
    surfaces.emplace_back(Parametrisation(lid), by_, off);
  };
  add(turned.first_radius, 0);
  add(turned.last_radius, turned.height);
}

SolidLeaf::Extent SolidLeaf::extent() const {
  if (const HalfSpace* const half = plane()) return {half->point, 0};
  const Parametrisation surface = side();
  return {by_.point(surface.center()), by_.most() * surface.size()};
}

}  // namespace durero::oracle
