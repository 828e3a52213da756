#pragma once
/// The values of a Mitsuba scene: numbers, points, colours and transformations.

#include <glm/vec3.hpp>
#include <string_view>
#include <vector>

#include "io/placed/placement.hpp"
#include "mitsuba_tree.hpp"

namespace durero::io {

/// The numbers of an attribute, between blanks and commas. Throws InputError.
std::vector<double> mitsuba_numbers(const MitsubaNode& node, std::string_view attribute);
/// The number of a float or an integer.
double mitsuba_number(const MitsubaNode& node);
/// The value of a boolean.
bool mitsuba_boolean(const MitsubaNode& node);
/// Three numbers, in `value` or in x, y and z. `missing` stands for each of these that is not there; a `value` of one
/// number stands for all three.
glm::dvec3 mitsuba_triple(const MitsubaNode& node, double missing = 0);

/// The colour of an rgb, a spectrum or a number.
struct MitsubaColor {
  glm::dvec3 rgb{0};
  bool is_mean = false;  ///< a spectrum, of which a grey of its mean is kept
};
/// A colour as it stands there; nothing of what is a picture, a pattern or in another file.
std::optional<MitsubaColor> mitsuba_color(const MitsubaNode& node);

/// The placement of a transform, its parts one after another.
AffinePlacement mitsuba_placement(const MitsubaNode& transform);

}  // namespace durero::io
