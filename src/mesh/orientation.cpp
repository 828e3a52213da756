#include "orientation.hpp"

#include "durero/number/ball.hpp"
#include "space_step.hpp"

namespace durero::mesh {
namespace {

using number::Dyadic;
using number::RealBall;

template <class Number>
bool has_area(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  return cross(SpaceStep<Number>(a, b), SpaceStep<Number>(a, c)).has_sign();
}

}  // namespace

bool are_collinear(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  return !has_area<RealBall>(a, b, c) && !has_area<Dyadic>(a, b, c);
}

bool lies_between(const glm::dvec3& w, const glm::dvec3& a, const glm::dvec3& b) {
  if (!are_collinear(a, b, w)) return false;
  return sign(dot(SpaceStep<Dyadic>(w, a), SpaceStep<Dyadic>(w, b))) < 0;
}

Dyadic determinant(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  const Dyadic bx(b.x), by(b.y), bz(b.z), cx(c.x), cy(c.y), cz(c.z);
  return Dyadic(a.x) * (by * cz - bz * cy) + Dyadic(a.y) * (bz * cx - bx * cz) + Dyadic(a.z) * (bx * cy - by * cx);
}

}  // namespace durero::mesh
