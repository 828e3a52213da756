#include "durero/model/operaciones.hpp"

#include <cmath>
#include <stdexcept>
#include <vector>

#include "durero/model/operaciones_clauses.hpp"
#include "escenas.hpp"
#include "support/catch.hpp"
#include "support/clauses.hpp"

// A test case a schema: each precondition broken by an input, each postcondition by a spoiled after-state.

using namespace durero;
using namespace durero::model;
using namespace durero::test;
using contract::cost;

namespace {

/// The label that the operation violates on one_of_each(), which must stay as it was.
std::string refused(const Operation& operation) {
  Escena escena = one_of_each();
  const std::string label = violated([&] { model::apply(escena, operation); });
  CHECK(escena == one_of_each());
  return label;
}

/// The labels that see that the after-state, or the answer, of an operation on one_of_each() was spoiled. The two
/// prices must agree, since what is spoiled is the operation's own element.
template <class Op, class Spoil>
std::string spoiled(const Op& in, Spoil&& spoil) {
  const Escena before = one_of_each();
  Escena after = before;
  Respuesta r = model::apply(after, in);
  CHECK(all_hold(post(before, in, after, r, cost::normal)));
  CHECK(all_hold(post(before, in, after, r, cost::audit)));
  spoil(after, r);
  const Judgements normal = post(before, in, after, r, cost::normal), audit = post(before, in, after, r, cost::audit);
  CHECK(broken(normal) == broken(audit));
  CHECK(broken(audit).size() == 1);
  return violated([&] { check(normal, cost::normal); });
}

template <class Op>
std::string wrong_answer(const Op& in) {
  return spoiled(in, [](Escena&, Respuesta& r) { r = Respuesta::tipo_incorrecto; });
}

}  // namespace

#define SPOILED(op, change) spoiled(op, [](Escena& after, Respuesta&) { change; })

TEST_CASE("Agregar_Elemento, the part of every addition") {
  for (const Operation& again :
       std::vector<Operation>{Agregar_Esfera{esfera, far, 2}, Agregar_Cilindro{esfera, far, 2, axis, 5},
                              Agregar_Cono{cilindro, far, 2, axis, 5}, Agregar_Tronco{tronco, far, 3, 2, axis, 5},
                              Agregar_Elemento{cono, Tipo::soy_esfera, far, 2}})
    CHECK(refused(again) == "Agregar_Elemento.pre.1");
  CHECK(SPOILED(agregar_esfera, after.elementos.erase(nuevo)) == "Agregar_Elemento.post.1");
  CHECK(SPOILED(agregar_cono, after.elementos.erase(nuevo)) == "Agregar_Elemento.post.1");
  CHECK(SPOILED(agregar_esfera, after.de_que_tipo.at(nuevo) = Tipo::soy_cono) == "Agregar_Elemento.post.2");
  CHECK(SPOILED(agregar_cilindro, after.de_que_tipo.erase(nuevo)) == "Agregar_Elemento.post.2");
}

TEST_CASE("Agregar_Esfera") {
  CHECK(refused(Agregar_Esfera{nuevo, far, 2, Tipo::soy_cono}) == "Agregar_Esfera.pre.1");
  for (const double wrong : {0.0, -2.0, HUGE_VAL, std::nan("")})
    CHECK(refused(Agregar_Esfera{nuevo, far, wrong}) == "Agregar_Esfera.pre.2");
  CHECK(SPOILED(agregar_esfera, after.mi_centro.at(nuevo) = origin) == "Agregar_Esfera.post.1");
  CHECK(SPOILED(agregar_esfera, after.mi_radio.at(nuevo) = Rmas(3)) == "Agregar_Esfera.post.2");
  CHECK(SPOILED(agregar_esfera, after.mi_vector.emplace(nuevo, axis)) == "Agregar_Esfera.post.3");
  CHECK(SPOILED(agregar_esfera, after.mi_altura.emplace(nuevo, 1)) == "Agregar_Esfera.post.4");
  CHECK(SPOILED(agregar_esfera, after.mi_proporcion.emplace(nuevo, 1)) == "Agregar_Esfera.post.5");
  CHECK(SPOILED(agregar_esfera, after.mi_vertices.emplace(nuevo, corners)) == "Agregar_Esfera.post.6");
  CHECK(wrong_answer(agregar_esfera) == "Agregar_Esfera.post.7");
}

