#include "durero/number/surd.hpp"

#include "support/catch.hpp"
#include "support/doubles.hpp"
#include "support/property.hpp"
using namespace durero::number;
using namespace durero::test;
TEST_CASE("smoke") {
  CHECK(round_to_binary64(Surd(0, 1, 2)) == std::sqrt(2.0));
  CHECK(round_to_binary64(DyadicSurd{.x = 1, .y = 1, .delta = 5, .w = 2}) == 1.618033988749895);
  CHECK(Surd(0, 3, 2) == Surd(0, 1, 18));
  CHECK(Surd(0, 1, 2) < Surd(0, 1, 3));
  CHECK(sign(Surd(1, 1, 2) * Surd(1, -1, 2) + Surd(1)) == 0);
  property("rt", [] {
    double d = *anyFinite();
    RC_ASSERT(round_to_binary64(Dyadic(d)) == d);
    RC_ASSERT(round_to_binary64(exact(d)) == d);
    RC_ASSERT(Dyadic(d).rational() == exact(d));
    RC_ASSERT(round_to_binary64(DyadicSurd{.x = 0, .y = 1, .delta = Dyadic(std::abs(d)), .w = 1}) ==
              std::sqrt(std::abs(d)));
  });
}
