#pragma once
/// The precondition of every question about faces.

#include <algorithm>
#include <cstddef>
#include <span>
#include <stdexcept>

#include "durero/mesh/audit.hpp"

namespace durero::mesh {

/// Throws std::out_of_range where a corner of a face is none of so many vertices.
inline void require_vertices(std::size_t count, std::span<const CornerNumbers> faces) {
  for (const CornerNumbers& face : faces)
    if (std::ranges::max(face) >= count) throw std::out_of_range("a face names a vertex that there is not");
}

}  // namespace durero::mesh
