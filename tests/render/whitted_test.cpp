#include "durero/render/whitted.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "durero/model/operaciones.hpp"
#include "durero/render/render.hpp"
#include "render/lit_ball.hpp"
#include "support/catch.hpp"

using namespace durero;
using durero::test::lit_ball;

namespace {

const scene::ElementRef ball{model::Tipo::soy_esfera, 0}, blocker{model::Tipo::soy_esfera, 1};

/// Answers every ray with one hit, and every shadow ray with one word; remembers what the shadow rays started on.
struct Fake : engine::Engine {
  scene::Hit hit;
  bool shadow;
  mutable scene::ElementSet origin{};

  explicit Fake(const scene::Hit& every = {}, bool in_shadow = false) : hit(every), shadow(in_shadow) {}

  void first_hits(std::span<const scene::Query>, std::span<scene::Hit> hits) const override {
    std::fill(hits.begin(), hits.end(), hit);
  }
  void occluded_segments(std::span<const scene::Query> queries, std::span<bool> occluded) const override {
    for (const scene::Query& query : queries) {
      origin = query.en;
      CHECK(query.rayo.p().xyz() == hit.punto);
    }
    std::fill(occluded.begin(), occluded.end(), shadow);
  }
};

glm::dvec3 color(const scene::Scene& scene, const engine::Engine& engine, const model::Rayo& ray,
                 std::uint32_t max_depth = 1) {
  const scene::Query query{ray};
  return render::brought(scene, engine, {&query, 1}, {max_depth}).at(0).color;
}

/// The colour by the exact engine, and how many rays it was asked, and how many of them to point lights.
struct Traced {
  glm::dvec3 color;
  std::size_t rays, shadow_rays;
};

Traced traced(const scene::Scene& scene, const model::Rayo& ray, std::uint32_t max_depth) {
  struct Counting : engine::Engine {
    const engine::Engine& of;
    mutable std::size_t asked = 0, asked_to_lights = 0;
    explicit Counting(const engine::Engine& engine) : of(engine) {}
    void first_hits(std::span<const scene::Query> queries, std::span<scene::Hit> hits) const override {
      asked += queries.size();
      of.first_hits(queries, hits);
    }
    void occluded_segments(std::span<const scene::Query> queries, std::span<bool> occluded) const override {
      asked_to_lights += queries.size();
      of.occluded_segments(queries, occluded);
    }
  };
  const auto exact = engine::find("exact")->prepare(scene);
  const Counting counting(*exact);
  const glm::dvec3 seen = color(scene, counting, ray, max_depth);
  return {seen, counting.asked, counting.asked_to_lights};
}

/// A plane through a point of the x axis, across it, with that material.
void add_wall(scene::Scene& scene, const char* name, double x, double facing, const scene::Material& look) {
  const auto index = static_cast<std::uint32_t>(scene.stage().materials.size());
  scene.stage().materials.push_back(look);
  scene.apply(model::Agregar_Plano{model::Elemento(name), {x, 0, 0}, {facing, 0, 0}});
  scene.set_material(*scene.find(name), index);
}

const model::Rayo down{{0, 5, 0}, {0, -1, 0}}, along{{0.5, 0, 0}, {1, 0, 0}};
const scene::Hit above{model::Resultado::hit, 4, {0, 1, 0}, {ball}};
const glm::dvec3 black(0);

}  // namespace

TEST_CASE("Lambert's law: full where the light is overhead, cosine elsewhere, none from behind") {
  const scene::Scene scene = lit_ball();
  Fake top(above);
  CHECK(color(scene, top, down) == glm::dvec3(1, 0, 0));
  CHECK(top.origin == scene::ElementSet{ball});  // the shadow ray starts on the element hit: no offset

  const glm::dvec3 side = glm::normalize(glm::dvec3(1, 1, 0));
  Fake slope({model::Resultado::hit, 1, side, {ball}});
  const glm::dvec3 to_light = glm::normalize(glm::dvec3(0, 10, 0) - side);
  CHECK(color(scene, slope, {{5, 5, 0}, {-1, -1, 0}}).r == Approx(glm::dot(to_light, side)));

  Fake bottom({model::Resultado::hit, 4, {0, -1, 0}, {ball}});
  CHECK(color(scene, bottom, {{0, -5, 0}, {0, 1, 0}}) == glm::dvec3(0, 0, 0));
}

