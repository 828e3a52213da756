#include "durero/raster/local_model.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>

namespace durero::raster {
namespace {

/// The share of a light in the unit direction l that is sent towards the eye.
glm::dvec3 sent_back(const scene::Material& m, const glm::dvec3& n, const glm::dvec3& to_eye, const glm::dvec3& l) {
  const double cosine = glm::dot(n, l);
  glm::dvec3 sum = m.color * (m.k_a + m.k_d * std::max(0.0, cosine));
  if (m.k_s > 0 && cosine > 0) {
    const glm::dvec3 r = 2 * cosine * n - l;
    sum += m.k_s * std::pow(std::max(0.0, glm::dot(r, to_eye)), m.e);
  }
  return sum;
}

}  // namespace

LightColors colors_of(const scene::Stage& stage) {
  LightColors colors;
  for (const scene::Light& light : stage.lights) colors.push_back(light.color);
  for (const scene::DirectionalLight& light : stage.directional_lights) colors.push_back(light.color);
  return colors;
}

glm::dvec3 local_color(const scene::Stage& stage, const RasterPoint& at, const LightColors& lights) {
  const scene::Material& m = at.polygon->material;
  const glm::dvec3 to_eye = -glm::normalize(at.direction), flat = at.polygon->normal;
  const glm::dvec3 n = glm::dot(flat, to_eye) < 0 ? -flat : flat;
  glm::dvec3 sum = m.emission + m.ambient;
  std::size_t next = 0;
  for (const scene::Light& light : stage.lights) {
    const glm::dvec3 to_light = light.position - at.point;
    const glm::dvec3& bright = lights[next++];
    if (bright != glm::dvec3(0) && to_light != glm::dvec3(0))
      sum += bright * sent_back(m, n, to_eye, glm::normalize(to_light));
  }
  for (const scene::DirectionalLight& light : stage.directional_lights) {
    const glm::dvec3& bright = lights[next++];
    if (bright != glm::dvec3(0)) sum += bright * sent_back(m, n, to_eye, -glm::normalize(light.direction));
  }
  return sum;
}

}  // namespace durero::raster
