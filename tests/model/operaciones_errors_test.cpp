#include "durero/model/operaciones_errors.hpp"

#include "durero/model/operaciones_clauses.hpp"
#include "escenas.hpp"
#include "support/catch.hpp"
#include "support/clauses.hpp"

// What can go wrong, and the total operations.

using namespace durero;
using namespace durero::model;
using namespace durero::test;
using contract::cost;

namespace {

/// The label that an error violates on one_of_each(), where it does not apply.
std::string out_of_place(const Error& error) {
  const Escena escena = one_of_each();
  return violated([&] { model::apply(escena, error); });
}

/// The label that sees an answer that is not the error's, on one_of_each(), where it applies.
template <class Schema>
std::string wrong_answer(const Schema& in) {
  CHECK(all_hold(judgements(one_of_each(), in, in.answer)));
  return violated([&] { check(judgements(one_of_each(), in, Respuesta::elemento_agregado), cost::normal); });
}

/// What the total operation answers on one_of_each(), which must stay as it was where the answer is an error.
std::pair<std::string, std::string> answer(const Operation& operation) {
  Escena escena = one_of_each();
  const Answer answer = model::apply_total(escena, operation);
  CHECK((escena == one_of_each()) == !answer.ok());
  return {std::string(name(answer.r)), answer.ok() ? "none" : std::string(answer.violated->label)};
}

using Pair = std::pair<std::string, std::string>;

}  // namespace

TEST_CASE("Elemento_Ya_Existe and Elemento_No_Existe") {
  CHECK(out_of_place(Elemento_Ya_Existe{nuevo}) == "Elemento_Ya_Existe.pre.1");
  CHECK(wrong_answer(Elemento_Ya_Existe{esfera}) == "Elemento_Ya_Existe.post.1");
  CHECK(out_of_place(Elemento_No_Existe{esfera}) == "Elemento_No_Existe.pre.1");
  CHECK(wrong_answer(Elemento_No_Existe{nuevo}) == "Elemento_No_Existe.post.1");
}

TEST_CASE("the attribute that is wrong") {
  CHECK(out_of_place(Radio_No_Positivo{1}) == "Radio_No_Positivo.pre.1");
  CHECK(wrong_answer(Radio_No_Positivo{0}) == "Radio_No_Positivo.post.1");
  CHECK(out_of_place(Vector_No_Unitario{axis}) == "Vector_No_Unitario.pre.1");
  CHECK(wrong_answer(Vector_No_Unitario{not_unit}) == "Vector_No_Unitario.post.1");
  CHECK(out_of_place(Altura_No_Positiva{1}) == "Altura_No_Positiva.pre.1");
  CHECK(wrong_answer(Altura_No_Positiva{0}) == "Altura_No_Positiva.post.1");
  CHECK(out_of_place(Proporcion_No_Positiva{1}) == "Proporcion_No_Positiva.pre.1");
  CHECK(wrong_answer(Proporcion_No_Positiva{0}) == "Proporcion_No_Positiva.post.1");
  CHECK(out_of_place(Vertices_Alineados{corners}) == "Vertices_Alineados.pre.1");
  CHECK(wrong_answer(Vertices_Alineados{aligned}) == "Vertices_Alineados.post.1");
}

TEST_CASE("the type that is wrong") {
  CHECK(out_of_place(No_Es_Esfera{nuevo}) == "No_Es_Esfera.pre.1");
  CHECK(out_of_place(No_Es_Esfera{esfera}) == "No_Es_Esfera.pre.2");
  CHECK(wrong_answer(No_Es_Esfera{cono}) == "No_Es_Esfera.post.1");
  CHECK(out_of_place(No_Es_Cilindro{nuevo}) == "No_Es_Cilindro.pre.1");
  CHECK(out_of_place(No_Es_Cilindro{cilindro}) == "No_Es_Cilindro.pre.2");
  CHECK(wrong_answer(No_Es_Cilindro{esfera}) == "No_Es_Cilindro.post.1");
  CHECK(out_of_place(No_Es_Cono{nuevo}) == "No_Es_Cono.pre.1");
  CHECK(out_of_place(No_Es_Cono{cono}) == "No_Es_Cono.pre.2");
  CHECK(wrong_answer(No_Es_Cono{esfera}) == "No_Es_Cono.post.1");
  CHECK(out_of_place(No_Es_Tronco{nuevo}) == "No_Es_Tronco.pre.1");
  CHECK(out_of_place(No_Es_Tronco{tronco}) == "No_Es_Tronco.pre.2");
  CHECK(wrong_answer(No_Es_Tronco{cono}) == "No_Es_Tronco.post.1");
  CHECK(out_of_place(No_Es_Plano{nuevo}) == "No_Es_Plano.pre.1");
  CHECK(out_of_place(No_Es_Plano{plano}) == "No_Es_Plano.pre.2");
  CHECK(wrong_answer(No_Es_Plano{cono}) == "No_Es_Plano.post.1");
  CHECK(out_of_place(No_Es_Disco{nuevo}) == "No_Es_Disco.pre.1");
  CHECK(out_of_place(No_Es_Disco{disco}) == "No_Es_Disco.pre.2");
  CHECK(wrong_answer(No_Es_Disco{plano}) == "No_Es_Disco.post.1");
  CHECK(out_of_place(No_Es_Triangulo{nuevo}) == "No_Es_Triangulo.pre.1");
  CHECK(out_of_place(No_Es_Triangulo{triangulo}) == "No_Es_Triangulo.pre.2");
  CHECK(wrong_answer(No_Es_Triangulo{plano}) == "No_Es_Triangulo.post.1");
}

