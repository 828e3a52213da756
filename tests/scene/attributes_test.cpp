#include "durero/scene/attributes.hpp"

#include <cmath>

#include "durero/model/escena.hpp"
#include "durero/scene/shapes.hpp"
#include "support/catch.hpp"

using namespace durero;
using namespace durero::scene;
using model::Escena;

TEST_CASE("a table stores the numbers of an input, every bit of them") {
  CHECK(stored(0.1) == 0.1);
  CHECK(stored(model::Punto(0.1, -0.0, 3)) == glm::dvec3(0.1, 0, 3));
  CHECK(std::signbit(stored(model::Punto(0.1, -0.0, 3)).y));
  CHECK(stored(model::Vector(1, 2, 3)) == glm::dvec3(1, 2, 3));
}

TEST_CASE("a shape has the attributes of its table, by the components of the specification") {
  CHECK(has_attribute<Sphere, &Escena::mi_centro>());
  CHECK(has_attribute<Sphere, &Escena::mi_radio>());
  CHECK_FALSE(has_attribute<Sphere, &Escena::mi_vector>());
  CHECK_FALSE(has_attribute<Sphere, &Escena::mi_altura>());
  CHECK(has_attribute<Cylinder, &Escena::mi_radio>());
  CHECK_FALSE(has_attribute<Cylinder, &Escena::mi_proporcion>());
  CHECK(has_attribute<Cone, &Escena::mi_proporcion>());
  CHECK(has_attribute<Cone, &Escena::mi_vector>());
  CHECK_FALSE(has_attribute<Cone, &Escena::mi_radio>());
  CHECK(has_attribute<Disc, &Escena::mi_radio>());
  CHECK(has_attribute<Triangle, &Escena::mi_vertices>());
  CHECK_FALSE(has_attribute<Triangle, &Escena::mi_centro>());
  CHECK_FALSE(has_attribute<Disc, &Escena::mi_vertices>());
  CHECK(has_attribute<Plane, &Escena::mi_vector>());
  CHECK_FALSE(has_attribute<Plane, &Escena::mi_altura>());
  CHECK(has_attribute<TruncatedCone, &Escena::mi_radio>());
  CHECK(has_attribute<TruncatedCone, &Escena::mi_proporcion>());
  constexpr TruncatedCone shape{{1, 2, 3}, 4, 5, {0, 0, 1}, 6};
  CHECK(attribute_value<&Escena::mi_radio>(shape) == 4);
  CHECK(attribute_value<&Escena::mi_proporcion>(shape) == 5);
  CHECK(attribute_value<&Escena::mi_altura>(shape) == 6);
}

TEST_CASE("what stands for the scene of the specification has its components, for every attribute") {
  for_each_shape([]<class Shape>(std::type_identity<Shape>) {
    const auto alike = []<class... Any, class... TableRow>(const std::tuple<Any...>&, const std::tuple<TableRow...>&) {
      return (std::is_same_v<typename Any::Value, typename TableRow::Value> && ...);
    };
    CHECK(alike(attributes_of<Shape>, attributes_of<Shape, Escena>));
  });
  CHECK(has_attribute<Sphere, &AnyEscena::mi_radio>());
  CHECK_FALSE(has_attribute<Sphere, &AnyEscena::mi_altura>());
  CHECK(has_attribute<Cone, &AnyEscena::mi_proporcion>());
  CHECK_FALSE(has_attribute<Cone, &AnyEscena::mi_radio>());
  CHECK(has_attribute<Cylinder, &AnyEscena::mi_altura>());
  CHECK_FALSE(has_attribute<Triangle, &AnyEscena::mi_centro>());
}

TEST_CASE("the word of an attribute is the letters of the component that holds it") {
  const auto is_named = [](std::string_view word, const auto& component, const auto& expected) {
    using Component = std::remove_cvref_t<decltype(component)>;
    using Expected = std::remove_cvref_t<decltype(expected.second)>;
    if constexpr (std::is_same_v<Component, Expected>)
      return component == expected.second && word == expected.first;
    else
      return false;
  };
  for_each_shape([&]<class Shape>(std::type_identity<Shape>) {
    for_each_attribute<Shape, Escena>([&](const auto& attribute) {
      const auto is = [&](const auto& expected) { return is_named(attribute.word, attribute.component, expected); };
      INFO(attribute.word);
      CHECK((is(std::pair("centro", &Escena::mi_centro)) || is(std::pair("radio", &Escena::mi_radio)) ||
             is(std::pair("proporcion", &Escena::mi_proporcion)) || is(std::pair("vector", &Escena::mi_vector)) ||
             is(std::pair("altura", &Escena::mi_altura)) || is(std::pair("vertices", &Escena::mi_vertices))));
    });
  });
}
