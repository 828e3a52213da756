#pragma once
/// Questions about a ray and its exact answer, decided by exact arithmetic, tell of which families the ray truly is.
/// "Nearly" means within one part in 2²⁰ where nothing else is said; it describes a family and judges no answer.

#include "durero/scene/hit.hpp"
#include "durero/scene/query.hpp"
#include "durero/scene/scene.hpp"

namespace durero::conform {

class SceneTree;

/// A query and its exact answer.
struct AnsweredQuery {
  const scene::Scene& scene;
  const scene::Query& query;
  scene::Hit hit;                   ///< the exact answer
  const SceneTree* tree = nullptr;  ///< of the scene, where it has bodies
};

bool hits(const AnsweredQuery& q);
bool hits_flat(const AnsweredQuery& q);  ///< hits a plane, or part of one
/// Whether the ray has any coincidence with any element: a double root, a linear or a constant quadratic, a coefficient
/// B or C that is 0, a root exactly at a rim or the apex, a right angle with the axis; or a tie, or no minimum.
bool coincides(const AnsweredQuery& q);

// The families of scale (members_scale.cpp) ask about the element that the ray hits.
bool from_far(const AnsweredQuery& q);         ///< from 10³ of its sizes or more
bool far_from_zero(const AnsweredQuery& q);    ///< its centre 10³ of its sizes or more from 0, in some coordinate
bool hits_far(const AnsweredQuery& q);         ///< t|v| ≥ 10⁶
bool hits_tiny(const AnsweredQuery& q);        ///< a size of 10⁻³ or less
bool sizes_differ(const AnsweredQuery& q);     ///< two sizes in the scene with a ratio of 10⁶ or more
bool long_or_short(const AnsweredQuery& q);    ///< |v| > 2⁸ or |v| < 2⁻⁸
bool beyond_binary32(const AnsweredQuery& q);  ///< its size, squared, is ≥ 2¹²⁸ or < 2⁻¹²⁶
bool long_and_thin(const AnsweredQuery& q);    ///< altura is 10³ of its radii or more
bool hits_near(const AnsweredQuery& q);        ///< t|v| is 10⁻³ of the size or less
bool on_grid(const AnsweredQuery& q);          ///< every coordinate of the ray is a multiple of 1/4, up to 8

// These are the families of direction (members_direction.cpp).
bool nearly_axial(const AnsweredQuery& q);      ///< nearly parallel to the axis of some cylinder
bool axial(const AnsweredQuery& q);             ///< v × vector = 0 for some cylinder
bool perpendicular(const AnsweredQuery& q);     ///< v·vector = 0 for an element that it hits
bool nearly_generator(const AnsweredQuery& q);  ///< |A| ≤ v·v/8 for some element with an axis
bool generator(const AnsweredQuery& q);         ///< A = 0 for one
bool hits_tilted(const AnsweredQuery& q);       ///< an element whose axis is none of the coordinates', or that has none
bool aligned(const AnsweredQuery& q);           ///< hits, a coordinate of v is 0, −0 or subnormal in binary32
bool exactly_aligned(const AnsweredQuery& q);   ///< hits, a coordinate of v is 0 or −0
bool nearly_parallel(const AnsweredQuery& q);   ///< v·d is nearly 0 for some flat element
bool parallel(const AnsweredQuery& q);          ///< v·d = 0 for one
bool nearly_in_surface(const AnsweredQuery& q);
bool in_surface(const AnsweredQuery& q);  ///< no minimum, or the first point begins a segment

// These are the families of discs and triangles (members_bounded.cpp).
bool nearly_disc(const AnsweredQuery& q);      ///< meets a disc, or passes nearly through its rim
bool bound_of_disc(const AnsweredQuery& q);    ///< meets one at its rim exactly, or in its plane
bool nearly_cap(const AnsweredQuery& q);       ///< passes nearly through the rim of a disc, or starts inside an element
bool cap(const AnsweredQuery& q);              ///< hits a disc and another element at the disc's rim
bool nearly_edge(const AnsweredQuery& q);      ///< passes nearly through an edge of a triangle
bool shared_edge(const AnsweredQuery& q);      ///< meets two triangles at edges, or in their plane
bool nearly_sliver(const AnsweredQuery& q);    ///< meets a triangle that is thin, or huge beside the distance
bool edge_of_sliver(const AnsweredQuery& q);   ///< meets one at its edge exactly, or in its plane
bool nearly_coplanar(const AnsweredQuery& q);  ///< hits several at one point, or is nearly parallel to one
bool coplanar(const AnsweredQuery& q);         ///< hits several at one point, or lies in their plane

// These are the families of meshes (members_mesh.cpp).
bool at_edges(const AnsweredQuery& q);       ///< meets an edge or a vertex, or several elements at one point
bool starts_beside(const AnsweredQuery& q);  ///< starts in the box of a triangle, or by 1/8 of its edges beside it

// These are the families of bodies (members_body.cpp).
bool starts_in_body(const AnsweredQuery& q);       ///< has points of a body before and behind its origin
bool coincides_with_body(const AnsweredQuery& q);  ///< touches a body, hits several, or v has a coordinate 0

// The family of margins (members_margin.cpp) asks for the distance from a bound: from the limb of a sphere or the rim
// of a disc in radii, from an end along the axis in alturas, from an edge of a triangle by barycentric coordinate;
// where the ray meets nothing before.
bool beside_bound_by(const AnsweredQuery& q, int least, int greatest);  ///< 2^−greatest … 2^−least from one
bool beside_bound(const AnsweredQuery& q);                              ///< by 2⁻⁴¹ … 2⁻⁷

// These are the families of the place of the points (members_place.cpp).
bool mirrored_first(const AnsweredQuery& q);  ///< a root t > 0 on a mirrored nappe, before any hit
bool nearly_apex(const AnsweredQuery& q);     ///< passes nearly through the apex of a cone
bool apex(const AnsweredQuery& q);            ///< hits a cone at its apex
bool nearly_rim(const AnsweredQuery& q);      ///< a root t > 0 nearly at a rim
bool rim(const AnsweredQuery& q);             ///< hits an element at a rim exactly
bool inside(const AnsweredQuery& q);          ///< starts inside an element that it hits
bool starts_on(const AnsweredQuery& q);       ///< names an element of its origin, or starts nearly on one
bool starts_exactly_on(const AnsweredQuery& q);
bool nearly_tangent(const AnsweredQuery& q);  ///< D is nearly 0 for some element
bool tangent(const AnsweredQuery& q);         ///< hits where D = 0 and A ≠ 0
bool nearly_zero_b(const AnsweredQuery& q);   ///< hits where B is nearly 0
bool zero_b(const AnsweredQuery& q);          ///< hits where B = 0
bool nearly_tie(const AnsweredQuery& q);      ///< another element's first point is nearly at the same t
bool tie(const AnsweredQuery& q);             ///< hits two elements at one point

}  // namespace durero::conform
