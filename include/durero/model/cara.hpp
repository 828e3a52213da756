#pragma once
/// A face of spec/malla.tex. It stands apart from what is said of meshes, so that tables may keep faces as they are.

#include <cstdint>

namespace durero::model {

/// The number of a point or of a face (ℕ), from zero.
using Ordinal = std::uint32_t;

/// A face: the numbers of its three points (Cara).
struct Cara {
  Ordinal i, j, k;  ///< the numbers, in the order in which the points are gone round

  bool operator==(const Cara&) const = default;
};

}  // namespace durero::model
