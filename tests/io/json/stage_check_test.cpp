// What the text asks of materials and lights, of the stage of a scene.
#include "durero/io/json/stage_check.hpp"

#include <algorithm>

#include "durero/io/json/scene_check.hpp"
#include "durero/scene/stage.hpp"
#include "support/catch.hpp"

using namespace durero;

namespace {

scene::Stage with(const scene::Material& material) {
  scene::Stage stage{};
  stage.materials.push_back(material);
  return stage;
}

std::vector<std::string_view> broken(const scene::Stage& stage) {
  std::vector<std::string_view> labels;
  for (const model::Judgement& each : io::stage_invariants(stage))
    if (!each.holds) labels.push_back(each.what->label);
  return labels;
}

/// Glass that mirrors as much besides.
scene::Material sheet(double k_ps, double k_t) {
  scene::Material glass{.name = "glass/1"};
  glass.k_ps = k_ps;
  glass.k_t = k_t;
  return glass;
}

io::SceneCheck check_of(const std::string& material) {
  return io::check_scene(io::Source("f", R"({"format":"durero-scene","version":1,
"lights":[{"position":[0,0,0],"color":[1,1,1]}],
"materials":{"glass/1":{"color":[0,0,0])" + material +
                                             R"(}},"elementos":[]})"));
}

}  // namespace

TEST_CASE("a material is one of the text in each component of its colours") {
  scene::Material m{.name = "m", .color = {0.25, 0.5, 0.75}};
  m.k_d = 0.1;
  m.emission = {3, 4, 5};
  m.index = 1.5;
  const model::Material green = io::material_of(m, 1);
  CHECK(green.C == number::exact(0.5));
  CHECK(green.k_d == number::exact(0.1));
  CHECK(green.emisividad == 4);
  CHECK(green.M_T == 1);
  CHECK(green.indice == number::exact(1.5));
}

TEST_CASE("every invariant of a stage without materials and lights is none; else each stands once") {
  CHECK(io::stage_invariants({}).empty());
  scene::Stage stage = with(scene::Material{.name = "m"});
  CHECK(io::stage_invariants(stage).size() == 12);
  stage.materials.push_back(stage.materials.front());
  stage.directional_lights.push_back({{0, 0, 1}, {1, 1, 1}});
  stage.lights.push_back({{0, 0, 1}, {1, 1, 1}});
  CHECK(io::stage_invariants(stage).size() == 13);
  CHECK(broken(stage).empty());
}

TEST_CASE("one component of one material or light breaks an invariant") {
  using Labels = std::vector<std::string_view>;
  scene::Material m{.name = "m"};
  m.color = {0, 0, 1.5};
  CHECK(broken(with(m)) == Labels{"Material.inv.6"});
  m = {.name = "m"};
  m.index = 0;
  CHECK(broken(with(m)) == Labels{"Material.inv.12"});
  scene::Stage stage{};
  stage.lights = {{{0, 0, 0}, {1, 1, 1}}, {{0, 0, 0}, {0, -1, 0}}};
  CHECK(broken(stage) == Labels{"Fuente.inv.1"});
}

TEST_CASE("conserva.def.1 is warned of, but for what the storage of a decimal adds") {
  CHECK(io::stage_warnings(with(sheet(0.1, 0.9))).empty());
  CHECK(io::stage_warnings(with(sheet(0.7, 0.3))).empty());
  CHECK(io::stage_warnings(with(sheet(0.06, 0.94))).empty());
  CHECK(io::stage_warnings(with(sheet(0.5, 0.5 + 0x1p-51))).empty());
  CHECK(io::stage_warnings(with(sheet(0.5, 0.5 + 0x1p-49))).size() == 1);
  scene::Material tinted = sheet(0.5, 0.75);
  tinted.M_T = {0.5, 0.9, 0.1};
  const auto warnings = io::stage_warnings(with(tinted));
  REQUIRE(warnings.size() == 1);
  CHECK(warnings[0].message ==
        "material \"glass/1\" sends on 1.175 of the green light that it receives; expected k_ps * M_PS + k_t * M_T ≤ 1 "
        "(conserva.def.1)");
  CHECK(warnings[0].pointer == "/materials/glass~11");
  tinted.M_PS = {0.5, 0.5, 0.5};
  CHECK(io::stage_warnings(with(tinted)).empty());
}

TEST_CASE("a check tells of both: labels with their verdict, and warnings that change no verdict") {
  const io::SceneCheck good = check_of("");
  CHECK(good.invariants.size() == 9 + 12 + 1);
  CHECK(check_text(good).find("Material.inv.12 ok: indice ∈ Rmas\n") != std::string::npos);
  CHECK(check_json(good).find("warnings") == std::string::npos);
  const io::SceneCheck bright = check_of(R"(,"k_ps":1,"k_t":1)");
  CHECK(bright.findings.empty());
  CHECK(check_text(bright).find("warning: material \"glass/1\" sends on 2 of the red light") != std::string::npos);
  CHECK(check_json(bright).find(R"("ok":true,)") != std::string::npos);
  CHECK(check_json(bright).find(R"("pointer":"/materials/glass~11"})") != std::string::npos);
  CHECK(check_sarif(bright).find(R"({"ruleId":"conserva.def.1","level":"warning")") != std::string::npos);
  const io::SceneCheck wrong = check_of(R"(,"k_ps":1.5)");
  REQUIRE(wrong.findings.size() == 1);
  REQUIRE(wrong.findings[0].broken);
  CHECK(wrong.findings[0].broken->label == "Material.inv.4");
  CHECK(wrong.findings[0].message == "k_ps is 1.5; expected a share of light, 0 to 1 (Material.inv.4)");
}

TEST_CASE("a lens is one of the text, and a pinhole is none") {
  scene::Stage stage{};
  stage.camera = scene::Camera{{0, 0, -5}, {0, 0, 0}, {0, 1, 0}, 45};
  CHECK(io::stage_invariants(stage).empty());
  stage.camera->aperture = 0.5;
  CHECK(io::stage_invariants(stage).size() == 2);
  CHECK(broken(stage).empty());
  stage.camera->focus = -1;  // as if it were left out: the distance of look_at
  CHECK(broken(stage).empty());
  stage.camera->look_at = stage.camera->eye;
  CHECK(broken(stage) == std::vector<std::string_view>{"Lente.inv.3"});
}
