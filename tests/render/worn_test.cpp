#include <cmath>
#include <memory>
#include <vector>

#include "durero/scene/stage.hpp"
#include "render/lone_rays.hpp"

using namespace durero;
using namespace durero::test;

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
  scene::TexelImage ramp{4, 1};
  for (int i = 0; i < 4; ++i) ramp.texels.emplace_back(i / 4.0);
  scene.stage().textures = {{.name = "ramp", .pattern = scene::Pattern::image, .repeat = {0.25, 1}}};
  scene.stage().textures[0].image.levels = std::make_shared<const std::vector<scene::TexelImage>>(1, ramp);
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
  scene::TexelImage checker{4, 4};
  for (int i = 0; i < 16; ++i) checker.texels.emplace_back((i % 4 + i / 4) % 2);
  scene.stage().textures = {
      {.name = "t", .pattern = scene::Pattern::image, .filter = scene::Filter::mipmap, .near = 3}};
  scene.stage().textures[0].image.levels =
      std::make_shared<const std::vector<scene::TexelImage>>(scene::mipmap(checker));
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
