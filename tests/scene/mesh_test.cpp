// Meshes as the tables hold them, and their faces among the triangles.
#include "durero/scene/mesh.hpp"

#include "durero/model/operaciones.hpp"
#include "durero/scene/mesh_edit.hpp"
#include "durero/scene/scene.hpp"
#include "support/catch.hpp"

using namespace durero;
using namespace durero::model;
using scene::MeshAddition;
using scene::MeshEdit;
using scene::Scene;
using scene::VertexMove;

namespace {

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

TEST_CASE("the faces of meshes are rows behind the triangles by themselves") {
  Scene scene = with_square();
  REQUIRE(scene.apply_total(MeshEdit(MeshAddition{square("a")})).ok());
  REQUIRE(scene.shapes<scene::Triangle>().size() == 5);
  CHECK(scene.singles<scene::Triangle>().size() == 1);
  std::vector<std::string> names;
  scene.for_each([&](scene::ElementRef e, const auto&) { names.push_back(scene.name(e).name()); });
  CHECK(names == std::vector<std::string>{"t", "a:0", "a:1", "m:0", "m:1"});
  CHECK(scene.find("m:1") == scene::ElementRef{Tipo::soy_triangulo, 4});
  CHECK(scene.shapes<scene::Triangle>()[4].vertices == scene::Corners{glm::dvec3(0), {4, 4, 0}, {0, 4, 0}});
  for (const char* no_face : {"m", "m:", "m:2", "m:01", "m:-1", "m:+1", "m:1 ", "w:0", ":0", "m:99999999999"})
    CHECK_FALSE(scene.find(no_face));
  CHECK_FALSE(scene.face({Tipo::soy_triangulo, 0}));
  CHECK_FALSE(scene.face({Tipo::soy_esfera, 7}));
  CHECK(scene.face({Tipo::soy_triangulo, 4})->number == 1);
  std::vector<scene::Corners> corners;
  for (const scene::Triangle& triangle : scene.shapes<scene::Triangle>()) corners.push_back(triangle.vertices);
  REQUIRE(corners.size() == 5);
  CHECK(corners[0][0] == glm::dvec3(0, 0, 9));
  CHECK(corners[2] == scene::Corners{glm::dvec3(0), {4, 4, 0}, {0, 4, 0}});
  CHECK(Scene().shapes<scene::Triangle>().empty());
}

TEST_CASE("copies share meshes until one of them is edited") {
  Scene scene = with_square();
  const Scene copy = scene;
  CHECK(&copy.meshes()[0] == &scene.meshes()[0]);
  REQUIRE(scene.apply_total(MeshEdit(VertexMove{Elemento("m"), 2, Punto(5, 5, 5)})).ok());
  CHECK(scene.meshes()[0].puntos[2] == glm::dvec3(5));
  CHECK(copy.meshes()[0].puntos[2] == glm::dvec3(4, 4, 0));
  const scene::Mesh* const own = &scene.meshes()[0];
  REQUIRE(scene.apply_total(MeshEdit(VertexMove{Elemento("m"), 2, Punto(6, 6, 6)})).ok());
  CHECK(&scene.meshes()[0] == own);
}

TEST_CASE("meshes without faces take no rows") {
  Scene scene = with_square();
  for (const char* m : {"a", "k", "z"}) {
    scene::Mesh points = square(m);
    points.caras.clear();
    REQUIRE(scene.apply_total(MeshEdit(MeshAddition{points})).ok());
  }
  CHECK(scene.meshes().size() == 4);
  CHECK(scene.size() == 3);
  CHECK(scene.name({Tipo::soy_triangulo, 1}) == Elemento("m:0"));
  CHECK(scene.name({Tipo::soy_triangulo, 2}) == Elemento("m:1"));
  CHECK(scene.meshes().find("k") == 1);
  CHECK_FALSE(scene.meshes().find("l"));
}
