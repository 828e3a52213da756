// The parts that two scenes differ in.
#include "durero/io/json/scene_changes.hpp"

#include "durero/io/json/groups_file.hpp"
#include "io/json/any_edit.hpp"
#include "support/catch.hpp"
#include "support/property.hpp"

namespace durero::io {
namespace {

scene::GroupedScene scene_of(const std::string& members) {
  return read_grouped_scene(Source("f", R"({"format":"durero-scene","version":1,)" + members + "}"), Bodies::read);
}

TEST_CASE("A change is added, removed or changed, and has its values on one line") {
  const std::string a = R"({"id":"a","tipo":"esfera","centro":[0,1,0],"radio":1})";
  const std::string b = R"({"id":"b","tipo":"esfera","centro":[0,1,0],"radio":1})";
  const std::string c = R"({"id":"c","tipo":"esfera","centro":[0,1,0],"radio":1})";
  const std::string grown = R"({"id":"b","tipo":"esfera","centro":[0,1,0],"radio":2})";
  const std::vector<PartChange> changes = part_changes(
      scene_of("\"elementos\":[" + a + "," + b + "]"),
      scene_of(R"("lights":[{"position":[0,0,0],"color":[1,1,1]}],"elementos":[)" + grown + "," + c + "]"));
  std::string all;
  for (const PartChange& change : changes) all += change_text(change) + "\n";
  CHECK(all == R"({"part":"/lights","change":"added","to":[{"position":[0,0,0],"color":[1,1,1]}]})"
               "\n{\"part\":\"/elementos/a\",\"change\":\"removed\",\"from\":" +
                   a + "}\n{\"part\":\"/elementos/b\",\"change\":\"changed\",\"from\":" + b + ",\"to\":" + grown +
                   "}\n{\"part\":\"/elementos/c\",\"change\":\"added\",\"to\":" + c + "}\n");
  CHECK(changes_summary(changes) ==
        "lights: 1 added, 0 removed, 0 changed\nelementos: 1 added, 1 removed, 1 changed\n");
  CHECK(changes_summary({}).empty());
}

TEST_CASE("Changes that are made in the parts of one scene make the other") {
  test::property("any two scenes", [] {
    scene::GroupedScene a = test::any_grouped_scene();
    scene::GroupedScene b = test::flip() ? a : test::any_grouped_scene();
    test::edit_at_random(b, 10);
    test::look_at_random(b.scene);
    SceneParts parts = scene_parts(a);
    for (const PartChange& change : part_changes(a, b)) {
      RC_ASSERT(change.from != change.to);
      RC_ASSERT((parts.contains(change.part) ? std::optional(parts[change.part]) : std::nullopt) == change.from);
      if (change.to)
        parts[change.part] = *change.to;
      else
        parts.erase(change.part);
    }
    RC_ASSERT(parts == scene_parts(b));
  });
}

}  // namespace
}  // namespace durero::io
