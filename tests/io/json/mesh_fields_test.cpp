// Meshes in scene files and in scripts.
#include "durero/io/json/edited_scene.hpp"
#include "durero/io/json/groups_file.hpp"
#include "durero/io/json/scene_file.hpp"
#include "durero/scene/retrieve.hpp"
#include "support/catch.hpp"

using namespace durero;

namespace {

std::string scene_with(const std::string& meshes, const std::string& elements = "") {
  return R"({"format":"durero-scene","version":1,"mallas":[)" + meshes + R"(],"materials":{"red":{"color":[1,0,0]}},)" +
         R"("elementos":[)" + elements + "]}";
}

scene::Scene read(const std::string& text) { return io::read_scene(io::Source("s.json", text)); }

std::string error_of(const std::string& text) {
  try {
    read(text);
  } catch (const io::InputError& error) {
    return error.what();
  }
  return "none";
}

const std::string square =
    R"({"id":"m","puntos":[[0,0,0],[4,0,0],[4,4,0],[0,4,0]],"caras":[[0,1,2],[0,2,3]],"material":"red",)"
    R"("normals":[[0,0,1],[0,1,1],[1,0,1],[0,0,2]],"uv":[[0,0],[1,0],[1,1],[0,0.1]]})";

}  // namespace

TEST_CASE("a mesh is read, wherever materials stand, and is written so that it reads back") {
  const scene::Scene scene = read(scene_with(square));
  REQUIRE(scene.meshes().size() == 1);
  const scene::Mesh& mesh = scene.meshes()[0];
  CHECK(mesh.puntos[2] == glm::dvec3(4, 4, 0));
  CHECK(mesh.caras == std::vector<model::Cara>{{0, 1, 2}, {0, 2, 3}});
  CHECK(mesh.material == 0);
  CHECK(mesh.normals[3] == glm::dvec3(0, 0, 2));
  CHECK(mesh.uv[3] == glm::dvec2(0, 0.1));
  const std::string text = io::scene_text(scene);
  CHECK(io::scene_text(read(text)) == text);
  CHECK(text.ends_with(R"("elementos":[],
"mallas":[
{"id":"m","material":"red","puntos":[
[0,0,0],
[4,0,0],
[4,4,0],
[0,4,0]],"caras":[
[0,1,2],
[0,2,3]],"normals":[
[0,0,1],
[0,1,1],
[1,0,1],
[0,0,2]],"uv":[
[0,0],
[1,0],
[1,1],
[0,0.1]]}
]}
)"));
}

TEST_CASE("groups, instances and solids know faces by their names") {
  const scene::Scene scene =
      io::read_scene(io::Source("s.json", scene_with(square, R"({"id":"copy","tipo":"instancia","de":"m:1",)"
                                                             R"("mapa":[[1,0,0,9],[0,1,0,0],[0,0,1,0]]})")),
                     io::Bodies::read);
  CHECK(scene.body(*scene.find("copy")) != nullptr);
  const auto grouped = io::read_grouped_scene(io::Source(
      "s.json",
      R"({"format":"durero-scene","version":1,"groups":{"g":{"elementos":["m:0"]}},"elementos":[],"mallas":[)" +
          square.substr(0, square.find(",\"material\"")) + "}]}"));
  CHECK(grouped.groups.of_element("m:0") == "g");
}

