#include "durero/accel/work.hpp"

#include "support/catch.hpp"

using namespace durero;

TEST_CASE("work is added number by number") {
  accel::Work work{1, 2, 3, 4, 5, 6, 7, 8, 9};
  work += accel::Work{10, 20, 30, 40, 50, 60, 70, 80, 90};
  CHECK(work == accel::Work{11, 22, 33, 44, 55, 66, 77, 88, 99});
}