TEST_CASE("a shadow takes the light away") {
  const scene::Scene scene = lit_ball();
  Fake top(above, true);
  CHECK(color(scene, top, down) == glm::dvec3(0, 0, 0));
}

TEST_CASE("several lights add up; each has its colour") {
  scene::Scene scene = lit_ball();
  scene.set_material(ball, std::nullopt);
  scene.stage().lights.push_back({{0, 3, 0}, {0, 0.25, 0.5}});
  Fake top(above);
  const glm::dvec3 c = color(scene, top, down);
  CHECK(c.r == Approx(0.8));
  CHECK(c.g == Approx(0.8 * 0.75));
  CHECK(c.b == Approx(0.8 * 0.75));
}

TEST_CASE("where there is no nearest point, and where there is none, the background shows") {
  scene::Scene scene = lit_ball();
  scene.stage().background = glm::dvec3(0.1, 0.2, 0.3);
  CHECK(color(scene, Fake{}, down) == glm::dvec3(0.1, 0.2, 0.3));
  Fake inside({model::Resultado::no_minimum, 0, {}, {ball}});
  CHECK(color(scene, inside, down) == glm::dvec3(0.1, 0.2, 0.3));
}

TEST_CASE("of several elements at one point the first by name gives the colour") {
  scene::Scene scene = lit_ball();
  scene.stage().materials.push_back({"white", {1, 1, 1}});
  scene.apply(model::Agregar_Esfera{model::Elemento("another"), {0, 0, 0}, 1});
  scene.set_material(*scene.find("another"), 1);
  Fake both({model::Resultado::hit, 4, {0, 1, 0}, {ball, blocker}});
  CHECK(color(scene, both, down) == glm::dvec3(1, 0.5, 0.25));
}

TEST_CASE("each term of the local model by itself") {
  scene::Scene scene = lit_ball();
  scene::Material& look = scene.stage().materials[0];
  const glm::dvec3 light = scene.stage().lights[0].color;
  const auto seen = [&](const scene::Material& material) {
    look = material;
    return color(scene, Fake(above), down);
  };
  CHECK(seen({.color = {1, 0.5, 0.25}, .k_d = 0}) == black);
  CHECK(seen({.color = {1, 0.5, 0.25}, .k_d = 0.5}) == 0.5 * light * glm::dvec3(1, 0.5, 0.25));
  CHECK(seen({.color = {1, 0.5, 0.25}, .k_a = 0.25, .k_d = 0}) == 0.25 * light * glm::dvec3(1, 0.5, 0.25));
  CHECK(seen({.k_d = 0, .k_s = 0.5, .e = 10}) == 0.5 * light);  // the light's own colour, full where r = v
  CHECK(seen({.k_d = 0, .emission = {1, 2, 3}}) == glm::dvec3(1, 2, 3));
  CHECK(seen({.k_d = 0, .ambient = {0.1, 0.2, 0.3}}) == glm::dvec3(0.1, 0.2, 0.3));
}

TEST_CASE("k_a counts for each light that is seen, emission and ambient once; shadow takes the first alone") {
  scene::Scene scene = lit_ball();
  scene.stage().lights = {{{0, 10, 0}, {1, 1, 1}}, {{0, 20, 0}, {1, 1, 1}}};
  scene.stage().materials[0] = {.color = {1, 1, 1}, .k_a = 0.25, .k_d = 0, .emission = {1, 0, 0}, .ambient = {0, 1, 0}};
  CHECK(color(scene, Fake(above), down) == glm::dvec3(1.5, 1.5, 0.5));
  CHECK(color(scene, Fake(above, true), down) == glm::dvec3(1, 1, 0));
}

