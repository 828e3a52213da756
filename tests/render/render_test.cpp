#include "durero/render/render.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <set>
#include <stdexcept>

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

glm::dvec3 color(const scene::Scene& scene, const engine::Engine& engine, const model::Rayo& ray) {
  const scene::Query query{ray};
  return render::colors(scene, engine, {&query, 1}).at(0);
}

const model::Rayo down{{0, 5, 0}, {0, -1, 0}};

}  // namespace

TEST_CASE("Lambert's law: full where the light is overhead, cosine elsewhere, none from behind") {
  const scene::Scene scene = lit_ball();
  Fake top({model::Resultado::hit, 4, {0, 1, 0}, {ball}});
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
  Fake top({model::Resultado::hit, 4, {0, 1, 0}, {ball}}, true);
  CHECK(color(scene, top, down) == glm::dvec3(0, 0, 0));
}

TEST_CASE("several lights add up; each has its colour") {
  scene::Scene scene = lit_ball();
  scene.set_material(ball, std::nullopt);
  scene.stage().lights.push_back({{0, 3, 0}, {0, 0.25, 0.5}});
  Fake top({model::Resultado::hit, 4, {0, 1, 0}, {ball}});
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

TEST_CASE("render fills every pixel, tells its progress up to 1, and refuses a scene without a camera") {
  scene::Scene scene = lit_ball();
  CHECK_THROWS_AS(render::render(scene, Fake{}), std::domain_error);
  scene.stage().camera = scene::Camera{{0, 0, -5}, {0, 0, 0}, {0, 1, 0}, 45};
  scene.stage().resolution = scene::Resolution{16, 8};
  scene.stage().background = glm::dvec3(1, 1, 1);
  double last = 0;
  const render::Image image = render::render(scene, Fake{}, [&](double share) { last = share; });
  CHECK(last == 1);
  CHECK(image.resolution == scene::Resolution{16, 8});
  CHECK(image.rgb == std::vector<std::uint8_t>(16 * 8 * 3, 255));
}

TEST_CASE("every engine that honours origins draws the same image") {
  scene::Scene scene = lit_ball();
  scene.apply(model::Agregar_Cono{model::Elemento("hat"), {0, 0.8, 0}, 0.5, {0, 1, 0}, 1});
  scene.stage().camera = scene::Camera{{0, 2, -5}, {0, 0, 0}, {0, 1, 0}, 45};
  scene.stage().resolution = scene::Resolution{32, 24};
  const render::Image truth = render::render(scene, *engine::find("exact")->prepare(scene));
  CHECK(std::set(truth.rgb.begin(), truth.rgb.end()).size() > 10);  // something is to be seen
  for (const engine::Row& row : engine::engines()) {
    if (!row.exact_bytes) continue;
    CAPTURE(row.name);
    CHECK(row.honours_origins);
    CHECK(render::render(scene, *row.prepare(scene)).rgb == truth.rgb);
  }
}

TEST_CASE("a crop has the pixels that the whole picture has there, whatever its size") {
  scene::Scene scene = lit_ball();
  scene.stage().camera = scene::Camera{{0, 2, -5}, {0, 0, 0}, {0, 1, 0}, 45};
  scene.stage().resolution = scene::Resolution{3, 2};
  const auto engine = engine::find("analytic")->prepare(scene);
  const render::Frame whole{.size = scene::Resolution{32, 24}};
  const render::Image image = render::render(scene, *engine, {}, whole);
  CHECK(image.resolution == scene::Resolution{32, 24});
  for (const render::Crop& crop : {render::Crop{10, 5, {12, 11}}, {31, 23, {1, 1}}, {0, 0, {32, 24}}}) {
    const render::Image part = render::render(scene, *engine, {}, {whole.size, crop});
    REQUIRE(part.resolution == crop.size);
    for (std::uint32_t y = 0; y < crop.size.height; ++y) {
      const auto* const row = &image.rgb[((crop.y + y) * std::size_t{32} + crop.x) * 3];
      CHECK(std::equal(row, row + crop.size.width * 3, &part.rgb[y * std::size_t{crop.size.width} * 3]));
    }
  }
  for (const render::Crop& crop : {render::Crop{32, 0, {1, 1}},
                                   {0, 24, {1, 1}},
                                   {1, 0, {32, 1}},
                                   {0, 1, {1, 24}},
                                   {0, 0, {0, 1}},
                                   {1, 1, {0xFFFFFFFF, 1}}})
    CHECK_THROWS_AS(render::render(scene, *engine, {}, {whole.size, crop}), std::out_of_range);
}
