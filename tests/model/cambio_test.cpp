#include "durero/model/cambio.hpp"

#include <functional>

#include "escenas.hpp"
#include "support/catch.hpp"
#include "support/clauses.hpp"
#include "support/model_gen.hpp"
#include "support/property.hpp"

// A test case an attribute: each precondition broken by an input, each postcondition by a spoiled after-state.

using namespace durero;
using namespace durero::model;
using namespace durero::test;
using contract::cost;

namespace {

const Vector across(1, 0, 0);

/// The label that the change violates on one_of_each(), which must stay as it was.
std::string refused(const AttributeChange& change) {
  Escena escena = one_of_each();
  const std::string label = violated([&] { model::apply(escena, change); });
  CHECK(escena == one_of_each());
  return label;
}

/// What the total change answers on one_of_each(), which stays as it was where it is refused.
std::string answer(const AttributeChange& change) {
  Escena escena = one_of_each();
  const Answer given = model::apply_total(escena, change);
  CHECK(given.ok() == (escena != one_of_each()));
  return std::string(name(given.r)) + (given.ok() ? "" : " " + std::string(given.violated->label));
}

/// The labels that see that the after-state, or the answer, of a change of one_of_each() was spoiled, by whole
/// predicates.
std::set<std::string> spoiled(const AttributeChange& change, const std::function<void(Escena&, Respuesta&)>& spoil) {
  const Escena before = one_of_each();
  Escena after = before;
  Respuesta r = model::apply(after, change);
  for (const cost price : {cost::normal, cost::audit}) CHECK(broken(post(before, change, after, r, price)).empty());
  spoil(after, r);
  return broken(post(before, change, after, r, cost::audit));
}

/// The labels that see that each attribute in turn was spoiled elsewhere, in their order.
std::vector<std::string> spoiled_attributes(const AttributeChange& change) {
  std::vector<std::string> labels;
  for_each_attribute([&](const auto& attribute) {
    const auto seen = spoiled(change, [&](Escena& after, Respuesta&) {
      auto& component = after.*attribute.component;
      component.erase(component.begin()->first == name_of(change) ? std::prev(component.end()) : component.begin());
    });
    labels.insert(labels.end(), seen.begin(), seen.end());
  });
  return labels;
}

using Labels = std::vector<std::string>;

/// What every change says of names and types, and of its answer.
void check_frame(const AttributeChange& change) {
  CHECK(spoiled(change, [](Escena& after, Respuesta&) { after.elementos.insert(nuevo); }) ==
        std::set<std::string>{"Cambiar_Elemento.post.1"});
  CHECK(spoiled(change, [](Escena& after, Respuesta&) { after.de_que_tipo.at(esfera) = Tipo::soy_cono; }) ==
        std::set<std::string>{"Cambiar_Elemento.post.2"});
  CHECK(spoiled(change, [](Escena&, Respuesta& r) { r = Respuesta::elemento_agregado; }) ==
        std::set<std::string>{"Cambiar_Elemento.post.3"});
}

}  // namespace

TEST_CASE("Cambiar_Centro: another value of the attribute, and nothing else") {
  const Cambiar_Centro in{plano, far};
  CHECK(answer(in) == "elemento_cambiado");  // Cambiar_Centro_Total.def.1
  CHECK(refused(Cambiar_Centro{nuevo, far}) == "Cambiar_Elemento.pre.1");
  CHECK(refused(Cambiar_Centro{triangulo, far}) == "Cambiar_Centro.pre.1");
  CHECK(answer(Cambiar_Centro{nuevo, far}) == "elemento_no_existe Cambiar_Elemento.pre.1");
  CHECK(answer(Cambiar_Centro{triangulo, far}) == "tipo_incorrecto Cambiar_Centro.pre.1");
  check_frame(in);
  CHECK(spoiled_attributes(in) == Labels{"Cambiar_Centro.post.1", "Cambiar_Centro.post.2", "Cambiar_Centro.post.3",
                                         "Cambiar_Centro.post.4", "Cambiar_Centro.post.5", "Cambiar_Centro.post.6"});
  CHECK(broken(judgements(one_of_each(), Sin_Centro{nuevo}, Respuesta::hecho)) ==
        std::set<std::string>{"Sin_Centro.pre.1", "Sin_Centro.post.1"});
  CHECK(broken(judgements(one_of_each(), Sin_Centro{plano}, Sin_Centro::answer)) ==
        std::set<std::string>{"Sin_Centro.pre.2"});
}

