// The edits of meshes in the tables are the operations of spec/malla.tex, and the tables stand for the scene that these
// give. They hold what sueltas.def.1 says, and the meshes.
#include "durero/scene/mesh_edit.hpp"

#include <limits>
#include <stdexcept>

#include "durero/scene/edit.hpp"
#include "durero/scene/grouped_scene.hpp"
#include "durero/scene/retrieve.hpp"
#include "durero/scene/stage.hpp"
#include "durero/scene/tablas.hpp"
#include "support/catch.hpp"
#include "support/mallas_gen.hpp"
#include "support/property.hpp"

using namespace durero;
using namespace durero::model;
using namespace durero::test;
using scene::MeshAddition;
using scene::MeshEdit;
using scene::MeshRemoval;
using scene::MeshReplacement;
using scene::Scene;
using scene::VertexMove;

namespace {

scene::Mesh mesh_of(const Elemento& m, const Red& red) {
  scene::Mesh mesh{m};
  for (const auto& [n, p] : red.puntos()) mesh.puntos.push_back(p.xyz());
  for (const auto& [n, c] : red.caras()) mesh.caras.push_back(c);
  return mesh;
}

MeshEdit edit_of(const Agregar_Malla& in) { return MeshAddition{mesh_of(in.m, in.red)}; }
MeshEdit edit_of(const Eliminar_Malla& in) { return MeshRemoval{in.m}; }
MeshEdit edit_of(const Reemplazar_Malla& in) { return MeshReplacement{mesh_of(in.m, in.red)}; }
MeshEdit edit_of(const Mover_Vertice& in) { return VertexMove{in.m, in.n, in.punto}; }
MeshEdit edit_of(const MeshOperation& operation) {
  return std::visit([](const auto& in) { return edit_of(in); }, operation);
}

scene::Mesh square(const char* m) {
  return {Elemento(m), {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}, {{0, 1, 2}, {0, 2, 3}}};
}

Scene with_square() {
  Scene scene;
  scene.apply(Agregar_Triangulo{Elemento("t"), {Punto(0, 0, 9), Punto(1, 0, 9), Punto(0, 1, 9)}});
  REQUIRE(scene.apply_total(MeshEdit(MeshAddition{square("m")})).ok());
  return scene;
}

}  // namespace

TEST_CASE("a scene with meshes answers as the text, and stands for the same") {
  property("whatever operations come, of meshes and of elements", [] {
    Scene scene;
    Mallas text = Init_Mallas();
    const auto audited = *rc::gen::inRange(0, 4) == 0 ? contract::evaluation_semantic::enforce
                                                      : contract::semantic(contract::cost::audit);
    const contract::scoped_semantic scope(contract::cost::audit, audited);
    const int count = *rc::gen::inRange(1, 12);
    for (int i = 0; i < count; ++i) {
      Answer answer, expected;
      if (*rc::gen::inRange(0, 3) > 0) {
        const MeshOperation operation = *any_mesh_operation();
        answer = scene.apply_total(edit_of(operation));
        expected = apply_total(text, operation);
      } else {
        const Operation operation = *any_single_operation();
        answer = scene.apply_total(operation);
        expected = apply_total(text, operation);
      }
      RC_ASSERT(answer == expected);
      RC_ASSERT(scene::retrieve_mallas(scene) == text);
      RC_ASSERT(scene::tablas(scene).nombres.size() == sueltas(text).elementos.size());
      RC_ASSERT(scene.size() == text.escena.elementos.size());
      for (const Elemento& e : text.escena.elementos) {
        const auto found = scene.find(e.name());
        RC_ASSERT(found.has_value());
        RC_ASSERT(scene.name(*found) == e);
        RC_ASSERT(scene.face(*found).has_value() == de_malla(text).contains(e));
      }
    }
    RC_CLASSIFY(text.mallas.size() > 1, "several meshes");
  });
}

TEST_CASE("a face is removed with its mesh alone") {
  Scene scene = with_square();
  const Mallas before = scene::retrieve_mallas(scene);
  for (const Operation& operation :
       {Operation(Eliminar_Elemento{Elemento("m:0")}), Operation(Eliminar_Triangulo{Elemento("m:0")}),
        Operation(Eliminar_Esfera{Elemento("m:0")})}) {
    const Answer answer = scene.apply_total(operation);
    CHECK(answer.r == Respuesta::es_de_malla);
    CHECK(answer.violated->label == "Fuera_De_Malla.pre.1");
    CHECK_THROWS_AS(scene.apply(operation), contract::contract_violation);
    const contract::scoped_semantic ignored(contract::cost::normal, contract::evaluation_semantic::ignore);
    CHECK_THROWS_AS(scene.apply(operation), contract::contract_violation);
  }
  CHECK(scene::retrieve_mallas(scene) == before);
}

