#include "durero/model/resultado.hpp"

#include "support/catch.hpp"

using namespace durero::model;

TEST_CASE("each outcome has its name") {
  CHECK(name(Resultado::hit) == "hit");
  CHECK(name(Resultado::miss) == "miss");
  CHECK(name(Resultado::no_minimum) == "no_minimum");
}
