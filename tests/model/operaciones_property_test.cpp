// Properties of the operations over random scenes: what a refusal leaves behind, what the total operations answer.

#include <new>

#include "durero/model/operaciones_clauses.hpp"
#include "escenas.hpp"
#include "support/catch.hpp"
#include "support/clauses.hpp"
#include "support/failing_new.hpp"
#include "support/model_gen.hpp"
#include "support/property.hpp"

using namespace durero;
using namespace durero::model;
using namespace durero::test;
using contract::cost;
using contract::evaluation_semantic;
using contract::scoped_semantic;

namespace {

Escena scene_after(const std::vector<Operation>& operations) {
  Escena escena = Init();
  for (const Operation& operation : operations) model::apply_total(escena, operation);
  return escena;
}

/// Whether the label is of what an addition says of t?, which the total operation hides.
bool is_about_t(const std::string& label) {
  return label.starts_with("Agregar_") && label.ends_with(".pre.1") && label != "Agregar_Elemento.pre.1";
}

}  // namespace

TEST_CASE("operations over random scenes") {
  const scoped_semantic audited(cost::audit, evaluation_semantic::enforce);

  property("every scene that is reached satisfies its invariant", [] {
    const Escena escena = scene_after(*any_operations());
    RC_ASSERT(broken(inv(escena)).empty());
    for (const Elemento& e : escena.elementos) RC_ASSERT(broken(inv_at(escena, e)).empty());
  });

  property("the partial operation is done where its preconditions hold, and otherwise changes nothing", [] {
    Escena escena = scene_after(*any_operations());
    const Escena before = escena;
    const Operation operation = *any_operation();
    const auto labels = broken(pre(before, operation));
    const std::string label = violated([&] { model::apply(escena, operation); });
    RC_CLASSIFY(labels.empty(), "done");
    if (labels.empty()) {
      RC_ASSERT(label == "none");
      RC_ASSERT(escena != before);
    } else {
      RC_ASSERT(labels.contains(label));
      RC_ASSERT(escena == before);
    }
  });

  property("the total operation does what the partial one does, and answers the clause that it breaks", [] {
    Escena partial = scene_after(*any_operations()), total = partial;
    const Escena before = partial;
    const Operation operation = *any_operation();
    const std::string label = violated([&] { model::apply(partial, operation); });
    RC_PRE(!is_about_t(label));
    const Answer answer = model::apply_total(total, operation);
    RC_ASSERT(label == (answer.ok() ? "none" : answer.violated->label));
    RC_ASSERT(partial == total);
    if (!answer.ok()) RC_ASSERT(total == before);
  });

  property("what is added can be removed, and the scene is then as it was", [] {
    Escena escena = scene_after(*any_operations());
    const Escena before = escena;
    const Operation operation = *any_operation();
    const Elemento e = std::visit([](const auto& in) { return in.e; }, operation);
    RC_PRE(!before.elementos.contains(e));
    RC_PRE(model::apply_total(escena, operation).ok());
    RC_ASSERT(model::apply_total(escena, Eliminar_Elemento{e}).ok());
    RC_ASSERT(escena == before);
  });
}

TEST_CASE("an operation for which memory runs out changes nothing") {
  const scoped_semantic audited(cost::audit, evaluation_semantic::enforce);
  const Escena before = one_of_each();
  const std::vector<Operation> operations{agregar_esfera,
                                          agregar_cilindro,
                                          agregar_cono,
                                          agregar_tronco,
                                          agregar_plano,
                                          agregar_disco,
                                          agregar_triangulo,
                                          Agregar_Elemento{nuevo, Tipo::soy_cilindro, far, 2, axis, 5},
                                          Eliminar_Esfera{esfera},
                                          Eliminar_Cilindro{cilindro},
                                          Eliminar_Cono{cono},
                                          Eliminar_Tronco{tronco},
                                          Eliminar_Plano{plano},
                                          Eliminar_Disco{disco},
                                          Eliminar_Triangulo{triangulo},
                                          Eliminar_Elemento{cono},
                                          Agregar_Esfera{esfera, far, 2},
                                          Eliminar_Cono{esfera}};
  for (const Operation& operation : operations) {
    Escena escena = before, expected = before;
    const Answer answer = model::apply_total(expected, operation);
    const auto unchanged = [&] { REQUIRE(escena == before); };
    CHECK(fail_every_allocation([&] { model::apply_total(escena, operation); }, unchanged) > 0);
    CHECK(escena == expected);

    escena = before;
    std::string_view label = "none";
    const auto partial = [&] {
      try {
        model::apply(escena, operation);
      } catch (const contract::contract_violation& violation) {
        label = violation.label();
      }
    };
    CHECK(fail_every_allocation(partial, unchanged) > 0);
    CHECK(label == (answer.ok() ? "none" : answer.violated->label));
    CHECK(escena == expected);
  }
}
