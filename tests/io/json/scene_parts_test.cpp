// Scenes as parts with names.
#include "durero/io/json/scene_parts.hpp"

#include "durero/io/json/groups_file.hpp"
#include "io/json/any_edit.hpp"
#include "support/catch.hpp"
#include "support/property.hpp"

namespace durero::io {
namespace {

constexpr const char* small = R"({"format":"durero-scene","version":1,
"camera":{"eye":[0,2,-9],"look_at":[0,1,0],"up":[0,1,0],"fov_y":40},
"lights":[
{"position":[5,8,-5],"color":[1,1,1]}],
"materials":{
"a/b":{"color":[1,0,0]}},
"max_depth":3,
"groups":{
"g":{"elementos":["ball"]}},
"elementos":[
{"id":"ball","tipo":"esfera","centro":[0,1,0],"radio":1}
],
"mallas":[
{"id":"m","puntos":[
[0,0,0],
[1,0,0],
[0,1,0]],"caras":[
[0,1,2]]}
]}
)";

TEST_CASE("A part has a pointer, and its value") {
  std::string all;
  for (const auto& [name, value] : scene_parts(Source("f", small))) all += name.pointer() + " " + value + "\n";
  CHECK(all == R"(/camera/eye [0,2,-9]
/camera/fov_y 40
/camera/look_at [0,1,0]
/camera/up [0,1,0]
/lights [
{"position":[5,8,-5],"color":[1,1,1]}]
/materials/a~1b {"color":[1,0,0]}
/max_depth 3
/groups/g {"elementos":["ball"]}
/elementos/ball {"id":"ball","tipo":"esfera","centro":[0,1,0],"radio":1}
/mallas/m {"id":"m","puntos":[
[0,0,0],
[1,0,0],
[0,1,0]],"caras":[
[0,1,2]]}
)");
}

TEST_CASE("Parts that are put together are the scene") {
  CHECK(parts_text({}) == "{\"format\":\"durero-scene\",\"version\":1,\n\"elementos\":[]}\n");
  test::property("any scene", [] {
    scene::GroupedScene scene = test::any_grouped_scene();
    test::look_at_random(scene.scene);
    const std::string text = scene_text(scene.scene, scene.groups);
    const SceneParts parts = scene_parts(Source("f", text));
    const scene::GroupedScene back = read_grouped_scene(Source("f", parts_text(parts)), Bodies::read);
    RC_ASSERT(scene_text(back.scene, back.groups) == text);
    RC_ASSERT(scene_parts(Source("f", parts_text(parts))) == parts);
  });
}

}  // namespace
}  // namespace durero::io