TEST_CASE("Agregar_Cilindro") {
  CHECK(refused(Agregar_Cilindro{nuevo, far, 2, axis, 5, Tipo::soy_esfera}) == "Agregar_Cilindro.pre.1");
  CHECK(refused(Agregar_Cilindro{nuevo, far, -2, axis, 5}) == "Agregar_Cilindro.pre.2");
  CHECK(refused(Agregar_Cilindro{nuevo, far, 2, not_unit, 5}) == "Agregar_Cilindro.pre.3");
  CHECK(refused(Agregar_Cilindro{nuevo, far, 2, axis, 0}) == "Agregar_Cilindro.pre.4");
  CHECK(SPOILED(agregar_cilindro, after.mi_centro.at(nuevo) = origin) == "Agregar_Cilindro.post.1");
  CHECK(SPOILED(agregar_cilindro, after.mi_radio.at(nuevo) = Rmas(3)) == "Agregar_Cilindro.post.2");
  CHECK(SPOILED(agregar_cilindro, after.mi_vector.at(nuevo) = Vector(1, 0, 0)) == "Agregar_Cilindro.post.3");
  CHECK(SPOILED(agregar_cilindro, after.mi_altura.erase(nuevo)) == "Agregar_Cilindro.post.4");
  CHECK(SPOILED(agregar_cilindro, after.mi_proporcion.emplace(nuevo, 1)) == "Agregar_Cilindro.post.5");
  CHECK(SPOILED(agregar_cilindro, after.mi_vertices.emplace(nuevo, corners)) == "Agregar_Cilindro.post.6");
  CHECK(wrong_answer(agregar_cilindro) == "Agregar_Cilindro.post.7");
}

TEST_CASE("Agregar_Cono") {
  CHECK(refused(Agregar_Cono{nuevo, far, 2, axis, 5, Tipo::soy_esfera}) == "Agregar_Cono.pre.1");
  CHECK(refused(Agregar_Cono{nuevo, far, 0, axis, 5}) == "Agregar_Cono.pre.2");
  CHECK(refused(Agregar_Cono{nuevo, far, 2, not_unit, 5}) == "Agregar_Cono.pre.3");
  CHECK(refused(Agregar_Cono{nuevo, far, 2, axis, -5}) == "Agregar_Cono.pre.4");
  CHECK(SPOILED(agregar_cono, after.mi_centro.at(nuevo) = origin) == "Agregar_Cono.post.1");
  CHECK(SPOILED(agregar_cono, after.mi_radio.emplace(nuevo, 1)) == "Agregar_Cono.post.2");
  CHECK(SPOILED(agregar_cono, after.mi_vector.at(nuevo) = Vector(1, 0, 0)) == "Agregar_Cono.post.3");
  CHECK(SPOILED(agregar_cono, after.mi_altura.at(nuevo) = Rmas(1)) == "Agregar_Cono.post.4");
  CHECK(SPOILED(agregar_cono, after.mi_proporcion.at(nuevo) = Rmas(1)) == "Agregar_Cono.post.5");
  CHECK(SPOILED(agregar_cono, after.mi_vertices.emplace(nuevo, corners)) == "Agregar_Cono.post.6");
  CHECK(wrong_answer(agregar_cono) == "Agregar_Cono.post.7");
}

