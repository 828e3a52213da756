#pragma once
/// The local model of the realism seed: what a surface sends of a light.

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "durero/render/light/directions.hpp"
#include "encounter.hpp"

namespace durero::render {

/// The factor of S in the local model: the share of a light from that unit direction that is sent towards the ray, by
/// Lambert's law (k_d) and Phong's highlight (k_s, e). A relief sees no light that the surface has its back to.
inline glm::dvec3 sent(const Encounter& at, const glm::dvec3& l, double cosine) {
  const Look& m = at.look;
  if (!(glm::dot(l, at.normal) > 0)) cosine = 0;
  glm::dvec3 sum = m.color * (m.k_a + m.k_d * std::max(0.0, cosine));
  if (m.k_s > 0 && cosine > 0) {
    // r·v, both taken the other way around: l goes on from the mirror as −r, and d is −v.
    const double towards = glm::dot(mirrored(l, at.facing), at.d);
    if (towards > 0 || m.e == 0) sum += glm::dvec3(m.k_s * std::pow(std::max(0.0, towards), m.e));
  }
  return sum;
}

}  // namespace durero::render
