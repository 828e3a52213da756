#include "durero/trace/picked.hpp"

#include <vector>

#include "support/catch.hpp"

using namespace durero;

TEST_CASE("entries are picked by an order, or as they stand where there is none") {
  std::vector<int> all{10, 11, 12, 13, 14};
  const std::vector<std::uint32_t> order{4, 2, 0, 1, 3};
  const auto by_order = trace::picked(std::span(all), order, 1, 3), standing = trace::picked(std::span(all), {}, 1, 3);
  REQUIRE(by_order.size() == 3);
  REQUIRE(standing.size() == 3);
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(by_order[i] == 10 + static_cast<int>(order[1 + i]));
    CHECK(standing[i] == 11 + static_cast<int>(i));
  }
  by_order[0] = 7;
  CHECK(all == std::vector{10, 11, 7, 13, 14});
}