TEST_CASE("Cambiar_Radio: another value of the attribute, and nothing else") {
  const Cambiar_Radio in{esfera, 2};
  CHECK(answer(in) == "elemento_cambiado");  // Cambiar_Radio_Total.def.1
  CHECK(refused(Cambiar_Radio{nuevo, 2}) == "Cambiar_Elemento.pre.1");
  CHECK(refused(Cambiar_Radio{plano, 2}) == "Cambiar_Radio.pre.1");
  CHECK(refused(Cambiar_Radio{esfera, 0}) == "Cambiar_Radio.pre.2");
  CHECK(answer(Cambiar_Radio{nuevo, 2}) == "elemento_no_existe Cambiar_Elemento.pre.1");
  CHECK(answer(Cambiar_Radio{plano, 2}) == "tipo_incorrecto Cambiar_Radio.pre.1");
  check_frame(in);
  CHECK(spoiled_attributes(in) == Labels{"Cambiar_Radio.post.2", "Cambiar_Radio.post.1", "Cambiar_Radio.post.3",
                                         "Cambiar_Radio.post.4", "Cambiar_Radio.post.5", "Cambiar_Radio.post.6"});
  CHECK(broken(judgements(one_of_each(), Sin_Radio{nuevo}, Respuesta::hecho)) ==
        std::set<std::string>{"Sin_Radio.pre.1", "Sin_Radio.post.1"});
  CHECK(broken(judgements(one_of_each(), Sin_Radio{esfera}, Sin_Radio::answer)) ==
        std::set<std::string>{"Sin_Radio.pre.2"});
}

TEST_CASE("Cambiar_Vector: another value of the attribute, and nothing else") {
  const Cambiar_Vector in{disco, across};
  CHECK(answer(in) == "elemento_cambiado");  // Cambiar_Vector_Total.def.1
  CHECK(refused(Cambiar_Vector{nuevo, across}) == "Cambiar_Elemento.pre.1");
  CHECK(refused(Cambiar_Vector{esfera, across}) == "Cambiar_Vector.pre.1");
  CHECK(refused(Cambiar_Vector{disco, not_unit}) == "Cambiar_Vector.pre.2");
  CHECK(answer(Cambiar_Vector{nuevo, across}) == "elemento_no_existe Cambiar_Elemento.pre.1");
  CHECK(answer(Cambiar_Vector{esfera, across}) == "tipo_incorrecto Cambiar_Vector.pre.1");
  check_frame(in);
  CHECK(spoiled_attributes(in) == Labels{"Cambiar_Vector.post.2", "Cambiar_Vector.post.3", "Cambiar_Vector.post.1",
                                         "Cambiar_Vector.post.4", "Cambiar_Vector.post.5", "Cambiar_Vector.post.6"});
  CHECK(broken(judgements(one_of_each(), Sin_Vector{nuevo}, Respuesta::hecho)) ==
        std::set<std::string>{"Sin_Vector.pre.1", "Sin_Vector.post.1"});
  CHECK(broken(judgements(one_of_each(), Sin_Vector{disco}, Sin_Vector::answer)) ==
        std::set<std::string>{"Sin_Vector.pre.2"});
}

TEST_CASE("Cambiar_Altura: another value of the attribute, and nothing else") {
  const Cambiar_Altura in{cono, 7};
  CHECK(answer(in) == "elemento_cambiado");  // Cambiar_Altura_Total.def.1
  CHECK(refused(Cambiar_Altura{nuevo, 7}) == "Cambiar_Elemento.pre.1");
  CHECK(refused(Cambiar_Altura{disco, 7}) == "Cambiar_Altura.pre.1");
  CHECK(refused(Cambiar_Altura{cono, -1}) == "Cambiar_Altura.pre.2");
  CHECK(answer(Cambiar_Altura{nuevo, 7}) == "elemento_no_existe Cambiar_Elemento.pre.1");
  CHECK(answer(Cambiar_Altura{disco, 7}) == "tipo_incorrecto Cambiar_Altura.pre.1");
  check_frame(in);
  CHECK(spoiled_attributes(in) == Labels{"Cambiar_Altura.post.2", "Cambiar_Altura.post.3", "Cambiar_Altura.post.4",
                                         "Cambiar_Altura.post.1", "Cambiar_Altura.post.5", "Cambiar_Altura.post.6"});
  CHECK(broken(judgements(one_of_each(), Sin_Altura{nuevo}, Respuesta::hecho)) ==
        std::set<std::string>{"Sin_Altura.pre.1", "Sin_Altura.post.1"});
  CHECK(broken(judgements(one_of_each(), Sin_Altura{cono}, Sin_Altura::answer)) ==
        std::set<std::string>{"Sin_Altura.pre.2"});
}

