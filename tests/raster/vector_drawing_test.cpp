#include "durero/raster/vector_drawing.hpp"

#include "durero/raster/visible_polygons.hpp"
#include "raster/triangles.hpp"
#include "support/catch.hpp"

using namespace durero;
using namespace durero::raster;
using namespace durero::test;

namespace {

/// A square over a floor, straight below a camera and a lamp.
scene::Scene stacked() {
  scene::Scene scene;
  scene::Stage& stage = scene.stage();
  stage.camera = {{0.5, 8, 0.25}, {0.5, 0, 0.25}, {0, 0, 1}, 60};
  stage.background = glm::dvec3(0, 0, 1);
  stage.lights = {{{-2, 6, 0}, {1, 1, 1}}};
  stage.materials = {{.name = "white", .color = {1, 1, 1}, .ambient = {0.25, 0.25, 0.25}}};
  add_square(scene, "floor", {0, 0, 0}, 4);
  add_square(scene, "lid", {0, 1, 0}, 1);
  return scene;
}

std::size_t count(const std::string& text, const std::string& of) {
  std::size_t found = 0;
  for (std::size_t at = text.find(of); at != text.npos; at = text.find(of, at + 1)) ++found;
  return found;
}

}  // namespace

TEST_CASE("the parts that a light sees have one area by both techniques") {
  const scene::Scene scene = stacked();
  const RasterScene raster(scene, {64, 48}, Opacity::opaque);
  const auto by_shadows = lit_by_shadows(raster), by_visibility = lit_by_visibility(raster);
  REQUIRE(by_shadows.size() == 1);
  REQUIRE(by_visibility.size() == 1);
  for (std::size_t i = 0; i < raster.corners().size(); ++i) {
    polygon::RationalPoint sum{};
    for (const polygon::Polygon& part : by_shadows[0][i]) sum = sum + polygon::doubled_area(part);
    for (const polygon::Polygon& part : by_visibility[0][i]) sum = sum - polygon::doubled_area(part);
    CHECK(sum == polygon::RationalPoint{});
  }
}

TEST_CASE("a drawing has the background, and an area for each lit and dark part in its colour") {
  const scene::Scene scene = stacked();
  const RasterScene raster(scene, {64, 48}, Opacity::opaque);
  const std::string drawing = svg(raster, lit_by_visibility(raster));
  CHECK(drawing.starts_with("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"64\" height=\"48\""));
  CHECK(drawing.find("fill=\"#0000ff\"/>") != drawing.npos);
  CHECK(count(drawing, "fill=\"#898989\"") >= 2);  // the ambient alone: a shadow on each half of the floor
  CHECK(count(drawing, "<polygon") > count(drawing, "fill=\"#898989\""));
  CHECK(drawing == svg(raster, lit_by_visibility(raster)));
  CHECK(drawing.ends_with("</svg>\n"));
}

TEST_CASE("what lies outside the picture, or behind the eye, is not in the drawing") {
  scene::Scene scene = stacked();
  scene.stage().lights.clear();
  add(scene, "above", {glm::dvec3(-1, 9, -1), {1, 9, -1}, {0, 9, 1}});
  add(scene, "aside", {glm::dvec3(90, 0, -1), {91, 0, -1}, {90, 0, 1}});
  const RasterScene raster(scene, {64, 48}, Opacity::opaque);
  const std::string drawing = svg(raster, {});
  CHECK(count(drawing, "<polygon") >= 4);
  for (std::size_t at = drawing.find("points=\""); at != drawing.npos; at = drawing.find("points=\"", at + 1)) {
    const double x = std::stod(drawing.substr(at + 8));
    CHECK(x >= -0.001);
    CHECK(x <= 64.001);
  }
}
