#include "durero/scene/environment.hpp"

#include "support/catch.hpp"

using namespace durero::scene;

TEST_CASE("a box has a picture for each face, a gradient none, the others one") {
  CHECK(pictures_of(Surroundings::gradient) == 0);
  CHECK(pictures_of(Surroundings::box) == 6);
  CHECK(pictures_of(Surroundings::spherical) == 1);
  CHECK(pictures_of(Surroundings::equirectangular) == 1);
  CHECK(surroundings_words[static_cast<std::size_t>(Surroundings::equirectangular)] == "equirectangular");
}
