#pragma once
/// A shape where an affine map has put it: its power and its bounds as polynomials over the points of space.

#include <optional>
#include <vector>

#include "durero/composed/form.hpp"
#include "durero/scene/body.hpp"
#include "durero/surface/bounds.hpp"
#include "durero/surface/exact_element.hpp"

namespace durero::composed {

/// The points w with power 0 at which no bound is negative: copia(mapa, the shape's points), by Cramer's rule once and
/// for all. A positive number times each polynomial of the text, without fractions: no sign and no root changes by it.
class MovedShape {
 public:
  /// Of an instance.
  explicit MovedShape(const scene::Instance& instance);

  /// The power, which is negative inside of a shape that closes or is closed.
  const SpaceForm<Dyadic>& power() const { return power_; }
  /// The bounds: two of a stretch of an axis, one of a disc, three of a triangle.
  const std::vector<SpaceForm<Dyadic>>& bounds() const { return bounds_; }

  /// The points of a ray on the surface; `on`: it starts there, so that the constant term of the power is 0.
  surface::exact::Reach reach(const model::Rayo& rayo, bool on) const;
  /// False only where the ray meets the surface at no t > 0.
  bool may_meet(const model::Rayo& rayo, bool on) const;

  /// A box that holds every point, infinite where no finite one does.
  surface::Box box() const;
  /// The gradient of the power at a point in binary64: it looks outwards; of a cone's apex its axis.
  glm::dvec3 gradient(const glm::dvec3& w) const;

 private:
  scene::Instance of_;
  SpaceForm<Dyadic> power_;
  SpaceForm<RealBall> rough_power_;
  std::vector<SpaceForm<Dyadic>> bounds_;
  std::array<surface::Dual<double>, 3> seen_;  // the coordinates of what is put at the origin, and how they grow
};

}  // namespace durero::composed
