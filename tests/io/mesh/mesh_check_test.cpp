#include "durero/io/mesh/mesh_check.hpp"

#include <algorithm>
#include <stdexcept>

#include "durero/scene/edit.hpp"
#include "durero/scene/mesh_edit.hpp"
#include "support/catch.hpp"

using namespace durero;
using namespace durero::io;

namespace {

constexpr glm::dvec3 o(0, 0, 0), x(2, 0, 0), y(0, 2, 0), z(0, 0, 2), half(1, 0, 0);

scene::Scene scene_of(const std::vector<scene::Triangle>& triangles) {
  scene::Scene scene;
  int n = 0;
  for (const scene::Triangle& each : triangles) {
    const std::string name(1, static_cast<char>('a' + n++));
    REQUIRE(scene.add(model::Elemento(name), each).ok());
  }
  return scene;
}

SceneMesh mesh_of_scene(const std::vector<scene::Triangle>& triangles) { return mesh_of(scene_of(triangles)); }

std::vector<std::string> kinds(const std::vector<scene::Triangle>& triangles) {
  std::vector<std::string> all;
  for (const MeshDefect& each : check_mesh("m", mesh_of_scene(triangles)).findings) all.push_back(each.kind);
  return all;
}

const scene::Triangle base{{o, y, x}}, front{{o, x, z}}, slope{{x, y, z}}, side{{o, z, y}},
    across{{glm::dvec3(-1, 1, -1), {1, 1, 1}, {2, 0, 3}}};

}  // namespace

TEST_CASE("points that are the same are one vertex, the two zeros too") {
  const SceneMesh mesh = mesh_of(scene_of({base, {{glm::dvec3(-0.0, 0, -0.0), x, z}}}));
  CHECK(mesh.vertices == std::vector<glm::dvec3>{o, y, x, z});
  CHECK(mesh.faces == std::vector<mesh::CornerNumbers>{{0, 1, 2}, {0, 2, 3}});
  CHECK(mesh.names == std::vector<std::string>{"a", "b"});
}

TEST_CASE("a closed mesh has no finding, and an exact volume") {
  const MeshCheck check = check_mesh("m", mesh_of_scene({base, front, slope, side}));
  CHECK(check.findings.empty());
  CHECK(check.volume == "4/3");
}

TEST_CASE("pieces are told by their first faces, each with its own volume") {
  const glm::dvec3 far(10, 0, 0);
  const MeshCheck check = check_mesh("m", mesh_of_scene({base, {{o + far, y + far, x + far}}, front, slope, side}));
  CHECK(check.pieces == 2);
  CHECK_FALSE(check.volume);
  REQUIRE(check.listed_pieces.size() == 2);
  CHECK(check.listed_pieces[0].first == "a");
  CHECK(check.listed_pieces[0].faces == 4);
  CHECK(check.listed_pieces[0].volume == "4/3");
  CHECK(check.listed_pieces[1].first == "b");
  CHECK_FALSE(check.listed_pieces[1].volume);
}

TEST_CASE("so many findings of each kind are left, and so many pieces; the others are counted") {
  MeshCheck check{"m", 9, 9, 3, std::nullopt, std::nullopt, {}, {{"a", 4, {}}, {"e", 4, {}}, {"i", 1, {}}}, {}};
  for (const char* kind : {"abiertas", "abiertas", "abiertas", "abiertas", "discordes", "discordes", "cruzadas"})
    check.findings.push_back({kind, {std::to_string(check.findings.size())}, {}, "", {}});
  MeshCheck all = check;
  list_at_most(4, all);
  CHECK(all.findings.size() == 7);
  CHECK(all.unlisted.empty());
  CHECK(all.listed_pieces.size() == 3);
  list_at_most(1, check);
  std::vector<std::string> first;
  for (const MeshDefect& each : check.findings) first.push_back(each.faces[0]);
  CHECK(first == std::vector<std::string>{"0", "4", "6"});
  REQUIRE(check.unlisted.size() == 2);
  CHECK(check.unlisted[0].kind == "abiertas");
  CHECK(check.unlisted[0].count == 3);
  CHECK(check.unlisted[1].kind == "discordes");
  CHECK(check.unlisted[1].count == 1);
  CHECK(check.pieces == 3);
  CHECK(check.listed_pieces.size() == 1);
}

