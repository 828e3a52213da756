#pragma once
/// A camera that a map puts into a scene.

#include <optional>

#include "durero/scene/stage.hpp"
#include "placement.hpp"

namespace durero::io {

/// The sides of a picture that an angle may be measured across.
enum class AngleAcross { width, height, smaller, larger, diagonal };

/// The vertical angle in degrees of a picture of that size, whose angle across a side is given; nothing where it is
/// none.
std::optional<double> vertical_angle(double degrees, AngleAcross side, scene::Resolution size);

/// The camera of a frame whose origin is the eye, whose +z is the view and whose +y is upwards; the picture is mirrored
/// where `is_mirrored` differs from whether the map turns right into left. Nothing where the frame is askew, or
/// stretched in one direction.
std::optional<scene::Camera> placed_camera(const AffinePlacement& frame, double fov_y, bool is_mirrored);

}  // namespace durero::io
