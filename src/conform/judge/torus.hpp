#pragma once
/// A torus is what lies within a radius of a circle, its ring, and its surface is where a polynomial of the fourth
/// degree is 0.
///
/// Let q go from the middle of the ring to a point, n across its plane, R be its radius, and h = √(|q|² − (q·n)²/n²)
/// the distance from the line through the middle along n. The nearest point of the ring and the farthest lie in the
/// plane of q and n, and their squared distances are S ∓ 2R·h, with S = |q|² + R². So
///   f = (S − ρ²)² − 4R²·h² = (near² − ρ²)·(far² − ρ²).
/// The farthest point is R away at least. Where ρ ≤ R the second factor is hence not negative, and it is 0 only on the
/// line through the middle where ρ = R, where near = far. So f is negative where near < ρ, 0 where near = ρ, and
/// positive where near > ρ. n²·f has no root in it.

#include "conform/judge/shell.hpp"
#include "durero/algebra/root.hpp"
#include "durero/conform/families/asked_body.hpp"
#include "durero/surface/exact_element.hpp"

namespace durero::conform {

/// The numbers of a torus. Its ring is centro + cos·x + sin·z, as round as x is long.
class Torus {
 public:
  explicit Torus(const AskedBody& body);

  const Dyadic& radio() const { return radio_; }
  /// Whether the tube of that radius ρ has the sign of f: 0 < ρ ≤ R.
  bool is_tube(const Dyadic& rho) const;
  /// n²·f for the radius ρ at a point. Its sign is −1 inside the tube, where ρ is the radius of one.
  Dyadic at(const Point<Dyadic>& w, const Dyadic& rho) const;
  /// n²·f for the radius ρ along a ray.
  algebra::Polynomial along(const model::Rayo& rayo, const Dyadic& rho) const;

 private:
  Point<Dyadic> centro_, n_;
  Dyadic nn_, squared_, radio_;  // n², R² and the radius
};

/// A root of a polynomial along a ray, t > 0, between two numbers that are apart by less than 2⁻⁴⁰⁰ of it, or that are
/// the root itself.
struct TubeRoot {
  algebra::Root root;
  surface::exact::Parameter low, high;
  bool is_touched;  ///< the derivative is 0 there, too
};
/// The roots t > 0, ascending, each once. Precondition: the polynomial is not 0.
std::vector<TubeRoot> tube_roots(const algebra::Polynomial& of);

/// The crossing at a root as the truth has it: the root itself, or a number between its bounds. Another element's
/// crossing there would be the root of a quadratic, and so the root itself.
surface::exact::Parameter crossing_at(const TubeRoot& root);
/// The crossing at any root of a polynomial, likewise.
surface::exact::Parameter crossing_at(const algebra::Root& root);

}  // namespace durero::conform
