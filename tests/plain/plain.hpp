#pragma once
/// The same closed forms in binary64 without any certificate: what a tracer usually is. It is the measure of what the
/// certificates of trace::first_hit cost, and right to a few units in the last place on ordinary rays.
///
/// With a = v − s1·vector, b = q0 − s0·vector (s1 = v·vector, s0 = q0·vector, q0 = p − centro) and g = altura − s0, the
/// quadratic A·t² + 2B·t + C of each element and its discriminant D = B² − AC are, for any vector, unit or not,
///   sphere    A = v·v            B = q0·v           C = q0·q0 − r²      D = r²A − |q0 × v|²
///   cylinder  A = a·a            B = b·a            C = b·b − r²        D = r²A − |b × a|²
///   cone      A = a·a − k²s1²    B = b·a + k²g·s1   C = b·b − k²g²      D = k²|g·a + s1·b|² − |b × a|²
/// and those of the truncated cone, with ρ = r + k·g,
///             A = a·a − k²s1²    B = b·a + k·ρ·s1   C = b·b − ρ²        D = |ρ·a + k·s1·b|² − |b × a|²
/// and those of the plane
///             A = 0              B = s1/2           C = s0             D = B²
/// which are those of the disc as well, and with the edges e1 = b − a, e2 = c − a and q0 = p − a those of the triangle
///             A = 0              B = −det/2         C = e2·(q0 × e1)   D = B²     with det = e1·(v × e2)
/// The line crosses a disc where r|s1| ≥ |s1·q0 − s0·v|, and a triangle where none of q0·(v × e2), v·(q0 × e1) and what
/// is left of det has the other sign. A ray in the plane of either is taken for a miss, as tracers do.
/// The discriminant is a difference of squared distances (Lagrange's identity), so it keeps its figures where B² and AC
/// are large and close: far from the element.

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "durero/scene/shapes.hpp"
#include "durero/trace/packet.hpp"
#include "durero/trace/search.hpp"
#include "durero/trace/tables.hpp"

namespace durero::trace::plain {

/// A·t² + 2B·t + C = 0 and its discriminant; the clip 0 ≤ s0 + t·s1 ≤ altura (∞ for a sphere, with s0 = s1 = 0); how
/// far within the edge of a disc or a triangle the line crosses it.
struct Quadratic {
  double A, B, C, D;
  double s0, s1, altura;
  std::optional<double> margin{};
};

/// on: the origin of the ray lies on the element, so C is 0.
Quadratic quadratic(const scene::Sphere& sphere, const model::Rayo& rayo, bool on);
Quadratic quadratic(const scene::Cylinder& cylinder, const model::Rayo& rayo, bool on);
Quadratic quadratic(const scene::Cone& cone, const model::Rayo& rayo, bool on);
Quadratic quadratic(const scene::TruncatedCone& cone, const model::Rayo& rayo, bool on);
Quadratic quadratic(const scene::Plane& plane, const model::Rayo& rayo, bool on);
Quadratic quadratic(const scene::Disc& disc, const model::Rayo& rayo, bool on);
Quadratic quadratic(const scene::Triangle& triangle, const model::Rayo& rayo, bool on);

/// What a ray has of one element: its first point there, none, or points from t → 0⁺ on.
struct First {
  model::Resultado resultado;
  double t;
};
First first(const Quadratic& quadratic);

/// By lane, the parameter of a hit. A lane neither hit nor undecided is a miss.
struct Firsts {
  alignas(64) Packet::Column t{};
  unsigned hit = 0, undecided = 0;  ///< a bit for every lane, the first lane's lowest
};

/// As the functions of trace, in binary64 throughout. Those of tables share the filter, where a certificate costs one
/// addition in some forty operations. Precondition of that: element and ray are ordinary.
scene::Hit first_hit(const scene::Scene& scene, const model::Rayo& rayo, Origin en = {});
scene::Hit first_hit(const Tables& tables, const model::Rayo& rayo, Origin en = {});

/// first_hit of every query, in blocks and lanes as trace::first_hits. Precondition: elements and rays are ordinary.
std::vector<scene::Hit> first_hits(const Tables& tables, std::span<const scene::Query> queries);

/// first(quadratic) in every lane, for rays that do not start on the element; undecided where both roots are 0, or A
/// is for this ray alone.
void first(const Packet& packet, model::Tipo tipo, Firsts& firsts);

}  // namespace durero::trace::plain
