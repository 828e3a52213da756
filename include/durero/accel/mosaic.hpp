#pragma once
/// A mosaic is a scene as compact voxels (A §1.4.2): the cubes of an octree of one depth in which some surface has a
/// point, and for solids also the cubes strictly inside a sphere. A sphere is the only surface of a scene that encloses
/// space: cylinders and cones are open, and a mesh may be.
///
/// Cubes are closed: a cube that a surface touches in a corner belongs to the mosaic. Exact numbers decide for spheres
/// and triangles. For cylinders, cones, truncated cones and discs touches() decides (accel/touch.hpp), which misses no
/// cube and may take one that lies close by.
///
/// A ray's first cube bounds its first point from before. The ray meets a surface only in cubes of the mosaic, but it
/// may pass through earlier cubes, in which the surface lies beside it. Some point of a surface lies in the first cube,
/// within its diagonal.

#include <functional>
#include <string_view>

#include "durero/accel/octree.hpp"
#include "durero/scene/shape_view.hpp"

namespace durero::accel {

/// The cubes of a mosaic.
enum class Filling : std::uint8_t {
  surface,  ///< the cubes in which a surface has a point
  solid     ///< these and the cubes inside a sphere
};

/// A cube of a mosaic: one of the finest, or a larger one in which no surface has a point. Its spans are valid while it
/// is visited.
struct Voxel {
  Cell corner;                             ///< in units of the finest cubes
  std::string_view code;                   ///< its octal code, a digit a level from the root on; empty for the root
  std::span<const std::uint32_t> surface;  ///< the elements with a point in it: numbers in Contents, ascending
  std::span<const std::uint32_t> inside;   ///< the spheres that strictly contain it, likewise; for Filling::solid
};

/// Whether exact numbers decide in which cubes an element of the type has points.
constexpr bool is_exact_in_mosaics(model::Tipo tipo) {
  return tipo == model::Tipo::soy_esfera || tipo == model::Tipo::soy_triangulo;
}

/// Whether the surface of an element has a point in a closed box: exactly, where is_exact_in_mosaics, otherwise by
/// touches(). Preconditions are those of touches().
bool has_point_in(scene::ShapeView element, const surface::Box& box);

/// Whether a closed box lies strictly inside a sphere, exactly; false for other elements.
bool encloses(scene::ShapeView element, const surface::Box& box);

/// The mosaic of a scene. It is computed at each visit, in memory that grows with the depth and not with the number of
/// cubes.
class Mosaic {
 public:
  /// Prepares a scene, which must outlive it unedited. Throws std::invalid_argument where the depth is not in 0 …
  /// deepest.
  Mosaic(const scene::Scene& scene, int depth, Filling filling);

  /// The greatest depth, at which the numbers of cubes are less than 2⁵³.
  static constexpr int deepest = 17;

  /// The numbered elements. Elements that are `apart`, such as planes, are not in the mosaic.
  const Contents& contents() const noexcept { return contents_; }
  /// All possible cubes: 2^depth along each axis of the root.
  const Lattice& finest() const noexcept { return finest_; }
  /// The closed cube of a voxel.
  surface::Box box(const Voxel& voxel) const { return box(voxel.corner, side(voxel)); }
  /// The side of a voxel, in sides of the finest cubes.
  int side(const Voxel& voxel) const { return finest_.count.x >> voxel.code.size(); }

  /// Calls visit(voxel) for every voxel, in the order of their codes. Voxels share at most faces.
  void for_each(const std::function<void(const Voxel&)>& visit) const;

 private:
  struct Cutter;
  surface::Box box(const Cell& corner, int side) const;

  Contents contents_;
  Lattice finest_;
  Filling filling_;
};

}  // namespace durero::accel
