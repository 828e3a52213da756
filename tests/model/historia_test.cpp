#include "durero/model/historia.hpp"

#include <functional>

#include "escenas.hpp"
#include "mallas.hpp"
#include "support/catch.hpp"
#include "support/clauses.hpp"
#include "support/mallas_gen.hpp"
#include "support/model_gen.hpp"
#include "support/property.hpp"

using namespace durero;
using namespace durero::model;
using namespace durero::test;

namespace {

using Labels = std::set<std::string>;

const Vector across(1, 0, 0);
const Operacion add{Operation(agregar_esfera)}, widen{AttributeChange(Cambiar_Radio{nuevo, 5})},
    remove_cone{Operation(Eliminar_Cono{cono})}, impossible{Operation(Eliminar_Esfera{cono})};

/// Two steps are done and one was undone.
Historia with_past() {
  Historia s = Init_Historia(one_of_each());
  for (const Operacion& op : {add, remove_cone, widen}) model::apply(s, Transaccion{{op}});
  model::apply(s, Deshacer{});
  return s;
}

bool same(const Historia& a, const Historia& b) {
  return a.escena == b.escena && a.inicial == b.inicial && a.hechas.size() == b.hechas.size() &&
         a.deshechas.size() == b.deshechas.size() && pliegue(a.deshechas, a.escena) == pliegue(b.deshechas, b.escena);
}

std::string answer(Historia& s, const HistoryOperation& operation) {
  const Historia before = s;
  const Answer given = model::apply_total(s, operation);
  if (!given.ok()) CHECK(same(s, before));
  return std::string(name(given.r)) + (given.ok() ? "" : " " + std::string(given.violated->label));
}

/// The labels that see that an after-state of with_past(), or its answer, was spoiled.
Labels spoiled(const HistoryOperation& operation, const std::function<void(Historia&, Respuesta&)>& spoil) {
  const Historia before = with_past();
  Historia after = before;
  Respuesta r = model::apply(after, operation);
  CHECK(broken(post(before, operation, after, r)).empty());
  spoil(after, r);
  return broken(post(before, operation, after, r));
}

ElementOperation any_element_operation(const Escena& escena) {
  if (escena.elementos.empty() || *rc::gen::inRange(0, 3) == 0) return Operation(*any_operation());
  const Elemento e = *rc::gen::elementOf(std::vector<Elemento>(escena.elementos.begin(), escena.elementos.end()));
  const double length = *rc::gen::element(0.5, 3.0);
  return *rc::gen::element<AttributeChange>(Cambiar_Centro{e, far}, Cambiar_Radio{e, length}, Cambiar_Vector{e, across},
                                            Cambiar_Altura{e, length}, Cambiar_Proporcion{e, length},
                                            Cambiar_Vertices{e, other_corners});
}

}  // namespace

TEST_CASE("what undoes an operation is an operation") {
  property("of elements: the inverse gives the scene back, and is a transition", [] {
    Escena escena = Init();
    for (const Operation& operation : *any_operations()) model::apply_total(escena, operation);
    const Escena before = escena;
    const ElementOperation operation = any_element_operation(escena);
    RC_PRE(apply_either(escena, operation).ok());
    const Escena after = escena;
    RC_ASSERT(apply_either(escena, inverse(before, operation)).ok());
    RC_ASSERT(escena == before);
    // transiciones.def.1: both ways.
    RC_ASSERT(transition(before, after).has_value());
    RC_ASSERT(transition(after, before).has_value());
  });

  property("of meshes", [] {
    Mallas s = any_scene_with_meshes();
    const Mallas before = s;
    const MeshOperation operation = *any_mesh_operation();
    RC_PRE(model::apply_total(s, operation).ok());
    RC_ASSERT(model::apply_total(s, inverse(before, operation)).ok());
    RC_ASSERT(s == before);
  });
}

