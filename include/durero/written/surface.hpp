#pragma once
/// An algebraic surface is the zero set of polynomials, with inequalities as clips; this finds where a ray meets it
/// first.
///
/// Along a ray p + t·v each polynomial in x, y and z is one in t. Where an equation p = 0 of the surface is not 0 = 0
/// along the ray, the ray meets it at roots of that polynomial alone, and the other conditions are tested at each of
/// them. Where all its equations are 0 = 0, the ray lies in the surface, and the clips decide: between neighbouring
/// roots of theirs none changes its sign, so that their truth at one point of such a stretch is that on all of it. A
/// union of such surfaces is met where one of them is.

#include <array>
#include <glm/vec3.hpp>
#include <optional>
#include <variant>
#include <vector>

#include "durero/algebra/root.hpp"
#include "durero/model/tipos.hpp"
#include "durero/number/ball.hpp"
#include "durero/written/formula.hpp"

namespace durero::written {

/// The case of a ray whose points on a surface have no least t: they come as near to this one as one likes.
struct After {
  std::optional<algebra::Root> t;  ///< nothing: to 0
};
/// The first meeting of a ray with a surface: none, at some t > 0, or without a least t.
using First = std::variant<std::monostate, algebra::Root, After>;

/// The part of a ray that is asked about: the parameters 0 < t < 1, or all t > 0.
enum class RayPart : bool { to_one, whole };

/// A polynomial in x, y and z with dyadic coefficients, arranged for Horner's rule.
class AlongRays {
 public:
  /// The formula times a positive number: it has the same signs.
  explicit AlongRays(const Formula& formula);
  /// The polynomial in t along the ray.
  algebra::Polynomial along(const model::Rayo& rayo) const;
  /// Coefficients of that polynomial, each known to about 50 bits.
  std::vector<number::RealBall> roughly_along(const model::Rayo& rayo) const;
  /// Its value at a point.
  number::Dyadic at(const std::array<number::Dyadic, 3>& w) const;

 private:
  using InZ = algebra::Polynomial;
  std::vector<std::vector<InZ>> coefficients_;  // [i][j][k] of xⁱ·yʲ·zᵏ
  std::vector<std::vector<std::vector<number::RealBall>>> rough_;
};

/// A part of a surface: the set { w : Punto | p₁ = 0 ∧ … ∧ clips }, of which there is at least one equation.
class Piece {
 public:
  /// The piece of a condition. Precondition: an equation is among the conjuncts, or the condition is nowhere true.
  explicit Piece(const Condition& of);

  /// The first meeting of the ray with the piece. A ray that starts on the piece sees the points at which the equations
  /// have the value that they have at its stored origin (puntos_desde); the clips stay as they are.
  First first(const model::Rayo& rayo, bool starts_on) const;
  /// Whether the ray may meet the piece on a part of it: a quick answer. False is certain.
  bool may_meet(const model::Rayo& rayo, bool starts_on, RayPart part) const;
  /// The meetings of the ray with the piece on a part of it, ascending. Nothing where the ray lies in the piece on a
  /// stretch there.
  std::optional<std::vector<algebra::Root>> all(const model::Rayo& rayo, bool starts_on, RayPart part) const;
  /// Whether the equations may be true of a point whose rounding this is. False is certain.
  bool may_hold_near(const glm::dvec3& rounded) const;

  /// The polynomial p of the first equation p = 0.
  const Formula& equation() const { return equation_; }
  /// The derivatives of equation() by x, y and z.
  const std::array<Formula, 3>& gradient() const { return gradient_; }

 private:
  friend class RayOnPiece;

  /// A condition whose comparisons are given by their numbers.
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
  std::vector<AlongRays> equations_, magnitudes_;  // in step; the magnitudes have positive coefficients
  std::vector<Comparison> comparisons_;
  Clip clips_;
  Formula equation_;
  std::array<Formula, 3> gradient_;
};

/// A set of points that is a union of pieces, as a solid with its caps is; most surfaces have one.
class Surface {
 public:
  /// The most pieces of a surface.
  static constexpr std::size_t most_pieces = 64;

  /// The surface of a condition. Precondition: 0 < pieces(of) ≤ most_pieces.
  explicit Surface(const Condition& of);
  /// The number of pieces of a condition; 0 where it is no union of pieces. A piece has an equation among its
  /// conjuncts, or is true of no point. A conjunction without an equation has the pieces of the first ∨ in it each of
  /// whose sides has some.
  static std::size_t pieces(const Condition& of);

  /// The first meeting of the ray with the surface. A ray that starts on the surface starts on every piece whose
  /// equations may be true of the point that its origin is the rounding of; where there is one piece alone, on that.
  First first(const model::Rayo& rayo, bool starts_on) const;
  /// Whether the ray meets the surface at some 0 < t < 1.
  bool hides(const model::Rayo& rayo, bool starts_on) const;
  /// The parameters of all points that the ray meets on a part of it, ascending, each once. Nothing where the ray lies
  /// in a piece that it meets there.
  std::optional<std::vector<algebra::Root>> parameters(const model::Rayo& rayo, bool starts_on, RayPart part) const;

  /// The sum of the degrees of its pieces' first equations: a line that does not lie in the surface meets it no more
  /// often.
  std::size_t degree() const;
  /// About how far a point is from the nearest piece, to the first order; clips do not count. The value of the piece's
  /// first equation there is exact, and what it is divided by known to some digits.
  double distance(const std::array<number::Dyadic, 3>& w) const;
  /// The direction in which the first equation of the piece that is nearest to a point grows most there, to some
  /// digits: a unit vector, or null where it grows in none.
  glm::dvec3 normal(const glm::dvec3& w) const;

 private:
  bool starts_here(const Piece& piece, const model::Rayo& rayo, bool starts_on) const;

  std::vector<Piece> pieces_;
};

}  // namespace durero::written