TEST_CASE("Agregar_Tronco") {
  CHECK(refused(Agregar_Tronco{nuevo, far, 3, 2, axis, 5, Tipo::soy_cono}) == "Agregar_Tronco.pre.1");
  CHECK(refused(Agregar_Tronco{nuevo, far, 0, 2, axis, 5}) == "Agregar_Tronco.pre.2");
  CHECK(refused(Agregar_Tronco{nuevo, far, 3, -2, axis, 5}) == "Agregar_Tronco.pre.3");
  CHECK(refused(Agregar_Tronco{nuevo, far, 3, 2, not_unit, 5}) == "Agregar_Tronco.pre.4");
  CHECK(refused(Agregar_Tronco{nuevo, far, 3, 2, axis, 0}) == "Agregar_Tronco.pre.5");
  CHECK(SPOILED(agregar_tronco, after.mi_centro.at(nuevo) = origin) == "Agregar_Tronco.post.1");
  CHECK(SPOILED(agregar_tronco, after.mi_radio.at(nuevo) = Rmas(2)) == "Agregar_Tronco.post.2");
  CHECK(SPOILED(agregar_tronco, after.mi_vector.at(nuevo) = Vector(1, 0, 0)) == "Agregar_Tronco.post.3");
  CHECK(SPOILED(agregar_tronco, after.mi_altura.at(nuevo) = Rmas(1)) == "Agregar_Tronco.post.4");
  CHECK(SPOILED(agregar_tronco, after.mi_proporcion.erase(nuevo)) == "Agregar_Tronco.post.5");
  CHECK(SPOILED(agregar_tronco, after.mi_vertices.emplace(nuevo, corners)) == "Agregar_Tronco.post.6");
  CHECK(wrong_answer(agregar_tronco) == "Agregar_Tronco.post.7");
}

TEST_CASE("Agregar_Plano") {
  CHECK(refused(Agregar_Plano{nuevo, far, axis, Tipo::soy_cono}) == "Agregar_Plano.pre.1");
  CHECK(refused(Agregar_Plano{nuevo, far, not_unit}) == "Agregar_Plano.pre.2");
  CHECK(SPOILED(agregar_plano, after.mi_centro.at(nuevo) = origin) == "Agregar_Plano.post.1");
  CHECK(SPOILED(agregar_plano, after.mi_radio.emplace(nuevo, 1)) == "Agregar_Plano.post.2");
  CHECK(SPOILED(agregar_plano, after.mi_vector.at(nuevo) = Vector(1, 0, 0)) == "Agregar_Plano.post.3");
  CHECK(SPOILED(agregar_plano, after.mi_altura.emplace(nuevo, 1)) == "Agregar_Plano.post.4");
  CHECK(SPOILED(agregar_plano, after.mi_proporcion.emplace(nuevo, 1)) == "Agregar_Plano.post.5");
  CHECK(SPOILED(agregar_plano, after.mi_vertices.emplace(nuevo, corners)) == "Agregar_Plano.post.6");
  CHECK(wrong_answer(agregar_plano) == "Agregar_Plano.post.7");
}

TEST_CASE("Agregar_Disco") {
  CHECK(refused(Agregar_Disco{nuevo, far, 2, axis, Tipo::soy_plano}) == "Agregar_Disco.pre.1");
  CHECK(refused(Agregar_Disco{nuevo, far, 0, axis}) == "Agregar_Disco.pre.2");
  CHECK(refused(Agregar_Disco{nuevo, far, 2, not_unit}) == "Agregar_Disco.pre.3");
  CHECK(SPOILED(agregar_disco, after.mi_centro.at(nuevo) = origin) == "Agregar_Disco.post.1");
  CHECK(SPOILED(agregar_disco, after.mi_radio.at(nuevo) = Rmas(3)) == "Agregar_Disco.post.2");
  CHECK(SPOILED(agregar_disco, after.mi_vector.at(nuevo) = Vector(1, 0, 0)) == "Agregar_Disco.post.3");
  CHECK(SPOILED(agregar_disco, after.mi_altura.emplace(nuevo, 1)) == "Agregar_Disco.post.4");
  CHECK(SPOILED(agregar_disco, after.mi_proporcion.emplace(nuevo, 1)) == "Agregar_Disco.post.5");
  CHECK(SPOILED(agregar_disco, after.mi_vertices.emplace(nuevo, corners)) == "Agregar_Disco.post.6");
  CHECK(wrong_answer(agregar_disco) == "Agregar_Disco.post.7");
}

