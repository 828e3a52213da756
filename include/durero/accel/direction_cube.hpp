#pragma once
/// The direction cube (A §1.6): a cube about a point, its faces across the axes of space. A direction from the point is
/// where it leaves the cube: a face, and (u, v) of [−1, 1]² on it. Its squares, quartered as often as one likes, are
/// the bases of pyramids with their apex in the point: every direction lies in one of the six whole faces, and if it
/// lies in a square, in one of its quarters.

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>

#include "durero/accel/seen.hpp"

namespace durero::accel {

/// Faces are +X −X +Y −Y +Z −Z, from 0. On the face across the axis i, u is along the axis after i and v along the one
/// after that, Z being followed by X.
struct Place {
  std::uint32_t face;  ///< 0 to 5
  double u;            ///< in [−1, 1]
  double v;            ///< in [−1, 1]
  bool operator==(const Place&) const = default;
};

/// Where a direction leaves the cube: by its greatest component, of equal ones the first; u and v are rounded once.
/// Precondition: its components are finite, and not all 0.
Place place_of(const glm::dvec3& direction);
/// The vector from the middle of the cube, of side 2, to the place.
glm::dvec3 direction_of(const Place& place);

/// The places with u in [u, u + side) and v in [v, v + side); where those end at 1, with the edge. Side and corner are
/// dyadic, and so exact.
struct Square {
  std::uint32_t face;  ///< 0 to 5
  double u;            ///< the least
  double v;            ///< the least
  double side;         ///< 2 of a whole face
};

/// The whole of a face.
constexpr Square whole(std::uint32_t face) { return {face, -1, -1, 2}; }
/// Which of the quarters holds a place that the square holds: 0 to 3, v before u.
std::uint32_t quarter_of(const Square& square, const Place& place);
/// That quarter.
Square quarter(const Square& square, std::uint32_t which);

/// A cone that holds the directions of a square, and all that are up to `more` radians from one of them.
Cone cone_of(const Square& square, double more);

}  // namespace durero::accel
