// Lines of scripts read back as the edits that they are the text of.
#include "durero/io/json/operation_text.hpp"

#include "durero/io/json/groups_file.hpp"
#include "io/json/any_edit.hpp"
#include "support/catch.hpp"
#include "support/property.hpp"

namespace durero::io {
namespace {

std::string text_of(test::AnyEdit edit, const scene::Stage& stage) {
  return operation_text({1, std::move(edit)}, stage);
}

scene::Stage stage_with(std::vector<std::string> names) {
  scene::Stage stage;
  for (std::string& name : names) stage.materials.push_back({.name = std::move(name)});
  return stage;
}

std::vector<ScriptStep> reread(const std::string& line, const scene::Stage& stage,
                               std::span<const WrittenType> types = {}) {
  return read_script(Source("line", line), stage, types);
}

/// The answer of a step, and what it makes of a scene.
std::string effect(const scene::GroupedScene& scene, const ScriptStep& step) {
  EditedScene edited(scene);
  const EditAnswer answer = edited.apply_total(step);
  return answer_text(1, answer) + edited.scene_text();
}

TEST_CASE("An edit has a line, which reads back as it") {
  const scene::Stage stage = stage_with({"red"});
  const auto check = [&](const std::string& line) {
    const std::vector<ScriptStep> steps = reread(line, stage);
    REQUIRE(steps.size() == 1);
    CHECK(operation_text(steps[0], stage) == line);
  };
  check("Agregar_Esfera e?=a centro?=(0,-0,1e-300) radio?=0.1 material?=red");
  check("Agregar_Cilindro e?=a centro?=(0,0,5) radio?=1 vector?=(0,1,0) altura?=2");
  check("Agregar_Triangulo e?=a vertices?=((0,5,0),(1,5,0),(0,6,0))");
  check("Agregar_Elemento e?=a t?=soy_esfera centro?=(0,0,5) radio?=1 altura?=-3");
  check("Eliminar_Elemento e?=a");
  check("Eliminar_Tronco e?=a");
  check("Agregar_Instancia e?=a de?=b centro?=(0,0,5) x?=(2,0,0) y?=(0,1,0) z?=(0,0,0.1) material?=red");
  check("Eliminar_Instancia e?=a");
  check("Agregar_Union e?=a de?=b,c material?=red");
  check("Agregar_Interseccion e?=a de?=c,b");
  check("Agregar_Diferencia e?=a de?=b,c,d");
  check("Eliminar_Solido e?=a");
  check("Agregar_Malla m?=m puntos?=((0,0,0),(1,0,0),(0,1,0)) caras?=((0,1,2)) material?=red");
  check("Reemplazar_Malla m?=m puntos?=() caras?=()");
  check("Eliminar_Malla m?=m");
  check("Mover_Vertice m?=m n?=4294967295 punto?=(0,2,0)");
  check("group g?=g elementos?=a,b groups?=h,i");
  check("group g?=g");
  check("ungroup g?=g");
  check("close e?=a base?=b top?=c");
}

TEST_CASE("A material whose name is no word has its line in JSON") {
  const scene::Stage stage = stage_with({"", "(x", "dark red", "#red", "\"\\\n"});
  const auto addition = [&](std::uint32_t material) {
    return text_of(scene::Edit{model::Agregar_Esfera{model::Elemento("a"), model::Punto(0, 0, 0), 1}, material}, stage);
  };
  const std::string rest = R"({"op":"Agregar_Esfera","e":"a","centro":[0,0,0],"radio":1,"material":)";
  CHECK(addition(0) == rest + R"(""})");
  CHECK(addition(1) == rest + R"("(x"})");
  CHECK(addition(2) == rest + R"("dark red"})");
  CHECK(addition(3) == "Agregar_Esfera e?=a centro?=(0,0,0) radio?=1 material?=#red");
  CHECK(addition(4) == rest + R"("\"\\\u000a"})");
  for (std::uint32_t i = 0; i < stage.materials.size(); ++i) {
    const std::vector<ScriptStep> steps = reread(addition(i), stage);
    REQUIRE(steps.size() == 1);
    CHECK(std::get<scene::Edit>(steps[0].edit).material == i);
  }
  const scene::Mesh mesh{model::Elemento("m"), {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}, 2};
  const std::string line = text_of(scene::MeshEdit(scene::MeshAddition{mesh}), stage);
  CHECK(line == R"({"op":"Agregar_Malla","m":"m","puntos":[[0,0,0],[1,0,0],[0,1,0]],"caras":[[0,1,2]],)"
                R"("material":"dark red"})");
  CHECK(text_of(scene::Joining{scene::Compound::Operation::united, "a", {"b", "c"}, 2}, stage) ==
        R"({"op":"Agregar_Union","e":"a","de":["b","c"],"material":"dark red"})");
}

TEST_CASE("An edit of elements of a Z text has its line by their types") {
  const std::vector<WrittenType> types{{"toro", {{"centro", WrittenKind::triple}, {"mayor", WrittenKind::number}}},
                                       {"vela", {{"vertices", WrittenKind::three_points}}}};
  for (const std::string line : {"Agregar_Toro e?=ring centro?=(0,0,0.1) mayor?=2 material?=red",
                                 "Agregar_Vela e?=sail vertices?=((0,5,0),(1,5,0),(0,6,0))", "Eliminar_Vela e?=sail"}) {
    const scene::Stage stage = stage_with({"red"});
    const std::vector<ScriptStep> steps = reread(line, stage, types);
    REQUIRE(steps.size() == 1);
    CHECK(operation_text(steps[0], stage, types) == line);
  }
}

TEST_CASE("Any edit is what its line reads back as") {
  test::property("any edit of any scene", [] {
    const scene::GroupedScene scene = test::any_grouped_scene(12);
    const scene::Stage& stage = scene.scene.stage();
    const ScriptStep step{1, test::any_edit(stage)};
    const std::string line = operation_text(step, stage);
    const std::vector<ScriptStep> back = reread(line, stage);
    RC_ASSERT(back.size() == std::size_t{1});
    RC_ASSERT(back[0].edit.index() == step.edit.index());
    RC_ASSERT(operation_text(back[0], stage) == line);
    RC_ASSERT(effect(scene, back[0]) == effect(scene, step));
  });
}

}  // namespace
}  // namespace durero::io
