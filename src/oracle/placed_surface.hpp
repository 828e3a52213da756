#pragma once
/// A parametrised surface where an affine map has put it. The parameters of a point stay; lengths, normals and
/// curvatures change by bounds of the map's stretch.

#include "durero/oracle/cover.hpp"
#include "durero/oracle/parametrisation.hpp"
#include "placement.hpp"

namespace durero::oracle {

/// The copy that a map makes of a surface, as points.
class PlacedSurface {
 public:
  /// `off`: how far the surface itself may be off, in its own lengths.
  explicit PlacedSurface(const Parametrisation& original, const Placement& by = {}, double off = 0);

  /// The surface that is put there.
  const Parametrisation& original() const noexcept { return original_; }
  /// The map.
  const Placement& placement() const noexcept { return by_; }

  /// At least the length of each line of equal v.
  double length() const noexcept { return by_.most() * original_.length(); }
  /// At least the length of each line of equal u that this one is no farther from than `way`, along the lines of equal
  /// v.
  double around_within(double u, double way) const;
  /// The point of these parameters, and what the surface is like around it.
  SurfacePoint at(double u, double v) const;
  /// How far a point may be off.
  double rounding() const noexcept;
  /// Whether a point may be one of what goes on beyond the rim: of a plane, whose patch alone has parameters. `slack`
  /// is for the rounding of the point.
  bool goes_on_at(const glm::dvec3& point, double slack) const;

  /// @{ As of a surface that no map has moved (cover.hpp); δ grows with the greatest stretch.
  CoverPlan outline(double fineness) const;
  Cover cover(double fineness) const;
  /// @}

 private:
  double moved_rounding() const noexcept;
  void place(BallNode& ball) const;

  Parametrisation original_;
  Placement by_;
  double off_;
};

}  // namespace durero::oracle
