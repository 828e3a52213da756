#include "durero/scene/shape/cone.hpp"

#include "attributes_of.hpp"
#include "durero/scene/attributes.hpp"
#include "support/catch.hpp"
#include "support/elements.hpp"
#include "support/property.hpp"

using namespace durero;
using namespace durero::test;
using scene::Cone;

TEST_CASE("a cone has a centre, a proportion, an axis and a height") {
  CHECK(Cone::word == "cono");
  CHECK(Cone::tipo == model::Tipo::soy_cono);
  CHECK(words<Cone>() == std::vector<std::string_view>{"centro", "proporcion", "vector", "altura"});
  const model::Agregar_Cono in = scene::addition(model::Elemento("e"), Cone{{1, 2, 3}, 4, {0, 0, -1}, 5});
  CHECK(in.centro == model::Punto(1, 2, 3));
  CHECK(in.proporcion == 4);
  CHECK(in.vector == model::Vector(0, 0, -1));
  CHECK(in.altura == 5);
}

TEST_CASE("what adds a cone to a scene is the cone") {
  property("any", [] { RC_ASSERT(is_what_its_addition_adds(*cones(moderate()))); });
}