TEST_CASE("Agregar_Triangulo") {
  CHECK(refused(Agregar_Triangulo{nuevo, corners, Tipo::soy_plano}) == "Agregar_Triangulo.pre.1");
  CHECK(refused(Agregar_Triangulo{nuevo, aligned}) == "Agregar_Triangulo.pre.2");
  CHECK(SPOILED(agregar_triangulo, after.mi_centro.emplace(nuevo, origin)) == "Agregar_Triangulo.post.1");
  CHECK(SPOILED(agregar_triangulo, after.mi_radio.emplace(nuevo, 1)) == "Agregar_Triangulo.post.2");
  CHECK(SPOILED(agregar_triangulo, after.mi_vector.emplace(nuevo, axis)) == "Agregar_Triangulo.post.3");
  CHECK(SPOILED(agregar_triangulo, after.mi_altura.emplace(nuevo, 1)) == "Agregar_Triangulo.post.4");
  CHECK(SPOILED(agregar_triangulo, after.mi_proporcion.emplace(nuevo, 1)) == "Agregar_Triangulo.post.5");
  CHECK(SPOILED(agregar_triangulo, after.mi_vertices.at(nuevo) = Vertices(corners)) == "Agregar_Triangulo.post.6");
  CHECK(SPOILED(agregar_triangulo, after.mi_vertices.erase(nuevo)) == "Agregar_Triangulo.post.6");
  CHECK(wrong_answer(agregar_triangulo) == "Agregar_Triangulo.post.7");
}

TEST_CASE("Eliminar_Elemento, the part of every removal") {
  for (const Operation& unknown : std::vector<Operation>{
           Eliminar_Esfera{nuevo}, Eliminar_Cilindro{nuevo}, Eliminar_Cono{nuevo}, Eliminar_Tronco{nuevo},
           Eliminar_Plano{nuevo}, Eliminar_Disco{nuevo}, Eliminar_Triangulo{nuevo}, Eliminar_Elemento{nuevo}})
    CHECK(refused(unknown) == "Eliminar_Elemento.pre.1");
  CHECK(SPOILED(Eliminar_Esfera{esfera}, after.elementos.insert(esfera)) == "Eliminar_Elemento.post.1");
  CHECK(SPOILED(Eliminar_Cono{cono}, after.elementos.insert(cono)) == "Eliminar_Elemento.post.1");
  CHECK(SPOILED(Eliminar_Esfera{esfera}, after.de_que_tipo.emplace(esfera, Tipo::soy_esfera)) ==
        "Eliminar_Elemento.post.2");
}

TEST_CASE("Eliminar_Esfera") {
  const Eliminar_Esfera in{esfera};
  CHECK(refused(Eliminar_Esfera{cilindro}) == "Eliminar_Esfera.pre.1");
  CHECK(SPOILED(in, after.mi_centro.emplace(esfera, origin)) == "Eliminar_Esfera.post.1");
  CHECK(SPOILED(in, after.mi_radio.emplace(esfera, 1)) == "Eliminar_Esfera.post.2");
  CHECK(SPOILED(in, after.mi_vector.emplace(esfera, axis)) == "Eliminar_Esfera.post.3");
  CHECK(SPOILED(in, after.mi_altura.emplace(esfera, 1)) == "Eliminar_Esfera.post.4");
  CHECK(SPOILED(in, after.mi_proporcion.emplace(esfera, 1)) == "Eliminar_Esfera.post.5");
  CHECK(SPOILED(in, after.mi_vertices.emplace(esfera, corners)) == "Eliminar_Esfera.post.6");
  CHECK(wrong_answer(in) == "Eliminar_Esfera.post.7");
}

