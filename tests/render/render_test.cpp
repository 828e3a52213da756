#include "durero/render/render.hpp"

#include <atomic>
#include <glm/geometric.hpp>
#include <set>
#include <stdexcept>

#include "durero/trace/analytic.hpp"
#include "support/catch.hpp"

using namespace durero;

namespace {

const scene::ElementRef ball{model::Tipo::soy_esfera, 0}, blocker{model::Tipo::soy_esfera, 1};

/// A unit ball at the origin, red, lit from above; perhaps with a ball in the way of the light.
scene::Scene lit_ball() {
  scene::Scene scene;
  scene.stage().materials = {{"red", {1, 0, 0}}};
  scene.stage().lights = {{{0, 10, 0}, {1, 0.5, 0.25}}};
  scene.apply(model::Agregar_Esfera{model::Elemento("ball"), {0, 0, 0}, 1});
  scene.set_material(*scene.find("ball"), 0);
  return scene;
}

/// Answers every ray with one hit, and every shadow ray with one word; remembers what the shadow rays started on.
struct Fake {
  scene::Hit hit;
  bool shadow = false;
  mutable scene::ElementSet origin{};

  render::Tracer tracer() const {
    return {[this](const model::Rayo&, render::Tracer::Origin) { return hit; },
            [this](const model::Rayo& ray, render::Tracer::Origin en) {
              origin.assign(en.begin(), en.end());
              CHECK(ray.p().xyz() == hit.punto);
              return shadow;
            }};
  }
};

const model::Rayo down{{0, 5, 0}, {0, -1, 0}};

}  // namespace

TEST_CASE("Lambert's law: full where the light is overhead, cosine elsewhere, none from behind") {
  const scene::Scene scene = lit_ball();
  Fake top{{model::Resultado::hit, 4, {0, 1, 0}, {ball}}};
  CHECK(render::color(scene, top.tracer(), down) == glm::dvec3(1, 0, 0));
  CHECK(top.origin == scene::ElementSet{ball});  // the shadow ray starts on the element hit: no offset

  const glm::dvec3 side = glm::normalize(glm::dvec3(1, 1, 0));
  Fake slope{{model::Resultado::hit, 1, side, {ball}}};
  const glm::dvec3 to_light = glm::normalize(glm::dvec3(0, 10, 0) - side);
  CHECK(render::color(scene, slope.tracer(), {{5, 5, 0}, {-1, -1, 0}}).r == Approx(glm::dot(to_light, side)));

  Fake bottom{{model::Resultado::hit, 4, {0, -1, 0}, {ball}}};
  CHECK(render::color(scene, bottom.tracer(), {{0, -5, 0}, {0, 1, 0}}) == glm::dvec3(0, 0, 0));
}

TEST_CASE("a shadow takes the light away") {
  const scene::Scene scene = lit_ball();
  Fake top{{model::Resultado::hit, 4, {0, 1, 0}, {ball}}, true};
  CHECK(render::color(scene, top.tracer(), down) == glm::dvec3(0, 0, 0));
}

TEST_CASE("several lights add up; each has its colour") {
  scene::Scene scene = lit_ball();
  scene.set_material(ball, std::nullopt);
  scene.stage().lights.push_back({{0, 3, 0}, {0, 0.25, 0.5}});
  Fake top{{model::Resultado::hit, 4, {0, 1, 0}, {ball}}};
  const glm::dvec3 c = render::color(scene, top.tracer(), down);
  CHECK(c.r == Approx(0.8));
  CHECK(c.g == Approx(0.8 * 0.75));
  CHECK(c.b == Approx(0.8 * 0.75));
}

TEST_CASE("where there is no nearest point, and where there is none, the background shows") {
  scene::Scene scene = lit_ball();
  scene.stage().background = glm::dvec3(0.1, 0.2, 0.3);
  CHECK(render::color(scene, Fake{}.tracer(), down) == glm::dvec3(0.1, 0.2, 0.3));
  Fake inside{{model::Resultado::no_minimum, 0, {}, {ball}}};
  CHECK(render::color(scene, inside.tracer(), down) == glm::dvec3(0.1, 0.2, 0.3));
}

