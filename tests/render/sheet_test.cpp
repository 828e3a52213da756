#include <string_view>
#include <vector>

#include "durero/render/render.hpp"
#include "durero/scene/stage.hpp"
#include "render/lone_rays.hpp"

using namespace durero;
using namespace durero::test;

namespace {

/// A lit ball, a mirror and glass over a checker that is seen from (0, 1, -9), and a material that is no more than a
/// sheet. Nothing is on the near side of one before the eye: it would be in its shadow. No meeting sends on two rays,
/// so that colours are added in one order, with the sheet and without.
scene::Scene behind_a_sheet() {
  scene::Scene scene = lit_ball();
  scene::Stage& stage = scene.stage();
  stage.background = glm::dvec3(0.2, 0.4, 0.8);
  stage.lights = {{{-3, 7, -2}, {0.7, 0.6, 0.5}}, {{4, 9, 3}, {0.3, 0.3, 0.4}}};
  stage.textures = {{.name = "squares", .colors = {glm::dvec3(0.9), glm::dvec3(0.1)}, .repeat = {0.7, 0.7}}};
  stage.materials.push_back({.name = "silver", .color = glm::dvec3(0.3), .k_a = 0.2, .k_s = 0.6, .e = 30, .k_ps = 0.7});
  stage.materials.push_back({.name = "glass", .color = black, .k_d = 0, .k_t = 0.9, .index = 1.5});
  stage.materials.push_back({.name = "floor", .color = glm::dvec3(0.8), .k_a = 0.1});
  stage.materials.back().textures.names[std::size_t(scene::Coefficient::color)] = "squares";
  stage.materials.push_back({.name = "sheet", .color = glm::dvec3(1), .k_d = 0, .k_t = 1});
  const auto wear = [&](const char* name, std::uint32_t material) { scene.set_material(*scene.find(name), material); };
  scene.apply(model::Agregar_Esfera{model::Elemento("mirror"), {2.1, 0.1, 0.4}, 1});
  wear("mirror", 1);
  scene.apply(model::Agregar_Esfera{model::Elemento("lens"), {-1.1, -0.3, -1.9}, 0.7});
  wear("lens", 2);
  scene.apply(model::Agregar_Disco{model::Elemento("floor"), {0, -1, 1}, 5.5, {0, 1, 0}});
  wear("floor", 3);
  stage.camera = scene::Camera{{0.1, 1, -9}, {0.3, 0, 0}, {0, 1, 0}, 40};
  stage.resolution = scene::Resolution{48, 36};
  return scene;
}

}  // namespace

TEST_CASE("a sheet that takes nothing and bends nothing is invisible, to the last bit") {
  const auto drawn = [](const scene::Scene& scene, std::string_view engine) {
    return render::render(scene, *engine::find(engine)->prepare(scene), {}, {.max_depth = 30}).rgb;
  };
  const scene::Scene bare = behind_a_sheet();
  const auto truth = drawn(bare, "exact");
  const model::Elemento e("sheet"), other("sheet-2");
  // Across no axis; each is between the eye and all that is lit, one is seen from its back.
  const std::vector<std::vector<model::Operation>> sheets{
      {model::Agregar_Plano{e, {0, 0, -6}, {0.48, 0.36, -0.8}}},
      {model::Agregar_Disco{e, {0.2, 0.8, -7}, 5, {-0.36, 0.48, 0.8}}},
      {model::Agregar_Triangulo{e, {{-9, -9, -6}, {9, -8, -7}, {0.3, 20, -6.5}}}},
      {model::Agregar_Disco{e, {0, 0.7, -6.5}, 1.1, {0.6, 0, -0.8}},
       model::Agregar_Triangulo{other, {{-9, -9, -6}, {9, -8, -5.5}, {0.3, 20, -6}}}}};
  for (const auto& some : sheets) {
    scene::Scene scene = bare;
    for (const model::Operation& sheet : some) scene.apply(sheet);
    for (const model::Elemento& name : {e, other})
      if (const auto found = scene.find(name.name())) scene.set_material(*found, 4);
    for (const char* const engine : {"exact", "fast"}) CHECK(drawn(scene, engine) == truth);
    scene.stage().materials[4].M_T = {1, 1, 0.5};  // it is there
    CHECK(drawn(scene, "fast") != truth);
  }
}
