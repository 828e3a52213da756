#include "durero/scene/element_record.hpp"

#include "durero/model/cambio.hpp"
#include "durero/model/vista.hpp"
#include "durero/scene/copying.hpp"
#include "durero/scene/edit.hpp"
#include "durero/scene/mesh_edit.hpp"
#include "durero/scene/retrieve.hpp"
#include "durero/scene/stage.hpp"
#include "support/catch.hpp"

using namespace durero;
using model::Elemento;
using scene::GroupedScene;

namespace {

/// A red triangle with coordinates, normals and a motion, and a sphere: both in a group.
GroupedScene with_looks() {
  GroupedScene of;
  of.scene.stage().materials = {{"blue", {0, 0, 1}}, {"red", {1, 0, 0}}};
  of.scene.apply(model::Agregar_Triangulo{Elemento("t"), {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}});
  of.scene.apply(model::Agregar_Esfera{Elemento("s"), {0, 0, 5}, 1});
  const auto t = of.scene.find("t").value();
  of.scene.set_material(t, 1);
  of.scene.set_wrap(t, scene::Wrap{{{{0, 0}, {1, 0}, {0, 1}}}});
  of.scene.set_vertex_normals(t, {glm::dvec3(0, 0, 1), glm::dvec3(0, 0, 1), glm::dvec3(0, 1, 1)});
  of.scene.set_motion(t, {0, 0, 2});
  of.apply_total(scene::GroupEdit(scene::Grouping{"pair", {{"s", "t"}, {}}}));
  return of;
}

void check_same(const GroupedScene& a, const GroupedScene& b) {
  CHECK(scene::retrieve(a.scene) == scene::retrieve(b.scene));
  CHECK(a.groups == b.groups);
  for (const char* name : {"t", "s"}) {
    const auto one = a.scene.find(name), other = b.scene.find(name);
    REQUIRE(one.has_value());
    CHECK(a.scene.material(*one) == b.scene.material(*other));
    CHECK((a.scene.wrap(*one).has_value() == b.scene.wrap(*other).has_value()));
    CHECK((a.scene.vertex_normals(*one).has_value() == b.scene.vertex_normals(*other).has_value()));
    CHECK((a.scene.motion(*one) == nullptr) == (b.scene.motion(*other) == nullptr));
  }
}

}  // namespace

TEST_CASE("an element comes back with its looks and into its group") {
  GroupedScene of = with_looks();
  for (const char* name : {"t", "s"}) {
    const auto record = scene::record_of(of, name);
    of.apply_total(scene::Edit{model::Eliminar_Elemento{Elemento(name)}, {}});
    CHECK(!of.scene.find(name));
    restore(of, record);
    check_same(of, with_looks());
  }
  // Another element of the name leaves.
  const auto record = scene::record_of(of, "s");
  of.change_total(model::AttributeChange(model::Cambiar_Radio{Elemento("s"), 7}));
  of.change_looks(model::LookChange(model::Quitar_Grupo{Elemento("s")}));
  of.change_looks(model::LookChange(model::Cambiar_Material{Elemento("s"), "red"}));
  restore(of, record);
  check_same(of, with_looks());
}

TEST_CASE("a name that nothing bore is borne by nothing again") {
  GroupedScene of = with_looks();
  const auto record = scene::record_of(of, "new");
  CHECK(!record.element);
  of.scene.apply(model::Agregar_Esfera{Elemento("new"), {0, 0, 5}, 1});
  restore(of, record);
  CHECK(!of.scene.find("new"));
  check_same(of, with_looks());
}

TEST_CASE("a body comes back as it was") {
  GroupedScene of = with_looks();
  const model::Mapa twice{model::ExactVector(model::Vector(0, 0, 0)), model::ExactVector(model::Vector(2, 0, 0)),
                          model::ExactVector(model::Vector(0, 2, 0)), model::ExactVector(model::Vector(0, 0, 2))};
  REQUIRE(scene::apply_total(of.scene, scene::Copying{"copy", "s", twice, 0}).ok());
  const auto record = scene::record_of(of, "copy");
  of.apply_total(scene::Edit{model::Eliminar_Elemento{Elemento("copy")}, {}});
  restore(of, record);
  const auto copy = of.scene.find("copy");
  REQUIRE(copy.has_value());
  CHECK(of.scene.body(*copy) != nullptr);
  CHECK(of.scene.material(*copy) == 0);
}

TEST_CASE("a mesh comes back, its faces into their groups") {
  GroupedScene of;
  const auto add = [](const char* m) {
    return scene::MeshEdit(
        scene::MeshAddition{{Elemento(m), std::vector<glm::dvec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}});
  };
  REQUIRE(of.apply_total(add("tent")).ok());
  REQUIRE(of.apply_total(scene::GroupEdit(scene::Grouping{"faces", {{"tent:0"}, {}}})).ok());
  const GroupedScene before = of;
  const auto record = scene::mesh_record_of(of, Elemento("tent"));
  of.apply_total(scene::MeshEdit(scene::MeshRemoval{Elemento("tent")}));
  CHECK(of.groups != before.groups);
  restore(of, record);
  CHECK(of.groups == before.groups);
  CHECK(scene::retrieve_mallas(of.scene) == scene::retrieve_mallas(before.scene));

  const auto moved = scene::mesh_record_of(of, Elemento("tent"));
  of.apply_total(scene::MeshEdit(scene::VertexMove{Elemento("tent"), 2, {0, 5, 0}}));
  restore(of, moved);
  CHECK(scene::retrieve_mallas(of.scene) == scene::retrieve_mallas(before.scene));

  const auto none = scene::mesh_record_of(of, Elemento("roof"));
  of.apply_total(add("roof"));
  restore(of, none);
  CHECK(scene::retrieve_mallas(of.scene) == scene::retrieve_mallas(before.scene));
}
