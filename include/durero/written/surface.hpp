#pragma once
/// An algebraic surface with inequalities as clips, and where a ray meets it first.
///
/// Along a ray p + t·v each polynomial in x, y and z is one in t. Where an equation p = 0 of the surface is not 0 = 0
/// along the ray, the ray meets it at roots of that polynomial alone, and each of them is asked for the rest. Where all
/// its equations are 0 = 0, the ray lies in the surface, and the clips decide: between neighbouring roots of theirs
/// none changes its sign, so that what they say at one point of such a stretch they say on all of it. A union of such
/// surfaces is met where one of them is.

#include <array>
#include <glm/vec3.hpp>
#include <optional>
#include <variant>
#include <vector>

#include "durero/algebra/root.hpp"
#include "durero/model/tipos.hpp"
#include "durero/written/formula.hpp"

namespace durero::written {

/// The points of a ray on a surface have no least t: they come as near to this one as one likes.
struct After {
  std::optional<algebra::Root> t;  ///< nothing: to 0
};
/// Where a ray meets a surface first: nowhere, at some t > 0, or at no first t.
using First = std::variant<std::monostate, algebra::Root, After>;

/// A polynomial in x, y and z with dyadic coefficients, for Horner's rule.
class AlongRays {
 public:
  /// The formula times a positive number: it has the same signs.
  explicit AlongRays(const Formula& formula);
  /// The polynomial in t that it is on the ray.
  algebra::Polynomial along(const model::Rayo& rayo) const;
  /// Its value at a point.
  number::Dyadic at(const std::array<number::Dyadic, 3>& w) const;

 private:
  using InZ = algebra::Polynomial;
  std::vector<std::vector<InZ>> coefficients_;  // [i][j][k] of xⁱ·yʲ·zᵏ
};

/// A part of a surface: the set { w : Punto | p₁ = 0 ∧ … ∧ clips }, of which there is at least one equation.
class Piece {
 public:
  /// Precondition: an equation is among the conjuncts, or it is nowhere true.
  explicit Piece(const Condition& of);

  /// Where the ray meets it first. A ray that starts on it sees the points at which the equations have the value that
  /// they have at its stored origin (puntos_desde); the clips are those of the piece all the same.
  First first(const model::Rayo& rayo, bool starts_on) const;
  /// Whether its equations may be true of a point whose rounding this is. False is certain.
  bool may_hold_near(const glm::dvec3& rounded) const;

  /// The first equation: of its points p = 0, for this p.
  const Formula& equation() const { return equation_; }
  /// The derivatives of that by x, y and z.
  const std::array<Formula, 3>& gradient() const { return gradient_; }

 private:
  friend class RayOnPiece;

  /// A condition whose comparisons are known by their numbers.
  struct Clip {
    Condition::Kind kind;
    bool truth;
    std::size_t comparison;
    std::vector<Clip> parts;
  };
  Clip clip_of(const Condition& condition);

  struct Comparison {
    AlongRays polynomial;
    Signs signs;
  };
  std::vector<AlongRays> equations_, magnitudes_;  // in step: of the magnitudes all coefficients are positive
  std::vector<Comparison> comparisons_;
  Clip clips_;
  Formula equation_;
  std::array<Formula, 3> gradient_;
};

/// A set of points that is a union of pieces, as a solid with its caps is; of most there is one.
class Surface {
 public:
  /// No condition is followed that comes to more of them.
  static constexpr std::size_t most_pieces = 64;

  /// Precondition: 0 < pieces(of) ≤ most_pieces.
  explicit Surface(const Condition& of);
  /// How many pieces it comes to; 0 where it comes to none. A piece is what has an equation among its conjuncts, or is
  /// true of no point; a conjunction without comes to those of the first ∨ in it each of whose sides comes to some.
  static std::size_t pieces(const Condition& of);

  /// Where the ray meets it first. A ray that starts on the surface starts on every piece whose equations may be true
  /// of the point that its origin is the rounding of; of one piece alone, on that.
  First first(const model::Rayo& rayo, bool starts_on) const;
  /// Whether the ray meets it at some 0 < t < 1.
  bool hides(const model::Rayo& rayo, bool starts_on) const;

  /// The direction in which the first equation of the piece that is nearest to a point grows most there, to some
  /// digits: a unit vector, or null where it grows in none.
  glm::dvec3 normal(const glm::dvec3& w) const;

 private:
  std::vector<Piece> pieces_;
};

}  // namespace durero::written
