#include "durero/render/bundle/beams.hpp"

#include "durero/engine/engine.hpp"
#include "durero/render/render.hpp"
#include "render/bundle/triangle_scene.hpp"
#include "support/catch.hpp"

using namespace durero;
using namespace durero::test;

namespace {

/// How many pixels by beams have not the colour of their ray, to the last bit.
std::size_t unlike(const scene::Scene& scene, const render::BeamPicture& drawn, const render::RenderSettings& frame) {
  const auto engine = engine::find("fast")->prepare(scene);
  const render::Picture picture = render::render(scene, *engine, {}, frame);
  std::size_t count = 0;
  for (std::size_t i = 0; i < picture.rgb.size(); ++i) count += picture.rgb[i] != drawn.picture.rgb[i];
  return count;
}

render::BeamPicture drawn_by_beams(const scene::Scene& scene, const render::RenderSettings& frame = {}) {
  const auto engine = engine::find("fast")->prepare(scene);
  return render::by_beams(scene, *engine, {}, frame);
}

}  // namespace

TEST_CASE("a picture by beams is that by rays at every pixel centre, mirrors in mirrors included") {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    scene::Scene scene = random_triangles(random, 6);
    scene.stage().camera->mirrored = seed > 3;
    const render::BeamPicture drawn = drawn_by_beams(scene);
    CHECK(unlike(scene, drawn, {}) == 0);
    CHECK(drawn.asked == 0);
    CHECK(drawn.tree.back().depth == 4);
  }
}

TEST_CASE("a crop by beams has the pixels that it has in the whole picture") {
  Random random(11);
  const scene::Scene scene = random_triangles(random, 6);
  const render::RenderSettings frame{.crop = render::Crop{7, 5, {21, 13}}};
  const render::BeamPicture drawn = drawn_by_beams(scene, frame);
  CHECK(unlike(scene, drawn, frame) == 0);
  polygon::Rational sum = 0;
  for (const render::BeamRegion& region : drawn.tree)
    if (region.depth == 1) sum += render::area(region.outline);
  CHECK(sum == 21 * 13);
}

TEST_CASE("where edges lie on pixel centres, and elements edge-on, the engine is asked, and the picture is the same") {
  scene::Scene scene = triangle_stage();
  scene.stage().camera = scene::Camera{{0, 0, -4}, {0, 0, 0}, {0, 1, 0}, 90};
  scene.stage().resolution = scene::Resolution{33, 33};
  add_triangle(scene, "left", {-2, -2, 0}, {0, -2, 0}, {0, 2, 0});
  add_triangle(scene, "right", {2, -2, 0}, {0, -2, 0}, {0, 2, 0});  // the common edge is on the middle column
  add_triangle(scene, "edge", {1, 0, -2}, {3, 0, -2}, {1, 0, 2});   // on the middle row, seen edge-on
  const render::BeamPicture drawn = drawn_by_beams(scene);
  CHECK(unlike(scene, drawn, {}) == 0);
  CHECK(drawn.asked >= 33);
  CHECK(drawn.asked < 33 * 33 / 4);
}
