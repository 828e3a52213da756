#pragma once
/// A surface as a finite set of points with a proved covering radius δ: every point of the surface has a sample
/// within δ. The oracle of the design card looks at nothing else of an element.
///
/// Each cover is made of rings, lines of equal u. A point of the surface reaches the nearest ring by a path in the
/// surface of length at most δ/2, a piece of the profile, and from there the nearest sample of that ring by an arc of
/// at most δ/2; a chord is no longer than its path, so the sample is within δ. δ includes the rounding of the samples.

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "durero/oracle/parametrisation.hpp"

namespace durero::oracle {

/// A ball that holds the samples [first, last). Balls stand in preorder: the left half of one is the next ball, its
/// right half is `right`; a ball of a single ring has none (right = 0).
struct BallNode {
  glm::dvec3 center;          ///< a point of space
  double radius;              ///< greater by its own rounding
  std::uint32_t first, last;  ///< the samples that it holds
  std::uint32_t right;        ///< the place of its right half
};

/// Samples of a surface.
struct Cover {
  std::vector<glm::dvec3> samples;  ///< points of the surface, rounded
  double delta = 0;                 ///< covering radius δ, a length
  std::vector<BallNode> balls;      ///< a tree over the samples; the first ball holds them all
};

/// A cover before it is made.
struct CoverPlan {
  BallNode ball;      ///< the first ball; its `right` is 0
  double delta;       ///< covering radius δ, a length
  std::size_t bytes;  ///< of the samples and the balls
};

/// The first ball, the radius and the size of the cover that cover() makes of the surface with this fineness. It throws
/// what cover() throws.
CoverPlan outline(const Parametrisation& surface, double fineness);

/// Covers a surface with a covering radius of `fineness` times its widest radius, before rounding. Precondition:
/// 0 < fineness ≤ 1. Throws std::length_error where that would take more than 2²⁴ samples.
Cover cover(const Parametrisation& surface, double fineness);

}  // namespace durero::oracle
