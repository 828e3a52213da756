#pragma once
/// What the numbers of a stage must be, whatever file they come from.

#include <cmath>
#include <glm/vec3.hpp>

namespace durero::io {

/// A full angle of view, in degrees.
inline bool is_view_angle(double angle) { return angle > 0 && angle < 180; }

/// A side of a picture. 65535² pixels are past every picture that fits in memory.
inline bool is_side(double pixels) { return pixels >= 1 && pixels <= 65535 && std::trunc(pixels) == pixels; }

/// Red, green and blue, each from 0.
inline bool is_color(const glm::dvec3& c) { return c.x >= 0 && c.y >= 0 && c.z >= 0; }

/// The share of each colour that a material sends back.
inline bool is_share(const glm::dvec3& c) { return is_color(c) && c.x <= 1 && c.y <= 1 && c.z <= 1; }

}  // namespace durero::io
