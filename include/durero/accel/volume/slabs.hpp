#pragma once
/// The bounding volumes of Kay and Kajiya: intersections of slabs, each the space between two parallel planes; an
/// oriented box is one of three slabs across directions of its own.
///
/// A ray p + t·v is between the planes of low ≤ n·w ≤ high where low − S ≤ t·(n·v) ≤ high − S, with S = n·p. In
/// binary64, with u = 2⁻⁵³, S errs by less than 4u·Σ|nᵢ·pᵢ|, and n·v likewise; taken twice that and more, `slack` and
/// `doubt` pay also for the rounding of low − S as far as it comes of S. (What comes of low is in the slab, which is
/// made wider by 2⁻⁵⁰ of its numbers.) So n·v lies between |n·v| − doubt and |n·v| + doubt, and the parameters at which
/// a plane may be crossed between two quotients, of five roundings each: the factors 1 ± 2⁻⁵⁰ = 1 ± 8u pay for them.
/// Where the sign of n·v is in doubt the slab is never left, and if the ray starts outside it is not entered before the
/// distance of the nearer plane over |n·v| + doubt; where that is 0, the ray runs parallel to it, and never enters.

#include <array>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "durero/accel/slab.hpp"
#include "durero/accel/volume/outline.hpp"
#include "durero/trace/ray.hpp"

namespace durero::accel {

/// No ordinary ray comes from an ordinary origin to any volume as late as this.
inline constexpr double never = 0x1p1000;

/// What a ray and a direction make of all slabs across it: S and T of t = (S + D)·T, in bounds.
class Projection {
 public:
  Projection() = default;
  /// Preconditions: the ray is ordinary; each component of n is 0 or of magnitude 2⁻¹⁰⁰ … 2¹⁰⁰, and some is not 0.
  Projection(const glm::dvec3& n, const trace::Ray& ray);

  /// Where the ray may be in the slab, at most: within t ≥ 0, and t ≤ `never`.
  Stretch within(const Slab& slab) const {
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

/// How many directions there are at most.
inline constexpr std::size_t most_slabs = 13;
/// Of k slabs the first k of these: the axes, the diagonals of the cube, and the diagonals of its faces.
std::span<const glm::dvec3> slab_directions(std::size_t k);

/// A ray's projections on the first k of the common directions, each computed here once, whatever number of volumes
/// asks.
class Projections {
 public:
  /// Of an ordinary ray.
  Projections(const trace::Ray& ray, std::size_t k);
  /// Of one direction.
  const Projection& operator[](std::size_t i) const { return all_[i]; }

 private:
  std::array<Projection, most_slabs> all_;
};

/// k slabs across the common directions.
struct Slabs {
  std::vector<Slab> along;  ///< one a direction

  /// Moved by a vector, by which the numbers of each slab change by n·δ: the fit is as good as before.
  Slabs moved(const glm::dvec3& delta) const;
};

/// Three slabs across directions of its own.
struct OrientedBox {
  std::array<glm::dvec3, 3> normal;  ///< perpendicular up to rounding, on which nothing depends; of any length
  std::array<Slab, 3> along;         ///< one a direction
};

/// The slab of an outline, with what the test asks of it.
Slab slab_around(const Outline& outline, const glm::dvec3& n);
/// k slabs around it.
Slabs slabs_around(const Outline& outline, std::size_t k);
/// The oriented box around it, along its axis, or along an edge and the normal of a triangle.
OrientedBox oriented_box_around(const Outline& outline);

/// The intersection of what the slabs leave of a ray. Precondition: projections on as many directions.
Stretch stretch(const Slabs& slabs, const Projections& projections);
/// The same; S and T are this box's own, which is what makes it dearer.
Stretch stretch(const OrientedBox& box, const trace::Ray& ray);

}  // namespace durero::accel
