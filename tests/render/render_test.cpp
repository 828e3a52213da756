#include "durero/render/render.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>

#include "durero/io/json/scene_file.hpp"
#include "durero/io/nff/nff.hpp"
#include "durero/model/operaciones.hpp"
#include "durero/scene/edit.hpp"
#include "durero/scene/stage.hpp"
#include "render/lit_ball.hpp"
#include "support/catch.hpp"
#include "support/spd.hpp"
#include "support/tree.hpp"

using namespace durero;
using durero::test::lit_ball;

namespace {

/// Answers that every ray meets nothing.
struct Nothing : engine::Engine {
  void first_hits(std::span<const scene::Query>, std::span<scene::Hit> hits) const override {
    std::fill(hits.begin(), hits.end(), scene::Hit{});
  }
  void occluded_segments(std::span<const scene::Query>, std::span<bool> occluded) const override {
    std::fill(occluded.begin(), occluded.end(), false);
  }
};

}  // namespace

TEST_CASE("render fills every pixel, tells its progress up to 1, and refuses a scene without a camera") {
  scene::Scene scene = lit_ball();
  CHECK_THROWS_AS(render::render(scene, Nothing{}), std::domain_error);
  scene.stage().camera = scene::Camera{{0, 0, -5}, {0, 0, 0}, {0, 1, 0}, 45};
  scene.stage().resolution = scene::Resolution{16, 8};
  scene.stage().background = glm::dvec3(1, 1, 1);
  double last = 0;
  const render::Picture picture = render::render(scene, Nothing{}, [&](double share) { last = share; });
  CHECK(last == 1);
  CHECK(picture.resolution == scene::Resolution{16, 8});
  CHECK(picture.rgb == std::vector<glm::dvec3>(16 * 8, glm::dvec3(1)));
}