TEST_CASE("a highlight falls with the cosine's power, and is not there behind") {
  scene::Scene scene = lit_ball();
  scene.stage().materials[0] = {.k_d = 0, .k_s = 1, .e = 3};
  scene.stage().lights = {{{10, 11, 0}, {1, 1, 1}}};  // at 45°; the mirror of the light leaves at 45° to the ray
  CHECK(color(scene, Fake(above), down).x == Approx(std::pow(std::sqrt(0.5), 3)));
  scene.stage().materials[0].e = 0;
  CHECK(color(scene, Fake(above), down).x == Approx(1));
  scene.stage().lights = {{{10, -11, 0}, {1, 1, 1}}};
  CHECK(color(scene, Fake(above), down) == black);
}

TEST_CASE("depth counts from 1, and rays are sent on only where something is left to send") {
  scene::Scene scene;
  add_wall(scene, "mirror", 1, -1, {.k_d = 0, .k_ps = 0.5, .emission = {1, 1, 1}});
  add_wall(scene, "facing", 0, 1, {.k_d = 0, .k_ps = 0.5, .emission = {1, 1, 1}});
  // Each mirror shines with 1, and shows half of the other: 1, 1 + 1/2, 1 + 1/2 + 1/4, …
  CHECK(traced(scene, along, 0).color == black);
  for (std::uint32_t depth = 1; depth <= 5; ++depth) {
    const Traced at = traced(scene, along, depth);
    CHECK(at.color.x == 2 - std::pow(0.5, depth - 1));
    CHECK(at.rays == depth);
  }
  scene.stage().materials[1].k_ps = 0;
  CHECK(traced(scene, along, 5).rays == 2);
}

TEST_CASE("with no light, one and three, the mirror is asked once") {
  for (const std::size_t lights : {0, 1, 3}) {
    scene::Scene scene;
    scene.stage().lights.assign(lights, {{0.5, 10, 0}, {1, 1, 1}});
    add_wall(scene, "mirror", 1, -1, {.k_d = 0, .k_ps = 0.25, .M_PS = {1, 0.5, 0}});
    add_wall(scene, "lamp", 0, 1, {.k_d = 0, .emission = {1, 1, 1}});
    const Traced at = traced(scene, along, 9);
    CHECK(at.rays == 2);
    CHECK(at.color == glm::dvec3(0.25, 0.125, 0));
  }
}

TEST_CASE("from every meeting one ray goes to each light, and no more") {
  scene::Scene scene;
  scene.stage().lights.assign(3, {{0.5, 10, 0}, {1, 1, 1}});
  add_wall(scene, "mirror", 1, -1, {.color = {1, 1, 1}, .k_ps = 0.5});
  add_wall(scene, "facing", 0, 1, {.color = {1, 1, 1}, .k_ps = 0.5});
  const Traced at = traced(scene, along, 5);
  CHECK(at.rays == 5);
  CHECK(at.shadow_rays == 3 * 5);
}

TEST_CASE("what mirrors and lets through sends two rays at every meeting") {
  scene::Scene scene;
  add_wall(scene, "sheet", 1, -1, {.k_d = 0, .k_ps = 0.5, .k_t = 0.25});
  add_wall(scene, "behind", 2, -1, {.k_d = 0, .emission = {4, 4, 4}});
  add_wall(scene, "before", 0, 1, {.k_d = 0, .emission = {1, 1, 1}});
  const Traced at = traced(scene, along, 9);
  CHECK(at.rays == 3);
  CHECK(at.color.x == 0.5 * 1 + 0.25 * 4);
}

TEST_CASE("total reflection: what would shine through goes the mirror's way, in the colour of the glass") {
  scene::Scene scene;
  const scene::Material glass{.color = {0, 0, 0}, .k_t = 0.5, .M_T = {1, 0.5, 0}, .index = 1.5};
  add_wall(scene, "out", 1, 1, glass);  // left along its normal: from 1.5 into 1
  scene.stage().background = glm::dvec3(1);
  scene.stage().materials.push_back({"lamp", {0, 0, 0}});
  scene.stage().materials.back().emission = {8, 8, 8};
  scene.apply(model::Agregar_Disco{model::Elemento("lamp"), {0.5, 2, 0}, 1, {0, 1, 0}});
  scene.set_material(*scene.find("lamp"), 1);
  // At more than 41.8° the ray turns back and meets the lamp at x = 0.5; at less it is gone.
  CHECK(traced(scene, {{0.5, 1, 0}, {1, 1, 0}}, 3).color == 0.5 * 8.0 * glass.M_T);
  CHECK(traced(scene, {{0.5, 1, 0}, {1, 0.5, 0}}, 3).color == 0.5 * 1.0 * glass.M_T);
}

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

