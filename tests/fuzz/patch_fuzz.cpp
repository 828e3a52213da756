// JSON Patches of a scene: whatever one makes of it, the differences and the merges between both scenes are right.
#include "durero/io/json/edited_scene.hpp"
#include "durero/io/json/groups_file.hpp"
#include "durero/io/json/scene_merge.hpp"
#include "durero/io/json/scene_patch.hpp"
#include "durero/io/json/scene_script.hpp"
#include "fuzz/fuzz.hpp"

using namespace durero;

namespace {

const char* const before = R"({"format":"durero-scene","version":1,
"camera":{"eye":[0,2,-9],"look_at":[0,1,0],"up":[0,1,0],"fov_y":40},
"lights":[{"position":[5,8,-5],"color":[1,1,1]}],
"materials":{"red":{"color":[1,0,0]}},
"groups":{"g":{"elementos":["ball"]}},
"elementos":[
{"id":"ball","tipo":"esfera","centro":[0,1,0],"radio":1,"material":"red"},
{"id":"both","tipo":"union","de":[{"tipo":"esfera","centro":[0,1,0],"radio":1},{"tipo":"plano","centro":[0,0,0],"vector":[0,1,0]}]}],
"mallas":[{"id":"m","puntos":[[0,0,0],[1,0,0],[0,1,0]],"caras":[[0,1,2]]}]})";

std::string text_of(const scene::GroupedScene& of) { return io::scene_text(of.scene, of.groups); }

void check_script(const scene::GroupedScene& from, const scene::GroupedScene& to) {
  const io::SceneScript script = io::script_between(from, to);
  if (!script.beyond.empty()) return;
  io::EditedScene edited(from);
  for (const io::ScriptStep& step : script.steps) test::must(edited.apply_total(step).ok());
  test::must(edited.scene_text() == text_of(to));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return test::fuzz([&] {
    const scene::GroupedScene base = io::read_grouped_scene(io::Source("base", before), io::Bodies::read);
    const scene::GroupedScene now = io::patched_scene(base, test::as_source(data, size));
    const io::Source patch("patch", io::scene_patch(base, now));
    test::must(text_of(io::patched_scene(base, patch)) == text_of(now));
    check_script(base, now);
    check_script(now, base);
    test::must(text_of(io::merged_scene(base, now, base).scene.value()) == text_of(now));
  });
}