TEST_CASE("the types at which the general addition looks") {
  const auto seen = [](const Judgements& judgements) { return violated([&] { check(judgements, cost::normal); }); };
  CHECK(seen(given<&Escena::mi_radio>(Tipo::soy_cono)) == "Con_Radio.pre.1");
  CHECK(seen(given<&Escena::mi_vector>(Tipo::soy_esfera)) == "Con_Vector.pre.1");
  CHECK(seen(given<&Escena::mi_altura>(Tipo::soy_esfera)) == "Con_Altura.pre.1");
  CHECK(seen(given<&Escena::mi_proporcion>(Tipo::soy_cilindro)) == "Con_Proporcion.pre.1");
  CHECK(seen(given<&Escena::mi_vertices>(Tipo::soy_disco)) == "Con_Vertices.pre.1");
  CHECK(all_hold(given<&Escena::mi_vertices>(Tipo::soy_triangulo)));
  CHECK(all_hold(given<&Escena::mi_radio>(Tipo::soy_disco)));
  CHECK(all_hold(given<&Escena::mi_vector>(Tipo::soy_disco)));
  CHECK_FALSE(all_hold(given<&Escena::mi_vector>(Tipo::soy_triangulo)));
  CHECK(all_hold(given<&Escena::mi_radio>(Tipo::soy_esfera)));
  CHECK(all_hold(given<&Escena::mi_radio>(Tipo::soy_tronco)));
  CHECK(all_hold(given<&Escena::mi_vector>(Tipo::soy_plano)));
  CHECK_FALSE(all_hold(given<&Escena::mi_altura>(Tipo::soy_plano)));
  CHECK(all_hold(given<&Escena::mi_proporcion>(Tipo::soy_tronco)));
  CHECK(all_hold(given<&Escena::mi_vector>(Tipo::soy_cono)));
  CHECK(all_hold(given<&Escena::mi_altura>(Tipo::soy_cilindro)));
  CHECK(all_hold(given<&Escena::mi_proporcion>(Tipo::soy_cono)));
}

TEST_CASE("an error that applies answers and changes nothing") {
  const Escena escena = one_of_each();
  CHECK(model::apply(escena, Elemento_Ya_Existe{esfera}) == Respuesta::elemento_ya_existe);
  CHECK(model::apply(escena, No_Es_Cono{esfera}) == Respuesta::tipo_incorrecto);
}

TEST_CASE("a total operation that can be done is done") {
  CHECK(answer(agregar_esfera) == Pair{"esfera_agregada", "none"});
  CHECK(answer(agregar_cilindro) == Pair{"cilindro_agregado", "none"});
  CHECK(answer(agregar_cono) == Pair{"cono_agregado", "none"});
  CHECK(answer(agregar_tronco) == Pair{"tronco_agregado", "none"});
  CHECK(answer(agregar_plano) == Pair{"plano_agregado", "none"});
  CHECK(answer(agregar_disco) == Pair{"disco_agregado", "none"});
  CHECK(answer(agregar_triangulo) == Pair{"triangulo_agregado", "none"});
  CHECK(answer(Agregar_Elemento{nuevo, Tipo::soy_esfera, far, 2}) == Pair{"elemento_agregado", "none"});
  CHECK(answer(Eliminar_Esfera{esfera}) == Pair{"esfera_eliminada", "none"});
  CHECK(answer(Eliminar_Cilindro{cilindro}) == Pair{"cilindro_eliminado", "none"});
  CHECK(answer(Eliminar_Cono{cono}) == Pair{"cono_eliminado", "none"});
  CHECK(answer(Eliminar_Tronco{tronco}) == Pair{"tronco_eliminado", "none"});
  CHECK(answer(Eliminar_Plano{plano}) == Pair{"plano_eliminado", "none"});
  CHECK(answer(Eliminar_Disco{disco}) == Pair{"disco_eliminado", "none"});
  CHECK(answer(Eliminar_Triangulo{triangulo}) == Pair{"triangulo_eliminado", "none"});
  CHECK(answer(Eliminar_Elemento{cono}) == Pair{"elemento_eliminado", "none"});
}