TEST_CASE("faces by numbers are named by their own, and same points are one vertex") {
  const std::vector<glm::dvec3> vertices{o, x, y, o, half, z};
  const std::vector<mesh::CornerNumbers> faces{{0, 1, 2}, {3, 4, 1}, {3, 5, 1}};
  const MeshCheck check = check_mesh("m", mesh_of(vertices, faces));
  CHECK(check.vertices == 5);
  const auto found = std::ranges::find(check.findings, "degeneradas", &MeshDefect::kind);
  REQUIRE(found != check.findings.end());
  CHECK(found->faces == std::vector<std::string>{"1"});
  CHECK(found->places == std::vector<glm::dvec3>{o, half, x});
  const std::vector<mesh::CornerNumbers> beyond{{0, 1, 6}};
  CHECK_THROWS_AS(mesh_of(vertices, beyond), std::out_of_range);
}

TEST_CASE("each planted fault is found, with its faces and what mends it") {
  CHECK(kinds({base, front, slope}) == std::vector<std::string>{"abiertas", "abiertas", "abiertas"});
  const auto of = [](const std::vector<scene::Triangle>& triangles, const std::string& kind) {
    for (const MeshDefect& each : check_mesh("m", mesh_of_scene(triangles)).findings)
      if (each.kind == kind) return each;
    FAIL("no " + kind);
    throw 0;
  };
  const MeshDefect turned = of({base, front, slope, {{z, o, y}}}, "discordes");
  CHECK(turned.faces == std::vector<std::string>{"a", "d"});
  CHECK(turned.mended == std::vector<std::string>{"Eliminar_Triangulo e?=d",
                                                  "Agregar_Triangulo e?=d vertices?=((0,0,0),(0,0,2),(0,2,0))"});
  const MeshDefect twice = of({base, front, slope, side, {{z, y, o}}}, "repetidas");
  CHECK(twice.faces == std::vector<std::string>{"e"});
  CHECK(twice.mended == std::vector<std::string>{"Eliminar_Triangulo e?=e"});
  CHECK(of({base, front, slope, side, {{z, y, o}}}, "multiples").faces == std::vector<std::string>{"a", "d", "e"});
  const MeshDefect crossing = of({base, across}, "cruzadas");
  CHECK(crossing.faces == std::vector<std::string>{"a", "b"});
  CHECK(crossing.places == std::vector<glm::dvec3>{{0, 1, 0}});
  const MeshDefect singular = of({base, {{o, -x, -y}}}, "singulares");
  CHECK(singular.faces == std::vector<std::string>{"a", "b"});
  CHECK(singular.places == std::vector<glm::dvec3>{o});
  const MeshDefect junction = of({base, {{o, half, z}}, {{half, x, z}}, slope, side}, "uniones_en_t");
  CHECK(junction.faces == std::vector<std::string>{"a"});
  CHECK(junction.places == std::vector<glm::dvec3>{half, o, x});
  CHECK(junction.mended == std::vector<std::string>{"Eliminar_Triangulo e?=a",
                                                    "Agregar_Triangulo e?=a vertices?=((1,0,0),(0,2,0),(2,0,0))",
                                                    "Agregar_Triangulo e?=a.2 vertices?=((0,0,0),(0,2,0),(1,0,0))"});
}

TEST_CASE("faces of a mesh are audited with the others, and no operation edits one of them alone") {
  scene::Scene scene = scene_of({base, front});
  scene::Mesh mesh{model::Elemento("m"), {o, x, y, z}, {{1, 2, 3}, {2, 0, 3}, {2, 0, 3}}};
  REQUIRE(scene.apply_total(scene::MeshEdit(scene::MeshAddition{mesh})).ok());
  const MeshCheck check = check_mesh("m", mesh_of(scene));
  CHECK(check.faces == 5);
  CHECK(check.vertices == 4);
  const auto twice = std::ranges::find(check.findings, "repetidas", &MeshDefect::kind);
  REQUIRE(twice != check.findings.end());
  CHECK(twice->faces == std::vector<std::string>{"m:2"});
  CHECK(twice->mended.empty());
}
