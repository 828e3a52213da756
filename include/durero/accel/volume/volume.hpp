#pragma once
/// Any bounding volume: one of the kinds, or several composed by intersection or union; how well it fits, and what it
/// costs.

#include <glm/vec3.hpp>
#include <string_view>
#include <variant>
#include <vector>

#include "durero/accel/volume/outline.hpp"
#include "durero/accel/volume/round.hpp"
#include "durero/accel/volume/slabs.hpp"
#include "durero/accel/work.hpp"
#include "durero/surface/bounds.hpp"

namespace durero::accel {

/// One of the kinds.
using Simple = std::variant<surface::Ball, surface::Box, OrientedBox, Ellipsoid, Slabs>;

/// A ray as volumes are asked about it: what is computed once, whatever their number.
struct Asked {
  /// Of an ordinary ray, for slabs across the first k of the common directions.
  Asked(const trace::Ray& of, std::size_t k) : ray(of), beam(of), projections(of, k) {}

  const trace::Ray& ray;    ///< which must outlive it
  Beam beam;                ///< for boxes
  Projections projections;  ///< for slabs
};

/// What a test tells. Never that a volume is missed in which the ray has a point at some 0 < t ≤ limit.
Verdict verdict(const Simple& volume, const Asked& asked, double limit);

/// Volumes that together bound an element: by their intersection, where each contains it, or by their union, where
/// it has no point outside of all.
struct Volume {
  enum class Rule : std::uint8_t { intersection, union_of };  ///< all must be met, or any
  std::vector<Simple> parts;                                  ///< in the order of their tests; not none
  Rule rule = Rule::intersection;                             ///< of one part either
};

/// The same: an intersection stops at the first part that is not met, a union at the first that is. Each test of a part
/// is counted as one of a volume.
Verdict verdict(const Volume& volume, const Asked& asked, double limit, Work& work);

/// @{ Of a simple volume, rounded: its surface, and the area of its orthogonal projection along a unit vector.
double surface_of(const Simple& volume);
double projected(const Simple& volume, const glm::dvec3& v);
/// @}

/// The void area: of the projection of the volume, along a unit vector, what the hull of the element does not cover.
double void_area(const Simple& volume, const Outline& outline, const glm::dvec3& v);
/// Its mean over all directions, by Cauchy a quarter of the difference of the surfaces.
double mean_fit(const Simple& volume, const Outline& outline);

/// A kind of volume that every element can have.
struct Kind {
  std::string_view name;  ///< as figures have it
  double B;               ///< what a test costs, in nanoseconds on the machine of docs/acceleration.md
  Simple (*around)(scene::ShapeView element, const Outline& outline);  ///< the volume around an element
};
/// How many there are.
inline constexpr std::size_t kind_count = 7;
/// All of them: ball, box, oriented-box, ellipsoid, and three, seven and thirteen slabs.
std::span<const Kind, kind_count> kinds();
/// What a test of an element costs, as B.
inline constexpr double I = 51;

/// The kind of the least T = n·B + m·I, where of n rays a share m/n meets each volume. Shares and kinds in order.
const Kind& cheapest(std::span<const double> shares);
/// For isotropic rays that cross a convex region of that surface.
const Kind& cheapest(scene::ShapeView element, double surface_of_region);
/// For rays along a unit vector, within an area across it.
const Kind& cheapest(scene::ShapeView element, const glm::dvec3& v, double area);

}  // namespace durero::accel
