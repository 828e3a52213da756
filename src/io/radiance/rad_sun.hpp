#pragma once
/// Suns: sources of light so narrow that they shine in one direction.

#include <cmath>
#include <glm/trigonometric.hpp>
#include <numbers>

namespace durero::io {

/// Of what a sun so many degrees wide sends to a surface across it, Lambert's law sends on this share: its solid angle
/// over π.
inline double share_of_sun(double degrees) {
  const double solid_angle = 4 * std::numbers::pi * std::pow(std::sin(glm::radians(degrees) / 4), 2);
  return solid_angle / std::numbers::pi;
}

}  // namespace durero::io
