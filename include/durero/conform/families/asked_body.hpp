#pragma once
/// A body is an element that is none of the model's shapes: a box, a rounded box, a capsule, an ellipsoid, a torus, or
/// what an affine map makes of a cube or a ball. A system is asked about it as one element; exact arithmetic knows it
/// as the solid that exact_body() composes. Every body but a torus is convex.

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <string_view>

#include "durero/scene/body.hpp"
#include "durero/scene/scene.hpp"

namespace durero::conform {

/// The kinds of elements beside the types of the model: bodies, and the height field. But for copies, the sides stand
/// at right angles to each other.
enum class BodyKind : std::uint8_t {
  caja,          ///< the box centro + a·x + b·y + c·z with |a|, |b|, |c| ≤ 1
  capsula,       ///< what lies within |x| of the stretch from centro − y to centro + y; |z| is |x|
  elipsoide,     ///< centro + a·x + b·y + c·z with a² + b² + c² ≤ 1
  copia_caja,    ///< the points of a box, with any sides that span space: sheared, mirrored
  copia_esfera,  ///< the points of an ellipsoid, likewise
  caja_redonda,  ///< what lies within a radius of the points of a box
  toro,          ///< what lies within a radius, less than |x|, of the circle centro + cos·x + sin·z; |z| is |x|
  campo          ///< a height field: no body, but a mesh of triangles that is said as a grid (asked_grid.hpp)
};
/// The number of kinds of bodies.
inline constexpr std::size_t body_count = 7;
/// The number of kinds, the height field among them.
inline constexpr std::size_t kind_count = 8;
/// The words of the kinds in questions and files, in their order.
inline constexpr std::array<std::string_view, kind_count> body_words = {
    "caja", "capsula", "elipsoide", "copia_caja", "copia_esfera", "caja_redonda", "toro", "campo"};
/// The word of a kind.
constexpr std::string_view word(BodyKind kind) { return body_words[static_cast<std::size_t>(kind)]; }
/// Whether a body of the kind has a radius beside its sides.
constexpr bool has_radius(BodyKind kind) { return kind == BodyKind::caja_redonda || kind == BodyKind::toro; }

/// A body by the numbers that a question has of it.
struct AskedBody {
  BodyKind kind{};                    ///< what the sides mean
  glm::dvec3 centro{};                ///< the middle
  std::array<glm::dvec3, 3> sides{};  ///< x, y and z: half the body's extent each, of a rounded box without its radius
  double radio = 0;                   ///< the radius of a kind that has one
  bool operator==(const AskedBody&) const = default;
};

/// The length of a vector in binary64, right up to a rounding, whatever its magnitude.
double length_of(const glm::dvec3& v);

/// Whether the numbers are finite, the sides span space, and a radius is positive; that of a torus leaves a hole.
bool is_body(const AskedBody& body);

/// The body as exact arithmetic knows it; of a torus, a box around it, for it is no solid of quadrics (torus.hpp). Of a
/// capsule and a rounded box radii, the middles of ends and directions across are rounded to binary64. Precondition:
/// is_body(body).
scene::Body exact_body(const AskedBody& body);

/// A body of a scene.
struct NamedBody {
  scene::ElementRef element;  ///< its place in the scene
  AskedBody body;             ///< its numbers
};

/// The body that the element is; null of an element that is a shape.
const AskedBody* find_body(std::span<const NamedBody> bodies, scene::ElementRef element);

/// Adds the exact body to the scene by that name. Returns whether the scene takes it; the body may be none.
bool add_body(scene::Scene& scene, const model::Elemento& name, const AskedBody& body);

}  // namespace durero::conform
