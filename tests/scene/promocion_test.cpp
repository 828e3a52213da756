#include "durero/scene/promocion.hpp"

#include "durero/model/operaciones.hpp"
#include "durero/scene/retrieve.hpp"
#include "support/catch.hpp"
#include "support/model_gen.hpp"
#include "support/property.hpp"

using namespace durero;
using namespace durero::model;
using scene::Formas;

namespace {

const Punto origin(0, 0, 0);
const Vector axis(0, 0, 1);
const Elemento a("a"), b("b");

Formas one_sphere() {
  Formas formas;
  apply_lifted(formas, Agregar_Esfera{a, origin, 2});
  return formas;
}

}  // namespace

TEST_CASE("no shapes are the first scene (Init_Formas.def.1), and of it") {
  CHECK(retrieve(Formas()) == Init());
  CHECK(formas(scene::Scene()).forma.empty());
}

TEST_CASE("a shape keeps the attributes of its type, and says them (Esfera.def.1, Recobro.inv.2, Recobro.inv.3)") {
  const Formas shapes = one_sphere();
  REQUIRE(shapes.forma.size() == 1);
  const auto* sphere = std::get_if<scene::Sphere>(&shapes.forma.at(a));
  REQUIRE(sphere != nullptr);
  CHECK(sphere->radio == 2);
  const Escena escena = retrieve(shapes);
  CHECK(escena.de_que_tipo.at(a) == Tipo::soy_esfera);
  CHECK(escena.mi_radio.at(a) == Rmas(2));
  CHECK(escena.mi_vector.empty());
}

TEST_CASE("a name in use gets no other shape, and an input that its type does not admit makes none") {
  Formas shapes = one_sphere();
  CHECK_FALSE(apply_lifted(shapes, Agregar_Plano{a, origin, axis}));
  CHECK_FALSE(apply_lifted(shapes, Agregar_Esfera{b, origin, 0}));
  CHECK_FALSE(apply_lifted(shapes, Agregar_Plano{b, origin, Vector(0, 0, 2)}));
  CHECK(retrieve(shapes) == retrieve(one_sphere()));
}

TEST_CASE("a shape is removed as what it is") {
  Formas shapes = one_sphere();
  CHECK_FALSE(apply_lifted(shapes, Eliminar_Plano{a}));
  CHECK_FALSE(apply_lifted(shapes, Eliminar_Esfera{b}));
  CHECK_FALSE(apply_lifted(shapes, Eliminar_Elemento{b}));
  CHECK(shapes.forma.size() == 1);
  CHECK(apply_lifted(shapes, Eliminar_Esfera{a}) == Respuesta::esfera_eliminada);
  CHECK(shapes.forma.empty());
}

TEST_CASE("a lifted operation does to the shapes what the program does to the scene (Retrato.inv.1)") {
  test::property("any edits", [] {
    scene::Scene scene;
    Formas shapes;
    for (const Operation& operation : *test::any_operations()) {
      const Answer answer = scene.apply_total(operation);
      const auto lifted = apply_lifted(shapes, operation);
      RC_ASSERT(lifted.has_value() == answer.ok());
      if (lifted) RC_ASSERT(*lifted == answer.r);
      RC_ASSERT(retrieve(shapes) == retrieve(scene));
      RC_ASSERT(retrieve(formas(scene)) == retrieve(scene));
    }
  });
}
