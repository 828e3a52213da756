#include "orientation.hpp"

#include "durero/number/ball.hpp"

namespace durero::mesh {
namespace {

using number::Dyadic;
using number::RealBall;

/// The vector from one point to another.
template <class Number>
struct SpaceStep {
  SpaceStep(const glm::dvec3& from, const glm::dvec3& to)
      : x(Number(to.x) - Number(from.x)), y(Number(to.y) - Number(from.y)), z(Number(to.z) - Number(from.z)) {}
  Number x, y, z;
};

/// The area of a triangle, seen along each axis: all three are zero where its corners lie on one line.
template <class Number>
struct AreaShadows {
  AreaShadows(const SpaceStep<Number>& u, const SpaceStep<Number>& v)
      : x(u.y * v.z - u.z * v.y), y(u.z * v.x - u.x * v.z), z(u.x * v.y - u.y * v.x) {}
  Number x, y, z;
  bool has_sign() const { return sign(x) != 0 || sign(y) != 0 || sign(z) != 0; }
};

template <class Number>
Number dot(const SpaceStep<Number>& u, const SpaceStep<Number>& v) {
  return u.x * v.x + u.y * v.y + u.z * v.z;
}

template <class Number>
bool has_shadow(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  return AreaShadows<Number>(SpaceStep<Number>(a, b), SpaceStep<Number>(a, c)).has_sign();
}

}  // namespace

bool are_collinear(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  return !has_shadow<RealBall>(a, b, c) && !has_shadow<Dyadic>(a, b, c);
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
