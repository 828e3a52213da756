#include "durero/scene/shapes.hpp"

#include <set>
#include <string>
#include <variant>
#include <vector>

#include "durero/model/operaciones.hpp"
#include "durero/scene/attributes.hpp"
#include "support/catch.hpp"

using namespace durero;
using namespace durero::scene;
using model::Tipo;

TEST_CASE("every shape is visited once, in the order of the types, and by its type") {
  std::vector<Tipo> types;
  std::set<std::string_view> words;
  for_each_shape([&]<class Shape>(std::type_identity<Shape>) {
    types.push_back(Shape::tipo);
    words.insert(Shape::word);
    CHECK(place_of<Shape> == types.size() - 1);
    CHECK(with_shape(Shape::tipo, []<class Visited>(std::type_identity<Visited>) { return Visited::word; }) ==
          Shape::word);
  });
  CHECK(types == std::vector{Tipo::soy_esfera, Tipo::soy_cilindro, Tipo::soy_cono, Tipo::soy_tronco, Tipo::soy_plano,
                             Tipo::soy_disco, Tipo::soy_triangulo});
  CHECK(words.size() == shape_count);
}

TEST_CASE("an addition adds one shape; a removal and the general addition none") {
  CHECK(std::is_same_v<ShapeAddedBy<model::Agregar_Esfera>, Sphere>);
  CHECK(std::is_same_v<ShapeAddedBy<model::Agregar_Cilindro>, Cylinder>);
  CHECK(std::is_same_v<ShapeAddedBy<model::Agregar_Cono>, Cone>);
  CHECK(std::is_same_v<ShapeAddedBy<model::Agregar_Tronco>, TruncatedCone>);
  CHECK(std::is_same_v<ShapeAddedBy<model::Agregar_Plano>, Plane>);
  CHECK(std::is_same_v<ShapeAddedBy<model::Agregar_Disco>, Disc>);
  CHECK(std::is_same_v<ShapeAddedBy<model::Agregar_Triangulo>, Triangle>);
  CHECK(std::is_void_v<ShapeAddedBy<model::Eliminar_Cono>>);
  CHECK(std::is_void_v<ShapeAddedBy<model::Eliminar_Elemento>>);
  CHECK(std::is_void_v<ShapeAddedBy<model::Agregar_Elemento>>);
}

TEST_CASE("the attributes of all shapes are each shape's, one after the other") {
  std::vector<std::string_view> all, expected;
  for_each_attribute_of_all([&](const auto& attribute) { all.push_back(attribute.word); });
  for_each_shape([&]<class Shape>(std::type_identity<Shape>) {
    for_each_attribute<Shape>([&](const auto& attribute) { expected.push_back(attribute.word); });
  });
  CHECK(all == expected);
  CHECK(all.size() == 2 + 4 + 4 + 5 + 2 + 3 + 1);
}