TEST_CASE("transiciones: one operation, and no two") {
  const Escena one = one_of_each();
  const auto after = [&](const Operacion& op) { return pliegue({op}, one).value(); };
  CHECK(transition(one, after(add)).has_value());
  CHECK(transition(one, one).has_value());  // to the value that an element has
  CHECK(!transition(Init(), Init()).has_value());
  CHECK(!transition(one, pliegue({add, remove_cone}, one).value()).has_value());
  CHECK(!transition(one, pliegue({add, widen, {AttributeChange(Cambiar_Centro{esfera, far})}}, one).value()));
  Escena two = one;
  two.mi_radio.at(esfera) = Rmas(8);
  CHECK(transition(one, two).has_value());
  two.mi_centro.at(esfera) = far;
  CHECK(!transition(one, two).has_value());
  Escena retyped = one;
  retyped.de_que_tipo.at(plano) = Tipo::soy_disco;
  retyped.mi_radio.emplace(plano, 1);
  CHECK(!transition(one, retyped).has_value());
}

// Cambio_Mallas.def.1
TEST_CASE("no triangle of a mesh is changed alone") {
  Mallas s = with_square();
  const Mallas before = s;
  const Elemento face = *de_malla(s).begin();
  CHECK(model::apply_total(s, Cambiar_Vertices{face, other_corners}) ==
        Answer{Respuesta::es_de_malla, &Fuera_De_Malla_pre_1});
  CHECK(s == before);
  model::apply_total(s, Operation(agregar_esfera));
  CHECK(model::apply_total(s, Cambiar_Radio{nuevo, 7}).ok());
  CHECK(s.escena.mi_radio.at(nuevo) == Rmas(7));
  CHECK(s.mallas == before.mallas);
}

TEST_CASE("pliegue: the steps one after the other") {
  const Escena one = one_of_each();
  CHECK(pliegue({}, one) == one);                                                      // pliegue.def.1
  CHECK(pliegue({add, widen}, one) == pliegue({widen}, pliegue({add}, one).value()));  // pliegue.def.2
  CHECK(!pliegue({add, impossible, widen}, one));
  // Operacion.def.1: several operations are one step.
  CHECK(pliegue({{add[0], widen[0]}}, one) == pliegue({add, widen}, one));
}

TEST_CASE("Historia: the scene is the fold of what is done") {
  CHECK(broken(inv(with_past())).empty());
  Historia s = with_past();
  s.hechas.pop_back();
  CHECK(broken(inv(s)) == Labels{"Historia.inv.1"});
  s = with_past();
  s.deshechas.push_back(impossible);
  CHECK(broken(inv(s)) == Labels{"Historia.inv.2"});
}

TEST_CASE("Init_Historia") {
  const Historia first = Init_Historia(one_of_each());
  CHECK(broken(inv(first)).empty());
  const auto seen = [&](auto spoil) {
    Historia s = first;
    spoil(s);
    return broken(Init_Historia_post(s));
  };
  CHECK(seen([](Historia& s) { s.inicial = Init(); }) == Labels{"Init_Historia.post.1"});
  CHECK(seen([](Historia& s) { s.hechas.emplace_back(); }) == Labels{"Init_Historia.post.2"});
  CHECK(seen([](Historia& s) { s.deshechas.emplace_back(); }) == Labels{"Init_Historia.post.3"});
}

TEST_CASE("Seguir: what every operation on a history leaves") {
  const auto other_scene = [](Historia& s, Respuesta&) { s.escena = Init(); };
  for (const HistoryOperation& operation : std::vector<HistoryOperation>{Deshacer{}, Rehacer{}, Transaccion{{}}}) {
    CHECK(spoiled(operation, [](Historia& s, Respuesta&) { s.inicial = Init(); }).contains("Seguir.post.1"));
    CHECK(spoiled(operation, other_scene).contains("Seguir.post.2"));
  }
}

