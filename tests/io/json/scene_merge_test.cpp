// Two changes of one scene, put together.
#include "durero/io/json/scene_merge.hpp"

#include "durero/io/json/groups_file.hpp"
#include "durero/io/json/scene_script.hpp"
#include "io/json/any_edit.hpp"
#include "support/catch.hpp"
#include "support/property.hpp"

namespace durero::io {
namespace {

std::string text_of(const scene::GroupedScene& of) { return scene_text(of.scene, of.groups); }

std::string text_of(const SceneMerge& merge) { return merge.scene ? text_of(*merge.scene) : "conflict"; }

scene::GroupedScene scene_of(const std::string& members) {
  return read_grouped_scene(Source("f", R"({"format":"durero-scene","version":1,)" + members + "}"), Bodies::read);
}

std::string sphere(const std::string& id, const std::string& rest = "\"radio\":1") {
  return R"({"id":")" + id + R"(","tipo":"esfera","centro":[0,1,0],)" + rest + "}";
}

std::string elements(const std::string& items) { return "\"elementos\":[" + items + "]"; }

/// The parts in conflict with their labels, a line each; or the merged text.
std::string merged(const std::string& base, const std::string& ours, const std::string& theirs) {
  const SceneMerge merge = merged_scene(scene_of(base), scene_of(ours), scene_of(theirs));
  CHECK(merge.scene.has_value() == merge.conflicts.empty());
  if (merge.scene) return text_of(*merge.scene);
  std::string all;
  for (const MergeConflict& conflict : merge.conflicts)
    all += conflict.part + " " + std::string(conflict.violated->label) + "\n";
  return all;
}

std::string canonical(const std::string& members) { return text_of(scene_of(members)); }

const std::string a = sphere("a"), b = sphere("b"), c = sphere("c");
const std::string large = R"("radio":2)", huge = R"("radio":3)";

TEST_CASE("Changes of different parts stand together") {
  CHECK(merged(elements(a + "," + b), elements(sphere("a", large) + "," + b), elements(a + "," + sphere("b", huge))) ==
        canonical(elements(sphere("a", large) + "," + sphere("b", huge))));
  CHECK(merged(elements(a + "," + b), elements(b), elements(a + "," + b + "," + c)) ==
        canonical(elements(b + "," + c)));
  CHECK(merged(elements(a), elements(sphere("a", large)), elements(sphere("a", large))) ==
        canonical(elements(sphere("a", large))));
  CHECK(merged(elements(a), elements(""), elements("")) == canonical(elements("")));
  const std::string camera = R"("camera":{"eye":[0,0,1],"look_at":[0,0,0],"up":[0,1,0],"fov_y":)";
  const std::string moved = R"("camera":{"eye":[0,0,2],"look_at":[0,0,0],"up":[0,1,0],"fov_y":)";
  CHECK(merged(camera + "40}," + elements(""), camera + "50}," + elements(""), moved + "40}," + elements("")) ==
        canonical(moved + "50}," + elements("")));
}

TEST_CASE("A part that both sides change is in conflict") {
  CHECK(merged(elements(a), elements(sphere("a", large)), elements(sphere("a", huge))) == "/elementos/a merge.pre.1\n");
  CHECK(merged(elements(""), elements(a), elements(sphere("a", huge))) == "/elementos/a merge.pre.1\n");
  CHECK(merged(elements(a), elements(""), elements(sphere("a", huge))) == "/elementos/a merge.pre.2\n");
  CHECK(merged(elements(a), elements(sphere("a", huge)), elements("")) == "/elementos/a merge.pre.2\n");
  const std::string red = R"("materials":{"red":{"color":[1,0,0]}},)",
                    dark = R"("materials":{"red":{"color":[0.5,0,0]}},)";
  CHECK(merged(elements(a), red + elements(a), dark + elements(a)) == "/materials/red merge.pre.1\n");
  const std::string light = R"("lights":[{"position":[0,0,0],"color":[1,1,1]}],)";
  const std::string lamp = R"("lights":[{"position":[0,0,0],"color":[0,1,1]}],)";
  CHECK(merged(light + elements(a), elements(a), lamp + elements(a)) == "/lights merge.pre.2\n");
  const std::string both = "," + elements(a + "," + b);
  CHECK(merged(R"("groups":{"g":{}})" + both, R"("groups":{"g":{"elementos":["a"]}})" + both,
               R"("groups":{"g":{"elementos":["b"]}})" + both) == "/groups/g merge.pre.1\n");
}

TEST_CASE("Parts of two right scenes may make a wrong one") {
  const std::string both = "," + elements(a + "," + b);
  // A member of a group that one side makes, and whose element the other removes.
  CHECK(merged(elements(a + "," + b), R"("groups":{"g":{"elementos":["a"]}})" + both, elements(b)) ==
        "/groups/g group.pre.2\n");
  CHECK(merged(R"("groups":{"h":{}})" + both, R"("groups":{"g":{"groups":["h"]},"h":{}})" + both, both.substr(1)) ==
        "/groups/g group.pre.3\n");
  CHECK(merged(both.substr(1), R"("groups":{"g":{"elementos":["a"]}})" + both,
               R"("groups":{"h":{"elementos":["a"]}})" + both) == "/groups/h group.pre.4\n");
  CHECK(merged(R"("groups":{"i":{}})" + both, R"("groups":{"g":{"groups":["i"]},"i":{}})" + both,
               R"("groups":{"h":{"groups":["i"]},"i":{}})" + both) == "/groups/h group.pre.5\n");
  CHECK(merged(R"("groups":{"g":{},"h":{}})" + both, R"("groups":{"g":{"groups":["h"]},"h":{}})" + both,
               R"("groups":{"g":{},"h":{"groups":["g"]}})" + both) == "/groups/g groups.inv.1\n");
  // The face of a mesh that one side adds, and an element that the other gives its name.
  CHECK(merged(elements(""), elements(sphere("m:0")),
               R"("elementos":[],"mallas":[{"id":"m","puntos":[[0,0,0],[1,0,0],[0,1,0]],"caras":[[0,1,2]]}])") ==
        "/mallas/m Agregar_Malla.pre.5\n");
  // A material that one side removes, and that the other uses.
  const std::string red = R"("materials":{"red":{"color":[1,0,0]}},)";
  CHECK(merged(red + elements(a), elements(a),
               red + elements(a + "," + sphere("b", R"("radio":1,"material":"red")"))) == "/elementos/b merge.pre.3\n");
  // A camera that looks at the place where the other side puts it.
  const auto camera = [](const char* eye, const char* look_at) {
    return std::string(R"("camera":{"eye":)") + eye + R"(,"look_at":)" + look_at + R"(,"up":[0,1,0],"fov_y":40},)" +
           elements("");
  };
  CHECK(merged(camera("[0,0,1]", "[0,0,0]"), camera("[0,0,2]", "[0,0,0]"), camera("[0,0,1]", "[0,0,2]")) ==
        "/camera merge.pre.3\n");
}

TEST_CASE("A conflict is a line of JSON with both sides") {
  const SceneMerge changed =
      merged_scene(scene_of(elements(a)), scene_of(elements("")), scene_of(elements(sphere("a", huge))));
  REQUIRE(changed.conflicts.size() == 1);
  CHECK(conflict_text(changed.conflicts[0]) ==
        R"({"part":"/elementos/a","violated":"merge.pre.2",)"
        R"("predicate":"(dom base ∖ dom ours) ◁ theirs ⊆ base ∧ (dom base ∖ dom theirs) ◁ ours ⊆ base",)"
        R"("base":{"id":"a","tipo":"esfera","centro":[0,1,0],"radio":1},)"
        R"("theirs":{"id":"a","tipo":"esfera","centro":[0,1,0],"radio":3}})");
  const auto lights = [](const char* color) {
    return scene_of(R"("lights":[{"position":[0,0,0],"color":)" + std::string(color) + "}]," + elements(""));
  };
  const SceneMerge lit = merged_scene(scene_of(elements("")), lights("[1,1,1]"), lights("[0,1,1]"));
  REQUIRE(lit.conflicts.size() == 1);
  CHECK(conflict_text(lit.conflicts[0]).find('\n') == std::string::npos);
  CHECK(conflict_text(lit.conflicts[0])
            .ends_with(R"("ours":[{"position":[0,0,0],"color":[1,1,1]}],)"
                       R"("theirs":[{"position":[0,0,0],"color":[0,1,1]}]})"));
  const SceneMerge wrong = merged_scene(scene_of(elements(a)), scene_of(elements("")),
                                        scene_of(R"("groups":{"g":{"elementos":["a"]}},)" + elements(a)));
  REQUIRE(wrong.conflicts.size() == 1);
  CHECK(conflict_text(wrong.conflicts[0]) ==
        R"({"part":"/groups/g","violated":"group.pre.2","predicate":"elementos? ⊆ elementos",)"
        R"x("message":"\"a\" is no element; expected elementos? ⊆ elementos (group.pre.2)",)x"
        R"("theirs":{"elementos":["a"]}})");
}

TEST_CASE("A merge with what has not changed is the change, and sides may be exchanged") {
  test::property("any scene, and any changes of it", [] {
    const scene::GroupedScene base = test::any_grouped_scene();
    scene::GroupedScene ours = base, theirs = base;
    test::edit_at_random(ours, 12);
    test::edit_at_random(theirs, 12);
    test::look_at_random(theirs.scene);
    RC_ASSERT(text_of(merged_scene(base, base, theirs)) == text_of(theirs));
    RC_ASSERT(text_of(merged_scene(base, theirs, base)) == text_of(theirs));
    RC_ASSERT(text_of(merged_scene(base, theirs, theirs)) == text_of(theirs));
    const SceneMerge merge = merged_scene(base, ours, theirs), exchanged = merged_scene(base, theirs, ours);
    RC_TAG(merge.scene ? "merged" : "conflict");
    RC_ASSERT(text_of(merge) == text_of(exchanged));
    RC_ASSERT(merge.conflicts.size() == exchanged.conflicts.size());
    for (std::size_t i = 0; i < merge.conflicts.size(); ++i) {
      MergeConflict conflict = exchanged.conflicts[i];
      std::swap(conflict.ours, conflict.theirs);
      RC_ASSERT(conflict_text(conflict) == conflict_text(merge.conflicts[i]));
    }
    if (merge.scene)
      RC_ASSERT(text_of(read_grouped_scene(Source("f", text_of(merge)), Bodies::read)) == text_of(merge));
  });
}

TEST_CASE("Scripts of different elements commute, and their scenes merge into what both make") {
  test::property("any changes of the elements of either half of the names", [] {
    const scene::GroupedScene base = test::any_grouped_scene();
    const auto edited = [](scene::GroupedScene scene, std::string_view names) {
      EditedScene of(std::move(scene));
      for (int n = test::below(8); n > 0; --n) {
        const model::Elemento e(std::string(1, names[static_cast<std::size_t>(test::below(3))]));
        of.apply_total({1, test::flip() ? removal_of(e.name()) : scene::Edit{test::any_addition(e), {}}});
      }
      return of.of();
    };
    // Groups change where their elements are removed, so that they are left out.
    scene::GroupedScene start{base.scene, {}};
    const scene::GroupedScene ours = edited(start, "abc"), theirs = edited(start, "def");
    const SceneMerge merge = merged_scene(start, ours, theirs);
    RC_ASSERT(merge.scene.has_value());
    for (const auto& [from, to] : {std::pair{&ours, &theirs}, std::pair{&theirs, &ours}}) {
      EditedScene both(*from);
      for (const ScriptStep& step : script_between(start, *to).steps) RC_ASSERT(both.apply_total(step).ok());
      RC_ASSERT(both.scene_text() == text_of(merge));
    }
  });
}

}  // namespace
}  // namespace durero::io
