#include "durero/io/mesh/gathered.hpp"

#include "durero/io/mesh/obj.hpp"
#include "durero/model/operaciones.hpp"
#include "durero/scene/edit.hpp"
#include "durero/scene/stage.hpp"
#include "support/catch.hpp"

using namespace durero;

namespace {

constexpr const char* square = R"(v 0 0 0
v 4 0 0
v 4 4 0
v 0 4 0
g left
f 1 2 3
g right
f 1 3 4
)";

io::Imported read(const std::string& text) { return io::read_obj(io::Source("dir/a b.obj", text)); }

}  // namespace

TEST_CASE("triangles become one mesh, whose points stand once, and stay in their groups") {
  const io::Imported made = io::gathered(read(square), "dir/a b.obj");
  REQUIRE(made.scene.meshes().size() == 1);
  const scene::Mesh& mesh = made.scene.meshes()[0];
  CHECK(mesh.m.name() == "a_b.obj");
  CHECK(mesh.puntos == std::vector<glm::dvec3>{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}});
  CHECK(mesh.caras == std::vector<model::Cara>{{0, 1, 2}, {0, 2, 3}});
  CHECK(mesh.normals.empty());
  CHECK(made.scene.singles<scene::Triangle>().empty());
  CHECK(made.groups.table() == scene::Groups::Table{{"left", {{"a_b.obj:0"}, {}}}, {"right", {{"a_b.obj:1"}, {}}}});
}

TEST_CASE("a point that has two normals stands twice, and triangles without looks are another mesh") {
  const io::Imported made = io::gathered(
      read(std::string(square) + "vn 0 0 1\nvn 0 1 0\nvt 0 0\nf 1//1 2//1 3//1\nf 1//2 3//1 4//1\nf 1/1 2/1 3/1\n"),
      "m");
  REQUIRE(made.scene.meshes().size() == 3);
  CHECK(made.scene.meshes()[0].m.name() == "m");
  CHECK(made.scene.meshes()[0].caras.size() == 2);
  const scene::Mesh& smooth = made.scene.meshes()[1];
  CHECK(smooth.m.name() == "m.2");
  CHECK(smooth.caras == std::vector<model::Cara>{{0, 1, 2}, {3, 2, 4}});
  CHECK(smooth.normals[0] == glm::dvec3(0, 0, 1));
  CHECK(smooth.normals[3] == glm::dvec3(0, 1, 0));
  CHECK(made.scene.meshes()[2].uv.size() == 3);
  CHECK(made.scene.meshes()[2].normals.empty());
}

TEST_CASE("materials part meshes; other elements stay, and so does a triangle that moves") {
  io::Imported from = read(square);
  from.scene.stage().materials = {{"blue", {0, 0, 1}}, {"red", {1, 0, 0}}};
  from.scene.set_material(*from.scene.find("a_b.obj:1"), 1);
  from.scene.apply(model::Agregar_Esfera{model::Elemento("ball"), model::Punto(0, 0, 0), 1});
  from.scene.apply(model::Agregar_Triangulo{model::Elemento("kite"), {{0, 0, 9}, {1, 0, 9}, {0, 1, 9}}});
  from.scene.set_motion(*from.scene.find("kite"), {0, 0, 1});
  const io::Imported made = io::gathered(std::move(from), "m");
  REQUIRE(made.scene.meshes().size() == 2);
  CHECK(made.scene.material(*made.scene.find("m:0")) == 1);
  CHECK_FALSE(made.scene.material(*made.scene.find("m.2:0")));
  CHECK(made.scene.find("ball"));
  CHECK(made.scene.motion(*made.scene.find("kite")) != nullptr);
  CHECK(made.scene.size() == 4);
}

TEST_CASE("a face that would have the name of another element is refused") {
  io::Imported from = read(square);
  from.scene.apply(model::Agregar_Esfera{model::Elemento("m:1"), model::Punto(0, 0, 0), 1});
  CHECK_THROWS_AS(io::gathered(std::move(from), "m"), std::invalid_argument);
}
