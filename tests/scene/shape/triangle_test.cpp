#include "durero/scene/shape/triangle.hpp"

#include "attributes_of.hpp"
#include "durero/scene/attributes.hpp"
#include "support/catch.hpp"
#include "support/elements.hpp"
#include "support/property.hpp"

using namespace durero;
using namespace durero::test;
using scene::Triangle;

TEST_CASE("a triangle has its vertices") {
  CHECK(Triangle::word == "triangulo");
  CHECK(Triangle::tipo == model::Tipo::soy_triangulo);
  CHECK(words<Triangle>() == std::vector<std::string_view>{"vertices"});
  const Triangle shape{{{{1, 2, 3}, {4, 5, 6}, {7, 8, 10}}}};
  const model::Agregar_Triangulo in = scene::addition(model::Elemento("e"), shape);
  CHECK(in.vertices == model::Terna{model::Punto(1, 2, 3), model::Punto(4, 5, 6), model::Punto(7, 8, 10)});
  CHECK(scene::stored(in.vertices) == shape.vertices);
}

TEST_CASE("what adds a triangle to a scene is the triangle") {
  property("any", [] { RC_ASSERT(is_what_its_addition_adds(*triangles(moderate()))); });
}
