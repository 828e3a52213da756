#pragma once
/// The bounding volumes of Kay and Kajiya: intersections of slabs, each the space between two parallel planes. An
/// oriented box is one of three slabs across directions of its own.
///
/// A ray p + t·v is between the planes of low ≤ n·w ≤ high where low − S ≤ t·(n·v) ≤ high − S, with S = n·p. In
/// binary64, with u = 2⁻⁵³, S errs by less than 4u·Σ|nᵢ·pᵢ|, and n·v likewise. `slack` and `doubt` are more than twice
/// that, which pays also for the part of the rounding of low − S that S brings. (The part that low brings is in the
/// slab, which is widened by 2⁻⁵⁰ of its numbers.) So n·v lies between |n·v| − doubt and |n·v| + doubt, and the
/// parameters at which a plane may be crossed between two quotients, of five roundings each, for which the factors 1 ±
/// 2⁻⁵⁰ = 1 ± 8u pay. Where the sign of n·v is in doubt the ray never leaves the slab; if it starts outside, it does
/// not enter before the distance of the nearer plane over |n·v| + doubt; where that is 0, the ray runs parallel to the
/// slab and never enters.

#include <array>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "durero/accel/slab.hpp"
#include "durero/accel/volume/outline.hpp"
#include "durero/trace/ray.hpp"

namespace durero::accel {

/// A bound of the parameters at which an ordinary ray enters a volume of an ordinary element.
inline constexpr double never = 0x1p1000;

/// A ray projected on a direction, for all slabs across it: S and T of t = (S + D)·T, in bounds.
class Projection {
 public:
  Projection() = default;
  /// Projects a ray. Preconditions: the ray is ordinary; each component of n is 0 or of magnitude 2⁻¹⁰⁰ … 2¹⁰⁰, and
  /// some is not 0.
  Projection(const glm::dvec3& n, const trace::Ray& ray);

  /// The parameters at which the ray may be in the slab, within 0 … `never`.
  BoxInterval within(const Slab& slab) const {
    const double ahead = (backwards_ ? S_ - slab.high : slab.low - S_) - slack_;
    const double behind = (backwards_ ? S_ - slab.low : slab.high - S_) + slack_;
    if (T_far_ < never) return {ahead > 0 ? ahead * T_near_ : 0, behind * T_far_};
    const double outside = std::max(ahead, -behind);
    return {outside > 0 ? outside * T_near_ : 0, never};
  }

 private:
  double S_ = 0, slack_ = 0, T_near_ = 0, T_far_ = 0;  // T_far_ is infinite where the sign of n·v is in doubt
  bool backwards_ = false;
};

/// The greatest number of common directions.
inline constexpr std::size_t most_slabs = 13;
/// The first k of the common directions: the axes, the diagonals of the cube, and the diagonals of its faces.
std::span<const glm::dvec3> slab_directions(std::size_t k);

/// A ray's projections on the first k of the common directions, each computed once for all volumes.
class Projections {
 public:
  /// Projects a ray. Preconditions: the ray is ordinary; k ≤ most_slabs.
  Projections(const trace::Ray& ray, std::size_t k);
  /// The projection on a direction.
  const Projection& operator[](std::size_t i) const { return all_[i]; }

 private:
  std::array<Projection, most_slabs> all_;
};

/// A volume of k slabs across the common directions.
struct Slabs {
  std::vector<Slab> along;  ///< a slab for each direction

  /// The slabs moved by a vector, which adds n·δ to the numbers of each; the fit stays the same.
  Slabs moved(const glm::dvec3& delta) const;
};

/// A box of three slabs across directions of its own.
struct OrientedBox {
  std::array<glm::dvec3, 3> normal;  ///< of any length; perpendicular up to rounding, on which nothing depends
  std::array<Slab, 3> along;         ///< a slab for each direction
};

/// The slab around an outline, prepared for the test.
Slab slab_around(const Outline& outline, const glm::dvec3& n);
/// k slabs around an outline.
Slabs slabs_around(const Outline& outline, std::size_t k);
/// The oriented box around an outline: along its axis, or along an edge and the normal of a triangle.
OrientedBox oriented_box_around(const Outline& outline);

/// The intersection of the ray's stretches in all slabs. Precondition: the projections cover the slabs' directions.
BoxInterval stretch(const Slabs& slabs, const Projections& projections);
/// The intersection of the ray's stretches in the box's slabs. It projects the ray on the box's own directions, which
/// makes it dearer.
BoxInterval stretch(const OrientedBox& box, const trace::Ray& ray);

}  // namespace durero::accel
