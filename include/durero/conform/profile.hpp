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

// The words of these in files, in the order of the enumerators.
inline constexpr std::array<std::string_view, 2> format_words = {"binary32", "binary64"};
inline constexpr std::array<std::string_view, 2> caps_words = {"open", "solid"};
inline constexpr std::array<std::string_view, 3> measure_words = {"parameter", "length", "point"};
inline constexpr std::array<std::string_view, 3> directions_words = {"any", "unit", "unchecked"};
inline constexpr std::array<std::string_view, 4> inside_words = {"exit_point", "nothing", "origin", "undefined"};

constexpr std::string_view word(Format format) { return format_words[static_cast<std::size_t>(format)]; }
constexpr std::string_view word(Caps caps) { return caps_words[static_cast<std::size_t>(caps)]; }
constexpr std::string_view word(Measure measure) { return measure_words[static_cast<std::size_t>(measure)]; }
constexpr std::string_view word(Directions directions) {
  return directions_words[static_cast<std::size_t>(directions)];
}
constexpr std::string_view word(Inside inside) { return inside_words[static_cast<std::size_t>(inside)]; }

/// One claim, and where the system's documentation makes it.
struct Source {
  std::string claim;     ///< the profile's key that it supports
  std::string sentence;  ///< of the documentation
  std::string place;     ///< file, page or address
};

struct Profile {
  std::string system;
  Format format = Format::binary64;
  std::vector<model::Tipo> tipos{};
  Caps caps = Caps::open;
  Measure measure = Measure::parameter;
  Directions directions = Directions::any;
  Inside inside = Inside::exit_point;
  double thickness = 0;  ///< a length that is nothing to the system: what is no farther off may be off for it
  double least_t = 0;    ///< hits at less than this are outside the profile
  double greatest_t = std::numeric_limits<double>::infinity();
  double least_size = 0;  ///< of a radius or an altura
  double greatest_size = std::numeric_limits<double>::infinity();
  double greatest_coordinate = std::numeric_limits<double>::infinity();
  bool names_elements = true;  ///< whether its hits say which element they are of
  bool watertight = false;     ///< no ray leaves a closed mesh between triangles that share an edge or a vertex
  std::vector<Source> sources{};
};

}  // namespace durero::conform
