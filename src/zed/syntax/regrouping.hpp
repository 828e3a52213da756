#pragma once
/// The places of a text in Spivey's Z where ISO's grammar takes the same tokens for another tree.

#include <cstddef>
#include <set>
#include <utility>
#include <vector>

namespace durero::zed {

/// The places where ISO's Z writes otherwise, by the positions of tokens.
struct IsoGrouping {
  /// `x \inrel{R} y`, which is (x, y) ∈ R there.
  struct NamedMembership {
    std::size_t left;  ///< x begins here
    std::size_t sign;  ///< \inrel; the name stands behind it, and y behind that
    std::size_t end;   ///< y ends before
  };
  std::set<std::pair<std::size_t, std::size_t>> groups{};  ///< operands, from a token to before another
  std::vector<NamedMembership> memberships{};
};

}  // namespace durero::zed