TEST_CASE("every engine that honours origins draws the same image") {
  scene::Scene scene = lit_ball();
  scene.apply(model::Agregar_Cono{model::Elemento("hat"), {0, 0.8, 0}, 0.5, {0, 1, 0}, 1});
  scene.stage().camera = scene::Camera{{0, 2, -5}, {0, 0, 0}, {0, 1, 0}, 45};
  scene.stage().resolution = scene::Resolution{32, 24};
  const render::Picture truth = render::render(scene, *engine::find("exact")->prepare(scene));
  std::set<double> reds;
  for (const glm::dvec3& color : truth.rgb) reds.insert(color.x);
  CHECK(reds.size() > 10);  // something is to be seen
  for (const engine::EngineRow& row : engine::engines()) {
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
  const render::RenderSettings whole{.size = scene::Resolution{32, 24}};
  const render::Picture image = render::render(scene, *engine, {}, whole);
  CHECK(image.resolution == scene::Resolution{32, 24});
  for (const render::Crop& crop : {render::Crop{10, 5, {12, 11}}, {31, 23, {1, 1}}, {0, 0, {32, 24}}}) {
    const render::Picture part = render::render(scene, *engine, {}, {whole.size, crop});
    REQUIRE(part.resolution == crop.size);
    for (std::uint32_t y = 0; y < crop.size.height; ++y) {
      const auto* const row = &image.rgb[(crop.y + y) * std::size_t{32} + crop.x];
      CHECK(std::equal(row, row + crop.size.width, &part.rgb[y * std::size_t{crop.size.width}]));
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

namespace {

/// A picture that is followed to depth 15, and one of the rays of that that count for so much.
struct TracingContext {
  render::PathStatistics whole{}, some{};
  double lost = 0;  ///< of a component, at most

  double depth() const { return double(some.depths) / double(some.pixels); }
};

TracingContext followed(const scene::Scene& scene, scene::Resolution size, double min_weight) {
  const auto engine = engine::find("fast")->prepare(scene);
  const auto drawn = [&](double weight, render::PathStatistics& reach) {
    const render::RenderSettings frame{.size = size, .max_depth = 15, .min_weight = weight};
    return render::render(scene, *engine, {}, frame, &reach);
  };
  TracingContext found;
  const render::Picture all = drawn(0, found.whole), some = drawn(min_weight, found.some);
  for (std::size_t i = 0; i < all.rgb.size(); ++i)
    for (int k = 0; k < 3; ++k) found.lost = std::max(found.lost, all.rgb[i][k] - some.rgb[i][k]);
  return found;
}

/// The mean depth is that of few rays, and no pixel lost more than was said.
void check_bounded(const TracingContext& at) {
  INFO("mean depth " << at.depth() << " of " << double(at.whole.depths) / double(at.whole.pixels) << ", rays "
                     << at.some.rays << " of " << at.whole.rays << "; lost " << at.lost << ", at most "
                     << at.some.left_out);
  CHECK(at.depth() > 1.5);
  CHECK(at.depth() <= 2);
  CHECK(at.lost > 0);
  CHECK(at.lost <= at.some.left_out);
}

}  // namespace

TEST_CASE(
    "where each ray counts for a twentieth, Whitted's scene has a mean depth below 2 of 15, and the bound holds") {
  const scene::Scene scene = io::read_scene(io::read_source(test::source_dir() + "/demo/gallery/whitted.json"));
  const TracingContext at = followed(scene, {96, 72}, 0.05);
  check_bounded(at);
  CHECK(50 * at.some.rays < at.whole.rays);
}

TEST_CASE("the databases that are full of mirrors have a mean depth below 2 of 15, and the bound holds and is near") {
  for (const char* const name : {"balls", "jacks", "lattice", "rings"}) {
    const auto path = test::spd_path(name);
    if (!path) continue;
    const scene::Scene scene = std::move(io::read_nff(io::read_source(*path)).scene);
    for (const double min_weight : {0.01, 0.05}) {
      CAPTURE(name, min_weight);
      const TracingContext at = followed(scene, {160, 160}, min_weight);
      check_bounded(at);
      CHECK(at.some.left_out < 7 * at.lost);
    }
  }
}

// Fourteen panes, each of which mirrors less than a hundredth of one lamp.
TEST_CASE(
    "rays that count for less than a hundredth each are more than a tenth of a pixel together, and the bound says so") {
  const scene::Scene scene = io::read_scene(io::read_source(test::source_dir() + "/demo/gallery/ghosts.json"));
  const auto engine = engine::find("fast")->prepare(scene);
  const auto drawn = [&](double min_weight, render::PathStatistics& reach) {
    const render::RenderSettings frame{.size = scene::Resolution{64, 48}, .min_weight = min_weight};
    return render::render(scene, *engine, {}, frame, &reach);
  };
  render::PathStatistics whole, reach;
  const render::Picture all = drawn(0, whole), some = drawn(0.01, reach);
  CHECK(whole.left_out == 0);
  double lost = 0, share = 0;
  for (std::size_t i = 0; i < all.rgb.size(); ++i)
    for (int k = 0; k < 3; ++k) {
      const double by = all.rgb[i][k] - some.rgb[i][k];
      lost = std::max(lost, by);
      share = std::max(share, by / all.rgb[i][k]);
    }
  INFO("lost " << lost << ", " << share << " of a pixel; at most " << reach.left_out << " by the bound");
  CHECK(lost > 0.1);
  CHECK(share > 0.5);
  CHECK(lost <= reach.left_out);
  CHECK(reach.left_out < 1.2 * lost);  // no ray brings more than the lamp
}

TEST_CASE("elements of one type keep looks of their own, however many there are between them") {
  scene::Scene scene;
  scene.stage().materials = {{.name = "green", .k_d = 0, .emission = {0, 1, 0}},
                             {.name = "red", .k_d = 0, .emission = {1, 0, 0}}};
  scene.stage().camera = scene::Camera{{0, 0, -10}, {0, 0, 0}, {0, 1, 0}, 60};
  scene.stage().resolution = scene::Resolution{64, 32};
  constexpr int last = 256;  // a multiple of any number of places that looks may be kept in
  for (int i = 0; i <= last; ++i) {
    const model::Punto centro = i == 0      ? model::Punto(-3, 0, 0)
                                : i == last ? model::Punto(3, 0, 0)
                                            : model::Punto(0, 0, -100 - 3 * i);
    const scene::Edit edit{model::Agregar_Esfera{model::Elemento(std::to_string(i)), centro, 1}, i == last ? 0u : 1u};
    REQUIRE(scene.apply_total(edit).ok());
  }
  const render::Picture picture = render::render(scene, *engine::find("fast")->prepare(scene));
  std::set<std::pair<double, double>> seen;
  for (const glm::dvec3& color : picture.rgb) seen.insert({color.x, color.y});
  CHECK(seen == std::set<std::pair<double, double>>{{0, 0}, {0, 1}, {1, 0}});
}
