#include <cmath>
#include <vector>

#include "durero/scene/stage.hpp"
#include "render/lone_rays.hpp"

using namespace durero;
using namespace durero::test;

TEST_CASE("what counts too little is not followed: two mirrors of a half end at depth 5 where a twentieth is asked") {
  scene::Scene scene;
  add_wall(scene, "mirror", 1, -1, {.k_d = 0, .k_ps = 0.5, .emission = {1, 1, 1}});
  add_wall(scene, "facing", 0, 1, {.k_d = 0, .k_ps = 0.5, .emission = {1, 1, 1}});
  const auto engine = engine::find("exact")->prepare(scene);
  const scene::Query query{along};
  const auto seen = [&](double min_weight) {
    return render::brought(scene, *engine, {&query, 1}, {15, min_weight}).at(0);
  };
  const render::PathRadiance all = seen(0), some = seen(0.05);  // 0.5⁴ = 0.0625 ≥ 0.05 > 0.5⁵
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
  const render::PathRadiance at = render::brought(scene, *engine, {&query, 1}, {9, 0.75}).at(0);
  CHECK(at.color == black);
  for (int k = 0; k < 3; ++k) CHECK(at.left_out[k] == Approx(0.5 * (*scene.stage().background)[k]).epsilon(1e-8));
}
