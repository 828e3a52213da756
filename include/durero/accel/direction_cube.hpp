#pragma once
/// The direction cube (A §1.6) represents directions from a point by the places where they leave a cube about it, whose
/// faces are across the axes: a face, and (u, v) of [−1, 1]² on it. Its squares, quartered any number of times, are the
/// bases of pyramids with their apex in the point. Every direction lies in one of the six faces, and a direction in a
/// square lies in one of its quarters.

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>

#include "durero/accel/seen.hpp"

namespace durero::accel {

/// A place on the cube. The faces are numbered +X −X +Y −Y +Z −Z from 0. On the face across the axis i, u is along the
/// axis after i and v along the one after that; X follows Z.
struct CubePoint {
  std::uint32_t face;  ///< 0 to 5
  double u;            ///< in [−1, 1]
  double v;            ///< in [−1, 1]
  bool operator==(const CubePoint&) const = default;
};

/// The place of a direction, on the face of its greatest component, the first of equal ones; u and v are rounded once.
/// Precondition: the components are finite, and not all 0.
CubePoint place_of(const glm::dvec3& direction);
/// The vector from the middle of the cube, of side 2, to the place.
glm::dvec3 direction_of(const CubePoint& place);

/// A square of a face: u in [u, u + side) and v in [v, v + side), closed where that ends at 1. Side and corner are
/// dyadic, and so exact.
struct Square {
  std::uint32_t face;  ///< 0 to 5
  double u;            ///< the least
  double v;            ///< the least
  double side;         ///< 2 for a whole face
};

/// The whole of a face.
constexpr Square whole(std::uint32_t face) { return {face, -1, -1, 2}; }
/// The quarter of a square that holds a place: 0 to 3, v before u. Precondition: the square holds the place.
std::uint32_t quarter_of(const Square& square, const CubePoint& place);
/// The quarter of that number.
Square quarter(const Square& square, std::uint32_t which);

/// A cone that contains the directions of a square, and all within `more` radians of one of them.
DirectionCone cone_of(const Square& square, double more);

}  // namespace durero::accel