TEST_CASE("which medium: glass in water, air in glass, and a start inside") {
  scene::Scene scene;
  scene.stage().background = glm::dvec3(0);
  const auto medium = [](double index) { return scene::Material{.k_d = 0, .k_t = 1, .index = index}; };
  add_wall(scene, "water", 1, -1, medium(1.25));
  add_wall(scene, "glass", 2, -1, medium(1.5));
  add_wall(scene, "back", 3, 1, scene.stage().materials[1]);
  scene.set_material(*scene.find("back"), 1);
  // The tangent of the angle in each medium follows from its sine, which is that in air over the index.
  const double sine = 0.6;
  const auto rise = [&](double index) { return (sine / index) / std::sqrt(1 - sine * sine / (index * index)); };
  const double y = rise(1) + rise(1.25) + rise(1.5) + rise(1.25);  // at x = 4, a unit in each
  scene.stage().materials.push_back({.name = "lamp", .emission = {1, 1, 1}});
  scene.apply(model::Agregar_Disco{model::Elemento("lamp"), {4, y, 0}, 1e-9, {1, 0, 0}});
  scene.set_material(*scene.find("lamp"), static_cast<std::uint32_t>(scene.stage().materials.size() - 1));
  CHECK(traced(scene, {{0, 0, 0}, {0.8, 0.6, 0}}, 9).color == glm::dvec3(1));
  // From inside of the glass: from 1.5 into the open, since it never entered the water.
  scene::Scene inside;
  inside.stage().background = glm::dvec3(0);
  add_wall(inside, "back", 3, 1, medium(1.5));
  inside.stage().materials.push_back({.name = "lamp", .emission = {1, 1, 1}});
  inside.apply(model::Agregar_Disco{model::Elemento("lamp"), {4, rise(1.5) + rise(1), 0}, 1e-9, {1, 0, 0}});
  inside.set_material(*inside.find("lamp"), 1);
  const double cosine = std::sqrt(1 - 0.4 * 0.4);
  CHECK(traced(inside, {{2, 0, 0}, {cosine, 0.4, 0}}, 9).color == glm::dvec3(1));
}

TEST_CASE("what a ray brings depends on no other ray, and on no unit of length") {
  const auto scene_of = [](double unit) {
    scene::Scene scene;
    scene.stage().background = glm::dvec3(0.3, 0.5, 0.7);
    scene.stage().lights = {{{0, 9 * unit, -3 * unit}, {0.7, 0.6, 0.5}}};
    scene.stage().materials = {
        {.name = "glass", .color = {0.1, 0.2, 0.3}, .k_s = 0.1, .e = 7, .k_ps = 0.3, .k_t = 0.6, .index = 1.5}};
    for (int i = 0; i < 6; ++i) {
      const std::string name = "g" + std::to_string(i);
      scene.apply(model::Agregar_Esfera{model::Elemento(name), {(i - 2.5) * 0.7 * unit, 0, i % 2 * unit}, 0.9 * unit});
      scene.set_material(*scene.find(name), 0);
    }
    return scene;
  };
  const auto rays_of = [](double unit) {
    std::vector<scene::Query> rays;
    for (int i = 0; i < 40; ++i) rays.push_back({{{(i - 20) * 0.1 * unit, 0.3 * unit, -5 * unit}, {0.01 * i, 0, 1}}});
    return rays;
  };
  const scene::Scene scene = scene_of(1);
  const auto rays = rays_of(1);
  const auto engine = engine::find("fast")->prepare(scene);
  const auto together = render::brought(scene, *engine, rays, {9});
  for (std::size_t i = 0; i < rays.size(); ++i) CHECK(color(scene, *engine, rays[i].rayo, 9) == together[i].color);
  for (const double unit : {0x1p-30, 0x1p30}) {
    const scene::Scene scaled = scene_of(unit);
    const auto same = render::brought(scaled, *engine::find("fast")->prepare(scaled), rays_of(unit), {9});
    for (std::size_t i = 0; i < rays.size(); ++i) CHECK(same[i].color == together[i].color);
  }
}

