#pragma once
/// Solids as expressions of unions and intersections over the sides of faces (spec/solidos.tex).

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace durero::composed {

/// The place of a point beside a solid.
enum class SolidPlace : std::int8_t {
  outside = -1,  ///< not in cuerpo
  surface = 0,   ///< in superficie
  inside = 1     ///< in interior
};

/// A solid, as faces that are joined. Faces have numbers, and no two of them are one surface.
class SideTree {
 public:
  /// The inside of a face; of a face that is turned, the outside.
  static SideTree face(std::size_t number, bool turned);
  /// The intersection of some solids.
  static SideTree all(std::vector<SideTree> parts);
  /// The union of some solids.
  static SideTree any(std::vector<SideTree> parts);

  /// The rest of space.
  SideTree complement() const;

  /// The place of a point by its side of each face, the sign of valor: −1 inside, 1 outside, 0 on the face. A point on
  /// faces is tried on either side of each (repartos.def.1): where the solid has it on all of these, it is inside.
  SolidPlace place(std::span<const std::int8_t> sides) const;

 private:
  enum class Kind : std::uint8_t { face, all, any };

  SideTree(Kind kind, std::size_t number, bool turned, std::vector<SideTree> parts);

  /// 1 in the solid, −1 not in it, 0 where the faces that the point is on may decide.
  int certain(std::span<const std::int8_t> sides) const;
  /// Tries the sides of the faces that remain open, and notes what comes out, until both have come.
  void try_sides(std::span<std::int8_t> sides, std::span<const std::size_t> open, bool& is_in, bool& is_out) const;

  Kind kind_;
  bool turned_;                  // of a face
  std::size_t number_;           // of a face
  std::vector<SideTree> parts_;  // of the others
};

}  // namespace durero::composed
