#pragma once
/// A camera that moves about what it looks at.

#include <glm/vec3.hpp>

#include "durero/scene/scene.hpp"
#include "durero/scene/stage.hpp"

namespace durero::cli {

/// A camera that sees the whole of a scene from a corner: all that has a finite box, or the origin where nothing has.
scene::Camera camera_of_whole(const scene::Scene& scene);

/// Turns the camera about what it looks at, in degrees; what it sees turns the other way. It stays 1 degree from its
/// poles, where it would look along `up`.
scene::Camera turned(scene::Camera camera, double to_the_right, double upwards);

/// Moves the eye to a multiple of its distance from what it looks at. Precondition: times > 0. A camera whose eye would
/// come too near to be another point stays.
scene::Camera at_times_the_distance(scene::Camera camera, double times);

/// Moves eye and look_at alike, by shares of their distance.
scene::Camera moved(scene::Camera camera, double to_the_right, double upwards);

/// Looks at a point, from as far away as before and from the same side.
scene::Camera looking_at(scene::Camera camera, const glm::dvec3& point);

}  // namespace durero::cli
