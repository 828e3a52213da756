#pragma once
/// The first touch of a ball that moves along a ray: the least t ≥ 0 at which some point of an element is within ρ of
/// p + t·v.
///
/// The points within ρ of an element are a union of closed pieces, each told by signs of polynomials in the place of
/// the ball's middle, and so in t. A piece is entered at t = 0 or at a root of one of them.
///   A sphere: r − ρ ≤ |q| ≤ r + ρ.
///   A plane: |q·d| ≤ ρ·|d|.
///   A triangle: a prism over its face, a cylinder around each edge, and a ball at each vertex.
///   A disc: a cylinder over its face, and the tube around its rim.
///   A cylinder: what lies between two cylinders and the planes of the rims, and the tubes around the rims.
///   A cone: what lies within ρ of the line from rim to rim, or to the apex, in the plane of the axis and the point;
///   the tubes around its rims, and a ball at the apex.
/// The way across an axis is measured from the line along it, so that d counts for its direction alone; the planes of
/// the rims are s = 0 and s = altura, as in the text.

#include <compare>
#include <optional>

#include "conform/judge/shell.hpp"
#include "durero/algebra/root.hpp"
#include "durero/scene/scene.hpp"
#include "durero/surface/exact_element.hpp"

namespace durero::conform {

/// A parameter t ≥ 0 at which a ball touches.
struct BallTouch {
  std::optional<algebra::Root> root{};  ///< t; nothing where it is 0: the ball touches before it moves

  /// Bounds of t, apart by 2⁻²⁰⁰ of it at most, or t itself.
  surface::exact::Parameter low() const, high() const;
  /// Order of the parameters, exactly.
  friend std::strong_ordering operator<=>(const BallTouch& a, const BallTouch& b);
  /// Whether the parameters are equal.
  friend bool operator==(const BallTouch& a, const BallTouch& b) { return (a <=> b) == 0; }
};

/// The first touch of a ball of the radius ρ with the element; nothing where it never touches, or where ρ ≤ 0.
/// Precondition, here and below: the element is in the scene, and no body.
std::optional<BallTouch> first_touch(const AskedElements& elements, scene::ElementRef element, const model::Rayo& rayo,
                                     const Dyadic& rho);

/// Whether some point of the element is within ρ of w; of no point where ρ < 0.
bool is_touched(const AskedElements& elements, scene::ElementRef element, const Point<Dyadic>& w, const Dyadic& rho);

}  // namespace durero::conform