TEST_CASE("of several elements at one point the first by name gives the colour") {
  scene::Scene scene = lit_ball();
  scene.stage().materials.push_back({"white", {1, 1, 1}});
  scene.apply(model::Agregar_Esfera{model::Elemento("another"), {0, 0, 0}, 1});
  scene.set_material(*scene.find("another"), 1);
  Fake both{{model::Resultado::hit, 4, {0, 1, 0}, {ball, blocker}}};
  CHECK(render::color(scene, both.tracer(), down) == glm::dvec3(1, 0.5, 0.25));
}

TEST_CASE("normals are gradients of the power, on each type") {
  scene::Scene scene;
  scene.apply(model::Agregar_Esfera{model::Elemento("s"), {1, 2, 3}, 2});
  scene.apply(model::Agregar_Cilindro{model::Elemento("c"), {0, 0, 0}, 1, {0, 1, 0}, 2});
  scene.apply(model::Agregar_Cono{model::Elemento("k"), {0, 0, 0}, 1, {0, 1, 0}, 1});
  using model::Tipo;
  CHECK(render::normal(scene, {Tipo::soy_esfera, 0}, {3, 2, 3}) == glm::dvec3(1, 0, 0));
  CHECK(render::normal(scene, {Tipo::soy_cilindro, 0}, {0, 1.5, -1}) == glm::dvec3(0, 0, -1));
  const glm::dvec3 n = render::normal(scene, {Tipo::soy_cono, 0}, {0.5, 0.5, 0});
  CHECK(n.x == Approx(std::sqrt(0.5)));
  CHECK(n.y == Approx(std::sqrt(0.5)));
  CHECK(render::normal(scene, {Tipo::soy_cono, 0}, {0, 1, 0}) == glm::dvec3(0, 1, 0));  // the apex: the axis
}

TEST_CASE("render fills every pixel, tells its progress up to 1, and refuses a scene without a camera") {
  scene::Scene scene = lit_ball();
  CHECK_THROWS_AS(render::render(scene, Fake{}.tracer()), std::domain_error);
  scene.stage().camera = scene::Camera{{0, 0, -5}, {0, 0, 0}, {0, 1, 0}, 45};
  scene.stage().resolution = scene::Resolution{16, 8};
  scene.stage().background = glm::dvec3(1, 1, 1);
  double last = 0;
  const render::Image image = render::render(scene, Fake{}.tracer(), [&](double share) { last = share; });
  CHECK(last == 1);
  CHECK(image.resolution == scene::Resolution{16, 8});
  CHECK(image.rgb == std::vector<std::uint8_t>(16 * 8 * 3, 255));
}

TEST_CASE("an engine that answers many rays at once is asked row by row, and draws the same image") {
  scene::Scene scene = lit_ball();
  scene.stage().camera = scene::Camera{{0, 2, -5}, {0, 0, 0}, {0, 1, 0}, 45};
  scene.stage().resolution = scene::Resolution{32, 24};
  const trace::Tables tables(scene);
  render::Tracer tracer{
      [&](const model::Rayo& ray, render::Tracer::Origin en) { return trace::first_hit(tables, ray, en); },
      [&](const model::Rayo& ray, render::Tracer::Origin en) { return trace::occluded_segment(tables, ray, en); }};
  const render::Image one_by_one = render::render(scene, tracer);
  std::atomic<std::size_t> asked = 0;
  tracer.first_hits = [&](std::span<const scene::Query> rays, unsigned threads) {
    asked += rays.size();
    return trace::first_hits(tables, rays, threads);
  };
  CHECK(render::render(scene, tracer).rgb == one_by_one.rgb);
  CHECK(asked == 32 * 24);
  CHECK(std::set(one_by_one.rgb.begin(), one_by_one.rgb.end()).size() > 10);  // something is to be seen
}
