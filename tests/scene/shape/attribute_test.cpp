#include "durero/scene/shape/attribute.hpp"

#include "durero/scene/addition.hpp"
#include "durero/scene/shapes.hpp"
#include "support/catch.hpp"

using namespace durero;
using namespace durero::scene;

TEST_CASE("a row holds one attribute by all its names: the word, and the same in the table, the input and the scene") {
  constexpr auto radio = std::get<1>(inputs_of<Sphere>);
  CHECK(radio.word == "radio");
  CHECK(radio.field == &Sphere::radio);
  CHECK(radio.input == &model::Agregar_Esfera::radio);
  CHECK(radio.component == &model::Escena::mi_radio);
  STATIC_REQUIRE(std::is_same_v<decltype(radio)::Stored, double>);
  STATIC_REQUIRE(std::is_same_v<decltype(radio)::Value, model::Rmas>);
  constexpr auto vertices = std::get<0>(inputs_of<Triangle>);
  STATIC_REQUIRE(std::is_same_v<decltype(vertices)::Stored, Corners>);
}
