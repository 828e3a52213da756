#include <algorithm>

#include "conform/families/candidate.hpp"
#include "durero/surface/surfaces.hpp"

namespace durero::conform {

bool at_edges(const AnsweredQuery& q) {
  const auto at_edge = [](const ElementQuadratic& c) {
    return std::any_of(c.f.bounds.begin(), c.f.bounds.end(),
                       [](const auto& bound) { return number::sign(bound.C) == 0; });
  };
  return q.hit.elementos.size() > 1 || any_met_element(q, at_edge);
}

bool starts_beside(const AnsweredQuery& q) {
  const glm::dvec3& p = q.query.rayo.p().xyz();
  for (const scene::Triangle triangle : q.scene.shapes<scene::Triangle>()) {
    const surface::Box box = surface::box(triangle);
    const glm::dvec3 size = box.high - box.low;
    const double beside = std::max({size.x, size.y, size.z}) / 8;
    bool is_beside = true;
    for (int i = 0; i < 3; ++i) is_beside = is_beside && p[i] >= box.low[i] - beside && p[i] <= box.high[i] + beside;
    if (is_beside) return true;
  }
  return false;
}

}  // namespace durero::conform
