#include "durero/scene/shape/disc.hpp"

#include "attributes_of.hpp"
#include "durero/scene/attributes.hpp"
#include "support/catch.hpp"
#include "support/elements.hpp"
#include "support/property.hpp"

using namespace durero;
using namespace durero::test;
using scene::Disc;

TEST_CASE("a disc has a centre, a radius and an axis") {
  CHECK(Disc::word == "disco");
  CHECK(Disc::tipo == model::Tipo::soy_disco);
  CHECK(words<Disc>() == std::vector<std::string_view>{"centro", "radio", "vector"});
  const model::Agregar_Disco in = scene::addition(model::Elemento("e"), Disc{{1, 2, 3}, 4, {0, 0, -1}});
  CHECK(in.centro == model::Punto(1, 2, 3));
  CHECK(in.radio == 4);
  CHECK(in.vector == model::Vector(0, 0, -1));
}

TEST_CASE("what adds a disc to a scene is the disc") {
  property("any", [] { RC_ASSERT(is_what_its_addition_adds(*discs(moderate()))); });
}
