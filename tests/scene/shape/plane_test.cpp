#include "durero/scene/shape/plane.hpp"

#include "attributes_of.hpp"
#include "durero/scene/attributes.hpp"
#include "support/catch.hpp"
#include "support/elements.hpp"
#include "support/property.hpp"

using namespace durero;
using namespace durero::test;
using scene::Plane;

TEST_CASE("a plane has a centre and an axis") {
  CHECK(Plane::word == "plano");
  CHECK(Plane::tipo == model::Tipo::soy_plano);
  CHECK(words<Plane>() == std::vector<std::string_view>{"centro", "vector"});
  const model::Agregar_Plano in = scene::addition(model::Elemento("e"), Plane{{1, 2, 3}, {0, 0, -1}});
  CHECK(in.centro == model::Punto(1, 2, 3));
  CHECK(in.vector == model::Vector(0, 0, -1));
}

TEST_CASE("what adds a plane to a scene is the plane") {
  property("any", [] { RC_ASSERT(is_what_its_addition_adds(*planes(moderate()))); });
}
