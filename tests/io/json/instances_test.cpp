// Instances in scene files and scripts: what they stand for, their names, and what is refused, at its place.
#include <algorithm>

#include "durero/io/json/edited_scene.hpp"
#include "durero/io/json/groups_file.hpp"
#include "durero/io/json/scene_check.hpp"
#include "durero/io/json/scene_file.hpp"
#include "durero/io/pov/pov.hpp"
#include "durero/scene/body.hpp"
#include "io/malformed.hpp"
#include "support/catch.hpp"

using namespace durero;

namespace {

const auto reading = [](const io::Source& source) { return io::read_grouped_scene(source, io::Bodies::read); };
std::string error_of(const std::string& text) { return test::error_of(text, reading); }
std::string error_at(const std::string& with_mark) { return test::error_at_mark(with_mark, reading); }

const std::string head = R"({"format":"durero-scene","version":1,"materials":{"red":{"color":[1,0,0]}},)";
const std::string ball = R"({"id":"ball","tipo":"esfera","centro":[0,0,0],"radio":1,"material":"red"},)";
const std::string by = R"("mapa":[[2,0,0,"-1/3"],[0,1,0,0],[0,0,1,0]])";

std::string file(const std::string& elements, const std::string& more = "") {
  return head + more + "\"elementos\":[" + elements + "]}";
}
std::string copy(const std::string& id, const std::string& de) {
  return R"({"id":")" + id + R"(","tipo":"instancia","de":)" + de + "," + by + "}";
}

scene::GroupedScene read(const std::string& text) { return reading(io::Source("f", text)); }

const scene::Instance& instance(const scene::Scene& scene, const std::string& name) {
  const auto element = scene.find(name);
  REQUIRE(element);
  REQUIRE(scene.body(*element) != nullptr);
  return std::get<scene::Instance>(scene.body(*element)->form);
}

model::Mapa once() { return {{number::Rational(-1) / 3, 0, 0}, {2, 0, 0}, {0, 1, 0}, {0, 0, 1}}; }

std::string material(const scene::Scene& scene, const std::string& name) {
  const auto place = scene.material(*scene.find(name));
  return place ? scene.stage().materials[*place].name : "";
}

const std::string stool =
    R"("prototypes":{"stool":{"elementos":[{"id":"leg","tipo":"cilindro","centro":[0,0,0],"radio":1,"vector":[0,1,0],"altura":1,"material":"red"},)"
    R"({"id":"seat","tipo":"instancia","de":{"tipo":"esfera","centro":[0,1,0],"radio":1},"mapa":[[1,0,0,0],[0,0.5,0,0],[0,0,1,0]]}]},)"
    R"("unit":{"tipo":"esfera","centro":[0,0,0],"radio":5,"material":"red"}},)";

}  // namespace

TEST_CASE("An instance is the copy of an element, a shape, a prototype or an instance, wherever these stand") {
  const scene::Scene scene =
      read(file(copy("c", R"("b")") + "," + ball + copy("b", R"("ball")") + "," +
                    copy("d", R"({"tipo":"plano","centro":[0,0,0],"vector":[0,1,0]})") + "," + copy("u", R"("unit")"),
                stool))
          .scene;
  CHECK(scene.size() == 5);
  CHECK(instance(scene, "b").mapa == once());
  CHECK(instance(scene, "c").mapa == model::compuesto(once(), once()));
  CHECK(std::holds_alternative<scene::Plane>(instance(scene, "d").shape));
  CHECK(std::get<scene::Sphere>(instance(scene, "u").shape).radio == 5);
  CHECK(material(scene, "b") == "red");
  CHECK(material(scene, "c") == "red");
  CHECK(material(scene, "d").empty());
  CHECK(material(scene, "u") == "red");
}

TEST_CASE("A copy of a group is a group of copies, and may be copied") {
  const auto [scene, groups] = read(
      file(copy("s", R"("stool")") + "," + copy("t", R"({"group":"s"})") + "," + ball + copy("v", R"({"group":"all"})"),
           stool + R"("groups":{"all":{"elementos":["ball"],"groups":["s"]}},)"));
  for (const char* name : {"s:leg", "s:seat", "t:leg", "t:seat", "v:ball", "v:s:leg", "v:s:seat"}) {
    CAPTURE(name);
    CHECK(scene.find(name));
  }
  CHECK(scene.size() == 8);
  CHECK(instance(scene, "t:leg").mapa == model::compuesto(once(), once()));
  CHECK(instance(scene, "v:s:leg").mapa == model::compuesto(once(), once()));
  CHECK(material(scene, "t:leg") == "red");
  CHECK(groups.table().at("s").elementos == scene::Names{"s:leg", "s:seat"});
  CHECK(groups.of_group("s") == "all");
}

