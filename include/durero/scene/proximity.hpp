#pragma once
/// The answer to mas_cercano: how far a point is from a scene, and what is nearest to it, rounded once from its exact
/// values.

#include <cstdint>
#include <glm/vec3.hpp>

#include "durero/scene/element_ref.hpp"

namespace durero::scene {

/// How many points of a scene are nearest.
enum class NearestCount : std::uint8_t { none, one, many };

/// The nearest of a scene to a point. It is a value: it refers to the scene by places alone, until its next edit.
struct Proximity {
  NearestCount count = NearestCount::none;  ///< none where the scene has no element
  double distance = 0;                      ///< a_distancia, rounded once (∞ where it rounds to it); none: 0
  glm::dvec3 point{};      ///< the first of the nearest points by x, y, z, each coordinate rounded once; none: 0
  ElementSet elementos{};  ///< every element that attains the distance
  bool operator==(const Proximity&) const = default;
};

}  // namespace durero::scene
