#pragma once
/// The engines that `durero trace --engine` and `durero render --engine` know: a name, a first hit and a shadow.

#include <span>
#include <string>
#include <string_view>

#include "durero/model/tipos.hpp"
#include "durero/scene/hit.hpp"
#include "durero/scene/scene.hpp"

namespace durero::cli {

/// Primera_Interseccion: the first hit of a ray whose origin lies on the elements `en`.
using FirstHit = scene::Hit (*)(const scene::Scene& scene, const model::Rayo& rayo,
                                std::span<const scene::ElementRef> en);

/// occluded_segment: the ray meets an element at some 0 < t < 1.
using OccludedSegment = bool (*)(const scene::Scene& scene, const model::Rayo& rayo,
                                 std::span<const scene::ElementRef> en);

struct Engine {
  std::string_view name;
  FirstHit first_hit;
  OccludedSegment occluded_segment;
};

/// In the order of the ladder.
std::span<const Engine> engines();

/// The engine of that name; nothing where there is none.
const Engine* find_engine(std::string_view name);

/// Their names, separated by commas.
std::string engine_names();

/// What is wrong with the name of an engine, for CLI11's check(); empty where nothing is.
std::string is_engine(const std::string& name);

inline constexpr std::string_view default_engine = "analytic";

}  // namespace durero::cli
