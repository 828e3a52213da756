#pragma once
/// A bundle's box test by groups of eight rays. Eight consecutive rays are closer together than the whole bundle, and
/// their limits fall sooner. The test of an element's box first culls groups of eight, several in lanes, by their
/// bounds and greatest limits, and then tests the rays of the groups that remain.
///
/// A group of eight is tested by the same bounds as a bundle (wide_node.hpp). The theorems on all rays of a bundle
/// (proofs/Bundles.v) hold for the rays of a group too, up to the greatest of their limits.

#include <array>
#include <cstddef>
#include <cstdint>

#include "durero/accel/wide/wide_node.hpp"

namespace durero::accel {

/// The bounds of a bundle's groups of eight, in columns.
struct WidePacketEights {
  static constexpr std::size_t most = WidePacket::size / WidePacket::eight;  ///< groups in a bundle
  using Column = std::array<double, most>;                                   ///< a number of each group
  using Columns = std::array<Column, 3>;                                     ///< by axis

  /// @{ The bounds of that name of WidePacket, for each group.
  alignas(64) Columns p_low{}, p_high{};
  Columns inverse_low{}, inverse_high{};
  /// @}
  Column limit{};  ///< the greatest limit of the group's rays; below 0 where none takes part
};

/// Computes the bounds and limits of the groups. Precondition: the bundle is gathered from its first place on. Places
/// behind its end take no part.
void gather(WidePacketEights& eights, const WidePacket& bundle);

/// Computes the limits of the groups anew that hold a ray of `which`. The greatest limit of the bundle, or 0 where no
/// ray takes part.
double bring_up_to_date(WidePacketEights& eights, const WidePacket& bundle, std::uint64_t which);

/// met_by for one child of a node, by groups of eight. Precondition: the bounds and limits of `eights` are the
/// bundle's.
std::uint64_t met_by(const WideNode& node, std::size_t child, const WidePacket& bundle, const WidePacketEights& eights);

}  // namespace durero::accel
