#pragma once
/// Objects of a POV-Ray text as pieces of algebraic surfaces, and as what clips other objects.

#include <optional>
#include <vector>

#include "pov_object.hpp"

namespace durero::io {

/// The pieces that the surface of an object consists of, before its transformations; nothing of what is no sphere,
/// cylinder, cone, disc, plane, box or surface of degree four at most.
std::optional<std::vector<PovPiece>> pieces_of(const PovObject& object);

/// @{ The inside of a box and that of a ball, as clips: of the first polynomial of each the others leave a face.
std::vector<PovClip> faces_of_box(const std::array<glm::dvec3, 2>& box);
PovClip inside_of_box(const std::array<glm::dvec3, 2>& box);
PovClip inside_of_ball(const scene::Sphere& ball);
/// @}

/// The inside of all of these objects, as they are moved, as one clip; nothing where it takes another form, as a union
/// does, or more than three quadrics.
std::optional<PovClip> clip_by(const std::vector<PovObject>& objects);

/// The clip by all of these; nothing where that takes more than three quadrics. Precondition: there is one.
std::optional<PovClip> common_clip(const std::vector<PovClip>& clips);

}  // namespace durero::io