TEST_CASE("an edit that cannot be is refused by the predicate that it breaks") {
  Scene scene = with_square();
  const auto broken = [&](MeshEdit edit) {
    const Answer answer = scene.apply_total(std::move(edit));
    return answer.ok() ? "none" : answer.violated->label;
  };
  const auto moved = [&](Ordinal n, const Punto& p) { return broken(VertexMove{Elemento("m"), n, p}); };
  CHECK(moved(3, Punto(2, 2, 0)) == "Mover_Vertice.pre.3");
  CHECK(moved(1, Punto(2, 2, 0)) == "Mover_Vertice.pre.3");
  CHECK(moved(2, Punto(0, 0, 0)) == "Mover_Vertice.pre.3");
  CHECK(moved(4, Punto(9, 9, 9)) == "Mover_Vertice.pre.2");
  CHECK(moved(3, Punto(2, 2, 1)) == "none");
  for (const Cara& beyond : {Cara{4, 0, 1}, Cara{0, 4, 1}, Cara{0, 1, 4}}) {
    scene::Mesh mesh = square("b");
    mesh.caras.push_back(beyond);
    CHECK(broken(MeshAddition{mesh}) == "Agregar_Malla.pre.2");
    mesh.m = Elemento("m");
    CHECK(broken(MeshReplacement{mesh}) == "Reemplazar_Malla.pre.2");
  }
  // The name of a face is asked of few elements, then of many.
  for (const char* name : {"x:1", "y:0"}) {
    scene.apply(Agregar_Esfera{Elemento(name), Punto(0, 0, 0), 1});
    CHECK(broken(MeshAddition{square(std::string(1, name[0]).c_str())}) == "Agregar_Malla.pre.5");
    CHECK(broken(MeshAddition{square("free")}) == "none");
    CHECK(broken(MeshRemoval{Elemento("free")}) == "none");
    scene.apply(Agregar_Esfera{Elemento(std::string(name) + ".2"), Punto(0, 0, 0), 1});
  }
}

TEST_CASE("the looks of a face are those of its mesh") {
  Scene scene;
  scene.stage().materials = {{"blue", {0, 0, 1}}, {"red", {1, 0, 0}}};
  scene::Mesh mesh = square("m");
  mesh.material = 1;
  mesh.normals = {{0, 0, 1}, {0, 1, 1}, {1, 0, 1}, {0, 0, 2}};
  mesh.uv = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  REQUIRE(scene.apply_total(MeshEdit(MeshAddition{mesh})).ok());
  const scene::ElementRef face = scene.find("m:1").value();
  CHECK(scene.material(face) == 1);
  CHECK(scene.vertex_normals(face) == scene::VertexNormals{{{0, 0, 1}, {1, 0, 1}, {0, 0, 2}}});
  CHECK(scene.wrap(face)->uv == std::array<glm::dvec2, 3>{{{0, 0}, {1, 1}, {0, 1}}});
  CHECK(scene.motion(face) == nullptr);
  CHECK(scene.body(face) == nullptr);
  CHECK_THROWS_AS(scene.set_material(face, 0), std::domain_error);
  CHECK_THROWS_AS(scene.set_wrap(face, {}), std::domain_error);
  CHECK_THROWS_AS(scene.set_motion(face, {1, 0, 0}), std::domain_error);
  REQUIRE(scene.apply_total(MeshEdit(MeshReplacement{square("m")})).ok());
  CHECK_FALSE(scene.material(face));
  CHECK_FALSE(scene.vertex_normals(face));
  CHECK_FALSE(scene.wrap(face));
}

TEST_CASE("a mesh whose looks do not fit, or whose points are none, is no mesh: nothing changes") {
  Scene scene = with_square();
  const Mallas before = scene::retrieve_mallas(scene);
  const auto wrong = [&](auto&& change) {
    scene::Mesh mesh = square("w");
    change(mesh);
    return MeshEdit(MeshAddition{mesh});
  };
  CHECK_THROWS_AS(scene.apply_total(wrong([](auto& mesh) { mesh.material = 0; })), std::out_of_range);
  CHECK_THROWS_AS(scene.apply_total(wrong([](auto& mesh) { mesh.normals = {{0, 0, 1}}; })), std::domain_error);
  CHECK_THROWS_AS(scene.apply_total(wrong([](auto& mesh) { mesh.normals.resize(4); })), std::domain_error);
  CHECK_THROWS_AS(scene.apply_total(wrong([](auto& mesh) { mesh.uv.resize(3); })), std::domain_error);
  CHECK_THROWS_AS(scene.apply_total(wrong(
                      [](auto& mesh) { mesh.puntos.set(1, glm::dvec3(std::numeric_limits<double>::infinity())); })),
                  std::domain_error);
  CHECK(scene::retrieve_mallas(scene) == before);
}

TEST_CASE("a face leaves its group with its mesh") {
  scene::GroupedScene both{with_square(), {}};
  REQUIRE(both.apply_total(scene::GroupEdit{scene::Grouping{"some", {{"m:0", "m:1", "t"}, {}}}}).ok());
  scene::Mesh half = square("m");
  half.caras.pop_back();
  REQUIRE(both.apply_total(MeshEdit(MeshReplacement{half})).ok());
  CHECK(both.groups.of_element("m:0") == "some");
  CHECK(both.groups.of_element("m:1").empty());
  CHECK_FALSE(both.apply_total(MeshEdit(MeshRemoval{Elemento("w")})).ok());
  CHECK(both.groups.of_element("m:0") == "some");
  REQUIRE(both.apply_total(MeshEdit(MeshRemoval{Elemento("m")})).ok());
  CHECK(both.groups.table() == scene::Groups::Table{{"some", {{"t"}, {}}}});
}
