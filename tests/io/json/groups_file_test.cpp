#include "durero/io/json/groups_file.hpp"

#include "durero/io/json/scene_file.hpp"
#include "durero/model/operaciones.hpp"
#include "io/random_scene.hpp"
#include "support/catch.hpp"
#include "support/property.hpp"

using namespace durero;

namespace {

/// A scene of two elements, and groups.
std::string file(const std::string& groups) {
  return R"({"format":"durero-scene","version":1,"groups":)" + groups +
         R"(,"elementos":[{"id":"a","tipo":"esfera","centro":[0,0,0],"radio":1},)"
         R"({"id":"b","tipo":"esfera","centro":[0,0,0],"radio":1}]})";
}

/// The clause that the groups break, by which read_scene refuses them.
std::string broken_by(const std::string& groups) {
  std::vector<io::InputError> errors;
  io::read_scene(io::Source("f", file(groups)), errors);
  REQUIRE(errors.size() == 1);
  return errors[0].broken() == nullptr ? "none" : std::string(errors[0].broken()->label);
}

/// Of some elements and of some groups, which may be of one thing or of nothing.
scene::Groups any_groups(const scene::Scene& scene) {
  const auto flip = [] { return *rc::gen::arbitrary<bool>(); };
  scene::Groups groups;
  for (const char* name : {"z:9", "b", "a.b"}) {
    scene::Grouping made{name, {}};
    scene.for_each([&](scene::ElementRef e, const auto&) {
      const std::string& element = scene.name(e).name();
      if (groups.of_element(element).empty() && flip()) made.of.elementos.insert(element);
    });
    for (const auto& [group, of] : groups.table())
      if (groups.of_group(group).empty() && flip()) made.of.groups.insert(group);
    if (flip()) groups.apply_total(made, scene);
  }
  return groups;
}

}  // namespace

TEST_CASE("A scene and its groups read back from their text") {
  test::property("any scene", [] {
    const scene::Scene scene = test::any_scene();
    const scene::Groups groups = any_groups(scene);
    const std::string text = io::scene_text(scene, groups);
    const io::Source source("f", text);
    const scene::Scene back = io::read_scene(source);
    RC_ASSERT(test::same_scene(scene, back));
    RC_ASSERT(io::read_groups(source, back) == groups);
    RC_ASSERT((text == io::scene_text(scene)) == groups.empty());
  });
}

TEST_CASE("Groups stand by name, and may name those that stand below") {
  const io::Source source("f", file(R"({"all":{"groups":["z","none"]},"z":{"elementos":["b","a"]},"none":{}})"));
  const scene::Scene scene = io::read_scene(source);
  const scene::Groups groups = io::read_groups(source, scene);
  CHECK(groups.table() == scene::Groups::Table{{"all", {{}, {"none", "z"}}}, {"none", {}}, {"z", {{"a", "b"}, {}}}});
  const std::string_view written = R"(
"groups":{
"all":{"groups":["none","z"]},
"none":{},
"z":{"elementos":["a","b"]}},
"elementos")";
  CHECK(io::scene_text(scene, groups).find(written) != std::string::npos);
  CHECK(io::read_groups(io::Source("f", io::scene_text(scene)), scene).empty());
}

TEST_CASE("What breaks a clause of the groups is refused by it") {
  CHECK(broken_by(R"({"g":{"elementos":["x"]}})") == "group.pre.2");
  CHECK(broken_by(R"({"g":{"groups":["x"]}})") == "group.pre.3");
  CHECK(broken_by(R"({"g":{"elementos":["a","a"]}})") == "group.pre.4");
  CHECK(broken_by(R"({"g":{"elementos":["a"]},"h":{"elementos":["a"]}})") == "group.pre.4");
  CHECK(broken_by(R"({"g":{},"h":{"groups":["g"]},"i":{"groups":["g"]}})") == "group.pre.5");
  CHECK(broken_by(R"({"g":{"groups":["g"]}})") == "groups.inv.1");
  CHECK(broken_by(R"({"h":{"groups":["i"]},"i":{"groups":["h"]},"j":{"elementos":["a"]}})") == "groups.inv.1");
  CHECK(broken_by(R"({"g":{},"g":{}})") == "none");
  CHECK(broken_by(R"({"":{}})") == "none");
  CHECK(broken_by(R"({"g":{"elementos":["a b"]}})") == "none");
  CHECK(broken_by(R"({"g":{"members":[]}})") == "none");
}

TEST_CASE("Of wrong elements nothing is said where a group names them") {
  std::vector<io::InputError> errors;
  io::read_scene(io::Source("f", R"({"format":"durero-scene","version":1,"elementos":[{"id":"a"}],)"
                                 R"("groups":{"g":{"elementos":["a"]}}})"),
                 errors);
  CHECK(errors.size() == 1);
}
