#pragma once
/// A scene as a mosaic of cubes, the compact voxels of A §1.4.2: those cubes of an octree of one depth in which some
/// surface has a point, and where solids are asked for, those besides that lie strictly inside a sphere. A sphere is
/// the one surface of a scene that encloses anything: cylinders and cones are open, and of a mesh nobody knows whether
/// it is closed.
///
/// Cubes are closed: one that a surface touches in a corner is of the mosaic. Of a sphere and of a triangle that is
/// decided by exact numbers; of a cylinder, a cone, a truncated cone and a disc by touches() (accel/touch.hpp), which
/// passes over no cube and may take one that lies close by.
///
/// A ray that meets a surface does so in a cube of the mosaic, and in none before the first that it goes through; but
/// it may go through cubes before that, in which the surface lies beside it. So the first cube of a ray is not its
/// answer: it is no farther than that, and some point of a surface lies in it, within its diagonal.

#include <functional>
#include <string_view>

#include "durero/accel/octree.hpp"
#include "durero/scene/shape_view.hpp"

namespace durero::accel {

/// What a mosaic is made of.
enum class Filling : std::uint8_t {
  surface,  ///< cubes in which a surface has a point
  solid     ///< those, and what lies inside a sphere
};

/// A cube of a mosaic, of the finest ones or, where no surface has a point in it, a greater one. What it refers to
/// lives while it is visited.
struct Voxel {
  Cell corner;                             ///< in units of the finest cubes
  std::string_view code;                   ///< its octal code from the root on, a digit a level; of the root none
  std::span<const std::uint32_t> surface;  ///< whose surface has a point in it: numbers in Contents, ascending
  std::span<const std::uint32_t> inside;   ///< the spheres that it lies strictly inside, likewise; of Filling::solid
};

/// Whether it is decided exactly in which cubes an element of the type has points.
constexpr bool is_exact_in_mosaics(model::Tipo tipo) {
  return tipo == model::Tipo::soy_esfera || tipo == model::Tipo::soy_triangulo;
}

/// Whether the surface of an element has a point in a closed box: exactly, where is_exact_in_mosaics, and otherwise as
/// touches(). Preconditions: as of touches().
bool has_point_in(scene::ShapeView element, const surface::Box& box);

/// Whether a closed box lies strictly inside a sphere, exactly; of another element, false.
bool encloses(scene::ShapeView element, const surface::Box& box);

/// The mosaic of a scene: made each time that it is visited, in memory that grows with the depth and not with the
/// number of cubes.
class Mosaic {
 public:
  /// Of a scene, which must outlive it unedited. Throws std::invalid_argument where the depth is not in 0 … deepest.
  Mosaic(const scene::Scene& scene, int depth, Filling filling);

  /// At most: numbers of cubes are then less than 2⁵³.
  static constexpr int deepest = 17;

  /// Whose numbers the cubes have; elements that are `apart`, such as planes, are not in the mosaic.
  const Contents& contents() const noexcept { return contents_; }
  /// All cubes that there may be: 2^depth along each axis of the root.
  const Lattice& finest() const noexcept { return finest_; }
  /// The closed cube.
  surface::Box box(const Voxel& voxel) const { return box(voxel.corner, side(voxel)); }
  /// How many of the finest cubes make its side.
  int side(const Voxel& voxel) const { return finest_.count.x >> voxel.code.size(); }

  /// visit(voxel) for every one, in the order of their codes. No two of them overlap but in faces.
  void for_each(const std::function<void(const Voxel&)>& visit) const;

 private:
  struct Cutter;
  surface::Box box(const Cell& corner, int side) const;

  Contents contents_;
  Lattice finest_;
  Filling filling_;
};

}  // namespace durero::accel