TEST_CASE("what counts too little is not followed: two mirrors of a half end at depth 5 where a twentieth is asked") {
  scene::Scene scene;
  add_wall(scene, "mirror", 1, -1, {.k_d = 0, .k_ps = 0.5, .emission = {1, 1, 1}});
  add_wall(scene, "facing", 0, 1, {.k_d = 0, .k_ps = 0.5, .emission = {1, 1, 1}});
  const auto engine = engine::find("exact")->prepare(scene);
  const scene::Query query{along};
  const auto seen = [&](double min_weight) {
    return render::brought(scene, *engine, {&query, 1}, {15, min_weight}).at(0);
  };
  const render::Brought all = seen(0), some = seen(0.05);  // 0.5⁴ = 0.0625 ≥ 0.05 > 0.5⁵
  CHECK(all.depth == 15);
  CHECK(all.left_out == black);
  CHECK(some.depth == 5);
  CHECK(some.rays == 5);
  // The sixth ray would have brought 1/32 of 2 − 2⁻⁹, and the bound says no more than that but for its rounding.
  CHECK(all.color.x - some.color.x <= some.left_out.x);
  CHECK(some.left_out.x == Approx((2 - std::scalbn(1.0, -9)) / 32));
  CHECK(seen(0.0625).depth == 5);
  // All three components must count too little.
  scene.stage().materials[0].M_PS = scene.stage().materials[1].M_PS = {1, 0, 0};
  CHECK(seen(0.05).depth == 5);
  scene.stage().materials[0].M_PS = scene.stage().materials[1].M_PS = {0.1, 0.1, 0.1};
  CHECK(seen(0.05).depth == 2);
}

TEST_CASE("what was left out is never more than was said") {
  scene::Scene scene;
  scene.stage().background = glm::dvec3(0.5, 2, 0);
  scene.stage().lights = {{{0, 9, -3}, {0.7, 0.6, 0.5}}, {{5, 2, -9}, {0.1, 0.6, 0.9}}};
  scene.stage().materials = {{.name = "glass",
                              .color = {0.1, 0.2, 0.3},
                              .k_a = 0.2,
                              .k_s = 0.4,
                              .e = 3,
                              .k_ps = 0.4,
                              .M_PS = {1, 0.5, 0.2},
                              .k_t = 0.5,
                              .index = 1.5,
                              .emission = {0, 0.1, 0},
                              .ambient = {0.1, 0, 0}}};
  for (int i = 0; i < 6; ++i) {
    const std::string name = "g" + std::to_string(i);
    scene.apply(model::Agregar_Esfera{model::Elemento(name), {(i - 2.5) * 0.7, 0, i % 2 * 1.0}, 0.9});
    if (i > 0) scene.set_material(*scene.find(name), 0);
  }
  std::vector<scene::Query> rays;
  for (int i = 0; i < 200; ++i) rays.push_back({{{(i - 100) * 0.02, 0.3, -5}, {0.002 * i, 0, 1}}});
  const auto engine = engine::find("fast")->prepare(scene);
  const auto all = render::brought(scene, *engine, rays, {7});
  std::size_t lost = 0;
  for (const double min_weight : {0.01, 0.1, 0.3, 1.0}) {
    const auto some = render::brought(scene, *engine, rays, {7, min_weight});
    for (std::size_t i = 0; i < rays.size(); ++i)
      for (int c = 0; c < 3; ++c) {
        CHECK(some[i].color[c] <= all[i].color[c]);
        CHECK(all[i].color[c] - some[i].color[c] <= some[i].left_out[c]);
        lost += some[i].color[c] != all[i].color[c];
      }
  }
  CHECK(lost > 200);
}

TEST_CASE("what may be left out counts a background that is brighter than all that is lit") {
  scene::Scene scene;
  scene.stage().background = glm::dvec3(2, 4, 8);
  add_wall(scene, "mirror", 1, -1, {.k_d = 0, .k_ps = 0.5});
  const auto engine = engine::find("exact")->prepare(scene);
  const scene::Query query{along};
  const render::Brought at = render::brought(scene, *engine, {&query, 1}, {9, 0.75}).at(0);
  CHECK(at.color == black);
  for (int k = 0; k < 3; ++k) CHECK(at.left_out[k] == Approx(0.5 * (*scene.stage().background)[k]).epsilon(1e-8));
}

