#include <cmath>

#include "conform/families/candidate.hpp"

namespace durero::conform {

bool from_far(const AnsweredQuery& q) {
  return any_hit_element(q, [&](const ElementQuadratic& c) {
    const DyadicVector from = difference(q.query.rayo.p().xyz(), c.centro);
    return dot(from, from) >= square(Dyadic(1000) * c.size);
  });
}

bool far_from_zero(const AnsweredQuery& q) {
  return any_hit_element(q, [](const ElementQuadratic& c) {
    const double farthest = std::max({std::abs(c.centro.x), std::abs(c.centro.y), std::abs(c.centro.z)});
    return Dyadic(farthest) >= Dyadic(1000) * c.size;
  });
}

bool hits_far(const AnsweredQuery& q) { return hits(q) && travels_at_least(q, 1e6); }

bool hits_tiny(const AnsweredQuery& q) {
  return any_hit_element(q, [](const ElementQuadratic& c) { return c.size <= Dyadic(1e-3); });
}

bool sizes_differ(const AnsweredQuery& q) {
  return any_hit_element(q, [&](const ElementQuadratic& one) {
    return any_element(q, [&](const ElementQuadratic& other) {
      const Dyadic ratio(1e6);
      return one.size >= ratio * other.size || other.size >= ratio * one.size;
    });
  });
}

bool long_or_short(const AnsweredQuery& q) {
  const Dyadic square_of_v = squared_length(q.query.rayo.v().xyz());
  return hits(q) && (square_of_v > Dyadic(0x1p16) || square_of_v < Dyadic(0x1p-16));
}

bool beyond_binary32(const AnsweredQuery& q) {
  return any_hit_element(q, [](const ElementQuadratic& c) {
    return square(c.size) >= Dyadic(0x1p128) || square(c.size) < Dyadic(0x1p-126);
  });
}

bool long_and_thin(const AnsweredQuery& q) {
  return any_hit_element(q, [](const ElementQuadratic& c) { return Dyadic(c.altura) >= Dyadic(1000) * c.size; });
}

bool hits_near(const AnsweredQuery& q) {
  return any_hit_element(q, [&](const ElementQuadratic& c) { return !travels_at_least(q, Dyadic(1e-3) * c.size); });
}

bool on_grid(const AnsweredQuery& q) {
  const auto snapped = [](double x) { return std::abs(x) <= 8 && std::floor(4 * x) == 4 * x; };
  const glm::dvec3 &p = q.query.rayo.p().xyz(), &v = q.query.rayo.v().xyz();
  return snapped(p.x) && snapped(p.y) && snapped(p.z) && snapped(v.x) && snapped(v.y) && snapped(v.z);
}

}  // namespace durero::conform
