#include "durero/scene/shape/cylinder.hpp"

#include "attributes_of.hpp"
#include "durero/scene/attributes.hpp"
#include "support/catch.hpp"
#include "support/elements.hpp"
#include "support/property.hpp"

using namespace durero;
using namespace durero::test;
using scene::Cylinder;

TEST_CASE("a cylinder has a centre, a radius, an axis and a height") {
  CHECK(Cylinder::word == "cilindro");
  CHECK(Cylinder::tipo == model::Tipo::soy_cilindro);
  CHECK(words<Cylinder>() == std::vector<std::string_view>{"centro", "radio", "vector", "altura"});
  const model::Agregar_Cilindro in = scene::addition(model::Elemento("e"), Cylinder{{1, 2, 3}, 4, {0, 0, -1}, 5});
  CHECK(in.centro == model::Punto(1, 2, 3));
  CHECK(in.radio == 4);
  CHECK(in.vector == model::Vector(0, 0, -1));
  CHECK(in.altura == 5);
}

TEST_CASE("what adds a cylinder to a scene is the cylinder") {
  property("any", [] { RC_ASSERT(is_what_its_addition_adds(*cylinders(moderate()))); });
}