TEST_CASE("Eliminar_Cilindro") {
  const Eliminar_Cilindro in{cilindro};
  CHECK(refused(Eliminar_Cilindro{cono}) == "Eliminar_Cilindro.pre.1");
  CHECK(SPOILED(in, after.mi_centro.emplace(cilindro, origin)) == "Eliminar_Cilindro.post.1");
  CHECK(SPOILED(in, after.mi_radio.emplace(cilindro, 1)) == "Eliminar_Cilindro.post.2");
  CHECK(SPOILED(in, after.mi_vector.emplace(cilindro, axis)) == "Eliminar_Cilindro.post.3");
  CHECK(SPOILED(in, after.mi_altura.emplace(cilindro, 1)) == "Eliminar_Cilindro.post.4");
  CHECK(SPOILED(in, after.mi_proporcion.emplace(cilindro, 1)) == "Eliminar_Cilindro.post.5");
  CHECK(SPOILED(in, after.mi_vertices.emplace(cilindro, corners)) == "Eliminar_Cilindro.post.6");
  CHECK(wrong_answer(in) == "Eliminar_Cilindro.post.7");
}

TEST_CASE("Eliminar_Cono") {
  const Eliminar_Cono in{cono};
  CHECK(refused(Eliminar_Cono{esfera}) == "Eliminar_Cono.pre.1");
  CHECK(SPOILED(in, after.mi_centro.emplace(cono, origin)) == "Eliminar_Cono.post.1");
  CHECK(SPOILED(in, after.mi_radio.emplace(cono, 1)) == "Eliminar_Cono.post.2");
  CHECK(SPOILED(in, after.mi_vector.emplace(cono, axis)) == "Eliminar_Cono.post.3");
  CHECK(SPOILED(in, after.mi_altura.emplace(cono, 1)) == "Eliminar_Cono.post.4");
  CHECK(SPOILED(in, after.mi_proporcion.emplace(cono, 1)) == "Eliminar_Cono.post.5");
  CHECK(SPOILED(in, after.mi_vertices.emplace(cono, corners)) == "Eliminar_Cono.post.6");
  CHECK(wrong_answer(in) == "Eliminar_Cono.post.7");
}

TEST_CASE("Eliminar_Tronco") {
  const Eliminar_Tronco in{tronco};
  CHECK(refused(Eliminar_Tronco{cono}) == "Eliminar_Tronco.pre.1");
  CHECK(SPOILED(in, after.mi_centro.emplace(tronco, origin)) == "Eliminar_Tronco.post.1");
  CHECK(SPOILED(in, after.mi_radio.emplace(tronco, 1)) == "Eliminar_Tronco.post.2");
  CHECK(SPOILED(in, after.mi_vector.emplace(tronco, axis)) == "Eliminar_Tronco.post.3");
  CHECK(SPOILED(in, after.mi_altura.emplace(tronco, 1)) == "Eliminar_Tronco.post.4");
  CHECK(SPOILED(in, after.mi_proporcion.emplace(tronco, 1)) == "Eliminar_Tronco.post.5");
  CHECK(SPOILED(in, after.mi_vertices.emplace(tronco, corners)) == "Eliminar_Tronco.post.6");
  CHECK(wrong_answer(in) == "Eliminar_Tronco.post.7");
}

TEST_CASE("Eliminar_Plano") {
  const Eliminar_Plano in{plano};
  CHECK(refused(Eliminar_Plano{cono}) == "Eliminar_Plano.pre.1");
  CHECK(SPOILED(in, after.mi_centro.emplace(plano, origin)) == "Eliminar_Plano.post.1");
  CHECK(SPOILED(in, after.mi_radio.emplace(plano, 1)) == "Eliminar_Plano.post.2");
  CHECK(SPOILED(in, after.mi_vector.emplace(plano, axis)) == "Eliminar_Plano.post.3");
  CHECK(SPOILED(in, after.mi_altura.emplace(plano, 1)) == "Eliminar_Plano.post.4");
  CHECK(SPOILED(in, after.mi_proporcion.emplace(plano, 1)) == "Eliminar_Plano.post.5");
  CHECK(SPOILED(in, after.mi_vertices.emplace(plano, corners)) == "Eliminar_Plano.post.6");
  CHECK(wrong_answer(in) == "Eliminar_Plano.post.7");
}