TEST_CASE("a total operation hides the type: the name of a specific addition says it") {
  CHECK(answer(Agregar_Esfera{nuevo, far, 2, Tipo::soy_cono}) == Pair{"esfera_agregada", "none"});
  CHECK(answer(Agregar_Cono{nuevo, far, 2, axis, 5, Tipo::soy_esfera}) == Pair{"cono_agregado", "none"});
}

TEST_CASE("a total operation answers the first error in the order of the text") {
  CHECK(answer(Agregar_Esfera{esfera, far, 0}) == Pair{"elemento_ya_existe", "Agregar_Elemento.pre.1"});
  CHECK(answer(Agregar_Esfera{nuevo, far, 0}) == Pair{"radio_no_positivo", "Agregar_Esfera.pre.2"});

  CHECK(answer(Agregar_Cilindro{cono, far, 0, not_unit, 0}) == Pair{"elemento_ya_existe", "Agregar_Elemento.pre.1"});
  CHECK(answer(Agregar_Cilindro{nuevo, far, 0, not_unit, 0}) == Pair{"radio_no_positivo", "Agregar_Cilindro.pre.2"});
  CHECK(answer(Agregar_Cilindro{nuevo, far, 2, not_unit, 0}) == Pair{"vector_no_unitario", "Agregar_Cilindro.pre.3"});
  CHECK(answer(Agregar_Cilindro{nuevo, far, 2, axis, 0}) == Pair{"altura_no_positiva", "Agregar_Cilindro.pre.4"});

  CHECK(answer(Agregar_Cono{nuevo, far, 0, not_unit, 0}) == Pair{"proporcion_no_positiva", "Agregar_Cono.pre.2"});
  CHECK(answer(Agregar_Cono{nuevo, far, 2, not_unit, 0}) == Pair{"vector_no_unitario", "Agregar_Cono.pre.3"});
  CHECK(answer(Agregar_Cono{nuevo, far, 2, axis, 0}) == Pair{"altura_no_positiva", "Agregar_Cono.pre.4"});

  CHECK(answer(Agregar_Tronco{nuevo, far, 0, 0, not_unit, 0}) == Pair{"radio_no_positivo", "Agregar_Tronco.pre.2"});
  CHECK(answer(Agregar_Tronco{nuevo, far, 3, 0, not_unit, 0}) ==
        Pair{"proporcion_no_positiva", "Agregar_Tronco.pre.3"});
  CHECK(answer(Agregar_Tronco{nuevo, far, 3, 2, not_unit, 0}) == Pair{"vector_no_unitario", "Agregar_Tronco.pre.4"});
  CHECK(answer(Agregar_Tronco{nuevo, far, 3, 2, axis, 0}) == Pair{"altura_no_positiva", "Agregar_Tronco.pre.5"});

  CHECK(answer(Agregar_Plano{nuevo, far, not_unit}) == Pair{"vector_no_unitario", "Agregar_Plano.pre.2"});

  CHECK(answer(Agregar_Disco{nuevo, far, 0, not_unit}) == Pair{"radio_no_positivo", "Agregar_Disco.pre.2"});
  CHECK(answer(Agregar_Disco{nuevo, far, 2, not_unit}) == Pair{"vector_no_unitario", "Agregar_Disco.pre.3"});

  CHECK(answer(Agregar_Triangulo{cono, aligned}) == Pair{"elemento_ya_existe", "Agregar_Elemento.pre.1"});
  CHECK(answer(Agregar_Triangulo{nuevo, aligned}) == Pair{"vertices_alineados", "Agregar_Triangulo.pre.2"});

  CHECK(answer(Eliminar_Esfera{nuevo}) == Pair{"elemento_no_existe", "Eliminar_Elemento.pre.1"});
  CHECK(answer(Eliminar_Esfera{cono}) == Pair{"tipo_incorrecto", "Eliminar_Esfera.pre.1"});
  CHECK(answer(Eliminar_Cilindro{esfera}) == Pair{"tipo_incorrecto", "Eliminar_Cilindro.pre.1"});
  CHECK(answer(Eliminar_Cono{esfera}) == Pair{"tipo_incorrecto", "Eliminar_Cono.pre.1"});
  CHECK(answer(Eliminar_Tronco{cono}) == Pair{"tipo_incorrecto", "Eliminar_Tronco.pre.1"});
  CHECK(answer(Eliminar_Plano{cono}) == Pair{"tipo_incorrecto", "Eliminar_Plano.pre.1"});
  CHECK(answer(Eliminar_Disco{plano}) == Pair{"tipo_incorrecto", "Eliminar_Disco.pre.1"});
  CHECK(answer(Eliminar_Triangulo{plano}) == Pair{"tipo_incorrecto", "Eliminar_Triangulo.pre.1"});
  CHECK(answer(Eliminar_Elemento{nuevo}) == Pair{"elemento_no_existe", "Eliminar_Elemento.pre.1"});
}

