#include "durero/scene/solids.hpp"

#include "support/catch.hpp"

using namespace durero;
using namespace durero::scene;

TEST_CASE("a box is what lies behind six planes, whichever corners tell it") {
  const auto box = box_between({1, 0, 5}, {0, 2, 3});
  REQUIRE(box);
  CHECK(box->operation == Compound::Operation::intersected);
  REQUIRE(box->parts.size() == 6);
  glm::dvec3 low(0), high(0);
  for (const Body& part : box->parts) {
    const auto& plane = std::get<Plane>(std::get<Instance>(part.form).shape);
    for (int i = 0; i < 3; ++i) {
      if (plane.vector[i] < 0) low[i] = plane.centro[i];
      if (plane.vector[i] > 0) high[i] = plane.centro[i];
    }
  }
  CHECK(low == glm::dvec3(0, 0, 3));
  CHECK(high == glm::dvec3(1, 2, 5));
  CHECK_FALSE(box_between({0, 0, 0}, {1, 0, 1}));
}

TEST_CASE("what bounds a solid, and the copies of it") {
  CHECK(bounds_a_solid(unmoved(Sphere{{0, 0, 0}, 1})));
  CHECK(bounds_a_solid(unmoved(Plane{{0, 0, 0}, {0, 0, 1}})));
  CHECK_FALSE(bounds_a_solid(unmoved(Disc{{0, 0, 0}, 1, {0, 0, 1}})));
  CHECK_FALSE(bounds_a_solid(unmoved(Triangle{})));
  const Body solid{*box_between({0, 0, 0}, {1, 1, 1})};
  CHECK(bounds_a_solid(solid));
  CHECK(word_of(solid) == "interseccion");
  CHECK(word_of(Body{Compound{Compound::Operation::united, {solid}}}) == "union");
  CHECK(word_of(Body{Compound{Compound::Operation::subtracted, {solid}}}) == "diferencia");
  model::Mapa by = model::identity();
  by.centro = {5, 0, 0};
  const Body copy = copied(by, solid);
  CHECK(std::get<Instance>(std::get<Compound>(copy.form).parts[0].form).mapa.centro.x == 5);
}