TEST_CASE("the depth that the materials need") {
  scene::Stage stage;
  CHECK(render::depth_of(stage) == 1);
  stage.materials = {{"matt", {1, 1, 1}}};
  CHECK(render::depth_of(stage) == 1);
  stage.materials[0].k_ps = 0.05;  // 0.05² = 0.0025 ≥ 1/510 > 0.05³
  CHECK(render::depth_of(stage) == 3);
  stage.materials[0].M_PS = {0.5, 0, 0};
  stage.materials[0].k_ps = 0.1;
  CHECK(render::depth_of(stage) == 3);
  stage.materials[0].k_t = 1;
  CHECK(render::depth_of(stage) == 15);
  stage.max_depth = 7;
  CHECK(render::depth_of(stage) == 7);
}

TEST_CASE("a directional light is a point light far away, and any element on the way hides it") {
  scene::Scene scene = lit_ball();
  scene.stage().materials[0] = {.color = {1, 0.5, 0.25}, .k_a = 0.1, .k_d = 0.7, .k_s = 0.2, .e = 9};
  scene.apply(model::Agregar_Esfera{model::Elemento("blocker"), {3.5, 30, 0}, 1});
  scene.stage().lights = {{{1e9, 1e10, 0}, {1, 1, 1}}};
  scene::Scene directional = scene;
  directional.stage().lights = {};
  directional.stage().directional_lights = {{{-0.5, -5, 0}, {1, 1, 1}}};
  std::size_t lit = 0, dark = 0;
  for (int i = 0; i < 100; ++i) {
    const model::Rayo ray({-0.99 + 0.02 * i, 5, 0.1}, {0, -1, 0});
    const glm::dvec3 far = traced(scene, ray, 1).color, sun = traced(directional, ray, 1).color;
    for (int c = 0; c < 3; ++c) CHECK(std::abs(far[c] - sun[c]) < 1e-6);
    ++(sun == black ? dark : lit);
  }
  CHECK(lit > 10);
  CHECK(dark > 10);
}

namespace {

using scene::Coefficient;

/// The lit ball under one light, with two textures: `half`, which is one half everywhere, and `rows`.
scene::Scene dressed_ball() {
  scene::Scene scene = lit_ball();
  scene.stage().textures = {{.name = "half", .colors = {glm::dvec3(0.5), glm::dvec3(0.5)}},
                            {.name = "rows", .colors = {glm::dvec3(1, 0.5, 0), glm::dvec3(0)}, .repeat = {1, 4}}};
  return scene;
}

void wear(scene::Material& m, Coefficient coefficient, const char* texture) {
  m.textures.names[static_cast<std::size_t>(coefficient)] = texture;
}

}  // namespace

TEST_CASE("a texture multiplies each coefficient: a colour by its colour, a share by its grey") {
  const glm::dvec3 light(1, 0.5, 0.25);
  const auto of = [&](auto set, Coefficient coefficient, const char* texture) {
    scene::Scene scene = dressed_ball();
    scene::Material& m = scene.stage().materials[0];
    m = {.name = "m", .color = {0, 0, 0}, .k_d = 0};
    set(m);
    wear(m, coefficient, texture);
    return color(scene, Fake(above), down);
  };
  using M = scene::Material;
  // The uppermost point of the ball has v = 1 and u = 0, in the even squares of "rows".
  const glm::dvec3 rows(1, 0.5, 0);
  CHECK(of([](M& m) { m.color = glm::dvec3(1), m.k_d = 1; }, Coefficient::color, "rows") == light * rows);
  CHECK(of([](M& m) { m.color = glm::dvec3(1), m.k_d = 1; }, Coefficient::k_d, "half") == light * 0.5);
  CHECK(of([](M& m) { m.color = glm::dvec3(1), m.k_d = 1; }, Coefficient::k_d, "rows") == light * 0.5);
  CHECK(of([](M& m) { m.color = glm::dvec3(1), m.k_a = 0.5; }, Coefficient::k_a, "half") == light * 0.25);
  CHECK(of([](M& m) { m.k_s = 0.5; }, Coefficient::k_s, "half") == light * 0.25);
  CHECK(of([](M& m) { m.emission = glm::dvec3(4); }, Coefficient::emission, "rows") == 4.0 * rows);
  CHECK(of([](M& m) { m.ambient = glm::dvec3(0.5); }, Coefficient::ambient, "rows") == 0.5 * rows);
}

