#include "durero/scene/tablas.hpp"

#include "durero/model/operaciones.hpp"
#include "durero/scene/retrieve.hpp"
#include "support/catch.hpp"

using namespace durero;
using namespace durero::model;
using scene::ElementRef;
using scene::Scene;
using scene::Tablas;

namespace {

const Punto origin(0, 0, 0);
const Vector axis(0, 0, 1);
const ElementRef first{Tipo::soy_esfera, 0}, second{Tipo::soy_esfera, 1}, cone{Tipo::soy_cono, 0};

Scene three() {
  Scene scene;
  scene.apply(Agregar_Esfera{Elemento("a"), origin, 1});
  scene.apply(Agregar_Cono{Elemento("k"), Punto(1, 2, 3), 0.5, axis, 3});
  scene.apply(Agregar_Esfera{Elemento("b"), Punto(4, 0, 0), 2});
  return scene;
}

}  // namespace

TEST_CASE("the tables of no element are empty, and count none of each type (Init_Tablas.post.1)") {
  const Tablas tables = tablas(Scene());
  CHECK(tables.lugar.empty());
  CHECK(tables.cuantos.size() == tipo_count);
  for (const auto& [tipo, count] : tables.cuantos) CHECK(count == 0);
}

TEST_CASE(
    "each row has its place, its name and the attributes of its type (Agregar_Fila.post.1, Agregar_Fila.post.2)") {
  const Tablas tables = tablas(three());
  CHECK(tables.lugar ==
        std::map<Elemento, ElementRef>{{Elemento("a"), first}, {Elemento("b"), second}, {Elemento("k"), cone}});
  CHECK(tables.nombres ==
        std::map<ElementRef, Elemento>{{first, Elemento("a")}, {second, Elemento("b")}, {cone, Elemento("k")}});
  CHECK(tables.cuantos.at(Tipo::soy_esfera) == 2);
  CHECK(tables.cuantos.at(Tipo::soy_cono) == 1);
  CHECK(tables.cuantos.at(Tipo::soy_plano) == 0);
  CHECK(tables.centros ==
        std::map<ElementRef, Punto>{{first, origin}, {second, Punto(4, 0, 0)}, {cone, Punto(1, 2, 3)}});
  CHECK(tables.radios == std::map<ElementRef, Rmas>{{first, Rmas(1)}, {second, Rmas(2)}});
  CHECK(tables.vectores == std::map<ElementRef, Vector>{{cone, axis}});
  CHECK(tables.alturas == std::map<ElementRef, Rmas>{{cone, Rmas(3)}});
  CHECK(tables.proporciones == std::map<ElementRef, Rmas>{{cone, Rmas(0.5)}});
  CHECK(tables.ternas.empty());
}

TEST_CASE("what is removed leaves its place to the last row of its table (Quitar_Fila.post.1, mudanza.def.1)") {
  Scene scene = three();
  scene.apply(Eliminar_Esfera{Elemento("a")});
  const Tablas tables = tablas(scene);
  CHECK(tables.lugar == std::map<Elemento, ElementRef>{{Elemento("b"), first}, {Elemento("k"), cone}});
  CHECK(tables.cuantos.at(Tipo::soy_esfera) == 1);
  CHECK(tables.radios == std::map<ElementRef, Rmas>{{first, Rmas(2)}});
  CHECK_FALSE(tables == tablas(three()));
}

TEST_CASE("a column holds the attribute that retrieve makes of it (Retrieve.inv.2 to Retrieve.inv.7)") {
  const Scene scene = three();
  const Tablas tables = tablas(scene);
  const Escena escena = retrieve(scene);
  scene::for_each_column([&](const auto& column) {
    INFO(column.word);
    CHECK((tables.*column.values).size() == (escena.*column.component).size());
    for (const auto& [place, value] : tables.*column.values)
      CHECK((escena.*column.component).at(tables.nombres.at(place)) == value);
  });
}
