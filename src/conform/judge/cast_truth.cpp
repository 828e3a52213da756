#include "durero/conform/judge/cast_truth.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "conform/judge/ball.hpp"
#include "conform/judge/ball_candidates.hpp"
#include "conform/judge/robust.hpp"
#include "durero/distance/distances.hpp"
#include "durero/number/quotient.hpp"
#include "durero/trace/candidates.hpp"

namespace durero::conform {
namespace {

scene::Hit hit_of(const BallTouch& touch, const model::Rayo& rayo, const scene::ElementSet& elements) {
  scene::Hit hit{model::Resultado::hit, 0, rayo.p().xyz(), elements};
  std::sort(hit.elementos.begin(), hit.elementos.end());
  if (!touch.root) return hit;
  hit.t = algebra::rounded_linear({}, 1, *touch.root);
  for (int i = 0; i < 3; ++i) hit.punto[i] = algebra::rounded_linear(rayo.p().xyz()[i], rayo.v().xyz()[i], *touch.root);
  return hit;
}

ExactAnswer truth_of_cast(const scene::Scene& scene, const model::Rayo& rayo, double radius) {
  const AskedElements elements(scene);
  std::optional<BallTouch> first;
  scene::ElementSet at;
  double limit = std::numeric_limits<double>::infinity();
  const auto touch = [&](scene::ElementRef element) {
    const std::optional<BallTouch> found = first_touch(elements, element, rayo, radius);
    const auto order = found && first ? *found <=> *first : std::strong_ordering::less;
    if (!found || order > 0) return false;
    if (order < 0) at.clear();
    first = found;
    limit = rounded_up(found->high());
    at.push_back(element);
    return false;
  };
  BallWay(scene, rayo, radius).any_of([&] { return limit; }, touch);
  if (!first) return {};
  const Ambiguity ambiguity = at.size() > 1 ? Ambiguity::tie : Ambiguity::none;
  return {hit_of(*first, rayo, at), ambiguity};
}

/// A vector of length 1 across d.
glm::dvec3 some_across(const glm::dvec3& d) {
  const glm::dvec3 other = std::abs(d.x) < std::abs(d.y) ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  return glm::normalize(glm::cross(d, other));
}

/// The foot on the line from the radius at the base to that at the end, in the plane of the axis and the middle.
template <surface::Axial Shape>
glm::dvec3 contact_of_wall(const Shape& shape, const glm::dvec3& middle) {
  const double size = glm::length(shape.vector), altura = shape.altura / size;
  const glm::dvec3 d = shape.vector / size, q = middle - shape.centro;
  const double along = glm::dot(q, d);
  const glm::dvec3 across = q - along * d;
  const double away = glm::length(across);
  const glm::dvec3 out = away > 0 ? across / away : some_across(d);
  const double base = number::round_to_binary64(radius_at_centre(shape)), slope = -proportion(shape) * size;
  const double foot = (along + slope * (away - base)) / (1 + slope * slope), s = std::clamp(foot, 0.0, altura);
  return shape.centro + s * d + std::max(0.0, base + slope * s) * out;
}

}  // namespace

glm::dvec3 contact_of(const scene::Scene& scene, scene::ElementRef element, const glm::dvec3& middle) {
  return scene.visit(element, [&]<class Shape>(const Shape& shape) {
    if constexpr (surface::Axial<Shape>)
      return contact_of_wall(shape, middle);
    else
      return distance::nearest_of(scene, element, middle).point;
  });
}

std::vector<ExactAnswer> truths_of_casts(const scene::Scene& scene, std::span<const scene::Query> rays,
                                         std::span<const AskedRange> ranges) {
  std::vector<ExactAnswer> all(rays.size());
  trace::for_each_block(rays.size(), [&](std::size_t begin, std::size_t count) {
    for (std::size_t ray = begin; ray < begin + count; ++ray)
      all[ray] = truth_of_cast(scene, rays[ray].rayo, ranges[ray].radio);
  });
  return all;
}

}  // namespace durero::conform
