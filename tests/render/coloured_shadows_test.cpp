// Coloured shadows: what clear elements let through of a light (transmitido.def.1 of spec/luz.tex).
#include <array>
#include <glm/geometric.hpp>
#include <vector>

#include "durero/render/render.hpp"
#include "durero/scene/stage.hpp"
#include "render/lone_rays.hpp"

using namespace durero;
using namespace durero::test;

namespace {

using model::Elemento;

constexpr std::uint32_t floor_look = 0, red = 1, pale = 2, stone = 3;

/// A matt floor under a lamp at the height 10, without anything between. Its colours tell the light apart.
scene::Scene lit_floor() {
  scene::Scene scene;
  scene.stage().materials = {{.name = "a", .color = glm::dvec3(1)},
                             {.name = "b", .color = black, .k_d = 0, .k_t = 0.5, .M_T = {1, 0.25, 0}},
                             {.name = "c", .color = black, .k_d = 0, .k_t = 1, .M_T = {0.5, 0.5, 0.75}, .index = 1.5},
                             {.name = "d", .color = glm::dvec3(1)}};
  scene.stage().lights = {{{0, 10, 0}, {1, 1, 1}}};
  scene.apply(model::Agregar_Plano{Elemento("floor"), {0, 0, 0}, {0, 1, 0}});
  scene.set_material(*scene.find("floor"), floor_look);
  return scene;
}

void add(scene::Scene& scene, const model::Operation& what, const char* name, std::uint32_t look) {
  scene.apply(what);
  scene.set_material(*scene.find(name), look);
}

/// The colour of the floor under the lamp, by a ray from beside it.
glm::dvec3 floor_color(const scene::Scene& scene, render::ShadowRule rule, const char* engine = "exact",
                       render::Integrator by = render::Integrator::whitted) {
  const scene::Query query{{{3, 0.5, 0}, {-3, -0.5, 0}}};
  return render::brought(scene, *engine::find(engine)->prepare(scene), {&query, 1},
                         {.max_depth = 1, .integrator = by, .shadows = rule})
      .at(0)
      .color;
}

glm::dvec3 coloured(const scene::Scene& scene) { return floor_color(scene, render::ShadowRule::coloured); }

}  // namespace

TEST_CASE("a sheet lets its share of each colour through; by the text's rule it casts a full shadow") {
  scene::Scene scene = lit_floor();
  CHECK(coloured(scene) == glm::dvec3(1));
  add(scene, model::Agregar_Disco{Elemento("sheet"), {0, 5, 0}, 1, {0, 1, 0}}, "sheet", red);
  CHECK(coloured(scene) == glm::dvec3(0.5, 0.125, 0));
  CHECK(floor_color(scene, render::ShadowRule::opaque) == black);
}

TEST_CASE("a ball counts at both of its points, and one that holds the lamp at one of them") {
  scene::Scene scene = lit_floor();
  add(scene, model::Agregar_Esfera{Elemento("ball"), {0, 5, 0}, 1}, "ball", pale);
  CHECK(coloured(scene) == glm::dvec3(0.25, 0.25, 0.5625));
  scene.stage().lights[0].position = {0, 5, 0};
  CHECK(coloured(scene) == glm::dvec3(0.5, 0.5, 0.75));
}

TEST_CASE("all that stands between takes its share, and a stone takes all") {
  scene::Scene scene = lit_floor();
  add(scene, model::Agregar_Disco{Elemento("sheet"), {0, 7, 0}, 1, {0, 1, 0}}, "sheet", red);
  add(scene, model::Agregar_Esfera{Elemento("ball"), {0, 3, 0}, 1}, "ball", pale);
  CHECK(coloured(scene) == glm::dvec3(0.125, 0.03125, 0));
  add(scene, model::Agregar_Disco{Elemento("above"), {0, 12, 0}, 1, {0, 1, 0}}, "above", stone);
  CHECK(coloured(scene) == glm::dvec3(0.125, 0.03125, 0));
  add(scene, model::Agregar_Disco{Elemento("stone"), {0, 8, 0}, 1, {0, 1, 0}}, "stone", stone);
  CHECK(coloured(scene) == black);
}

TEST_CASE("an element without a material, and one whose light has no colour, is a stone") {
  scene::Scene scene = lit_floor();
  scene.apply(model::Agregar_Disco{Elemento("plain"), {0, 7, 0}, 1, {0, 1, 0}});
  CHECK(coloured(scene) == black);
  scene = lit_floor();
  scene.stage().materials[red].M_T = black;
  add(scene, model::Agregar_Disco{Elemento("sheet"), {0, 7, 0}, 1, {0, 1, 0}}, "sheet", red);
  CHECK(coloured(scene) == black);
}

