#pragma once
/// What a system claims for itself: a case inside its profile is judged, one outside is skipped with the clause.

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "durero/model/tipos.hpp"

namespace durero::conform {

/// The format that a system computes in, and so the ε of its backward error.
enum class Format { binary32, binary64 };

/// What a system closes a cylinder, a cone or a truncated cone with.
enum class Caps { open, solid };

/// What the number that a system calls distance is.
enum class Measure {
  parameter,  ///< t of p + t·v
  length,     ///< t·|v|
  point       ///< it gives none: the point alone
};

/// What a system says of v. Where it must be a unit vector the adapter makes it one, rounded in the system's format.
enum class Directions {
  any,       ///< need not be a unit vector
  unit,      ///< must be one, and is checked
  unchecked  ///< must be one, and nobody checks: what users trip over, so a warning of its own
};

/// What a system answers to a ray from inside a solid; undefined where it says that it answers nothing in particular.
enum class Inside { exit_point, nothing, origin, undefined };

/// @{ The words of these in files, in the order of the enumerators.
inline constexpr std::array<std::string_view, 2> format_words = {"binary32", "binary64"};
inline constexpr std::array<std::string_view, 2> caps_words = {"open", "solid"};
inline constexpr std::array<std::string_view, 3> measure_words = {"parameter", "length", "point"};
inline constexpr std::array<std::string_view, 3> directions_words = {"any", "unit", "unchecked"};
inline constexpr std::array<std::string_view, 4> inside_words = {"exit_point", "nothing", "origin", "undefined"};
/// @}

/// @{ The word of a value in files.
constexpr std::string_view word(Format format) { return format_words[static_cast<std::size_t>(format)]; }
constexpr std::string_view word(Caps caps) { return caps_words[static_cast<std::size_t>(caps)]; }
constexpr std::string_view word(Measure measure) { return measure_words[static_cast<std::size_t>(measure)]; }
constexpr std::string_view word(Directions directions) {
  return directions_words[static_cast<std::size_t>(directions)];
}
constexpr std::string_view word(Inside inside) { return inside_words[static_cast<std::size_t>(inside)]; }
/// @}

/// One claim, and where the system's documentation makes it.
struct Source {
  std::string claim;     ///< the profile's key that it supports
  std::string sentence;  ///< of the documentation
  std::string place;     ///< file, page or address
};

/// What a system claims for itself. A bound on t, sizes or coordinates that it does not claim leaves nothing
/// outside.
struct Profile {
  std::string system;                       ///< its name: that of its file, or what a profile's file says
  Format format = Format::binary64;         ///< a scene or ray with numbers beyond its range is outside the profile
  std::vector<model::Tipo> tipos{};         ///< those that it has: a scene with another is outside the profile
  Caps caps = Caps::open;                   ///< solid: a scene with an open cylinder, cone or truncated cone is outside
  Measure measure = Measure::parameter;     ///< what Claim::t is
  Directions directions = Directions::any;  ///< what it asks of v
  Inside inside = Inside::exit_point;       ///< undefined: a ray that may start inside a solid is outside the profile
  double thickness = 0;  ///< a length that is nothing to the system: what is no farther off may be off for it
  double least_t = 0;    ///< what is nearer need not be seen, a first hit there is outside: t, or t·|v| by `measure`
  double greatest_t = std::numeric_limits<double>::infinity();           ///< the same, at more
  double least_size = 0;                                                 ///< of a radius or an altura
  double greatest_size = std::numeric_limits<double>::infinity();        ///< of the same
  double greatest_coordinate = std::numeric_limits<double>::infinity();  ///< magnitude, of any point
  bool names_elements = true;     ///< whether its hits say which element they are of
  bool watertight = false;        ///< no ray leaves a closed mesh between triangles that share an edge or a vertex
  std::vector<Source> sources{};  ///< for its claims: they are shown, and decide nothing
};

}  // namespace durero::conform
