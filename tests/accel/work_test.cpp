#include "durero/accel/work.hpp"

#include "support/catch.hpp"

using durero::accel::Work;

TEST_CASE("work of two threads is added number by number") {
  Work sum{1, 2, 3, 4, 5, 6, 7, 8};
  sum += {10, 20, 30, 40, 50, 60, 70, 80};
  CHECK(sum == Work{11, 22, 33, 44, 55, 66, 77, 88});
}
