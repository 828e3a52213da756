#include "durero/render/whitted.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

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

/// The colour by the exact engine, and how many rays it was asked.
struct Traced {
  glm::dvec3 color;
  std::size_t rays;
};

Traced traced(const scene::Scene& scene, const model::Rayo& ray, std::uint32_t max_depth) {
  struct Counting : engine::Engine {
    const engine::Engine& of;
    mutable std::size_t asked = 0;
    explicit Counting(const engine::Engine& engine) : of(engine) {}
    void first_hits(std::span<const scene::Query> queries, std::span<scene::Hit> hits) const override {
      asked += queries.size();
      of.first_hits(queries, hits);
    }
    void occluded_segments(std::span<const scene::Query> queries, std::span<bool> occluded) const override {
      of.occluded_segments(queries, occluded);
    }
  };
  const auto exact = engine::find("exact")->prepare(scene);
  const Counting counting(*exact);
  const glm::dvec3 seen = color(scene, counting, ray, max_depth);
  return {seen, counting.asked};
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
