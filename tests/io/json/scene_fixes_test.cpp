// Proposals that mend a file: carried out, they make a scene that the reader takes.
#include "durero/io/json/scene_fixes.hpp"

#include <fmt/format.h>

#include "durero/io/json/edited_scene.hpp"
#include "durero/io/json/file_patch.hpp"
#include "durero/io/json/groups_file.hpp"
#include "durero/io/json/scene_check.hpp"
#include "durero/model/judgement.hpp"
#include "io/json/edited_script.hpp"
#include "io/json/json_value.hpp"
#include "support/catch.hpp"
#include "support/scenes.hpp"

namespace durero::io {
namespace {

std::string file_of(const std::string& elements, const std::string& groups = "{}") {
  return R"({"format":"durero-scene","version":1,"groups":)" + groups + ",\n\"elementos\":[\n" + elements + "]}\n";
}

std::string sphere(const std::string& id, int x) {
  return fmt::format(R"({{"id":"{}","tipo":"esfera","centro":[{},0,0],"radio":1}})", id, x);
}
std::string plane(const std::string& id, const std::string& vector) {
  return fmt::format(R"({{"id":"{}","tipo":"plano","centro":[0,0,0],"vector":[{}]}})", id, vector);
}
std::string triangle(const std::string& id, const std::string& last) {
  return fmt::format(R"({{"id":"{}","tipo":"triangulo","vertices":[[0,0,0],[1,0,0],[{}]]}})", id, last);
}

/// The text of a file after its patch.
Source mended(const Source& file, const SceneFixes& fixes) {
  return {"mended", json::patched_file(file, Source("fix", fixes.script)).text};
}

std::vector<std::string> operations_in(const std::string& patch) {
  const json::JsonValue operations = json::read_whole(Source("fix", patch));
  std::vector<std::string> lines;
  for (const json::JsonValue& operation : std::get<json::JsonItems>(operations.of)) {
    std::string& line = lines.emplace_back();
    for (const char* key : {"op", "path"}) line += std::get<std::string>(operation.member(key)->of) + " ";
    if (const json::JsonValue* const value = operation.member("value")) json::append_value(line, *value);
  }
  return lines;
}
using Lines = std::vector<std::string>;

TEST_CASE("an axis gets unit length in its direction, and what is not touched keeps its digits") {
  const Source file("f", file_of(plane("p", "0,2,0") + ",\n" + plane("q", "1.0, 1.00, 0e0") + ",\n" +
                                 R"({"id":"s","tipo":"esfera","centro":[1.50,0,-0.0],"radio":1e0})"));
  const SceneFixes fixes = scene_fixes(file);
  CHECK_FALSE(fixes.left);
  CHECK(operations_in(fixes.script) == Lines{"replace /elementos/0/vector [0,1,0]",
                                             "replace /elementos/1/vector "
                                             "[0.7071067811865476,0.7071067811865476,0]"});
  const Source after = mended(file, fixes);
  CHECK(after.text().find(R"("centro":[1.50,0,-0.0],"radio":1e0)") != after.text().npos);
  const SceneCheck check = check_scene(after);
  CHECK(check.errors.empty());
  CHECK(model::all_hold(check.invariants));
  CHECK(check.scene.size() == 3);
}

TEST_CASE("an element that stands twice is dropped, and another of its name gets a free one") {
  const Source file("f", file_of(sphere("a", 1) + "," + sphere("a:2", 5) + "," + sphere("a", 2) + "," + sphere("a", 1) +
                                     "," + sphere("a", 3) + "," + triangle("t", "2,0,0") + "," + triangle("u", "0,1,0"),
                                 R"({"g":{"elementos":["a"]}})"));
  const SceneFixes fixes = scene_fixes(file);
  CHECK_FALSE(fixes.left);
  CHECK(operations_in(fixes.script) == Lines{R"(replace /elementos/2/id "a:3")", R"(replace /elementos/4/id "a:4")",
                                             "remove /elementos/5 ", "remove /elementos/3 "});
  const scene::GroupedScene scene = read_grouped_scene(mended(file, fixes));
  CHECK(scene.scene.size() == 5);
  CHECK(scene.groups.of_element("a") == "g");
  CHECK(scene.scene.find("a:4"));
}

TEST_CASE("a member of a group is dropped where it is nothing, or in a group already") {
  const Source file("f", file_of(sphere("a", 1) + "," + sphere("b", 2),
                                 R"({"g":{"elementos":["a","x","b","a"]},"h":{"elementos":["b"],"groups":["g","z"]},)"
                                 R"("i":{"groups":["g"]}})"));
  const SceneFixes fixes = scene_fixes(file);
  CHECK_FALSE(fixes.left);
  const scene::GroupedScene scene = read_grouped_scene(mended(file, fixes));
  CHECK(scene.groups.table() == scene::Groups::Table{{"g", {{"a", "b"}, {}}}, {"h", {{}, {"g"}}}, {"i", {}}});
}

TEST_CASE("what nothing is proposed for is left, at its place in the file") {
  const Source file("f", file_of(plane("p", "0,2,0") + ",\n" + plane("q", "0,0,0") + ",\n" +
                                 R"({"id":"s","tipo":"esfera","centro":[0,0,0],"radio":-1})"));
  const SceneFixes fixes = scene_fixes(file);
  CHECK(operations_in(fixes.script).size() == 1);
  REQUIRE(fixes.left);
  CHECK(std::string(fixes.left->what()).starts_with("f:4:52: vector is (0, 0, 0); expected a unit vector"));
  const SceneFixes none = scene_fixes(Source("f", "{\"format\":"));
  CHECK(none.script.empty());
  REQUIRE(none.left);
  CHECK(std::string(none.left->what()).starts_with("f:1:11: "));
  // Groups within each other: no choice is better than another.
  const SceneFixes circle = scene_fixes(Source("f", file_of("", R"({"g":{"groups":["h"]},"h":{"groups":["g"]}})")));
  CHECK(circle.script.empty());
  CHECK(circle.left);
}

TEST_CASE("a scene gets operations that drop what is the same in all but its name") {
  const Source file("f", file_of(sphere("b", 1) + "," + sphere("a", 1) + "," + sphere("c", 2) + "," + sphere("d", 1) +
                                     "," + plane("p", "0,1,0") + "," + plane("q", "0,1,0"),
                                 R"({"g":{"elementos":["d"]}})"));
  const SceneFixes fixes = scene_fixes(file);
  CHECK_FALSE(fixes.left);
  CHECK(fixes.script ==
        "# b is the same as a.\nEliminar_Elemento e?=b\n"
        "# d is the same as a. It leaves the group g.\nEliminar_Elemento e?=d\n"
        "# q is the same as p.\nEliminar_Elemento e?=q\n");
  EditedScene edited(read_grouped_scene(file));
  test::edit(edited, fixes.script);
  CHECK(edited.of().scene.size() == 3);
  CHECK(scene_fixes(Source("f", edited.scene_text())).script.empty());
}

TEST_CASE("files with many random faults are mended, or told what is left") {
  test::Random random(20261129);
  for (int round = 0; round < 60; ++round) {
    std::string elements;
    for (int i = 0; i < 30; ++i) {
      const std::string id = fmt::format("e{}", random.below(25));
      const std::string some[] = {sphere(id, static_cast<int>(random.below(3))),
                                  plane(id, fmt::format("{},1,0", random.below(3))),
                                  triangle(id, random.below(3) == 0 ? "3,0,0" : "0,2,0")};
      elements += (elements.empty() ? "" : ",") + some[random.below(3)];
    }
    const auto name = [&] { return fmt::format("\"e{}\"", random.below(25)); };
    const std::string groups = fmt::format(R"({{"g":{{"elementos":[{},{}]}},"h":{{"elementos":[{}],"groups":["g"]}}}})",
                                           name(), name(), name());
    const Source file("f", file_of(elements, groups));
    const SceneFixes fixes = scene_fixes(file);
    CHECK_FALSE(fixes.left);
    const Source after = fixes.script.starts_with("[") ? mended(file, fixes) : file;
    const SceneCheck check = check_scene(after);
    CHECK(check.errors.empty());
    EditedScene edited(read_grouped_scene(after));
    test::edit(edited, scene_fixes(after).script);
    CHECK(scene_fixes(Source("f", edited.scene_text())).script.empty());
  }
}

}  // namespace
}  // namespace durero::io
