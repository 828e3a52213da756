#include "durero/scene/proximity.hpp"

#include "support/catch.hpp"

using namespace durero::scene;

TEST_CASE("What is near nothing has neither distance nor point, and differs from what is near something") {
  const Proximity nothing, something{NearestCount::one, 0, {}, {}};
  CHECK(nothing.count == NearestCount::none);
  CHECK(nothing.elementos.empty());
  CHECK_FALSE(nothing == something);
}
