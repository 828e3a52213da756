#pragma once
/// A surface as a finite set of points with a proved covering radius δ: every point of the surface has a sample
/// within δ. The oracle of the design card looks at nothing else of an element.
///
/// Each cover is made of rings. A point of the surface reaches the circle of the nearest ring by a path in the surface
/// of length at most δ/2, and from there the nearest sample of that ring by an arc of at most δ/2; a chord is no
/// longer than its path, so the sample is within δ. The path to the ring is an arc of a meridian on a sphere and a
/// piece of a generator on a cylinder or cone.
///
/// Samples are binary64, and the stored axis may miss unit length by 2⁻⁵⁰: both move a sample by less than
/// 2⁻⁴⁵·(|centro| + size), where size is the largest length of the element; δ includes it.

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "durero/scene/shapes.hpp"

namespace durero::oracle {

/// A ball that holds the samples [first, last). Balls stand in preorder: the left half of one is the next ball, its
/// right half is `right`; a ball of a single ring has none (right = 0).
struct Ball {
  glm::dvec3 center;
  double radius;
  std::uint32_t first, last;
  std::uint32_t right;
};

struct Cover {
  std::vector<glm::dvec3> samples;
  double delta = 0;         ///< covering radius δ, a length
  double gradient = 0;      ///< an upper bound of |∇potencia| within δ of the surface
  std::vector<Ball> balls;  ///< a tree over the samples; the first ball holds them all
};

/// Covers a surface with covering radius at most `fineness` times its radius (a cone's: the smaller of base radius and
/// slant height), before rounding. Precondition: 0 < fineness ≤ 1. Throws std::length_error where that would take
/// more than 2²⁴ samples.
Cover cover(const scene::Sphere& sphere, double fineness);
Cover cover(const scene::Cylinder& cylinder, double fineness);
Cover cover(const scene::Cone& cone, double fineness);

}  // namespace durero::oracle
