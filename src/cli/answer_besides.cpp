#include "answer_besides.hpp"

#include <array>
#include <glm/geometric.hpp>

#include "durero/number/quotient.hpp"

namespace durero::cli {
namespace {

/// A vector whose exponent has room for products of three numbers of binary64.
using Wide = glm::vec<3, long double>;

/// The outward normal at a point, of any length.
template <class Shape>
Wide outward_at(const Shape& shape, const Wide& w) {
  if constexpr (requires { shape.vertices; }) {
    const auto& [a, b, c] = shape.vertices;
    return glm::cross(Wide(b) - Wide(a), Wide(c) - Wide(a));
  } else if constexpr (requires { shape.altura; }) {
    const Wide d(shape.vector), q = w - Wide(shape.centro), across = q - glm::dot(q, d) * d;
    if constexpr (requires { shape.proporcion; })
      return across + shape.proporcion * glm::length(across) * d;
    else
      return across;
  } else if constexpr (requires { shape.vector; }) {
    return Wide(shape.vector);
  } else {
    return w - Wide(shape.centro);
  }
}

using Exact = std::array<number::Dyadic, 3>;

Exact exact_cross(const Exact& a, const Exact& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
number::Dyadic exact_dot(const Exact& a, const Exact& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Exact way(const glm::dvec3& from, const glm::dvec3& to) {
  using number::Dyadic;
  return {Dyadic(to.x) - Dyadic(from.x), Dyadic(to.y) - Dyadic(from.y), Dyadic(to.z) - Dyadic(from.z)};
}

/// u and v of a point, each rounded once: of a needle a product in binary64 would leave no digit.
glm::dvec2 uv_at(const scene::Triangle& triangle, const glm::dvec3& w) {
  const auto& [a, b, c] = triangle.vertices;
  const Exact ab = way(a, b), ac = way(a, c), q = way(a, w), normal = exact_cross(ab, ac);
  const number::Dyadic squared = exact_dot(normal, normal);
  return {number::round_quotient(exact_dot(exact_cross(q, ac), normal), squared),
          number::round_quotient(exact_dot(exact_cross(ab, q), normal), squared)};
}

}  // namespace

void add_besides(conform::Claim& claim, const scene::Scene& scene, const scene::Query& ray) {
  const Wide w(*claim.punto);
  scene.visit(*claim.element, [&]<class Shape>(const Shape& shape) {
    const Wide outward = outward_at(shape, w);
    const long double length = glm::length(outward);
    if (!(length > 0)) return;  // at an apex
    claim.normal = glm::dvec3(outward / length);
    claim.is_front = glm::dot(Wide(ray.rayo.v().xyz()), outward) < 0;
    if constexpr (requires { shape.vertices; }) claim.uv = uv_at(shape, *claim.punto);
  });
}

}  // namespace durero::cli