TEST_CASE("The text of a scene with instances reads back as the same text, and holds every entry") {
  const auto first = read(file(ball + copy("c", R"("ball")") + "," + copy("s", R"("stool")"), stool));
  const std::string text = io::scene_text(first.scene, first.groups);
  const auto second = read(text);
  CHECK(io::scene_text(second.scene, second.groups) == text);
  CHECK(text.find(R"("mapa":[[2,0,0,"-1/3"],[0,1,0,0],[0,0,1,0]])") != text.npos);
}

TEST_CASE("What is no instance is refused at its place") {
  CHECK(error_of(file(ball + copy("c", R"("ball")"))).empty());
  CHECK_FALSE(error_at(file(copy("c", R"(^"none")"))).empty());
  CHECK(error_at(file(copy("c", R"(^"none")"))).find("is no element") != std::string::npos);
  CHECK(error_at(file(copy("c", R"(^"c")"))).find("made of itself") != std::string::npos);
  CHECK(error_at(file(copy("b", R"("c")") + "," + copy("c", R"(^"b")"))).find("made of itself") != std::string::npos);
  CHECK(error_at(file(ball + R"(^{"id":"c","tipo":"instancia","de":"ball"})")).find("missing") != std::string::npos);
  const auto with_map = [](const std::string& mapa) {
    return file(ball + R"({"id":"c","tipo":"instancia","de":"ball","mapa":)" + mapa + "}");
  };
  CHECK(error_at(with_map("^[[1,0,0,0],[0,1,0,0],[1,1,0,0]]")).find("Mapa.inv.1") != std::string::npos);
  CHECK(error_at(with_map("[^[1,0,0],[0,1,0,0],[0,0,1,0]]")).find("four entries") != std::string::npos);
  CHECK(error_at(with_map("[[1,0,0,^\"1/0\"],[0,1,0,0],[0,0,1,0]]")).find("fraction") != std::string::npos);
  CHECK(error_at(with_map("[[1,0,0,^\"one\"],[0,1,0,0],[0,0,1,0]]")).find("fraction") != std::string::npos);
  CHECK(
      error_at(file(ball + R"({"id":^"ball","tipo":"instancia","de":"ball",)" + by + "}")).find("elemento_ya_existe") !=
      std::string::npos);
  CHECK(error_at(file(ball + copy("c", R"({"group":^"none"})"))).find("is no group") != std::string::npos);
  CHECK(error_at(file(ball + R"({"id":"c","tipo":"instancia","de":"ball",^"x":1,)" + by + "}")).find("\"x\"") !=
        std::string::npos);
  CHECK(error_at(file(ball + R"({"id":"c","tipo":"instancia","de":{"tipo":"esfera","centro":[0,0,0],"radio":^0},)" +
                      by + "}"))
            .find("Rmas.inv.1") != std::string::npos);
}

TEST_CASE("A prototype that is wrong is refused though nobody copies it") {
  const auto with = [](const std::string& prototypes) { return file(ball + copy("c", R"("ball")"), prototypes); };
  CHECK(error_at(with(R"("prototypes":{^"ball":{"tipo":"esfera","centro":[0,0,0],"radio":1}},)"))
            .find("name of an element") != std::string::npos);
  CHECK(error_at(with(R"("prototypes":{"p":{"tipo":"instancia","de":^"none",)" + by + "}},")).find("is no element") !=
        std::string::npos);
  CHECK(error_at(with(R"("prototypes":{"p":{"elementos":[{"id":"a","tipo":"esfera","centro":[0,0,0],"radio":1},)"
                      R"({"id":^"a","tipo":"esfera","centro":[0,0,0],"radio":1}]}},)"))
            .find("stands twice") != std::string::npos);
  CHECK(error_at(with(R"("prototypes":{"p":{"tipo":"esfera","centro":[0,0,0],"radio":1,"material":^"blue"}},)"))
            .find("unknown material") != std::string::npos);
}

