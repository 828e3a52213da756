#include "durero/render/light/planar_mirror.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "durero/model/operaciones.hpp"
#include "durero/render/light/whitted.hpp"
#include "durero/render/output/image.hpp"
#include "durero/render/render.hpp"
#include "durero/scene/srgb.hpp"
#include "durero/scene/stage.hpp"
#include "support/catch.hpp"

using namespace durero;

namespace {

constexpr scene::Resolution size{96, 64};
const glm::dvec3 normal{0.6, 0, -0.8};

/// A mirror across the room, a ball and a tube before it, and a ball behind it that the mirror must not show.
scene::Scene room() {
  scene::Scene scene;
  scene::Stage& stage = scene.stage();
  stage.camera = {{0.5, 0.4, -6}, {0, 0.2, 1}, {0, 1, 0}, 50};
  stage.resolution = size;
  stage.background = glm::dvec3(0.2, 0.3, 0.5);
  stage.lights = {{{-4, 5, -5}, {1, 1, 0.9}}};
  stage.materials = {{.name = "blue", .color = {0.1, 0.2, 0.9}, .k_d = 0.8, .k_s = 0.4, .e = 30},
                     {.name = "mirror", .color = {0, 0, 0}, .k_d = 0, .k_ps = 1},
                     {.name = "red", .color = {0.9, 0.1, 0.1}}};
  const auto wear = [&](const char* name, std::uint32_t material) { scene.set_material(*scene.find(name), material); };
  using model::Elemento;
  scene.apply(model::Agregar_Plano{Elemento("mirror"), {0, 0, 2}, model::Vector(normal)});
  scene.apply(model::Agregar_Esfera{Elemento("ball"), {0.3, 0.3, -0.6}, 0.7});
  scene.apply(model::Agregar_Cilindro{Elemento("tube"), {-1.5, -1, -1}, 0.4, {0, 1, 0}, 2});
  scene.apply(model::Agregar_Esfera{Elemento("behind"), {0, 0, 8}, 2});
  wear("mirror", 1);
  wear("ball", 2);
  wear("tube", 0);
  wear("behind", 2);
  return scene;
}

int apart(const glm::dvec3& a, const glm::dvec3& b) {
  int most = 0;
  for (int i = 0; i < 3; ++i) most = std::max(most, std::abs(scene::srgb_byte(a[i]) - scene::srgb_byte(b[i])));
  return most;
}

glm::dvec3 color(const scene::Scene& scene, const engine::Engine& engine, const scene::Query& query,
                 std::uint32_t depth) {
  return render::brought(scene, engine, {&query, 1}, {depth}).at(0).color;
}

}  // namespace

TEST_CASE("what the second camera sees is what the mirror shows, every pixel to 1/255") {
  scene::Scene scene = room();
  scene.stage().camera->mirrored = GENERATE(false, true);
  const auto engine = engine::find("exact")->prepare(scene);
  const scene::PrimaryRays first(*scene.stage().camera, size);
  const render::SecondCamera second(*scene.stage().camera, size, {0, 0, 2}, normal);
  const scene::ElementRef mirror = *scene.find("mirror");
  int pixels = 0, of_background = 0;
  for (std::uint32_t y = 0; y < size.height; ++y)
    for (std::uint32_t x = 0; x < size.width; ++x) {
      const scene::Query query{first.ray(x, y)};
      const scene::Hit hit = engine::first_hits(*engine, {&query, 1}).at(0);
      if (hit.elementos != scene::ElementSet{mirror}) continue;
      ++pixels;
      const auto ray = second.ray(x, y);
      REQUIRE(ray);
      const glm::dvec3 seen = color(scene, *engine, {*ray, {mirror}}, 1);
      CHECK(apart(seen, color(scene, *engine, query, 2)) <= 1);
      of_background += seen == *scene.stage().background;
    }
  CHECK(pixels > 2000);
  CHECK(pixels - of_background > 100);  // the ball and the tube are in the mirror
}

TEST_CASE("the mirrored camera is as far behind the mirror, and its picture is turned left to right") {
  const scene::Camera camera{{0, 0, -5}, {0, 0, 0}, {0, 1, 0}, 60};
  const render::SecondCamera second(camera, {4, 3}, {0, 0, 2}, {0, 0, -1});
  CHECK(second.camera().eye == glm::dvec3(0, 0, 9));
  CHECK(second.camera().look_at == glm::dvec3(0, 0, 4));
  CHECK(second.camera().up == glm::dvec3(0, 1, 0));
  CHECK(second.camera().mirrored);
  const scene::PrimaryRays first(camera, {4, 3});
  const auto ray = second.ray(0, 1);
  REQUIRE(ray);
  CHECK(ray->p().xyz().z == Approx(2));
  CHECK(glm::normalize(ray->v().xyz()).x == Approx(glm::normalize(first.ray(0, 1).v().xyz()).x));
  CHECK(glm::normalize(ray->v().xyz()).z == Approx(-glm::normalize(first.ray(0, 1).v().xyz()).z));
}

TEST_CASE("a pixel that looks away from the plane sees nothing in it") {
  const scene::Camera camera{{0, 0, -5}, {0, 0, -9}, {0, 1, 0}, 60};
  CHECK_FALSE(render::SecondCamera(camera, {4, 3}, {0, 0, 2}, {0, 0, -1}).ray(1, 1));
  CHECK_FALSE(render::SecondCamera(camera, {1, 1}, {0, 2, 0}, {0, 1, 0}).ray(0, 0));
}

TEST_CASE("between two facing mirrors a ball is there once more with each ray in a row") {
  scene::Scene scene;
  scene.stage().materials = {{.name = "glow", .color = {0, 0, 0}, .emission = {1, 0, 0}},
                             {.name = "mirror", .color = {0, 0, 0}, .k_d = 0, .k_ps = 1}};
  using model::Elemento;
  scene.apply(model::Agregar_Plano{Elemento("left"), {-1, 0, 0}, {1, 0, 0}});
  scene.apply(model::Agregar_Plano{Elemento("right"), {1, 0, 0}, {-1, 0, 0}});
  scene.apply(model::Agregar_Esfera{Elemento("ball"), {0, 0, 0}, 0.25});
  scene.set_material(*scene.find("left"), 1);
  scene.set_material(*scene.find("right"), 1);
  scene.set_material(*scene.find("ball"), 0);
  const auto engine = engine::find("exact")->prepare(scene);
  // Unfolded, the k-th image of the ball stands at (2k, 0, 0): the ray from the eye straight to it meets k mirrors.
  const glm::dvec3 eye(0, 0, -3);
  for (std::uint32_t depth = 1; depth <= 6; ++depth) {
    std::uint32_t copies = 0;
    for (int k = 0; k <= 8; ++k)
      copies += color(scene, *engine, {{model::Punto(eye), model::Vector(glm::dvec3(2 * k, 0, 0) - eye)}}, depth).x > 0;
    CHECK(copies == depth);
  }
}