TEST_CASE("the general addition looks only at the attributes of its type") {
  const auto add = [](Tipo t, double radio, const Vector& vector, double altura, double proporcion) {
    return answer(Agregar_Elemento{nuevo, t, far, radio, vector, altura, proporcion, aligned});
  };
  CHECK(add(Tipo::soy_esfera, 2, not_unit, 0, 0) == Pair{"elemento_agregado", "none"});
  CHECK(add(Tipo::soy_esfera, 0, not_unit, 0, 0) == Pair{"radio_no_positivo", "Agregar_Esfera.pre.2"});
  CHECK(add(Tipo::soy_cilindro, 2, axis, 5, 0) == Pair{"elemento_agregado", "none"});
  CHECK(add(Tipo::soy_cilindro, 0, not_unit, 0, 0) == Pair{"radio_no_positivo", "Agregar_Cilindro.pre.2"});
  CHECK(add(Tipo::soy_cilindro, 2, not_unit, 0, 0) == Pair{"vector_no_unitario", "Agregar_Cilindro.pre.3"});
  CHECK(add(Tipo::soy_cilindro, 2, axis, 0, 0) == Pair{"altura_no_positiva", "Agregar_Cilindro.pre.4"});
  CHECK(add(Tipo::soy_cono, 0, axis, 5, 2) == Pair{"elemento_agregado", "none"});
  CHECK(add(Tipo::soy_cono, 0, not_unit, 0, 0) == Pair{"proporcion_no_positiva", "Agregar_Cono.pre.2"});
  CHECK(add(Tipo::soy_cono, 0, not_unit, 0, 2) == Pair{"vector_no_unitario", "Agregar_Cono.pre.3"});
  CHECK(add(Tipo::soy_cono, 0, axis, 0, 2) == Pair{"altura_no_positiva", "Agregar_Cono.pre.4"});
  CHECK(add(Tipo::soy_plano, 0, axis, 0, 0) == Pair{"elemento_agregado", "none"});
  CHECK(add(Tipo::soy_plano, 0, not_unit, 0, 0) == Pair{"vector_no_unitario", "Agregar_Plano.pre.2"});
  CHECK(add(Tipo::soy_disco, 2, axis, 0, 0) == Pair{"elemento_agregado", "none"});
  CHECK(add(Tipo::soy_disco, 0, axis, 0, 0) == Pair{"radio_no_positivo", "Agregar_Disco.pre.2"});
  CHECK(add(Tipo::soy_triangulo, 0, not_unit, 0, 0) == Pair{"vertices_alineados", "Agregar_Triangulo.pre.2"});
  CHECK(answer(Agregar_Elemento{nuevo, Tipo::soy_triangulo, far, 0, not_unit, 0, 0, corners}) ==
        Pair{"elemento_agregado", "none"});
  CHECK(add(Tipo::soy_tronco, 3, axis, 5, 2) == Pair{"elemento_agregado", "none"});
  CHECK(add(Tipo::soy_tronco, 0, axis, 5, 2) == Pair{"radio_no_positivo", "Agregar_Tronco.pre.2"});
  CHECK(add(Tipo::soy_tronco, 3, axis, 5, 0) == Pair{"proporcion_no_positiva", "Agregar_Tronco.pre.3"});
  CHECK(answer(Agregar_Elemento{esfera, Tipo::soy_cono, far, {}, axis, 0, 2}) ==
        Pair{"elemento_ya_existe", "Agregar_Elemento.pre.1"});
}
