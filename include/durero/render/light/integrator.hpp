#pragma once
/// An integrator follows light back from the eye: along the ways of Whitted's algorithm, or along random paths.

#include <array>
#include <cstdint>
#include <string_view>

#include "durero/scene/stage.hpp"

namespace durero::render {

/// The way of following light.
enum class Integrator {
  whitted,  ///< light of the lights at each point, and what mirrors and glass send on
  path      ///< light that comes by way of all things: path tracing
};

/// Their names, in the order of Integrator.
inline constexpr std::array<std::string_view, 2> integrator_names{"whitted", "path"};

/// The ways of drawing light that shining elements send to a point, for paths. The mean is the same.
enum class LightSampling {
  both,       ///< by points of the elements and by directions of the surface, each with its weight (repartida.def.1)
  lights,     ///< by points of the elements alone, of those that have an area
  directions  ///< by directions of the surface alone
};

/// The rule of shadows.
enum class ShadowRule {
  opaque,   ///< whatever stands between a point and a light hides it, glass too (visible.def.1)
  coloured  ///< clear elements let their share of a light through (transmitido.def.1)
};

/// Their names, in the order of ShadowRule.
inline constexpr std::array<std::string_view, 2> shadow_rule_names{"opaque", "coloured"};

/// The number of rays in a row that a picture of this stage needs, where it names none. Whitted's algorithm: one where
/// no material sends rays on; else so many that what comes later weighs less than half a step of a picture's 255, and
/// at most
/// 15. Paths end by Russian roulette, and have scene::greatest_depth.
std::uint32_t depth_of(const scene::Stage& stage, Integrator integrator = Integrator::whitted);

}  // namespace durero::render
