#include "followed.hpp"

#include <algorithm>
#include <glm/common.hpp>

#include "durero/render/light/environment.hpp"
#include "durero/scene/stage.hpp"

namespace durero::render {
namespace {

/// An upper bound on the shares of the colour from beyond that a material sends on.
glm::dvec3 sent_on(const scene::Material& m) { return m.k_ps * m.M_PS + m.k_t * m.M_T; }

/// The sum of the colours of all lights.
glm::dvec3 all_lights(const scene::Stage& stage) {
  glm::dvec3 sum(0);
  for (const scene::Light& light : stage.lights) sum += light.color;
  for (const scene::DirectionalLight& light : stage.directional_lights) sum += light.color;
  return sum;
}

/// Upper bounds on the colour of a ray, by the number of rays that it may have in a row, itself the first. No cosine is
/// above one: where the ray meets a surface, it brings at most the sum of the terms of its material with all lights
/// seen, and the share that this sends on of the bound for a shorter row. Both this bound and the colour are sums of
/// numbers that are not negative, of fewer than 2²⁰ terms, so that the rounding of each is below 2⁻³² of it: 2⁻³⁰ more
/// than the sum is above the computed colour.
std::vector<glm::dvec3> most_brought(const scene::Stage& stage, const PathLimits& limits) {
  const glm::dvec3 lights = all_lights(stage);
  const glm::dvec3 beyond =
      stage.environment ? most_of(*stage.environment) : stage.background.value_or(default_background);
  std::vector<glm::dvec3> most{glm::dvec3(0)};
  while (most.size() <= limits.max_depth) {
    glm::dvec3 next = glm::max(beyond, default_color * lights);
    for (const scene::Material& m : stage.materials)
      next = glm::max(next,
                      m.emission + m.ambient + lights * (m.color * (m.k_a + m.k_d) + m.k_s) + sent_on(m) * most.back());
    most.push_back((1 + 0x1p-30) * next);
  }
  return most;
}

}  // namespace

TracingContext::TracingContext(const scene::Scene& of, const engine::Engine& by, const PathLimits& to,
                               const Caustics* also)
    : scene(of),
      engine(by),
      limits(to),
      caustics(also),
      looks(of.stage()),
      cones(of.stage()),
      most(most_brought(of.stage(), to)) {}

std::uint32_t depth_of(const scene::Stage& stage, Integrator integrator) {
  if (stage.max_depth) return *stage.max_depth;
  if (integrator == Integrator::path) return scene::greatest_depth;
  constexpr std::uint32_t most = 15;
  constexpr double half_a_step = 1.0 / 510;
  double share = 0;  // the greatest share that one meeting sends on
  for (const scene::Material& m : stage.materials) {
    const glm::dvec3 on = sent_on(m);
    share = std::max({share, on.x, on.y, on.z});
  }
  std::uint32_t depth = 1;
  for (double weight = share; weight >= half_a_step && depth < most; weight *= share) ++depth;
  return depth;
}

}  // namespace durero::render
