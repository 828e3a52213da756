#pragma once
/// The rays of a bundle eight by eight: eight that follow each other are narrower than all, and have found what they
/// are to find sooner. So the box of an element that the bundle comes to is tested for the eights at once, in lanes,
/// and then for the rays of those that it does not lie beside, nor beyond what they have found.
///
/// An eight is tested as a bundle is, by the ends between which its numbers lie (wide_node.hpp): what is proved there
/// of all rays of a bundle (proofs/Bundles.v) holds of those of an eight, up to the greatest of their limits.

#include <array>
#include <cstddef>
#include <cstdint>

#include "durero/accel/wide_node.hpp"

namespace durero::accel {

/// The eights of a bundle, in columns.
struct WideEights {
  static constexpr std::size_t most = WideBundle::size / WideBundle::eight;  ///< how many
  using Column = std::array<double, most>;                                   ///< a number of each
  using Columns = std::array<Column, 3>;                                     ///< of each axis

  /// @{ As of WideBundle.
  alignas(64) Columns p_low{}, p_high{};
  Columns inverse_low{}, inverse_high{};
  /// @}
  Column limit{};  ///< the greatest of their limits; below 0 where none of their rays takes part
};

/// Those of a bundle that walks together, from its first place on; what stands behind its end takes no part.
void gather(WideEights& eights, const WideBundle& bundle);

/// Their limits again, once those of the rays that have a bit have fallen. The greatest of all; 0 where none takes
/// part.
double bring_up_to_date(WideEights& eights, const WideBundle& bundle, std::uint64_t which);

/// As met_by of a child, of rays that are gathered by eights.
std::uint64_t met_by(const WideNode& node, std::size_t child, const WideBundle& bundle, const WideEights& eights);

}  // namespace durero::accel