TEST_CASE("Cambiar_Proporcion: another value of the attribute, and nothing else") {
  const Cambiar_Proporcion in{tronco, 0.25};
  CHECK(answer(in) == "elemento_cambiado");  // Cambiar_Proporcion_Total.def.1
  CHECK(refused(Cambiar_Proporcion{nuevo, 0.25}) == "Cambiar_Elemento.pre.1");
  CHECK(refused(Cambiar_Proporcion{cilindro, 0.25}) == "Cambiar_Proporcion.pre.1");
  CHECK(refused(Cambiar_Proporcion{tronco, 0}) == "Cambiar_Proporcion.pre.2");
  CHECK(answer(Cambiar_Proporcion{nuevo, 0.25}) == "elemento_no_existe Cambiar_Elemento.pre.1");
  CHECK(answer(Cambiar_Proporcion{cilindro, 0.25}) == "tipo_incorrecto Cambiar_Proporcion.pre.1");
  check_frame(in);
  CHECK(spoiled_attributes(in) == Labels{"Cambiar_Proporcion.post.2", "Cambiar_Proporcion.post.3",
                                         "Cambiar_Proporcion.post.4", "Cambiar_Proporcion.post.5",
                                         "Cambiar_Proporcion.post.1", "Cambiar_Proporcion.post.6"});
  CHECK(broken(judgements(one_of_each(), Sin_Proporcion{nuevo}, Respuesta::hecho)) ==
        std::set<std::string>{"Sin_Proporcion.pre.1", "Sin_Proporcion.post.1"});
  CHECK(broken(judgements(one_of_each(), Sin_Proporcion{tronco}, Sin_Proporcion::answer)) ==
        std::set<std::string>{"Sin_Proporcion.pre.2"});
}

TEST_CASE("Cambiar_Vertices: another value of the attribute, and nothing else") {
  const Cambiar_Vertices in{triangulo, other_corners};
  CHECK(answer(in) == "elemento_cambiado");  // Cambiar_Vertices_Total.def.1
  CHECK(refused(Cambiar_Vertices{nuevo, other_corners}) == "Cambiar_Elemento.pre.1");
  CHECK(refused(Cambiar_Vertices{cono, other_corners}) == "Cambiar_Vertices.pre.1");
  CHECK(refused(Cambiar_Vertices{triangulo, aligned}) == "Cambiar_Vertices.pre.2");
  CHECK(answer(Cambiar_Vertices{nuevo, other_corners}) == "elemento_no_existe Cambiar_Elemento.pre.1");
  CHECK(answer(Cambiar_Vertices{cono, other_corners}) == "tipo_incorrecto Cambiar_Vertices.pre.1");
  check_frame(in);
  CHECK(spoiled_attributes(in) == Labels{"Cambiar_Vertices.post.2", "Cambiar_Vertices.post.3",
                                         "Cambiar_Vertices.post.4", "Cambiar_Vertices.post.5",
                                         "Cambiar_Vertices.post.6", "Cambiar_Vertices.post.1"});
  CHECK(broken(judgements(one_of_each(), Sin_Vertices{nuevo}, Respuesta::hecho)) ==
        std::set<std::string>{"Sin_Vertices.pre.1", "Sin_Vertices.post.1"});
  CHECK(broken(judgements(one_of_each(), Sin_Vertices{triangulo}, Sin_Vertices::answer)) ==
        std::set<std::string>{"Sin_Vertices.pre.2"});
}