TEST_CASE("Eliminar_Disco") {
  const Eliminar_Disco in{disco};
  CHECK(refused(Eliminar_Disco{plano}) == "Eliminar_Disco.pre.1");
  CHECK(SPOILED(in, after.mi_centro.emplace(disco, origin)) == "Eliminar_Disco.post.1");
  CHECK(SPOILED(in, after.mi_radio.emplace(disco, 1)) == "Eliminar_Disco.post.2");
  CHECK(SPOILED(in, after.mi_vector.emplace(disco, axis)) == "Eliminar_Disco.post.3");
  CHECK(SPOILED(in, after.mi_altura.emplace(disco, 1)) == "Eliminar_Disco.post.4");
  CHECK(SPOILED(in, after.mi_proporcion.emplace(disco, 1)) == "Eliminar_Disco.post.5");
  CHECK(SPOILED(in, after.mi_vertices.emplace(disco, corners)) == "Eliminar_Disco.post.6");
  CHECK(wrong_answer(in) == "Eliminar_Disco.post.7");
}

TEST_CASE("Eliminar_Triangulo") {
  const Eliminar_Triangulo in{triangulo};
  CHECK(refused(Eliminar_Triangulo{plano}) == "Eliminar_Triangulo.pre.1");
  CHECK(SPOILED(in, after.mi_centro.emplace(triangulo, origin)) == "Eliminar_Triangulo.post.1");
  CHECK(SPOILED(in, after.mi_radio.emplace(triangulo, 1)) == "Eliminar_Triangulo.post.2");
  CHECK(SPOILED(in, after.mi_vector.emplace(triangulo, axis)) == "Eliminar_Triangulo.post.3");
  CHECK(SPOILED(in, after.mi_altura.emplace(triangulo, 1)) == "Eliminar_Triangulo.post.4");
  CHECK(SPOILED(in, after.mi_proporcion.emplace(triangulo, 1)) == "Eliminar_Triangulo.post.5");
  CHECK(SPOILED(in, after.mi_vertices.emplace(triangulo, corners)) == "Eliminar_Triangulo.post.6");
  CHECK(wrong_answer(in) == "Eliminar_Triangulo.post.7");
}

TEST_CASE("Elemento_Agregado: the operation of the type, with the general answer") {
  const Agregar_Elemento sphere{nuevo, Tipo::soy_esfera, far, 2};
  const Agregar_Elemento cylinder{nuevo, Tipo::soy_cilindro, far, 2, axis, 5};
  const Agregar_Elemento cone{nuevo, Tipo::soy_cono, far, {}, axis, 5, 2};
  const Agregar_Elemento truncated{nuevo, Tipo::soy_tronco, far, 3, axis, 5, 2};
  const Agregar_Elemento plane{nuevo, Tipo::soy_plano, far, {}, axis};
  const Agregar_Elemento disc{nuevo, Tipo::soy_disco, far, 2, axis};
  const Agregar_Elemento triangle{.e = nuevo, .t = Tipo::soy_triangulo, .vertices = other_corners};
  for (const auto& in : {sphere, cylinder, cone, truncated, plane, disc, triangle})
    CHECK(wrong_answer(in) == "Elemento_Agregado.post.1");
  CHECK(SPOILED(cone, after.mi_altura.at(nuevo) = Rmas(1)) == "Agregar_Cono.post.4");
  CHECK(refused(Agregar_Elemento{nuevo, Tipo::soy_cilindro, far, 2, not_unit, 5}) == "Agregar_Cilindro.pre.3");

  Escena general = one_of_each(), specific = one_of_each();
  CHECK(model::apply(general, cone) == Respuesta::elemento_agregado);
  CHECK(model::apply(specific, agregar_cono) == Respuesta::cono_agregado);
  CHECK(general == specific);
  general = specific = one_of_each();
  model::apply(general, truncated);
  model::apply(specific, agregar_tronco);
  CHECK(general == specific);
  general = specific = one_of_each();
  model::apply(general, plane);
  model::apply(specific, agregar_plano);
  CHECK(general == specific);
  general = specific = one_of_each();
  model::apply(general, disc);
  model::apply(specific, agregar_disco);
  CHECK(general == specific);
  general = specific = one_of_each();
  model::apply(general, triangle);
  model::apply(specific, agregar_triangulo);
  CHECK(general == specific);

  Escena escena = one_of_each();
  CHECK_THROWS_AS(model::apply(escena, Agregar_Elemento{nuevo, Tipo::soy_esfera, far}), std::invalid_argument);
  CHECK_THROWS_AS(model::apply_total(escena, Agregar_Elemento{nuevo, Tipo::soy_cono, far, 2, axis, 5}),
                  std::invalid_argument);
  CHECK_THROWS_AS(model::apply(escena, Agregar_Elemento{nuevo, Tipo::soy_triangulo, far, 2, axis, 5}),
                  std::invalid_argument);
  CHECK_THROWS_AS(model::apply(escena, Agregar_Elemento{.e = nuevo, .t = Tipo::soy_esfera, .radio = 2}),
                  std::invalid_argument);
  CHECK(escena == one_of_each());
}