TEST_CASE("Transaccion: all steps, or none") {
  Historia s = with_past();
  CHECK(answer(s, Transaccion{{widen, {AttributeChange(Cambiar_Centro{esfera, far})}}}) == "hecho");
  CHECK(s.hechas.size() == 3);
  CHECK(s.deshechas.empty());
  CHECK(s.escena.mi_centro.at(esfera) == far);
  // Transaccion_Total.def.1, Transaccion_Rechazada.pre.1, Transaccion_Rechazada.post.1
  CHECK(answer(s, Transaccion{{remove_cone}}) == "transaccion_rechazada Transaccion.pre.1");
  CHECK(answer(s, Transaccion{{{AttributeChange(Cambiar_Radio{esfera, 9})}, impossible}}) ==
        "transaccion_rechazada Transaccion.pre.1");
  CHECK(s.escena.mi_radio.at(esfera) == Rmas(1));
  CHECK(violated([&] { model::apply(s, Transaccion{{impossible}}); }) == "Transaccion.pre.1");
  const Transaccion in{{widen}};
  CHECK(spoiled(in, [](Historia& h, Respuesta&) { h.hechas.back() = {}; }).contains("Transaccion.post.1"));
  CHECK(spoiled(in, [](Historia& h, Respuesta&) { h.deshechas = {add}; }) == Labels{"Transaccion.post.2"});
  CHECK(spoiled(in, [](Historia&, Respuesta& r) { r = Respuesta::deshecho; }) == Labels{"Transaccion.post.3"});
}

TEST_CASE("Deshacer, Rehacer: back, and forth") {
  Historia s = with_past();
  CHECK(answer(s, Rehacer{}) == "rehecho");
  CHECK(s.escena.mi_radio.at(nuevo) == Rmas(5));
  // Rehacer_Total.def.1, Nada_Que_Rehacer.pre.1, Nada_Que_Rehacer.post.1
  CHECK(answer(s, Rehacer{}) == "nada_que_rehacer Rehacer.pre.1");
  for (int i = 0; i < 3; ++i) CHECK(answer(s, Deshacer{}) == "deshecho");
  CHECK(s.escena == one_of_each());
  // Deshacer_Total.def.1, Nada_Que_Deshacer.pre.1, Nada_Que_Deshacer.post.1
  CHECK(answer(s, Deshacer{}) == "nada_que_deshacer Deshacer.pre.1");
  CHECK(violated([&] { model::apply(s, Deshacer{}); }) == "Deshacer.pre.1");
  s = Init_Historia(one_of_each());
  CHECK(violated([&] { model::apply(s, Rehacer{}); }) == "Rehacer.pre.1");

  CHECK(spoiled(Deshacer{}, [](Historia& h, Respuesta&) { h.hechas.back() = {}; }).contains("Deshacer.post.1"));
  CHECK(spoiled(Deshacer{}, [](Historia& h, Respuesta&) { h.deshechas.erase(h.deshechas.begin()); }) ==
        Labels{"Deshacer.post.2"});
  CHECK(spoiled(Deshacer{}, [](Historia&, Respuesta& r) { r = Respuesta::hecho; }) == Labels{"Deshacer.post.3"});
  CHECK(spoiled(Rehacer{}, [](Historia& h, Respuesta&) { h.hechas.pop_back(); }).contains("Rehacer.post.1"));
  CHECK(spoiled(Rehacer{}, [](Historia& h, Respuesta&) { h.deshechas = {add}; }).contains("Rehacer.post.2"));
  CHECK(spoiled(Rehacer{}, [](Historia&, Respuesta& r) { r = Respuesta::hecho; }) == Labels{"Rehacer.post.3"});
}

TEST_CASE("histories over random operations") {
  property("to undo a transaction gives the scene back, to do it again the whole history", [] {
    Historia s = Init_Historia(one_of_each());
    for (int i = *rc::gen::inRange(0, 4); i > 0; --i)
      model::apply_total(s, Transaccion{{{any_element_operation(s.escena)}, {any_element_operation(s.escena)}}});
    const Historia before = s;
    const Answer given = model::apply_total(s, Transaccion{{{any_element_operation(s.escena)}}});
    RC_CLASSIFY(given.ok(), "done");
    if (!given.ok()) {
      RC_ASSERT(same(s, before));
      return;
    }
    const Historia after = s;
    RC_ASSERT(model::apply_total(s, Deshacer{}).ok());
    RC_ASSERT(s.escena == before.escena);
    const Historia undone = s;
    RC_ASSERT(model::apply_total(s, Rehacer{}).ok());
    RC_ASSERT(same(s, after));
    RC_ASSERT(model::apply_total(s, Deshacer{}).ok());
    RC_ASSERT(same(s, undone));
  });
}
