#pragma once
/// The colour that a ray brings follows the algorithm of Whitted: the local model of the realism seed at each point,
/// with rays of their own for mirrors and transparency.

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "durero/engine/engine.hpp"
#include "durero/render/light/integrator.hpp"
#include "durero/scene/query.hpp"
#include "durero/scene/scene.hpp"
#include "durero/scene/stage.hpp"

namespace durero::render {

/// @{ The values of a stage that leaves them open.
inline constexpr glm::dvec3 default_background{0, 0, 0};
inline constexpr glm::dvec3 default_color{0.8, 0.8, 0.8};
/// @}

/// The limits on the rays that are followed.
struct PathLimits {
  std::uint32_t max_depth;  ///< rays in a row, the first one being of depth 1; black where it is 0
  double min_weight = 0;    ///< a ray is not sent where it would count for less than this share of red, green and blue
  Integrator integrator = Integrator::whitted;         ///< the way of following light; paths know no min_weight
  LightSampling light_sampling = LightSampling::both;  ///< of paths
  ShadowRule shadows = ShadowRule::opaque;             ///< what clear elements do to lights behind them
};

/// The colour that a ray brings, and its counts.
struct PathRadiance {
  glm::dvec3 color{0};      ///< linear RGB
  std::uint32_t depth = 0;  ///< the depth of the deepest ray that was followed
  std::uint64_t rays = 0;   ///< the rays that were followed, itself among them
  glm::dvec3 left_out{0};   ///< an upper bound on the colour lost for min_weight
};

/// The colour that each ray brings, in order. Where a ray meets nothing, or no nearest point exists, it is that of the
/// environment in its direction, or the background. Otherwise, with the material of the element hit, n its unit normal
/// on the side of the ray and v the unit vector against the ray, it is
///
///   M_E + A_G + Σ over the lights of S·(k_a·C + k_d·C·max(0, n·l) + k_s·max(0, r·v)^e, where n·l > 0)
///       + k_ps·M_PS·(colour from the mirrored direction) + k_t·M_T·(colour from the refracted direction)
///
/// l is the unit vector to a light, r is l mirrored, S the light's colour where no element stands between, else 0:
/// glass too casts a full shadow, but by ShadowRule::coloured, where S is what all that stands between lets through. In
/// total reflection the share k_t goes the mirrored way.
///
/// The medium that a ray is in follows from the surfaces that it crossed: against the outward normal it enters the
/// element's material, along it it leaves the last such that it entered. A ray that leaves a medium it never entered,
/// such as a ray that starts inside, was in that material. The medium that an open surface bounds is therefore all that
/// lies behind it.
///
/// A material's textures multiply its coefficients, and its relief turns n: towards the lights, in r, and for the rays
/// sent on; but no light is seen through the surface, nor a ray sent through it the wrong way.
///
/// Rays start on the elements hit, so a surface neither shadows nor mirrors itself by rounding. A ray that goes
/// straight on through a flat element is the same ray, which has that element behind it: a sheet that takes nothing and
/// bends nothing changes no bit of what is seen through it, where the depth allows for one ray more. Of several
/// elements at one point the first by name gives colour and normal. Throws std::domain_error where a picture of the
/// stage has not been read. Precondition: the engine honours origins.
std::vector<PathRadiance> brought(const scene::Scene& scene, const engine::Engine& engine,
                                  std::span<const scene::Query> rays, const PathLimits& limits);

}  // namespace durero::render
