#pragma once
/// A lookup from a disc to the solid that it closes.

#include <algorithm>
#include <span>

#include "durero/conform/families/families.hpp"

namespace durero::conform {

/// The solid that the element closes as a disc; null where it closes none.
inline const Solid* solid_closed_by(std::span<const Solid> solids, scene::ElementRef element) {
  const auto solid = std::ranges::find_if(
      solids, [&](const Solid& of) { return std::ranges::find(of.discs, element) != of.discs.end(); });
  return solid == solids.end() ? nullptr : &*solid;
}

}  // namespace durero::conform
