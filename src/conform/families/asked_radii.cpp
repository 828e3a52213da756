#include "conform/families/asked_radii.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <vector>

#include "durero/distance/distances.hpp"

namespace durero::conform {
namespace {

/// The way of a point from the line of a ray.
double beside_line(const model::Rayo& rayo, const glm::dvec3& w) {
  const glm::dvec3 v = rayo.v().xyz() / glm::length(rayo.v().xyz());
  return glm::length(glm::cross(w - rayo.p().xyz(), v));
}

/// The way of the line of a ray from the line through two points.
double beside_edge(const model::Rayo& rayo, const glm::dvec3& a, const glm::dvec3& b) {
  const glm::dvec3 across = glm::cross(rayo.v().xyz(), b - a);
  const double length = glm::length(across);
  return length > 0 ? std::abs(glm::dot(a - rayo.p().xyz(), across)) / length : beside_line(rayo, a);
}

/// A size of a shape, and a radius with which a ball just passes it or just touches it.
struct ShapeRadii {
  double size, passing;
};

template <class Shape>
ShapeRadii radii_at(const Shape& shape, const model::Rayo& rayo, Random& random) {
  if constexpr (requires { shape.vertices; }) {
    const std::size_t first = random.below(3);
    const glm::dvec3 &a = shape.vertices[first], &b = shape.vertices[(first + 1) % 3];
    const bool is_of_edge = random.chance(1, 2);
    return {glm::length(b - a), is_of_edge ? beside_edge(rayo, a, b) : beside_line(rayo, a)};
  } else {
    const double away = beside_line(rayo, shape.centro);
    if constexpr (requires { shape.radio; })
      return {shape.radio, std::abs(away - shape.radio)};
    else if constexpr (requires { shape.altura; })
      return {shape.altura, away};
    else
      return {glm::length(shape.centro - rayo.p().xyz()), away};
  }
}

/// The radii of one case, in a format.
class RadiusDraw {
 public:
  RadiusDraw(const SuiteCase& of, NumberFormat numbers, Random& random)
      : of_(&of), distances_(of.the_case.scene), is_narrow_(numbers == NumberFormat::binary32), random_(&random) {
    of.the_case.scene.for_each([&](scene::ElementRef e, const auto&) { elements_.push_back(e); });
  }

  double radius(std::size_t ray) {
    const scene::Hit& hit = of_->truths[ray].hit;
    const model::Rayo& rayo = of_->the_case.rays[ray].rayo;
    const bool has_first = !hit.elementos.empty() && random_->chance(3, 4);
    const scene::ElementRef element = has_first ? random_->any_of(hit.elementos) : random_->any_of(elements_);
    const ShapeRadii of_shape =
        of_->the_case.scene.visit(element, [&](const auto& shape) { return radii_at(shape, rayo, *random_); });
    distance::DistanceWork work;
    const double apart = distances_.nearest(rayo.p().xyz(), work).distance;
    const double drawn = drawn_radius(of_shape, apart);
    const bool may_begin_in_touch = random_->chance(1, 16) || !(apart > 0);
    const double within = apart * random_->uniform(0, 1);
    return usable(drawn < apart || may_begin_in_touch ? drawn : within, of_shape.size);
  }

 private:
  double nearly(double x) { return x * (1 + random_->signed_power(is_narrow_ ? -22 : -50, -2)); }

  double drawn_radius(const ShapeRadii& of, double apart) {
    switch (random_->below(8)) {
      case 0:
        return std::ldexp(of.size, -random_->integer(15, 30));
      case 1:
      case 2:
        return std::ldexp(of.size, -random_->integer(2, 10));
      case 3:
        return of.size * random_->uniform(0.2, 2);
      case 4:
        return std::ldexp(of.size, random_->integer(1, 6));
      case 5:
        return nearly(apart);
      default:
        return nearly(of.passing);
    }
  }

  /// The radius in the format; where that is no normal number, or none of numbers of the size, the size.
  double usable(double radius, double size) const {
    for (const double r : {radius, size}) {
      const double rounded = is_narrow_ ? static_cast<double>(static_cast<float>(r)) : r;
      const double least =
          is_narrow_ ? static_cast<double>(std::numeric_limits<float>::min()) : std::numeric_limits<double>::min();
      if (std::isfinite(rounded) && rounded >= least) return rounded;
    }
    return 1;
  }

  const SuiteCase* of_;
  distance::Distances distances_;
  bool is_narrow_;
  Random* random_;
  std::vector<scene::ElementRef> elements_{};
};

}  // namespace

std::vector<AskedRange> radii_of_balls(const SuiteCase& of, NumberFormat numbers, Random& random) {
  RadiusDraw draw(of, numbers, random);
  std::vector<AskedRange> all;
  for (std::size_t ray = 0; ray < of.truths.size(); ++ray) all.push_back({.radio = draw.radius(ray)});
  return all;
}

}  // namespace durero::conform
