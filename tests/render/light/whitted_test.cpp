#include "durero/render/light/whitted.hpp"

#include <cmath>

#include "durero/scene/stage.hpp"
#include "render/lone_rays.hpp"

using namespace durero;
using namespace durero::test;

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
