#include "durero/model/vista.hpp"

#include <functional>

#include "escenas.hpp"
#include "support/catch.hpp"
#include "support/clauses.hpp"
#include "support/property.hpp"

// A test case a schema: each invariant and precondition broken, each postcondition by a spoiled after-state.

using namespace durero;
using namespace durero::model;
using namespace durero::test;

namespace {

using Labels = std::set<std::string>;

/// One element of each type, a sphere that is red and in a group, and a cone that is in another.
Vista with_looks() {
  return {one_of_each(), {"pair", "rest"}, {"blue", "red"}, {{esfera, "pair"}, {cono, "rest"}}, {{esfera, "red"}}};
}

std::string refused(const LookChange& change) {
  Vista s = with_looks();
  const std::string label = violated([&] { model::apply(s, change); });
  CHECK(s == with_looks());
  return label;
}

std::string answer(const LookChange& change) {
  Vista s = with_looks();
  const Answer given = model::apply_total(s, change);
  CHECK((given.ok() || s == with_looks()));
  return std::string(name(given.r)) + (given.ok() ? "" : " " + std::string(given.violated->label));
}

/// The labels that see each component spoiled in turn, and then the answer.
std::vector<std::string> spoiled(const LookChange& change) {
  const Vista before = with_looks();
  const std::vector<std::function<void(Vista&, Respuesta&)>> spoils{
      [](Vista& s, Respuesta&) { s.grupos.insert("new"); }, [](Vista& s, Respuesta&) { s.materiales.erase("blue"); },
      [](Vista& s, Respuesta&) { s.mi_grupo.emplace(plano, "rest"); },
      [](Vista& s, Respuesta&) { s.mi_material.emplace(plano, "red"); },
      [](Vista&, Respuesta& r) { r = Respuesta::hecho; }};
  std::vector<std::string> labels;
  for (const auto& spoil : spoils) {
    Vista after = before;
    Respuesta r = model::apply(after, change);
    CHECK(broken(post(before, change, after, r)).empty());
    spoil(after, r);
    const Labels seen = broken(post(before, change, after, r));
    labels.insert(labels.end(), seen.begin(), seen.end());
  }
  return labels;
}

using Seen = std::vector<std::string>;

}  // namespace

TEST_CASE("Vista: groups and materials are of elements, and known") {
  CHECK(broken(inv(with_looks())).empty());
  const auto seen = [](auto spoil) {
    Vista s = with_looks();
    spoil(s);
    return broken(inv(s));
  };
  CHECK(seen([](Vista& s) { s.mi_grupo.emplace(nuevo, "rest"); }) == Labels{"Vista.inv.1"});
  CHECK(seen([](Vista& s) { s.mi_grupo.at(cono) = "none"; }) == Labels{"Vista.inv.2"});
  CHECK(seen([](Vista& s) { s.mi_material.emplace(nuevo, "red"); }) == Labels{"Vista.inv.3"});
  CHECK(seen([](Vista& s) { s.mi_material.at(esfera) = "none"; }) == Labels{"Vista.inv.4"});
}

TEST_CASE("Cambiar_Material") {
  CHECK(answer(Cambiar_Material{cono, "blue"}) == "elemento_cambiado");  // Cambiar_Material_Total.def.1
  CHECK(refused(Cambiar_Material{nuevo, "blue"}) == "Cambiar_Material.pre.1");
  CHECK(refused(Cambiar_Material{cono, "green"}) == "Cambiar_Material.pre.2");
  // Nadie_Se_Llama.pre.1, Nadie_Se_Llama.post.1, Material_No_Existe.pre.1, Material_No_Existe.post.1
  CHECK(answer(Cambiar_Material{nuevo, "blue"}) == "elemento_no_existe Cambiar_Material.pre.1");
  CHECK(answer(Cambiar_Material{cono, "green"}) == "material_no_existe Cambiar_Material.pre.2");
  CHECK(answer(Cambiar_Material{nuevo, "green"}) == "elemento_no_existe Cambiar_Material.pre.1");
  CHECK(spoiled(Cambiar_Material{cono, "blue"}) == Seen{"Cambiar_Material.post.1", "Cambiar_Material.post.2",
                                                        "Cambiar_Material.post.3", "Cambiar_Material.post.4",
                                                        "Cambiar_Material.post.5"});
  Vista s = with_looks();
  model::apply(s, Cambiar_Material{esfera, "blue"});
  CHECK(s.mi_material == std::map<Elemento, Nombre>{{esfera, "blue"}});
}