TEST_CASE("a change that names a type: Cambio_Total.def.1 with Es_…") {
  const auto check = [](const AttributeChange& right, const AttributeChange& wrong, const std::string& name,
                        const std::string& clause) {
    CHECK(schema_name(right) == name);
    CHECK(total_name(right) == name + "_Total");
    CHECK(answer(right) == "elemento_cambiado");
    CHECK(answer(wrong) == "tipo_incorrecto " + clause);
    CHECK(refused(wrong) == clause);
  };
  // Cambiar_Centro_Esfera.def.1, Cambiar_Centro_Esfera_Total.def.1
  check(Cambiar_Centro{esfera, far, Tipo::soy_esfera}, Cambiar_Centro{cilindro, far, Tipo::soy_esfera},
        "Cambiar_Centro_Esfera", "Es_Esfera.pre.1");
  // Cambiar_Radio_Esfera.def.1, Cambiar_Radio_Esfera_Total.def.1
  check(Cambiar_Radio{esfera, 2, Tipo::soy_esfera}, Cambiar_Radio{cilindro, 2, Tipo::soy_esfera},
        "Cambiar_Radio_Esfera", "Es_Esfera.pre.1");
  // Cambiar_Centro_Cilindro.def.1, Cambiar_Centro_Cilindro_Total.def.1
  check(Cambiar_Centro{cilindro, far, Tipo::soy_cilindro}, Cambiar_Centro{esfera, far, Tipo::soy_cilindro},
        "Cambiar_Centro_Cilindro", "Es_Cilindro.pre.1");
  // Cambiar_Radio_Cilindro.def.1, Cambiar_Radio_Cilindro_Total.def.1
  check(Cambiar_Radio{cilindro, 2, Tipo::soy_cilindro}, Cambiar_Radio{esfera, 2, Tipo::soy_cilindro},
        "Cambiar_Radio_Cilindro", "Es_Cilindro.pre.1");
  // Cambiar_Vector_Cilindro.def.1, Cambiar_Vector_Cilindro_Total.def.1
  check(Cambiar_Vector{cilindro, across, Tipo::soy_cilindro}, Cambiar_Vector{esfera, across, Tipo::soy_cilindro},
        "Cambiar_Vector_Cilindro", "Es_Cilindro.pre.1");
  // Cambiar_Altura_Cilindro.def.1, Cambiar_Altura_Cilindro_Total.def.1
  check(Cambiar_Altura{cilindro, 7, Tipo::soy_cilindro}, Cambiar_Altura{esfera, 7, Tipo::soy_cilindro},
        "Cambiar_Altura_Cilindro", "Es_Cilindro.pre.1");
  // Cambiar_Centro_Cono.def.1, Cambiar_Centro_Cono_Total.def.1
  check(Cambiar_Centro{cono, far, Tipo::soy_cono}, Cambiar_Centro{esfera, far, Tipo::soy_cono}, "Cambiar_Centro_Cono",
        "Es_Cono.pre.1");
  // Cambiar_Vector_Cono.def.1, Cambiar_Vector_Cono_Total.def.1
  check(Cambiar_Vector{cono, across, Tipo::soy_cono}, Cambiar_Vector{esfera, across, Tipo::soy_cono},
        "Cambiar_Vector_Cono", "Es_Cono.pre.1");
  // Cambiar_Altura_Cono.def.1, Cambiar_Altura_Cono_Total.def.1
  check(Cambiar_Altura{cono, 7, Tipo::soy_cono}, Cambiar_Altura{esfera, 7, Tipo::soy_cono}, "Cambiar_Altura_Cono",
        "Es_Cono.pre.1");
  // Cambiar_Proporcion_Cono.def.1, Cambiar_Proporcion_Cono_Total.def.1
  check(Cambiar_Proporcion{cono, 0.25, Tipo::soy_cono}, Cambiar_Proporcion{esfera, 0.25, Tipo::soy_cono},
        "Cambiar_Proporcion_Cono", "Es_Cono.pre.1");
  // Cambiar_Centro_Tronco.def.1, Cambiar_Centro_Tronco_Total.def.1
  check(Cambiar_Centro{tronco, far, Tipo::soy_tronco}, Cambiar_Centro{esfera, far, Tipo::soy_tronco},
        "Cambiar_Centro_Tronco", "Es_Tronco.pre.1");
  // Cambiar_Radio_Tronco.def.1, Cambiar_Radio_Tronco_Total.def.1
  check(Cambiar_Radio{tronco, 2, Tipo::soy_tronco}, Cambiar_Radio{esfera, 2, Tipo::soy_tronco}, "Cambiar_Radio_Tronco",
        "Es_Tronco.pre.1");
  // Cambiar_Vector_Tronco.def.1, Cambiar_Vector_Tronco_Total.def.1
  check(Cambiar_Vector{tronco, across, Tipo::soy_tronco}, Cambiar_Vector{esfera, across, Tipo::soy_tronco},
        "Cambiar_Vector_Tronco", "Es_Tronco.pre.1");
  // Cambiar_Altura_Tronco.def.1, Cambiar_Altura_Tronco_Total.def.1
  check(Cambiar_Altura{tronco, 7, Tipo::soy_tronco}, Cambiar_Altura{esfera, 7, Tipo::soy_tronco},
        "Cambiar_Altura_Tronco", "Es_Tronco.pre.1");
  // Cambiar_Proporcion_Tronco.def.1, Cambiar_Proporcion_Tronco_Total.def.1
  check(Cambiar_Proporcion{tronco, 0.25, Tipo::soy_tronco}, Cambiar_Proporcion{esfera, 0.25, Tipo::soy_tronco},
        "Cambiar_Proporcion_Tronco", "Es_Tronco.pre.1");
  // Cambiar_Centro_Plano.def.1, Cambiar_Centro_Plano_Total.def.1
  check(Cambiar_Centro{plano, far, Tipo::soy_plano}, Cambiar_Centro{esfera, far, Tipo::soy_plano},
        "Cambiar_Centro_Plano", "Es_Plano.pre.1");
  // Cambiar_Vector_Plano.def.1, Cambiar_Vector_Plano_Total.def.1
  check(Cambiar_Vector{plano, across, Tipo::soy_plano}, Cambiar_Vector{esfera, across, Tipo::soy_plano},
        "Cambiar_Vector_Plano", "Es_Plano.pre.1");
  // Cambiar_Centro_Disco.def.1, Cambiar_Centro_Disco_Total.def.1
  check(Cambiar_Centro{disco, far, Tipo::soy_disco}, Cambiar_Centro{esfera, far, Tipo::soy_disco},
        "Cambiar_Centro_Disco", "Es_Disco.pre.1");
  // Cambiar_Radio_Disco.def.1, Cambiar_Radio_Disco_Total.def.1
  check(Cambiar_Radio{disco, 2, Tipo::soy_disco}, Cambiar_Radio{esfera, 2, Tipo::soy_disco}, "Cambiar_Radio_Disco",
        "Es_Disco.pre.1");
  // Cambiar_Vector_Disco.def.1, Cambiar_Vector_Disco_Total.def.1
  check(Cambiar_Vector{disco, across, Tipo::soy_disco}, Cambiar_Vector{esfera, across, Tipo::soy_disco},
        "Cambiar_Vector_Disco", "Es_Disco.pre.1");
  // Cambiar_Vertices_Triangulo.def.1, Cambiar_Vertices_Triangulo_Total.def.1
  check(Cambiar_Vertices{triangulo, other_corners, Tipo::soy_triangulo},
        Cambiar_Vertices{esfera, other_corners, Tipo::soy_triangulo}, "Cambiar_Vertices_Triangulo",
        "Es_Triangulo.pre.1");
}

