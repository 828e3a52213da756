#include "durero/raster/scene_polygons.hpp"

#include <stdexcept>

#include "raster/triangles.hpp"
#include "support/catch.hpp"

using namespace durero;
using namespace durero::raster;
using namespace durero::test;

namespace {

scene::Scene wearing(const scene::Material& material) {
  scene::Scene scene;
  scene.stage().materials = {material};
  add(scene, "b", {glm::dvec3(0), {1, 0, 0}, {0, 1, 0}});
  add(scene, "a", {glm::dvec3(0), {0, 1, 0}, {0, 0, 1}}, 7);
  return scene;
}

std::string refusal(const scene::Material& material, Opacity drawn) {
  const scene::Scene scene = wearing(material);
  try {
    polygons_of(scene, drawn);
  } catch (const std::domain_error& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("the triangles of a scene by name, with their normals and looks") {
  const scene::Scene scene = wearing({.name = "red", .color = {1, 0, 0}});
  const auto polygons = polygons_of(scene, Opacity::opaque);
  REQUIRE(polygons.size() == 2);
  CHECK(scene.name(polygons[0].element).name() == "a");
  CHECK(polygons[0].normal == glm::dvec3(1, 0, 0));
  CHECK(polygons[0].material.color == glm::dvec3(0.8));  // it wears none
  CHECK(polygons[1].material.color == glm::dvec3(1, 0, 0));
  CHECK(polygons[1].corners == polygon::Polygon{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  CHECK(corners_of(polygons)[1] == polygons[1].corners);
}

TEST_CASE("what a technique does not draw is named") {
  CHECK(refusal({.name = "m", .k_ps = 0.5}, Opacity::opaque).find("element b is a mirror") == 0);
  CHECK(refusal({.name = "m", .k_t = 0.5}, Opacity::opaque).find("element b is seen through") == 0);
  CHECK(refusal({.name = "m", .k_t = 0.5}, Opacity::transparent).empty());
  CHECK(refusal({.name = "m", .k_t = 0.5, .index = 1.5}, Opacity::transparent).find("element b bends light") == 0);
  CHECK(refusal({.name = "m", .index = 1.5}, Opacity::opaque).empty());
  CHECK(refusal({.name = "m", .bump = scene::Bump{"t"}}, Opacity::opaque).find("element b has a relief") == 0);
  scene::Material textured{.name = "m"};
  textured.textures.names[0] = "t";
  CHECK(refusal(textured, Opacity::opaque).find("element b has a texture") == 0);
  scene::Scene scene = wearing({.name = "m"});
  scene.apply(model::Agregar_Esfera{model::Elemento("ball"), {0, 0, 0}, 1});
  CHECK_THROWS_WITH(polygons_of(scene, Opacity::opaque),
                    Catch::Contains("element ball is of the type esfera; expected triangles alone"));
}

TEST_CASE("a light from a direction is an apex without end, against the way it shines") {
  std::mt19937_64 random(1);
  const auto apexes = apexes_of(grid_scene(random, 1, 1).stage());
  REQUIRE(apexes.size() == 2);
  CHECK_FALSE(apexes[0].far);
  CHECK(apexes[1].far);
  CHECK(apexes[1].at == polygon::RationalPoint{polygon::Rational(-1, 4), 1, polygon::Rational(-1, 2)});
  CHECK(rounded(polygon::exact({0.1, -0x1p-1074, 3})) == glm::dvec3(0.1, -0x1p-1074, 3));
}
