#include "durero/scene/shape/sphere.hpp"

#include "attributes_of.hpp"
#include "durero/scene/attributes.hpp"
#include "support/catch.hpp"
#include "support/elements.hpp"
#include "support/property.hpp"

using namespace durero;
using namespace durero::test;
using scene::Sphere;

TEST_CASE("a sphere has a centre and a radius") {
  CHECK(Sphere::word == "esfera");
  CHECK(Sphere::tipo == model::Tipo::soy_esfera);
  CHECK(words<Sphere>() == std::vector<std::string_view>{"centro", "radio"});
  const model::Agregar_Esfera in = scene::addition(model::Elemento("e"), Sphere{{1, 2, 3}, 4});
  CHECK(in.centro == model::Punto(1, 2, 3));
  CHECK(in.radio == 4);
}

TEST_CASE("what adds a sphere to a scene is the sphere") {
  property("any", [] { RC_ASSERT(is_what_its_addition_adds(*spheres(moderate()))); });
}