TEST_CASE("Elemento_Eliminado: the operation of the element's type, with the general answer") {
  for (const Elemento& e : {esfera, cilindro, cono, tronco, plano, disco, triangulo})
    CHECK(wrong_answer(Eliminar_Elemento{e}) == "Elemento_Eliminado.post.1");
  CHECK(SPOILED(Eliminar_Elemento{cono}, after.mi_altura.emplace(cono, 1)) == "Eliminar_Cono.post.4");

  Escena escena = one_of_each();
  for (const Elemento& e : {esfera, cilindro, cono, tronco, plano, disco, triangulo})
    CHECK(model::apply(escena, Eliminar_Elemento{e}) == Respuesta::elemento_eliminado);
  CHECK(escena == Init());
}

TEST_CASE("the whole predicates see a change of another element, which is not the operation's own") {
  const Escena before = one_of_each();
  Escena after = before;
  const Respuesta r = model::apply(after, agregar_cilindro);
  const auto seen = [&](auto&& spoil) {
    Escena other = after;
    spoil(other);
    CHECK(all_hold(post(before, agregar_cilindro, other, r, cost::normal)));
    return violated([&] { check(post(before, agregar_cilindro, other, r, cost::audit), cost::normal); });
  };
  CHECK(seen([](Escena& s) { s.de_que_tipo.at(esfera) = Tipo::soy_cono; }) == "Agregar_Elemento.post.2");
  CHECK(seen([](Escena& s) { s.mi_centro.at(esfera) = far; }) == "Agregar_Cilindro.post.1");
  CHECK(seen([](Escena& s) { s.mi_radio.at(cilindro) = Rmas(7); }) == "Agregar_Cilindro.post.2");
  CHECK(seen([](Escena& s) { s.mi_vector.at(cono) = Vector(0, 1, 0); }) == "Agregar_Cilindro.post.3");
  CHECK(seen([](Escena& s) { s.mi_altura.at(cono) = Rmas(7); }) == "Agregar_Cilindro.post.4");
  CHECK(seen([](Escena& s) { s.mi_proporcion.at(cono) = Rmas(7); }) == "Agregar_Cilindro.post.5");
  CHECK(seen([](Escena& s) { s.mi_vertices.at(triangulo) = Vertices(other_corners); }) == "Agregar_Cilindro.post.6");
}

TEST_CASE("an audit sees a scene whose invariant was broken before the operation") {
  Escena escena = one_of_each();
  escena.mi_radio.erase(esfera);
  const contract::scoped_semantic audited(cost::audit, contract::evaluation_semantic::enforce);
  CHECK(violated([&] { model::apply(escena, agregar_cono); }) == "Escena.inv.3");
}
