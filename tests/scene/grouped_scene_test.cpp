#include "durero/scene/grouped_scene.hpp"

#include "durero/scene/edit.hpp"
#include "support/catch.hpp"

using namespace durero;
using scene::Edit;
using scene::GroupEdit;
using scene::GroupedScene;
using scene::Grouping;

namespace {

Edit ball(const char* name, double radius = 1) {
  return {model::Agregar_Esfera{model::Elemento(name), model::Punto(0, 0, 5), radius}, {}};
}

}  // namespace

TEST_CASE("an element that is removed leaves its group, one that is refused does not, and one that comes is in none") {
  GroupedScene both;
  for (const char* name : {"a", "b"}) REQUIRE(both.apply_total(ball(name)).ok());
  REQUIRE(both.apply_total(GroupEdit{Grouping{"pair", {{"a", "b"}, {}}}}).ok());
  const GroupedScene copy = both;
  CHECK_FALSE(both.apply_total(Edit{model::Eliminar_Cono{model::Elemento("a")}, {}}).ok());
  CHECK(both.groups == copy.groups);
  CHECK(both.apply_total(Edit{model::Eliminar_Elemento{model::Elemento("a")}, {}}).ok());
  CHECK(both.groups.table() == scene::Groups::Table{{"pair", {{"b"}, {}}}});
  CHECK(both.scene.size() == 1);
  CHECK(both.apply_total(ball("a")).ok());
  CHECK(both.groups.of_element("a").empty());
  const scene::Outcome refused = both.apply_total(GroupEdit{Grouping{"new", {{"b"}, {}}}});
  CHECK(refused.violated == &scene::group_pre_4);
  CHECK(copy.groups.of_element("a") == "pair");
}
