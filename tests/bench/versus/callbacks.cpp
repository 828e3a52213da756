// Callbacks of one ray: the first root of the quadratic in binary64.
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "versus/embree_scene.hpp"

namespace durero::versus {
namespace {

/// The first root of the quadratic between the ray's ends at which the point is one of the element; infinite for none.
double first_root(const CurvedElement& e, const glm::dvec3& p, const glm::dvec3& v, double from, double to) {
  const glm::dvec3 q = p - e.a;
  double A = glm::dot(v, v), B = glm::dot(q, v), C = glm::dot(q, q), s0 = 0, s1 = 0, height = 0;
  if (e.tipo == model::Tipo::soy_esfera) {
    C -= e.radius * e.radius;
  } else {
    const glm::dvec3 along = e.b - e.a;
    height = glm::length(along);
    const glm::dvec3 d = along / height;
    s0 = glm::dot(q, d), s1 = glm::dot(v, d);
    const double k = (e.top - e.radius) / height, radius = e.radius + k * s0;
    A -= s1 * s1 * (1 + k * k);
    B -= s0 * s1 + k * s1 * radius;
    C -= s0 * s0 + radius * radius;
  }
  const double D = B * B - A * C;
  if (D < 0) return HUGE_VAL;
  const double root = std::sqrt(D), inverse = 1 / A;
  double near = (-B - root) * inverse, far = (-B + root) * inverse;
  if (near > far) std::swap(near, far);
  for (const double t : {near, far}) {
    const double s = s0 + t * s1;
    if (t > from && t < to && s >= 0 && s <= height) return t;
  }
  return HUGE_VAL;
}

double first_root(const RTCRay& ray, const void* callbacks, unsigned id) {
  const void* const elements = static_cast<const Callbacks*>(callbacks)->elements;
  return first_root(static_cast<const CurvedElement*>(elements)[id], {ray.org_x, ray.org_y, ray.org_z},
                    {ray.dir_x, ray.dir_y, ray.dir_z}, ray.tnear, ray.tfar);
}

void intersect(const RTCIntersectFunctionNArguments* call) {
  if (call->valid[0] == 0) return;
  auto* hit = reinterpret_cast<RTCRayHit*>(call->rayhit);
  const double t = first_root(hit->ray, call->geometryUserPtr, call->primID);
  if (!(t < HUGE_VAL)) return;
  hit->ray.tfar = static_cast<float>(t);
  hit->hit.primID = call->primID;
  hit->hit.geomID = call->geomID;
}

void occlude(const RTCOccludedFunctionNArguments* call) {
  if (call->valid[0] == 0) return;
  auto* ray = reinterpret_cast<RTCRay*>(call->ray);
  if (first_root(*ray, call->geometryUserPtr, call->primID) < HUGE_VAL) ray->tfar = -HUGE_VALF;
}

}  // namespace

Callbacks plain_callbacks(const std::vector<CurvedElement>& elements) { return {elements.data(), intersect, occlude}; }

}  // namespace durero::versus
