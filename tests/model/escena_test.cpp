#include "durero/model/escena.hpp"

#include "escenas.hpp"
#include "support/catch.hpp"
#include "support/clauses.hpp"

using namespace durero;
using namespace durero::model;
using namespace durero::test;
using Labels = std::set<std::string>;

namespace {

/// The invariants that a scene breaks when it is spoiled, and that the whole predicates and their share of one element
/// are checked as contracts alike.
template <class Spoil>
Labels invariants_broken(const Elemento& e, Spoil&& spoil) {
  Escena escena = one_of_each();
  REQUIRE(broken(inv(escena)).empty());
  REQUIRE(broken(inv_at(escena, e)).empty());
  spoil(escena);
  const Labels labels = broken(inv(escena));
  CHECK(labels == broken(inv_at(escena, e)));
  CHECK(labels.contains(violated([&] { check(inv(escena), contract::cost::normal); })));
  CHECK(labels.contains(violated([&] { check(inv_at(escena, e), contract::cost::normal); })));
  return labels;
}

}  // namespace

TEST_CASE("Escena.inv.1: the elements are those that have a type") {
  CHECK(invariants_broken(nuevo, [](Escena& s) { s.elementos.insert(nuevo); }) == Labels{"Escena.inv.1"});
}

TEST_CASE("Escena.inv.2: all but triangles have a centre, and no others") {
  CHECK(invariants_broken(disco, [](Escena& s) { s.mi_centro.erase(disco); }) == Labels{"Escena.inv.2"});
  CHECK(invariants_broken(triangulo, [](Escena& s) { s.mi_centro.emplace(triangulo, far); }) == Labels{"Escena.inv.2"});
  CHECK(invariants_broken(esfera, [](Escena& s) { s.mi_centro.erase(esfera); }) == Labels{"Escena.inv.2"});
  CHECK(invariants_broken(nuevo, [](Escena& s) { s.mi_centro.emplace(nuevo, far); }) == Labels{"Escena.inv.2"});
}

TEST_CASE("Escena.inv.3: spheres, cylinders, truncated cones and discs have a radius, and no others") {
  CHECK(invariants_broken(disco, [](Escena& s) { s.mi_radio.erase(disco); }) == Labels{"Escena.inv.3"});
  CHECK(invariants_broken(triangulo, [](Escena& s) { s.mi_radio.emplace(triangulo, 1); }) == Labels{"Escena.inv.3"});
  CHECK(invariants_broken(esfera, [](Escena& s) { s.mi_radio.erase(esfera); }) == Labels{"Escena.inv.3"});
  CHECK(invariants_broken(cilindro, [](Escena& s) { s.mi_radio.erase(cilindro); }) == Labels{"Escena.inv.3"});
  CHECK(invariants_broken(cono, [](Escena& s) { s.mi_radio.emplace(cono, 1); }) == Labels{"Escena.inv.3"});
  CHECK(invariants_broken(tronco, [](Escena& s) { s.mi_radio.erase(tronco); }) == Labels{"Escena.inv.3"});
  CHECK(invariants_broken(plano, [](Escena& s) { s.mi_radio.emplace(plano, 1); }) == Labels{"Escena.inv.3"});
}

TEST_CASE("Escena.inv.4: cylinders, cones, truncated cones, planes and discs have an axis, and no others") {
  CHECK(invariants_broken(disco, [](Escena& s) { s.mi_vector.erase(disco); }) == Labels{"Escena.inv.4"});
  CHECK(invariants_broken(cilindro, [](Escena& s) { s.mi_vector.erase(cilindro); }) == Labels{"Escena.inv.4"});
  CHECK(invariants_broken(esfera, [](Escena& s) { s.mi_vector.emplace(esfera, axis); }) == Labels{"Escena.inv.4"});
  CHECK(invariants_broken(tronco, [](Escena& s) { s.mi_vector.erase(tronco); }) == Labels{"Escena.inv.4"});
  CHECK(invariants_broken(plano, [](Escena& s) { s.mi_vector.erase(plano); }) == Labels{"Escena.inv.4"});
}

TEST_CASE("Escena.inv.5: cylinders, cones and truncated cones have a height, and no others") {
  CHECK(invariants_broken(cono, [](Escena& s) { s.mi_altura.erase(cono); }) == Labels{"Escena.inv.5"});
  CHECK(invariants_broken(esfera, [](Escena& s) { s.mi_altura.emplace(esfera, 1); }) == Labels{"Escena.inv.5"});
  CHECK(invariants_broken(tronco, [](Escena& s) { s.mi_altura.erase(tronco); }) == Labels{"Escena.inv.5"});
  CHECK(invariants_broken(plano, [](Escena& s) { s.mi_altura.emplace(plano, 1); }) == Labels{"Escena.inv.5"});
}

TEST_CASE("Escena.inv.6: cones and truncated cones have a proportion, and no others") {
  CHECK(invariants_broken(cono, [](Escena& s) { s.mi_proporcion.erase(cono); }) == Labels{"Escena.inv.6"});
  CHECK(invariants_broken(nuevo, [](Escena& s) { s.mi_proporcion.emplace(nuevo, 1); }) == Labels{"Escena.inv.6"});
  CHECK(invariants_broken(tronco, [](Escena& s) { s.mi_proporcion.erase(tronco); }) == Labels{"Escena.inv.6"});
  CHECK(invariants_broken(plano, [](Escena& s) { s.mi_proporcion.emplace(plano, 1); }) == Labels{"Escena.inv.6"});
}

TEST_CASE("Escena.inv.7: the types are those of the elements") {
  CHECK(invariants_broken(cono, [](Escena& s) { s.tipos.erase(Tipo::soy_cono); }) == Labels{"Escena.inv.7"});
  Escena empty = Init();
  empty.tipos.insert(Tipo::soy_cono);
  CHECK(broken(inv(empty)) == Labels{"Escena.inv.7"});
}

TEST_CASE("Escena.inv.8: the axes are unit vectors") {
  CHECK(invariants_broken(cono, [](Escena& s) { s.mi_vector.at(cono) = not_unit; }) == Labels{"Escena.inv.8"});
}

TEST_CASE("Escena.inv.9: triangles have vertices, and no others") {
  CHECK(invariants_broken(triangulo, [](Escena& s) { s.mi_vertices.erase(triangulo); }) == Labels{"Escena.inv.9"});
  CHECK(invariants_broken(plano, [](Escena& s) { s.mi_vertices.emplace(plano, corners); }) == Labels{"Escena.inv.9"});
}

TEST_CASE("Init.post.1: the first scene is empty") {
  CHECK(Init() == Escena{});
  CHECK(all_hold(Init_post(Init())));
  CHECK(violated([] { check(Init_post(one_of_each()), contract::cost::normal); }) == "Init.post.1");
}
