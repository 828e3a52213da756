#include "durero/raster/shadow_pictures.hpp"

#include <stdexcept>

#include "durero/raster/difference.hpp"
#include "durero/render/output/tone.hpp"
#include "durero/render/render.hpp"
#include "raster/triangles.hpp"
#include "support/catch.hpp"

using namespace durero;
using namespace durero::raster;
using namespace durero::test;

namespace {

std::uint64_t different(const render::Picture& one, const render::Picture& other) {
  return difference(render::toned(one, render::Tone::clamp), render::toned(other, render::Tone::clamp)).pixels;
}

}  // namespace

TEST_CASE("shadow polygons and lit polygons draw the picture that rays draw, every pixel") {
  std::mt19937_64 random(20251203);
  for (int round = 0; round < 4; ++round) {
    const scene::Scene scene = grid_scene(random, 16, 2, 2);
    const render::Picture rays = render::render(scene, *engine::find("fast")->prepare(scene));
    const RasterScene raster(scene, {96, 64}, Opacity::opaque);
    const DrawnShadows shadows = by_shadow_polygons(raster), lit = by_lit_polygons(raster);
    CHECK(different(shadows.picture, rays) == 0);
    CHECK(different(lit.picture, rays) == 0);
    CHECK(shadows.operations == 2 * 16 * 15);
    CHECK(lit.operations < shadows.operations);
    CHECK(lit.polygons > 0);
  }
}

TEST_CASE("depth maps come nearer to the picture that rays draw, the larger they are") {
  std::mt19937_64 random(20251204);
  scene::Scene scene = grid_scene(random, 10, 2, 2);
  CHECK_THROWS_WITH(by_depth_maps(RasterScene(scene, {8, 8}, Opacity::opaque), 16, DepthBias::texel),
                    Catch::Contains("shines from a direction"));
  scene.stage().directional_lights.clear();
  add_square(scene, "floor", {0, -4, 0}, 20);
  const RasterScene raster(scene, {96, 64}, Opacity::opaque);
  const render::Picture rays = render::render(scene, *engine::find("fast")->prepare(scene));
  const auto coarse = different(by_depth_maps(raster, 32, DepthBias::texel), rays),
             fine = different(by_depth_maps(raster, 256, DepthBias::texel), rays),
             without = different(by_depth_maps(raster, 256, DepthBias::none), rays);
  INFO(coarse << ", " << fine << ", " << without);
  CHECK(fine < coarse / 3);
  CHECK(without > 10 * fine);
}

TEST_CASE("a light throws a picture as rays find it, but for the edges of its shadows") {
  std::mt19937_64 random(20251205);
  scene::Scene scene = grid_scene(random, 6, 1, 1);
  scene.stage().directional_lights.clear();
  add_square(scene, "floor", {0, -2, 0}, 12);
  const scene::TexelImage picture{2, 2, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}}};
  const Projector projector({scene.stage().lights[0].position, {0, -2, 0}, {0, 0, 1}, 80}, picture);
  const RasterScene raster(scene, {96, 64}, Opacity::opaque);
  const auto engine = engine::find("fast")->prepare(scene);
  const render::Picture rays = projected_by_rays(raster, *engine, projector);
  CHECK(different(by_projector(raster, projector, 512), rays) < 60);
  CHECK(different(by_depth_maps(raster, 512, DepthBias::texel), rays) > 1000);
  scene.stage().lights.clear();
  CHECK_THROWS_WITH(by_projector(raster, projector, 8), Catch::Contains("no point light"));
  CHECK_THROWS_WITH(projected_by_rays(raster, *engine, projector), Catch::Contains("no point light"));
}