TEST_CASE("changes over random scenes") {
  const contract::scoped_semantic audited(cost::audit, contract::evaluation_semantic::enforce);
  const auto any_change = [](const Escena& escena) {
    std::vector<Elemento> names(escena.elementos.begin(), escena.elementos.end());
    names.push_back(nuevo);
    const Elemento e = *rc::gen::elementOf(names);
    const double length = *rc::gen::element(0.0, 0.5, 3.0);
    return *rc::gen::element<AttributeChange>(
        Cambiar_Centro{e, far}, Cambiar_Radio{e, length}, Cambiar_Vector{e, across}, Cambiar_Vector{e, not_unit},
        Cambiar_Altura{e, length}, Cambiar_Proporcion{e, length}, Cambiar_Vertices{e, other_corners},
        Cambiar_Vertices{e, aligned}, Cambiar_Radio{e, length, Tipo::soy_disco});
  };

  property("the total change does what the partial one does, or answers the clause that it breaks", [&] {
    Escena escena = Init();
    for (const Operation& operation : *any_operations()) model::apply_total(escena, operation);
    const Escena before = escena;
    const AttributeChange change = any_change(escena);
    const auto labels = broken(pre(before, change));
    const Answer given = model::apply_total(escena, change);
    RC_CLASSIFY(given.ok(), "done");
    RC_ASSERT(given.ok() == labels.empty());
    if (!given.ok()) RC_ASSERT(labels.contains(std::string(given.violated->label)));
    if (!given.ok()) RC_ASSERT(escena == before);
    RC_ASSERT(broken(inv(escena)).empty());
    RC_ASSERT(escena.elementos == before.elementos);
    Escena partial = before;
    RC_ASSERT(violated([&] { model::apply(partial, change); }) == (given.ok() ? "none" : given.violated->label));
    RC_ASSERT(partial == escena);
  });
}
