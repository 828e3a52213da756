#pragma once
/// Questions about a ray and its exact answer, decided by exact arithmetic: which families it is truly of.
/// "Nearly" is within one part in 2²⁰ everywhere; it says what a family is about and judges no answer.

#include "durero/conform/families.hpp"

namespace durero::conform {

struct Ray_And_Hit {
  const scene::Scene& scene;
  const scene::Query& ray;
  scene::Hit hit;  ///< of surface::exact
};

bool hits(const Ray_And_Hit& r);
/// Any coincidence of the ray with any element: a double root, a linear or a constant quadratic, a coefficient B or C
/// that is 0, a root exactly at a rim or the apex, a right angle with the axis; or a tie, or no minimum.
bool coincides(const Ray_And_Hit& r);

// Of scale. The element is one that the ray hits.
bool from_far(const Ray_And_Hit& r);         ///< from 10³ of its sizes or more
bool far_from_zero(const Ray_And_Hit& r);    ///< its centre 10³ of its sizes or more from 0, in some coordinate
bool hits_far(const Ray_And_Hit& r);         ///< t|v| ≥ 10⁶
bool hits_tiny(const Ray_And_Hit& r);        ///< a size of 10⁻³ or less
bool sizes_differ(const Ray_And_Hit& r);     ///< two sizes in the scene with a ratio of 10⁶ or more
bool long_or_short(const Ray_And_Hit& r);    ///< |v| > 2⁸ or |v| < 2⁻⁸
bool beyond_binary32(const Ray_And_Hit& r);  ///< its size, squared, is ≥ 2¹²⁸ or < 2⁻¹²⁶
bool beyond_binary64(const Ray_And_Hit& r);  ///< its size, squared, is ≥ 2¹⁰²⁴ or < 2⁻¹⁰²²
bool long_and_thin(const Ray_And_Hit& r);    ///< altura is 10³ of its radii or more

// Of direction.
bool nearly_axial(const Ray_And_Hit& r);      ///< nearly parallel to the axis of some cylinder
bool axial(const Ray_And_Hit& r);             ///< v × vector = 0 for some cylinder
bool perpendicular(const Ray_And_Hit& r);     ///< v·vector = 0 for an element that it hits
bool nearly_generator(const Ray_And_Hit& r);  ///< |A| is nearly 0 for some cylinder or cone
bool generator(const Ray_And_Hit& r);         ///< A = 0 for one
bool aligned(const Ray_And_Hit& r);           ///< hits, a coordinate of v is 0, −0 or subnormal
bool exactly_aligned(const Ray_And_Hit& r);   ///< hits, a coordinate of v is 0 or −0

// Of the place of the points.
bool mirrored_first(const Ray_And_Hit& r);  ///< a root t > 0 on a mirrored nappe, before any hit
bool nearly_apex(const Ray_And_Hit& r);     ///< passes nearly through the apex of a cone
bool apex(const Ray_And_Hit& r);            ///< hits a cone at its apex
bool nearly_rim(const Ray_And_Hit& r);      ///< a root t > 0 nearly at a rim
bool rim(const Ray_And_Hit& r);             ///< hits an element at a rim exactly
bool inside(const Ray_And_Hit& r);          ///< starts inside an element that it hits
bool starts_on(const Ray_And_Hit& r);       ///< names an element of its origin, or starts nearly on one
bool starts_exactly_on(const Ray_And_Hit& r);
bool hits_near(const Ray_And_Hit& r);       ///< t|v| is 10⁻³ of the size or less
bool nearly_tangent(const Ray_And_Hit& r);  ///< D is nearly 0 for some element
bool tangent(const Ray_And_Hit& r);         ///< hits where D = 0 and A ≠ 0
bool nearly_zero_b(const Ray_And_Hit& r);   ///< hits where B is nearly 0
bool zero_b(const Ray_And_Hit& r);          ///< hits where B = 0
bool nearly_tie(const Ray_And_Hit& r);      ///< another element's first point is nearly at the same t
bool tie(const Ray_And_Hit& r);             ///< hits two elements at one point
bool nearly_in_surface(const Ray_And_Hit& r);
bool in_surface(const Ray_And_Hit& r);  ///< no minimum, or the first point begins a segment
bool on_grid(const Ray_And_Hit& r);     ///< every coordinate of the ray is a multiple of 1/4, up to 8

}  // namespace durero::conform
