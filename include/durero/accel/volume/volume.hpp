#pragma once
/// A bounding volume of any kind, or several composed by intersection or union, with its fit and its cost.

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

/// A simple volume: one of the kinds.
using Simple = std::variant<surface::Ball, surface::Box, OrientedBox, Ellipsoid, Slabs>;

/// A ray, prepared once for tests against any number of volumes.
struct PrecomputedRay {
  /// Prepares a ray for boxes, and for slabs across the first k of the common directions. Precondition: it is ordinary.
  PrecomputedRay(const trace::Ray& of, std::size_t k) : ray(of), beam(of), projections(of, k) {}

  const trace::Ray& ray;    ///< the ray, which must outlive it
  Beam beam;                ///< for boxes
  Projections projections;  ///< for slabs
};

/// Tests a ray against a volume. The result is never `missed` where the ray has a point of the volume at some 0 < t ≤
/// limit, nor `beyond`.
VolumeTest verdict(const Simple& volume, const PrecomputedRay& asked, double limit);

/// A composed volume, which bounds an element by the intersection of its parts, where each contains the element, or by
/// their union, where they contain it together.
struct Volume {
  enum class Rule : std::uint8_t { intersection, union_of };  ///< all parts must be met, or any
  std::vector<Simple> parts;                                  ///< in the order of their tests; at least one
  Rule rule = Rule::intersection;                             ///< either for one part
};

/// Tests a ray against a composed volume. An intersection stops at the first part that is not met, a union at the first
/// that is. Each part's test is counted as that of a volume.
VolumeTest verdict(const Volume& volume, const PrecomputedRay& asked, double limit, Work& work);

/// @{ The surface of a simple volume, and the area of its orthogonal projection along a unit vector; rounded.
double surface_of(const Simple& volume);
double projected(const Simple& volume, const glm::dvec3& v);
/// @}

/// The void area along a unit vector: the area of the volume's projection that the hull of the element does not cover.
double void_area(const Simple& volume, const Outline& outline, const glm::dvec3& v);
/// The mean void area over all directions: by Cauchy a quarter of the difference of the surfaces.
double mean_fit(const Simple& volume, const Outline& outline);

/// A kind of volume that every element can have.
struct VolumeKind {
  std::string_view name;  ///< as figures print it
  double B;               ///< the cost of a test, in nanoseconds on the machine of docs/acceleration-reference.md
  Simple (*around)(scene::ShapeView element, const Outline& outline);  ///< makes the volume around an element
};
/// The number of kinds.
inline constexpr std::size_t kind_count = 7;
/// The kinds: ball, box, oriented-box, ellipsoid, and three, seven and thirteen slabs.
std::span<const VolumeKind, kind_count> kinds();
/// The cost of a test of an element, in the unit of VolumeKind::B.
inline constexpr double I = 51;

/// The kind of the least T = n·B + m·I, where a share m/n of n rays meets each kind's volume. `shares` are in the order
/// of kinds().
const VolumeKind& cheapest(std::span<const double> shares);
/// The cheapest kind for isotropic rays that cross a convex region of that surface.
const VolumeKind& cheapest(scene::ShapeView element, double surface_of_region);
/// The cheapest kind for rays along a unit vector, through an area across it.
const VolumeKind& cheapest(scene::ShapeView element, const glm::dvec3& v, double area);

}  // namespace durero::accel
