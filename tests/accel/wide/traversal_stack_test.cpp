#include "durero/accel/wide/traversal_stack.hpp"

#include "support/catch.hpp"

using namespace durero;

TEST_CASE("of the children that a node adds, the nearest is next; those of another that wait come after") {
  accel::TraversalStack waiting;
  CHECK(waiting.empty());
  waiting.push(3, 0b1000'0010, {0, 5, 0, 0, 0, 0, 0, 2});
  waiting.push(4, 0b0001'0101, {7, 0, 9, 0, 8, 0, 0, 0});
  waiting.push(5, 0, {});
  const auto next = [&](double entry, std::uint32_t node, std::uint32_t place) {
    const accel::StackEntry child = waiting.pop();
    return child.entry == entry && child.node == node && child.place == place;
  };
  CHECK(next(7, 4, 0));
  CHECK(next(8, 4, 4));
  CHECK(next(9, 4, 2));
  CHECK(next(2, 3, 7));
  CHECK(next(5, 3, 1));
  CHECK(waiting.empty());
}
