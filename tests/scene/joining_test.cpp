#include "durero/scene/joining.hpp"

#include "durero/model/operaciones.hpp"
#include "durero/scene/edit.hpp"
#include "durero/scene/stage.hpp"
#include "support/catch.hpp"

using namespace durero;
using namespace durero::scene;
using Operation = Compound::Operation;

namespace {

Scene two_balls_and_a_disc() {
  Scene scene;
  scene.apply(model::Agregar_Esfera{model::Elemento("a"), {0, 0, 0}, 2});
  scene.apply(model::Agregar_Esfera{model::Elemento("b"), {1, 0, 0}, 2});
  scene.apply(model::Agregar_Disco{model::Elemento("d"), {0, 0, 0}, 1, {0, 0, 1}});
  return scene;
}

std::string_view violated(const Outcome& outcome) { return outcome.ok() ? "none" : outcome.violated->label; }

}  // namespace

TEST_CASE("a solid is made of copies of its parts, in their order") {
  Scene scene = two_balls_and_a_disc();
  scene.stage().materials.push_back({.name = "red"});
  CHECK(apply_total(scene, Joining{Operation::subtracted, "s", {"b", "a"}, 0}).r == "solido_agregado");
  scene.apply_total(Edit{model::Eliminar_Elemento{model::Elemento("a")}});
  const auto element = scene.find("s");
  REQUIRE(element);
  CHECK(scene.material(*element) == 0);
  const auto& solid = std::get<Compound>(scene.body(*element)->form);
  CHECK(solid.operation == Operation::subtracted);
  REQUIRE(solid.parts.size() == 2);
  const auto centre = [&](std::size_t i) {
    return std::get<Sphere>(std::get<Instance>(solid.parts[i].form).shape).centro;
  };
  CHECK(centre(0) == glm::dvec3(1, 0, 0));
  CHECK(centre(1) == glm::dvec3(0, 0, 0));
  CHECK(apply_total(scene, Joining{Operation::united, "t", {"s", "b"}, {}}).ok());
  CHECK(std::holds_alternative<Compound>(std::get<Compound>(scene.body(*scene.find("t"))->form).parts[0].form));
}

TEST_CASE("Agregar_Solido.pre.1, Agregar_Solido.pre.2, Agregar_Solido.pre.3: what is refused changes nothing") {
  Scene scene = two_balls_and_a_disc();
  const auto add = [&](const char* e, std::vector<std::string> de) {
    return violated(apply_total(scene, Joining{Operation::united, e, std::move(de), {}}));
  };
  CHECK(add("a", {"a", "b"}) == "Agregar_Solido.pre.1");
  CHECK(add("s", {"a", "c"}) == "Agregar_Solido.pre.2");
  CHECK(add("s", {"a", "d"}) == "Agregar_Solido.pre.3");
  CHECK(scene.size() == 3);
}

TEST_CASE("Eliminar_Solido.pre.1, Eliminar_Solido.pre.2: a solid is removed, and nothing else") {
  Scene scene = two_balls_and_a_disc();
  apply_total(scene, Joining{Operation::united, "s", {"a", "b"}, {}});
  CHECK(violated(apply_total(scene, SolidRemoval{"t"})) == "Eliminar_Solido.pre.1");
  CHECK(violated(apply_total(scene, SolidRemoval{"a"})) == "Eliminar_Solido.pre.2");
  CHECK(apply_total(scene, SolidRemoval{"s"}).r == "solido_eliminado");
  CHECK(scene.size() == 3);
  CHECK_FALSE(scene.find("s"));
}
