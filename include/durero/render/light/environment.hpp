#pragma once
/// An environment surrounds a scene: it has a colour for each direction, and a direction for each texel of its
/// pictures.

#include <cstddef>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "durero/scene/environment.hpp"
#include "durero/scene/stage.hpp"

namespace durero::render {

/// A place in the pictures of an environment.
struct PictureSpot {
  std::size_t picture;  ///< the face of a box; else 0
  glm::dvec2 at;        ///< in the unit square, (0, 0) lower left
};

/// The spot where a direction, of any length but 0, is seen.
///
///   box              on the face of the greatest component, of equal ones the first of x, y, z; the camera of ±y has
///                    its upper side towards ±z, the others towards +y
///   equirectangular  across the angle from +z over −x, −z and +x, upwards the latitude; the seam is at +z
///   spherical        the point (x, y) of the unit ball, as ½ + ½x and ½ + ½y, whose normal mirrors +z into it; −z is
///                    the whole rim, of which it is the rightmost point
///
/// Precondition: the surroundings have pictures.
PictureSpot spot_of(scene::Surroundings kind, const glm::dvec3& direction);

/// The unit direction that is seen at a spot. Outside the ball of a spherical picture it is that of the rim.
/// Precondition: the surroundings have pictures.
glm::dvec3 direction_of(scene::Surroundings kind, const PictureSpot& spot);

/// The linear colour that comes from a direction, of any length but 0: for a gradient by the sine of its height over
/// the horizon, for pictures by the four texels around it. Throws std::domain_error where the pictures have not been
/// read.
glm::dvec3 environment_at(const scene::Environment& environment, const glm::dvec3& direction);

/// An upper bound on the colour of every direction, by component, up to rounding.
glm::dvec3 most_of(const scene::Environment& environment);

}  // namespace durero::render