TEST_CASE("Quitar_Material") {
  CHECK(answer(Quitar_Material{esfera}) == "elemento_cambiado");  // Quitar_Material_Total.def.1
  CHECK(refused(Quitar_Material{nuevo}) == "Quitar_Material.pre.1");
  CHECK(answer(Quitar_Material{nuevo}) == "elemento_no_existe Quitar_Material.pre.1");
  CHECK(spoiled(Quitar_Material{esfera}) == Seen{"Quitar_Material.post.1", "Quitar_Material.post.2",
                                                 "Quitar_Material.post.3", "Quitar_Material.post.4",
                                                 "Quitar_Material.post.5"});
  Vista s = with_looks();
  model::apply(s, Quitar_Material{esfera});
  CHECK(s.mi_material.empty());
}

TEST_CASE("Cambiar_Grupo") {
  CHECK(answer(Cambiar_Grupo{disco, "pair"}) == "elemento_cambiado");  // Cambiar_Grupo_Total.def.1
  CHECK(refused(Cambiar_Grupo{nuevo, "pair"}) == "Cambiar_Grupo.pre.1");
  CHECK(refused(Cambiar_Grupo{disco, "none"}) == "Cambiar_Grupo.pre.2");
  CHECK(answer(Cambiar_Grupo{nuevo, "pair"}) == "elemento_no_existe Cambiar_Grupo.pre.1");
  // Grupo_No_Existe.pre.1, Grupo_No_Existe.post.1
  CHECK(answer(Cambiar_Grupo{disco, "none"}) == "grupo_no_existe Cambiar_Grupo.pre.2");
  CHECK(spoiled(Cambiar_Grupo{disco, "pair"}) == Seen{"Cambiar_Grupo.post.1", "Cambiar_Grupo.post.2",
                                                      "Cambiar_Grupo.post.3", "Cambiar_Grupo.post.4",
                                                      "Cambiar_Grupo.post.5"});
  Vista s = with_looks();
  model::apply(s, Cambiar_Grupo{esfera, "rest"});
  CHECK(s.mi_grupo == std::map<Elemento, Nombre>{{esfera, "rest"}, {cono, "rest"}});
}

TEST_CASE("Quitar_Grupo") {
  CHECK(answer(Quitar_Grupo{esfera}) == "elemento_cambiado");  // Quitar_Grupo_Total.def.1
  CHECK(refused(Quitar_Grupo{nuevo}) == "Quitar_Grupo.pre.1");
  CHECK(answer(Quitar_Grupo{nuevo}) == "elemento_no_existe Quitar_Grupo.pre.1");
  CHECK(spoiled(Quitar_Grupo{esfera}) == Seen{"Quitar_Grupo.post.1", "Quitar_Grupo.post.2", "Quitar_Grupo.post.3",
                                              "Quitar_Grupo.post.4", "Quitar_Grupo.post.5"});
  Vista s = with_looks();
  model::apply(s, Quitar_Grupo{esfera});
  CHECK(s.mi_grupo == std::map<Elemento, Nombre>{{cono, "rest"}});
}

// Mismo_Aspecto.post.1, Mismo_Aspecto.post.2, Mismo_Aspecto.post.3, Mismo_Aspecto.post.4
TEST_CASE("an operation on elements leaves the looks of those that stay") {
  Vista s = with_looks();
  CHECK(model::apply_total(s, Operation(agregar_esfera)).ok());  // Agregar_Elemento_Vista.def.1
  CHECK(s.mi_grupo == with_looks().mi_grupo);
  CHECK(model::apply_total(s, AttributeChange(Cambiar_Radio{esfera, 2})).ok());  // Cambio_Vista.def.1
  CHECK(s.mi_grupo == with_looks().mi_grupo);
  CHECK(s.mi_material == with_looks().mi_material);
  CHECK(model::apply_total(s, Operation(Eliminar_Elemento{esfera})).ok());  // Eliminar_Elemento_Vista.def.1
  CHECK(s.mi_grupo == std::map<Elemento, Nombre>{{cono, "rest"}});
  CHECK(s.mi_material.empty());
  CHECK(s.grupos == with_looks().grupos);
  CHECK(s.materiales == with_looks().materiales);
  const Vista before = s;
  CHECK(!model::apply_total(s, Operation(Eliminar_Elemento{esfera})).ok());
  CHECK(s == before);
}
