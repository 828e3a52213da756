#include "durero/scene/groups.hpp"

#include "durero/model/operaciones.hpp"
#include "durero/scene/scene.hpp"
#include "support/catch.hpp"

using namespace durero;
using scene::Grouping;
using scene::Groups;
using scene::Outcome;
using scene::Scene;
using scene::Ungrouping;

namespace {

Scene with_elements(std::initializer_list<const char*> names) {
  Scene scene;
  for (const char* name : names) scene.apply(model::Agregar_Esfera{model::Elemento(name), model::Punto(0, 0, 5), 1});
  return scene;
}

/// A scene and its groups, as whoever edits both keeps them.
struct Edited {
  Scene scene;
  Groups groups{};

  std::string operator()(const scene::GroupEdit& edit) {
    const Groups before = groups;
    const Outcome outcome = groups.apply_total(edit, scene);
    if (outcome.ok()) return std::string(outcome.r);
    CHECK(groups == before);
    return std::string(outcome.violated->label);
  }
  void operator()(const model::Operation& operation) {
    if (scene.apply_total(operation).ok()) groups.follow(operation);
  }
};

/// What the tables say of each member, they say of each group too.
void check_both_ways(const Groups& groups) {
  const std::vector<std::string_view> order = groups.bottom_up();
  CHECK(order.size() == groups.table().size());
  for (const auto& [name, group] : groups.table()) {
    for (const std::string& e : group.elementos) CHECK(groups.of_element(e) == name);
    for (const std::string& g : group.groups) {
      CHECK(groups.of_group(g) == name);
      CHECK(std::ranges::find(order, g) < std::ranges::find(order, name));
    }
  }
}

}  // namespace

TEST_CASE("groups are made from small to large, and each refusal has its clause") {
  Edited edited{with_elements({"a", "b", "c", "d"})};
  CHECK(edited.groups.empty());
  CHECK(edited(Grouping{"pair", {{"a", "b"}, {}}}) == "grouped");
  CHECK(edited(Grouping{"row", {{"c"}, {"pair"}}}) == "grouped");
  CHECK(edited(Grouping{"a", {{"d"}, {}}}) == "grouped");  // a group may be called as an element is
  check_both_ways(edited.groups);
  CHECK(edited.groups.of_element("a") == "pair");
  CHECK(edited.groups.of_element("x").empty());
  CHECK(edited.groups.of_group("row").empty());
  CHECK(edited(Grouping{"row", {}}) == "group.pre.1");
  CHECK(edited(Grouping{"new", {{"x"}, {}}}) == "group.pre.2");
  CHECK(edited(Grouping{"new", {{}, {"new"}}}) == "group.pre.3");
  CHECK(edited(Grouping{"new", {{"a"}, {}}}) == "group.pre.4");
  CHECK(edited(Grouping{"new", {{}, {"pair"}}}) == "group.pre.5");
  CHECK(edited(Ungrouping{"new"}) == "ungroup.pre.1");
  CHECK(edited(Grouping{"all", {{}, {"row", "a"}}}) == "grouped");
  check_both_ways(edited.groups);
  CHECK(edited.groups.bottom_up().back() == "all");
}

TEST_CASE("what was in a group that is taken away is in the one above, or in none") {
  Edited edited{with_elements({"a", "b", "c"})};
  edited(Grouping{"inner", {{"a"}, {}}});
  edited(Grouping{"middle", {{"b"}, {"inner"}}});
  edited(Grouping{"outer", {{"c"}, {"middle"}}});
  CHECK(edited(Ungrouping{"middle"}) == "ungrouped");
  check_both_ways(edited.groups);
  CHECK(edited.groups.table().at("outer") == scene::Group{{"b", "c"}, {"inner"}});
  CHECK(edited(Ungrouping{"outer"}) == "ungrouped");
  check_both_ways(edited.groups);
  CHECK(edited.groups.table() == Groups::Table{{"inner", {{"a"}, {}}}});
  CHECK(edited.groups.of_element("c").empty());
  CHECK(edited(Grouping{"new", {{"b", "c"}, {"inner"}}}) == "grouped");
}

TEST_CASE("an element that is removed leaves its group, and one of its name is in none") {
  Edited edited{with_elements({"a", "b"})};
  edited(Grouping{"pair", {{"a", "b"}, {}}});
  edited(model::Eliminar_Esfera{model::Elemento("a")});
  CHECK(edited.groups.table().at("pair") == scene::Group{{"b"}, {}});
  edited(model::Eliminar_Elemento{model::Elemento("b")});
  CHECK(edited.groups.table().at("pair") == scene::Group{});
  edited(model::Agregar_Esfera{model::Elemento("a"), model::Punto(0, 0, 5), 1});
  CHECK(edited.groups.of_element("a").empty());
  edited(model::Eliminar_Elemento{model::Elemento("b")});  // refused
  check_both_ways(edited.groups);
}

TEST_CASE("an element is put into another group, or taken out") {
  Edited of{with_elements({"a", "b", "c"})};
  CHECK(of(Grouping{"one", {{"a"}, {}}}) == "grouped");
  CHECK(of(Grouping{"two", {{"b"}, {}}}) == "grouped");
  of.groups.put("a", "two");
  of.groups.put("c", "two");
  of.groups.put("c", "two");
  CHECK(of.groups.of_element("a") == "two");
  CHECK(of.groups.table().at("one").elementos.empty());
  CHECK(of.groups.table().at("two").elementos == scene::Names{"a", "b", "c"});
  check_both_ways(of.groups);
  of.groups.take_out("b");
  of.groups.take_out("b");
  CHECK(of.groups.of_element("b").empty());
  CHECK(of.groups.table().at("two").elementos == scene::Names{"a", "c"});
  check_both_ways(of.groups);
}
