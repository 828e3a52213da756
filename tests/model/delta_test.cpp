#include "durero/model/delta.hpp"

#include "escenas.hpp"
#include "support/catch.hpp"

using namespace durero;
using namespace durero::model;
using namespace durero::test;
using contract::cost;

namespace {

/// What a form of predicate says of two states, at both prices.
struct Said {
  bool normal, whole;
  bool operator==(const Said&) const = default;
};
constexpr Said holds{true, true}, fails{false, false}, seen_by_the_whole{true, false};

/// Applies a change to one_of_each() and asks for a form of predicate about e.
template <class Change, class Form>
Said after(const Elemento& e, Change&& change, Form&& form) {
  const Escena before = one_of_each();
  Escena after = before;
  change(after);
  return {form(Delta(before, e, after, cost::normal)), form(Delta(before, e, after, cost::audit))};
}

const auto nothing = [](Escena&) {};

}  // namespace

TEST_CASE("elementos' = elementos ∪ { e? }") {
  const auto added = [](const Delta& d) { return d.added(); };
  CHECK(after(
            nuevo, [](Escena& s) { s.elementos.insert(nuevo); }, added) == holds);
  CHECK(after(esfera, nothing, added) == holds);
  CHECK(after(nuevo, nothing, added) == fails);
  CHECK(
      after(
          nuevo,
          [](Escena& s) { s.elementos = {cilindro, cono, tronco, plano, disco, triangulo, nuevo, Elemento("other")}; },
          added) == seen_by_the_whole);
}

TEST_CASE("elementos' = elementos ∖ { e? }") {
  const auto removed = [](const Delta& d) { return d.removed(); };
  CHECK(after(
            esfera, [](Escena& s) { s.elementos.erase(esfera); }, removed) == holds);
  CHECK(after(nuevo, nothing, removed) == holds);
  CHECK(after(esfera, nothing, removed) == fails);
  CHECK(after(
            esfera, [](Escena& s) { s.elementos = {cilindro, tronco, plano, disco, triangulo, nuevo}; }, removed) ==
        seen_by_the_whole);
}

TEST_CASE("c' = c ∪ { e? ↦ x }") {
  const auto with_radius = [](double x) { return [x](const Delta& d) { return d.with(&Escena::mi_radio, x); }; };
  const auto put = [](Escena& s) { s.mi_radio.emplace(nuevo, 2); };
  CHECK(after(nuevo, put, with_radius(2)) == holds);
  CHECK(after(nuevo, put, with_radius(3)) == fails);
  CHECK(after(nuevo, nothing, with_radius(2)) == fails);
  CHECK(after(esfera, nothing, with_radius(1)) == holds);  // it is there already
  const auto other_too = [](Escena& s) {
    s.mi_radio.emplace(nuevo, 2);
    s.mi_radio.at(cilindro) = Rmas(7);
  };
  CHECK(after(nuevo, other_too, with_radius(2)) == seen_by_the_whole);
  // The other may stand before e? or after it.
  CHECK(after(
            cilindro, [](Escena& e) { e.mi_radio.at(esfera) = Rmas(7); }, with_radius(1)) == seen_by_the_whole);
  // Another value at e?: the union is no function, and the size alone does not tell.
  CHECK(after(
            esfera, [](Escena& s) { s.mi_radio.at(esfera) = Rmas(2); }, with_radius(2)) == seen_by_the_whole);
}

TEST_CASE("c' = c ∪ { e? ↦ x }, of three points") {
  const auto with_corners = [](const Delta& d) { return d.with(&Escena::mi_vertices, corners); };
  CHECK(after(
            nuevo, [](Escena& s) { s.mi_vertices.emplace(nuevo, corners); }, with_corners) == holds);
  CHECK(after(
            nuevo, [](Escena& s) { s.mi_vertices.emplace(nuevo, other_corners); }, with_corners) == fails);
  CHECK(after(nuevo, nothing, with_corners) == fails);
}

TEST_CASE("c' = { e? } ⩤ c") {
  const auto without = [](const Delta& d) { return d.without(&Escena::mi_altura); };
  CHECK(after(
            cono, [](Escena& s) { s.mi_altura.erase(cono); }, without) == holds);
  CHECK(after(esfera, nothing, without) == holds);
  CHECK(after(cono, nothing, without) == fails);
  CHECK(after(
            cono,
            [](Escena& s) {
              s.mi_altura = {{tronco, Rmas(3)}, {nuevo, Rmas(3)}};
            },
            without) == seen_by_the_whole);
}

TEST_CASE("c' = c") {
  const auto same = [](const Delta& d) { return d.same(&Escena::mi_vector); };
  CHECK(after(nuevo, nothing, same) == holds);
  CHECK(after(
            nuevo, [](Escena& s) { s.mi_vector.emplace(nuevo, axis); }, same) == fails);
  CHECK(after(
            cono, [](Escena& s) { s.mi_vector.erase(cono); }, same) == fails);
  CHECK(after(
            nuevo, [](Escena& s) { s.mi_vector.at(cono) = Vector(1, 0, 0); }, same) == seen_by_the_whole);
}
