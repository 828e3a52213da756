#include "conform/families/asked_points.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "durero/conform/judge/truth.hpp"

namespace durero::conform {
namespace {

bool has_numbers(const glm::dvec3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

glm::dvec3 rounded_to(NumberFormat numbers, const glm::dvec3& p) {
  return numbers == NumberFormat::binary32 ? glm::dvec3(glm::vec3(p)) : p;
}

/// The centre or the first vertex of some element.
glm::dvec3 some_centre(const scene::Scene& scene, Random& random) {
  std::vector<glm::dvec3> centres;
  scene.for_each([&](scene::ElementRef, const auto& shape) {
    if constexpr (requires { shape.vertices; })
      centres.push_back(shape.vertices[0]);
    else
      centres.push_back(shape.centro);
  });
  return random.any_of(centres);
}

/// A point on the ray: at or beside a crossing, between crossings, or far away.
glm::dvec3 point_along(const scene::Query& ray, std::vector<double> crossings, Random& random) {
  const glm::dvec3 &p = ray.rayo.p().xyz(), &v = ray.rayo.v().xyz();
  std::erase_if(crossings, [](double t) { return !std::isfinite(t); });
  if (crossings.empty()) crossings = {(1 + glm::length(p)) / glm::length(v)};
  const double t = random.any_of(crossings), other = random.any_of(crossings);
  switch (random.below(4)) {
    case 0:
      return p + t * v;
    case 1:
      return p + t * (1 + random.signed_power(-50, -2)) * v;
    case 2:
      return p + (t + random.uniform(0, 1) * (other - t)) * v;
    default:
      return p + std::ldexp(t, random.integer(1, 20)) * v;
  }
}

}  // namespace

void put_points_near(SuiteCase& of, NumberFormat numbers, Random& random) {
  const SceneTruths truths(of.the_case.scene, of.the_case.rays.size(), of.bodies);
  for (scene::Query& ray : of.the_case.rays) {
    const std::size_t which = random.below(8);
    glm::dvec3 point = ray.rayo.p().xyz();
    if (which == 0)
      point = some_centre(of.the_case.scene, random);
    else if (which <= 5)
      point = point_along(ray, truths.crossings(ray), random);
    point = rounded_to(numbers, point);
    if (has_numbers(point)) ray = {{model::Punto(point), ray.rayo.v()}, {}};
  }
}

void turn_to_nearest(SuiteCase& of) {
  for (std::size_t i = 0; i < of.truths.size(); ++i) {
    scene::Query& ray = of.the_case.rays[i];
    const glm::dvec3 way = (of.truths[i].hit.punto - ray.rayo.p().xyz()) / of.truths[i].hit.t;
    const bool is_way = has_numbers(way) && std::abs(glm::length(way) - 1) < 0.5;
    ray = {{ray.rayo.p(), model::Vector(is_way ? way : glm::dvec3(0, 0, 1))}, {}};
  }
}

}  // namespace durero::conform