TEST_CASE("a mesh that is wrong is an error at its face, its look or its name") {
  const auto wrong = [](const std::string& mesh, const std::string& elements = "") {
    return error_of(scene_with(mesh, elements));
  };
  const std::string points = R"("puntos":[[0,0,0],[4,0,0],[4,4,0],[8,0,0]])";
  CHECK(wrong(R"({"id":"m",)" + points + R"(,"caras":[[0,1,2],[0,2,4]]})") ==
        "s.json:1:118: a face has point 4 of 4; expected ∀ c : ran red.caras • { c.i, c.j, c.k } ⊆ dom red.puntos "
        "(Completa.inv.1)");
  CHECK(wrong(R"({"id":"m",)" + points + R"(,"caras":[[0,1,2],[0,1,3]]})") ==
        "s.json:1:118: a face has three points on one line; expected the corners of a triangle (Malla.inv.1)");
  CHECK(wrong(square + "," + square) ==
        "s.json:1:228: id is \"m\": malla_ya_existe (mesh_already_exists); expected m? ∉ dom mallas "
        "(Agregar_Malla.pre.1)");
  CHECK(wrong(square, R"({"id":"m:1","tipo":"esfera","centro":[0,0,0],"radio":1})") ==
        "s.json:1:54: id is \"m\": elemento_ya_existe (element_already_exists); expected dom (familia(m?, red?)) ∩ "
        "elementos = ∅ (Agregar_Malla.pre.5)");
  CHECK(wrong(R"({"id":"m",)" + points + R"(,"caras":[[0,1,2]],"normals":[[0,0,1]]})") ==
        "s.json:1:119: normals has 1 items; expected one for each of 4 points");
  CHECK(wrong(R"({"id":"m",)" + points + R"(,"caras":[[0,1,2]],"uv":[[0,0],[0,0],[0,0]]})") ==
        "s.json:1:119: uv has 3 items; expected one for each of 4 points");
  CHECK(wrong(R"({"id":"m",)" + points + R"(,"caras":[[0,1,2]],"normals":[[0,0,0]]})") ==
        "s.json:1:130: a normal is (0, 0, 0); expected a direction of any length but 0");
  CHECK(wrong(R"({"id":"m",)" + points + R"(,"caras":[[0,1,2]],"material":"blue"})") ==
        "s.json:1:130: unknown material \"blue\"; expected one of the scene's materials");
  CHECK(wrong(R"({"id":"m",)" + points + R"(,"caras":[[0,1,1.5]]})") ==
        "s.json:1:115: caras is 1.5; expected the number of a point, from 0");
  CHECK(wrong(R"({"id":"m",)" + points + "}") ==
        "s.json:1:48: key \"caras\" (faces) is missing in a mesh; expected it");
}

TEST_CASE("a face has its place in the file") {
  const std::string text = scene_with(square, R"({"id":"ball","tipo":"esfera","centro":[0,0,0],"radio":1})");
  const io::Source source("s.json", text);
  CHECK(io::element_place(source, "m:1").pointer == "/mallas/0/caras/1");
  CHECK(io::element_place(source, "m:1").place.column == text.find("[0,2,3]") + 1);
  CHECK(io::element_place(source, "ball").pointer == "/elementos/0");
  CHECK(io::element_place(source, "m:7").pointer.empty());
}

TEST_CASE("a script edits meshes, as text and as JSON") {
  io::EditedScene edited;
  const auto answer = [&](const std::string& line) {
    const auto script = io::read_script(io::Source("--op", line), edited.of().scene.stage());
    return edited.apply_total(script.front()).r;
  };
  CHECK(answer("Agregar_Malla m?=m puntos?=((0,0,0), (4,0,0),(4,4,0),(0,4,0)) caras?=((0,1,2),( 0, 2,3))") ==
        "malla_agregada");
  CHECK(answer(R"({"op":"Agregar_Malla","m":"w","puntos":[[0,0,1],[4,0,1],[4,4,1]],"caras":[[0,1,2]]})") ==
        "malla_agregada");
  CHECK(answer("Mover_Vertice m?=m n?=2 punto?=(5,5,5)") == "vertice_movido");
  CHECK(answer("Mover_Vertice m?=m n?=4 punto?=(5,5,5)") == "vertice_no_existe");
  CHECK(answer("Reemplazar_Malla m?=w puntos?=() caras?=()") == "malla_reemplazada");
  CHECK(answer("Eliminar_Elemento e?=m:0") == "es_de_malla");
  CHECK(edited.of().scene.size() == 2);
  CHECK(answer("Eliminar_Malla m?=m") == "malla_eliminada");
  CHECK(edited.of().scene.size() == 0);
  CHECK(edited.of().scene.meshes().size() == 1);
  const auto error = [&](const std::string& line) {
    try {
      io::read_script(io::Source("--op", line), edited.of().scene.stage());
    } catch (const io::InputError& wrong) {
      return std::string(wrong.what());
    }
    return std::string("none");
  };
  CHECK(error("Agregar_Malla m?=x puntos?=((0,0,0)) caras?=((0,0,-1))") ==
        "--op:1:45: -1 in caras? (faces); expected the number of a point, from 0");
  CHECK(error("Agregar_Malla m?=x puntos?=7 caras?=()") ==
        "--op:1:28: puntos? (points) is no list of triples; expected ((x,y,z),…), or [[x,y,z],…] in JSON");
  CHECK(error("Mover_Vertice m?=x n?=0.5 punto?=(0,0,0)") ==
        "--op:1:23: 0.5 in n? (number); expected the number of a point, from 0");
}
