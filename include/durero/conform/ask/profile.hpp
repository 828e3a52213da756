#pragma once
/// A profile is what a system claims for itself: a case inside its profile is judged, and a case outside is skipped
/// with the clause that excludes it.

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "durero/conform/families/asked_body.hpp"
#include "durero/model/tipos.hpp"

namespace durero::conform {

/// The format that a system computes in, which fixes the ε of its backward error.
enum class NumberFormat { binary32, binary64 };

/// The ends of a cylinder, a cone or a truncated cone in a system: open, or closed by discs into a solid.
enum class Caps { open, solid };

/// The meaning of the number that a system calls distance.
enum class Measure {
  parameter,  ///< t of p + t·v
  length,     ///< t·|v|
  point       ///< none: the system gives the point alone
};

/// The demand of a system on v. Where v must be a unit vector the adapter normalises it, rounded in the system's
/// format.
enum class Directions {
  any,       ///< v need not be a unit vector
  unit,      ///< v must be a unit vector, and the system checks it
  unchecked  ///< v must be a unit vector, but nobody checks: a trap for users, which has a warning of its own
};

/// The answer of a system to a ray from inside a solid; undefined where the system promises nothing in particular.
enum class Inside { exit_point, nothing, origin, undefined };

/// The question that a system is asked about a ray.
enum class QuestionKind {
  first,    ///< the first hit
  shadow,   ///< whether anything is hit at t ≤ the end of the ray's range, and no more
  range,    ///< the first hit within the ray's range
  all,      ///< every hit, in the order of t
  count,    ///< the number of all hits
  closest,  ///< the nearest point of the scene to the ray's origin, and how far it is
  cast      ///< the first touch of a ball of the ray's radius, whose middle moves along the ray
};

/// The answer of a system to a ball that touches an element before it moves: t = 0, or nothing in particular.
enum class Touching { undefined, zero };

/// The side to which the normals of a system point. The outward side of a sphere, and of an element with an axis, is
/// away from the centre or the axis; of a disc that closes a solid, away from the solid; of a plane or another disc,
/// that of its vector; of a triangle a, b, c, that of (b − a) × (c − a).
enum class NormalSide {
  none,     ///< it gives no normals
  outward,  ///< to the outward side
  facing,   ///< against the ray
  either    ///< to one side or the other
};

/// Whether hits of triangles, discs and planes from their back are seen.
enum class BackFaces {
  seen,   ///< as those from the front
  unseen  ///< they need not be: the system may leave them out, as renderers do that cull them
};

/// The length of a system's normals.
enum class NormalLength { unit, any };

/// @{ The words of the enumerators above in files, in their order.
inline constexpr std::array<std::string_view, 2> format_words = {"binary32", "binary64"};
inline constexpr std::array<std::string_view, 2> caps_words = {"open", "solid"};
inline constexpr std::array<std::string_view, 3> measure_words = {"parameter", "length", "point"};
inline constexpr std::array<std::string_view, 3> directions_words = {"any", "unit", "unchecked"};
inline constexpr std::array<std::string_view, 4> inside_words = {"exit_point", "nothing", "origin", "undefined"};
inline constexpr std::array<std::string_view, 4> normal_words = {"none", "outward", "facing", "either"};
inline constexpr std::array<std::string_view, 2> back_faces_words = {"seen", "unseen"};
inline constexpr std::array<std::string_view, 2> normal_length_words = {"unit", "any"};
inline constexpr std::array<std::string_view, 2> touching_words = {"undefined", "zero"};
inline constexpr std::array<std::string_view, 7> question_words = {"first", "shadow",  "range", "all",
                                                                   "count", "closest", "cast"};
/// @}

/// @{ The word of a value in files.
constexpr std::string_view word(NumberFormat format) { return format_words[static_cast<std::size_t>(format)]; }
constexpr std::string_view word(Caps caps) { return caps_words[static_cast<std::size_t>(caps)]; }
constexpr std::string_view word(Measure measure) { return measure_words[static_cast<std::size_t>(measure)]; }
constexpr std::string_view word(Directions directions) {
  return directions_words[static_cast<std::size_t>(directions)];
}
constexpr std::string_view word(NormalSide side) { return normal_words[static_cast<std::size_t>(side)]; }
constexpr std::string_view word(BackFaces faces) { return back_faces_words[static_cast<std::size_t>(faces)]; }
constexpr std::string_view word(NormalLength length) { return normal_length_words[static_cast<std::size_t>(length)]; }
constexpr std::string_view word(QuestionKind question) { return question_words[static_cast<std::size_t>(question)]; }
constexpr std::string_view word(Touching touching) { return touching_words[static_cast<std::size_t>(touching)]; }
constexpr std::string_view word(Inside inside) { return inside_words[static_cast<std::size_t>(inside)]; }
/// @}

/// Whether the rays of a question have a range.
constexpr bool has_range(QuestionKind question) {
  return question == QuestionKind::shadow || question == QuestionKind::range;
}
/// Whether rays have numbers behind them: a range, or the radius of a ball.
constexpr bool has_numbers(QuestionKind question) { return has_range(question) || question == QuestionKind::cast; }
/// Whether a question is about all crossings of a ray, and not about the first.
constexpr bool is_about_all(QuestionKind question) {
  return question == QuestionKind::all || question == QuestionKind::count;
}

/// The declared backward error in units of rounding, where nothing else is claimed: the least that may be claimed.
inline constexpr double usual_error = 16;
/// The greatest that may be claimed.
inline constexpr double greatest_error = 1 << 20;

/// A sentence of the system's documentation that supports a claim.
struct Citation {
  std::string claim;     ///< the profile's key that it supports
  std::string sentence;  ///< of the documentation
  std::string place;     ///< file, page or address
};

/// The claims of a system about itself. A bound on t, sizes or coordinates that it does not claim excludes nothing.
struct Profile {
  std::string system;                            ///< the system's name: of its file, or as a profile's file says
  NumberFormat format = NumberFormat::binary64;  ///< a scene or ray with numbers beyond its range is outside
  std::vector<model::Tipo> tipos{};              ///< the types of element that it has: a scene with another is outside
  std::vector<BodyKind> bodies{};                ///< the kinds of bodies that it has, likewise
  std::vector<std::string> surfaces{};           ///< the types of a text that it has, likewise
  Caps caps = Caps::open;                   ///< solid: a scene with an open cylinder, cone or truncated cone is outside
  Measure measure = Measure::parameter;     ///< the meaning of Claim::t
  Directions directions = Directions::any;  ///< the demand on v
  Inside inside = Inside::exit_point;       ///< undefined: a ray that may start inside a solid is outside
  /// The declared backward error (verdict.hpp) in units of rounding: more than usual_error for a system that claims an
  /// epsilon relative to the numbers of the question.
  double error = usual_error;
  double thickness = 0;  ///< the thickness of surfaces: a length by which data may be off besides 16ε·M
  double least_t = 0;    ///< a nearer hit need not be seen, a nearer first hit is outside: in t, or t·|v| by `measure`
  double greatest_t = std::numeric_limits<double>::infinity();  ///< the same for a farther hit
  double least_size = 0;  ///< the least size inside the profile, of a radius or an altura
  double greatest_size = std::numeric_limits<double>::infinity();        ///< the greatest size inside the profile
  double greatest_coordinate = std::numeric_limits<double>::infinity();  ///< magnitude of a coordinate
  bool names_elements = true;                                            ///< whether its hits name their element
  bool half_spaces = false;                 ///< whether a plane is a solid, all that lies behind it
  Touching touching = Touching::undefined;  ///< undefined: a cast that may begin in touch is outside
  BackFaces back_faces = BackFaces::seen;   ///< unseen: hits from the back of a flat element need not be seen
  bool watertight = false;  ///< no ray leaves a closed mesh between triangles that share an edge or a vertex
  NormalSide normal = NormalSide::none;             ///< the side to which the normals of its hits point
  NormalLength normal_length = NormalLength::unit;  ///< the length of these normals
  bool faces =
      false;        ///< whether its hits say from which side the ray comes: from the front, where normals point outward
  bool uv = false;  ///< whether its hits on triangles give u and v of (1 − u − v)·a + u·b + v·c
  std::vector<QuestionKind> questions{QuestionKind::first};  ///< the questions that it answers
  std::vector<Citation> sources{};  ///< the sources of its claims: they are shown, and decide nothing
};

}  // namespace durero::conform
