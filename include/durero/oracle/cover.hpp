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
#include <glm/vec3.hpp>
#include <vector>

#include "durero/scene/shapes.hpp"

namespace durero::oracle {

struct Cover {
  std::vector<double> x, y, z;  ///< the samples
  double delta;                 ///< covering radius δ, a length
  double gradient;              ///< an upper bound of |∇potencia| within δ of the surface
  glm::dvec3 center;            ///< centre and radius of a ball that holds the surface
  double radius;

  std::size_t size() const noexcept { return x.size(); }
};

/// Covers a surface with covering radius at most `fineness` times its radius (a cone's: the smaller of base radius and
/// slant height), before rounding. Precondition: 0 < fineness ≤ 1. Throws std::length_error where that would take
/// more than 2²⁴ samples.
Cover cover(const scene::Sphere& sphere, double fineness);
Cover cover(const scene::Cylinder& cylinder, double fineness);
Cover cover(const scene::Cone& cone, double fineness);

}  // namespace durero::oracle
