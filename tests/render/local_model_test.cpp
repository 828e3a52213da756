#include <cmath>
#include <glm/geometric.hpp>

#include "durero/scene/stage.hpp"
#include "render/lone_rays.hpp"

using namespace durero;
using namespace durero::test;

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
  // The power is that of 0 where the mirrored light leads away from the eye.
  scene.stage().lights = {{{10, 2, 0}, {1, 1, 1}}};
  const model::Rayo slanting({2, 2, 0}, {-2, -1, 0});
  CHECK(color(scene, Fake(above), slanting).x == Approx(1));
  scene.stage().materials[0].e = 3;
  CHECK(color(scene, Fake(above), slanting) == black);
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