TEST_CASE("a texture on k_ps and on k_t: what is sent on, and none where it is 0") {
  scene::Scene scene;
  scene.stage().background = glm::dvec3(1);
  scene.stage().textures = {
      {.name = "rows", .pattern = scene::Pattern::stripes, .colors = {glm::dvec3(0.5), glm::dvec3(0)}}};
  scene::Material look{.name = "wall", .color = {0, 0, 0}, .k_d = 0};
  add_wall(scene, "wall", 1, -1, look);
  // Across −x the first axis is +y: stripes of one unit along it.
  const auto at = [&](double y) { return traced(scene, {{0, y, 0.25}, {1, 0, 0}}, 2); };
  scene::Material& m = scene.stage().materials[0];
  for (const Coefficient c : {Coefficient::k_ps, Coefficient::k_t}) {
    m.k_ps = c == Coefficient::k_ps ? 1 : 0;
    m.k_t = c == Coefficient::k_t ? 1 : 0;
    m.textures = {};
    wear(m, c, "rows");
    CHECK(at(0.5).color == glm::dvec3(0.5));
    CHECK(at(0.5).rays == 2);
    CHECK(at(1.5).color == black);
    CHECK(at(1.5).rays == 1);
  }
  // M_PS and M_T by their colours.
  scene.stage().textures[0].colors[0] = {1, 0.5, 0};
  m.k_ps = m.k_t = 0.5;
  m.textures = {};
  wear(m, Coefficient::M_PS, "rows");
  wear(m, Coefficient::M_T, "rows");
  CHECK(at(0.5).color == glm::dvec3(1, 0.5, 0));
}

TEST_CASE("a relief turns the normal: by 45 degrees it is lit by what stands 45 degrees aside") {
  scene::Scene scene;
  // One texel a unit, rising by 1 a texel from 0 to 3 along u, which is +x on a floor.
  scene::Picture ramp{4, 1};
  for (int i = 0; i < 4; ++i) ramp.texels.emplace_back(i / 4.0);
  scene.stage().textures = {{.name = "ramp", .pattern = scene::Pattern::image, .repeat = {0.25, 1}}};
  scene.stage().textures[0].image.levels = std::make_shared<const std::vector<scene::Picture>>(1, ramp);
  scene.stage().directional_lights = {{{1, -1, 0}, {1, 1, 1}}};
  scene.stage().materials = {{.name = "floor", .color = {1, 1, 1}}};
  scene.stage().materials[0].bump = scene::Bump{"ramp", 4};
  scene.apply(model::Agregar_Plano{model::Elemento("floor"), {0, 0, 0}, {0, 1, 0}});
  scene.set_material(*scene.find("floor"), 0);
  const auto at = [&](double x) { return traced(scene, {{x, 1, 0.3}, {0, -1, 0}}, 1).color.x; };
  CHECK(at(2) == Approx(1).epsilon(1e-12));  // n' = (−1, 1, 0)/√2, against the light
  scene.stage().materials[0].bump->height = -4;
  CHECK(at(2) == Approx(0).margin(1e-12));  // and with it
  scene.stage().materials[0].bump->height = 0;
  CHECK(at(2) == Approx(std::sqrt(0.5)).epsilon(1e-12));
  // Twice as high, twice as steep: tan α = 2.
  scene.stage().materials[0].bump->height = 8;
  CHECK(at(2) == Approx((2 + 1) / std::sqrt(5.0) / std::sqrt(2.0)).epsilon(1e-12));
  scene.stage().materials[0].bump->height = -8;
  CHECK(at(2) == 0);  // the light, which the surface sees, is behind the relief
}