TEST_CASE("where the light runs along a sheet, it casts the full shadow") {
  scene::Scene scene = lit_floor();
  add(scene, model::Agregar_Disco{Elemento("upright"), {0, 5, 0}, 1, {1, 0, 0}}, "upright", red);
  CHECK(coloured(scene) == black);
}

TEST_CASE("a light without end is coloured by all on its way") {
  scene::Scene scene = lit_floor();
  scene.stage().lights.clear();
  scene.stage().directional_lights = {{{0, -3, 0}, {1, 1, 1}}};
  add(scene, model::Agregar_Disco{Elemento("sheet"), {0, 1e9, 0}, 1, {0, 1, 0}}, "sheet", red);
  CHECK(coloured(scene) == glm::dvec3(0.5, 0.125, 0));
  CHECK(floor_color(scene, render::ShadowRule::opaque) == black);
}

TEST_CASE("paths colour their lights too") {
  scene::Scene scene = lit_floor();
  add(scene, model::Agregar_Disco{Elemento("sheet"), {0, 5, 0}, 1, {0, 1, 0}}, "sheet", red);
  CHECK(floor_color(scene, render::ShadowRule::coloured, "exact", render::Integrator::path) ==
        glm::dvec3(0.5, 0.125, 0));
}

TEST_CASE("a texture of the glass counts where the light passes it") {
  scene::Scene scene = lit_floor();
  scene.stage().textures = {{.name = "squares", .colors = {glm::dvec3(1, 0, 1), glm::dvec3(0, 1, 0)}}};
  scene.stage().materials[pale].textures.names[std::size_t(scene::Coefficient::M_T)] = "squares";
  add(scene, model::Agregar_Plano{Elemento("window"), {0, 5, 0}, {0, 1, 0}}, "window", pale);
  std::vector<glm::dvec3> seen;
  for (const double x : {0.5, 1.5}) {
    for (const double z : {0.5, 1.5}) {
      scene.stage().lights[0].position = {2 * x, 10, 2 * z};  // the light to the origin passes the pane at (x, 5, z)
      seen.push_back(coloured(scene));
    }
  }
  const double cosine = 10 / glm::length(glm::dvec3(1, 10, 1));
  CHECK(std::ranges::any_of(seen, [](const glm::dvec3& c) { return c.x > 0 && c.y == 0 && c.z > 0; }));
  CHECK(std::ranges::any_of(seen, [](const glm::dvec3& c) { return c.x == 0 && c.y > 0 && c.z == 0; }));
  CHECK(std::ranges::all_of(seen, [&](const glm::dvec3& c) { return c.x <= 0.5 * cosine + 1e-12; }));
}

TEST_CASE("every engine draws the same coloured picture, and without clear elements the text's") {
  scene::Scene scene = lit_floor();
  scene::Stage& stage = scene.stage();
  stage.lights.push_back(
      {{4, 6, -3}, {0.5, 0.5, 1}, {.shape = scene::LightShape::disc, .radius = 1, .normal = {0, -1, 0}}});
  stage.directional_lights = {{{1, -2, 1}, {0.25, 0.25, 0.125}}};
  add(scene, model::Agregar_Esfera{Elemento("ball"), {0, 2, 0}, 1}, "ball", pale);
  add(scene, model::Agregar_Cilindro{Elemento("tube"), {1.5, 0.5, 0.5}, 0.5, {0, 1, 0}, 2}, "tube", red);
  add(scene, model::Agregar_Triangulo{Elemento("flag"), {{-3, 1, -1}, {-1, 1, 1}, {-2, 4, 0}}}, "flag", red);
  add(scene, model::Agregar_Cono{Elemento("stone"), {2, 0, 2}, 0.5, {0, 1, 0}, 2}, "stone", stone);
  stage.camera = scene::Camera{{0.1, 5, -9}, {0, 0.5, 0}, {0, 1, 0}, 40};
  const auto drawn = [&](std::string_view engine, render::ShadowRule rule) {
    return render::render(scene, *engine::find(engine)->prepare(scene), {},
                          {.size = scene::Resolution{32, 24}, .samples = {.most = 4}, .shadows = rule})
        .rgb;
  };
  const auto truth = drawn("exact", render::ShadowRule::coloured);
  CHECK(truth != drawn("exact", render::ShadowRule::opaque));
  for (const engine::EngineRow& row : engine::engines())
    if (row.exact_bytes) CHECK(drawn(row.name, render::ShadowRule::coloured) == truth);
  for (scene::Material& m : stage.materials) m.k_t = 0;
  CHECK(drawn("fast", render::ShadowRule::coloured) == drawn("fast", render::ShadowRule::opaque));
}
