// Scenes and JSON Patch.
#include "durero/io/json/scene_patch.hpp"

#include "durero/io/json/groups_file.hpp"
#include "io/json/any_edit.hpp"
#include "support/catch.hpp"
#include "support/property.hpp"

namespace durero::io {
namespace {

std::string text_of(const scene::GroupedScene& of) { return scene_text(of.scene, of.groups); }

scene::GroupedScene ball_and_group() {
  return read_grouped_scene(Source("f", R"({"format":"durero-scene","version":1,"groups":{"g":{"elementos":["ball"]}},)"
                                        R"("elementos":[{"id":"ball","tipo":"esfera","centro":[0,1,0],"radio":1}]})"));
}

/// The error of a patch that makes no scene, with its place.
std::string error_of(const std::string& patch) {
  try {
    static_cast<void>(patched_scene(ball_and_group(), Source("p", patch)));
    return "none";
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST_CASE("What a patch makes is read as every scene is") {
  CHECK(error_of(R"([{"op":"replace","path":"/elementos/0/radio","value":2}])") == "none");
  CHECK(error_of(R"([{"op":"replace","path":"/elementos/0/radio","value":0}])") ==
        "p:1:1: the scene is then wrong at /elementos/0/radio: radio (radius) is 0; expected r > 0 (Rmas.inv.1)");
  CHECK(error_of(R"([{"op":"remove","path":"/elementos/0"}])") ==
        "p:1:1: the scene is then wrong at /groups/g/elementos/0: \"ball\" is no element; expected elementos? ⊆ "
        "elementos "
        "(group.pre.2)");
  CHECK(error_of(R"([{"op":"replace","path":"","value":[]}])") ==
        "p:1:1: the scene is then wrong at the whole: a scene is an array; expected an object");
  CHECK(error_of(R"([{"op":"remove","path":"/elementos/1"}])") ==
        "p:1:24: \"/elementos/1\" is not there; expected a pointer to what the document has");
}

TEST_CASE("A patch between two scenes makes one of the other, byte for byte") {
  test::property("any two scenes", [] {
    scene::GroupedScene a = test::any_grouped_scene();
    scene::GroupedScene b = test::flip() ? a : test::any_grouped_scene();
    test::edit_at_random(a, 10);
    test::edit_at_random(b, 10);
    test::look_at_random(b.scene);
    const Source patch("p", scene_patch(a, b));
    RC_ASSERT(text_of(patched_scene(a, patch)) == text_of(b));
    RC_ASSERT((patch.text() == empty_patch) == (text_of(a) == text_of(b)));
  });
}

}  // namespace
}  // namespace durero::io