TEST_CASE("no relief sees a light behind its surface, nor does it mirror through it") {
  scene::Scene scene;
  scene.stage().background = glm::dvec3(0.25);
  scene.stage().textures = {
      {.name = "waves", .pattern = scene::Pattern::waves, .colors = {glm::dvec3(0), glm::dvec3(1)}}};
  scene.stage().lights = {{{0.3, -0.2, 0.1}, {1, 1, 1}}};
  scene.stage().materials = {{.name = "floor", .color = {1, 1, 1}, .k_s = 1, .k_ps = 1}};
  scene.stage().materials[0].bump = scene::Bump{"waves", 100};
  scene.apply(model::Agregar_Plano{model::Elemento("floor"), {0, 0, 0}, {0, 1, 0}});
  scene.apply(model::Agregar_Plano{model::Elemento("cellar"), {0, -3, 0}, {0, 1, 0}});
  scene.set_material(*scene.find("floor"), 0);
  // The light shines on the cellar alone, which no ray may see; what is mirrored is the sky.
  for (double x = 0.01; x < 1; x += 0.03)
    for (double z = 0.02; z < 1; z += 0.07)
      CHECK(traced(scene, {{x, 1, z}, {0.9, -1, 0.3}}, 2).color == glm::dvec3(0.25));
}

TEST_CASE("the distance of a mipmap is the whole way from the eye, along mirrors and through glass") {
  scene::Scene scene;
  scene::Picture checker{4, 4};
  for (int i = 0; i < 16; ++i) checker.texels.emplace_back((i % 4 + i / 4) % 2);
  scene.stage().textures = {
      {.name = "t", .pattern = scene::Pattern::image, .filter = scene::Filter::mipmap, .near = 3}};
  scene.stage().textures[0].image.levels = std::make_shared<const std::vector<scene::Picture>>(scene::mipmap(checker));
  scene::Material wall{.name = "wall", .color = {0, 0, 0}, .emission = {1, 1, 1}};
  wear(wall, Coefficient::emission, "t");
  add_wall(scene, "wall", -1, 1, wall);
  add_wall(scene, "mirror", 1, -1, {.name = "mirror", .color = {0, 0, 0}, .k_d = 0, .k_ps = 1});
  // In the middle of a white texel: from −1 + d to the wall is d, and over the mirror 2 + (2 − d).
  const auto towards = [&](double x, double v) { return traced(scene, {{x, 0.125, 0.125}, {v, 0, 0}}, 2).color.x; };
  CHECK(towards(0, -1) == towards(1, -1));    // within 3: the texel itself
  CHECK(towards(0, 1) == towards(1, -1));     // 1 + 2 = 3, still
  CHECK(towards(-0.9, 1) != towards(1, -1));  // 1.9 + 2
  CHECK(towards(-0.9, 1) == Approx(towards(1, -1) + (0.5 - towards(1, -1)) * std::log2(3.9 / 3)).epsilon(1e-12));
}

TEST_CASE("an environment stands where a background would, for every ray that meets nothing") {
  scene::Scene scene = lit_ball();
  scene.stage().background = glm::dvec3(9);
  scene.stage().environment =
      scene::Environment{.kind = scene::Surroundings::gradient, .colors = {glm::dvec3(0), glm::dvec3(1)}};
  CHECK(traced(scene, {{0, 5, 0}, {0, 1, 0}}, 1).color == glm::dvec3(1));
  CHECK(traced(scene, {{0, 5, 0}, {0, 0, 7}}, 1).color == glm::dvec3(0.5));
  scene.stage().materials[0] = {.name = "mirror", .color = {0, 0, 0}, .k_d = 0, .k_ps = 1};
  CHECK(traced(scene, down, 2).color == glm::dvec3(1));
}

TEST_CASE("a picture that was not read is said, and not drawn as nothing") {
  scene::Scene scene = dressed_ball();
  scene.stage().textures[0].pattern = scene::Pattern::image;
  wear(scene.stage().materials[0], Coefficient::color, "half");
  CHECK_THROWS_AS(color(scene, Fake(above), down), std::domain_error);
  wear(scene.stage().materials[0], Coefficient::color, "none");
  CHECK_THROWS_AS(color(scene, Fake(above), down), std::domain_error);
}