TEST_CASE("Groups that double with every line are refused before they fill the memory") {
  std::string prototypes = R"("prototypes":{"p0":{"tipo":"esfera","centro":[0,0,0],"radio":1})";
  for (int i = 1; i < 40; ++i) {
    const std::string half = R"(,"tipo":"instancia","de":"p)" + std::to_string(i - 1) + "\"," + by + "}";
    prototypes += R"(,"p)" + std::to_string(i) + R"(":{"elementos":[{"id":"a")" + half + R"(,{"id":"b")" + half + "]}";
  }
  CHECK(error_of(file(ball + copy("c", R"("ball")"), prototypes + "},")).find("more than 4194304 copies") !=
        std::string::npos);
  std::string chain;
  for (int i = 0; i < 600; ++i) chain += copy("c" + std::to_string(i), "\"c" + std::to_string(i + 1) + "\"") + ",";
  CHECK(error_of(file(chain + ball + copy("c600", R"("ball")"))).find("made of one another") != std::string::npos);
}

TEST_CASE("Elements that are too deep within one another are errors, and those beside them are none") {
  std::string chain;
  for (int i = 0; i < 504; ++i) chain += copy("c" + std::to_string(i), "\"c" + std::to_string(i + 1) + "\"") + ",";
  const io::SceneCheck check = io::check_scene(io::Source("f", file(chain + ball + copy("c504", R"("ball")"))));
  CHECK(check.errors.size() == 5);  // of the 505 those that stand above more than 500 others, or the ball
}

TEST_CASE("Who knows shapes alone refuses instances, and check counts them") {
  const std::string text = file(ball + copy("c", R"("ball")"));
  CHECK(test::error_of(text, [](const io::Source& s) { return io::read_scene(s); }).find("instancia") !=
        std::string::npos);
  const io::SceneCheck check = io::check_scene(io::Source("f", text));
  CHECK(check.errors.empty());
  CHECK(check.findings.empty());
  CHECK(io::check_text(check).starts_with("f: 2 elementos: 1 esfera, "));
  CHECK(io::check_text(check).find("1 instancia") != std::string::npos);
  const io::SceneCheck wrong =
      io::check_scene(io::Source("f", file(copy("c", R"("none")") + "," + copy("d", R"("none")"))));
  CHECK(wrong.errors.size() == 2);
}

TEST_CASE("Scripts add copies and remove them, and a copy is no sphere") {
  io::EditedScene edited(read(file(ball + copy("c", R"("ball")"), R"("groups":{"g":{"elementos":["c"]}},)")));
  const auto answer = [&](const std::string& operation) {
    const auto script = io::read_script(io::Source("f", operation), edited.of().scene.stage());
    const io::EditAnswer done = edited.apply_total(script.at(0));
    return done.r + (done.ok() ? "" : " " + done.violated) +
           (done.left_group.empty() ? "" : " left " + done.left_group);
  };
  CHECK(answer("Agregar_Instancia e?=d de?=c centro?=(0,0,1) x?=(1,0,0) y?=(0,1,0) z?=(0,0,1) material?=red") ==
        "instancia_agregada");
  CHECK(instance(edited.of().scene, "d").mapa.centro.z == 1);
  CHECK(material(edited.of().scene, "d") == "red");
  CHECK(answer("Eliminar_Esfera e?=c") == "tipo_incorrecto Eliminar_Esfera.pre.1");
  CHECK(answer(R"({"op":"Agregar_Instancia","e":"e","de":"c","centro":[0,0,1],"x":[1,0,0],"y":[2,0,0],"z":[0,0,1]})") ==
        "mapa_singular Mapa.inv.1");
  CHECK(answer("Eliminar_Instancia e?=c") == "instancia_eliminada left g");
  CHECK(answer("Eliminar_Elemento e?=d") == "elemento_eliminado");
  CHECK(edited.of().scene.size() == 1);
}

TEST_CASE("POV-Ray has the matrix of a copy, and its rounding is named") {
  const auto [scene, groups] = read(file(ball + copy("c", R"("ball")")));
  const io::Exported exported = io::pov_text(scene, groups);
  CHECK(exported.text.find("matrix <2, 0, 0, 0, 1, 0, 0, 0, 1, -0.3333333333333333, 0, 0>") != std::string::npos);
  CHECK(std::ranges::any_of(exported.lost, [](const std::string& line) { return line.starts_with("1 map rounded"); }));
}
