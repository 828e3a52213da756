#pragma once
/// The lists of a subdivision of space, both ways: the elements of its cells, and the cells of its elements.

#include <algorithm>

#include "durero/accel/cells.hpp"
#include "support/catch.hpp"

namespace durero::test {

/// Every element is in some cell, each cell of an element lists it once, and no cell lists any other.
template <class Subdivision>
void check_both_ways(const Subdivision& of) {
  const accel::Lists cells_of = of.lists().inverse(of.contents().elements.size());
  std::size_t references = 0;
  for (std::uint32_t e = 0; e < cells_of.rows(); ++e) {
    references += cells_of[e].size();
    REQUIRE_FALSE(cells_of[e].empty());
    for (const std::uint32_t cell : cells_of[e]) REQUIRE(std::ranges::count(of.lists()[cell], e) == 1);
  }
  REQUIRE(references == of.lists().references());
}

}  // namespace durero::test
