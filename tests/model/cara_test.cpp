#include "durero/model/cara.hpp"

#include "support/catch.hpp"

using durero::model::Cara;

TEST_CASE("a face is the numbers of its three points, in their order, in twelve bytes") {
  CHECK(Cara{0, 1, 2} == Cara{0, 1, 2});
  CHECK_FALSE(Cara{0, 1, 2} == Cara{1, 2, 0});
  CHECK(sizeof(Cara) == 12);
}
