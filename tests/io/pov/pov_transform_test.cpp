// What transformations make of POV-Ray's objects, and what is left out of a text.
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <set>

#include "durero/io/json/scene_file.hpp"
#include "durero/io/pov/pov.hpp"
#include "durero/scene/body.hpp"
#include "durero/scene/stage.hpp"
#include "support/catch.hpp"

using namespace durero;
using Lines = std::vector<std::string>;

namespace {

io::Imported import_text(const std::string& text) { return io::read_pov(io::Source("f", text + "\n#version 3.7;")); }
scene::Sphere ball(const std::string& transformations) {
  return import_text("sphere { <1, 2, 3>, 1 " + transformations + " }").scene.shapes<scene::Sphere>()[0];
}
bool is_ball(const scene::Sphere& ball, const glm::dvec3& centro, double radio) {
  return ball.centro == centro && ball.radio == radio;
}
bool is_near(const glm::dvec3& a, const glm::dvec3& b) { return glm::distance(a, b) < 1e-14; }
const std::string moved = " moved by a transformation: rounded";
const std::string bare = "1 object without a texture: of no material, where POV-Ray's is black";

}  // namespace

TEST_CASE("Shapes that are moved, turned and scaled alike stay of their type") {
  CHECK(ball("translate <1, 1, 1>").centro == glm::dvec3(2, 3, 4));
  CHECK(ball("scale 2 translate x").centro == glm::dvec3(3, 4, 6));
  CHECK(ball("translate x scale 2").centro == glm::dvec3(4, 4, 6));
  CHECK(ball("scale <-2, 2, 2>").radio == 2);
  CHECK(ball("rotate 90*x").centro == glm::dvec3(1, -3, 2));
  CHECK(ball("rotate <90, 90, -180>").centro == glm::dvec3(-2, 3, -1));
  CHECK(is_near(ball("rotate 30*z").centro, {std::sqrt(0.75) - 1, 0.5 + 2 * std::sqrt(0.75), 3}));
  CHECK(ball("matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 5, 6, 7>").centro == glm::dvec3(6, 8, 10));
  CHECK(ball("transform { scale 2 translate x inverse }").centro == glm::dvec3(0, 1, 1.5));
  CHECK(ball("transform { translate x } transform { translate y }").centro == glm::dvec3(2, 3, 3));
  CHECK(import_text("sphere { 0, 1 translate 0.1 }").lost == Lines{bare});  // nothing is rounded
  CHECK(import_text("sphere { 1, 1 translate 0.1 }").lost == Lines{"1 point" + moved, bare});

  const io::Imported i = import_text(
      "cylinder { 0, y, 1 open rotate 90*x scale 3 translate x } disc { y, y, 2 rotate 90*z scale 0.5 }\n"
      "plane { y, 2 scale <1, 3, 5> } plane { x + y, 0 scale <2, 1, 1> translate z }\n"
      "mesh2 { vertex_vectors { 3, 0, x, y } face_indices { 1, <0, 1, 2> } scale <1, 2, 3> translate y }");
  const auto cylinder = i.scene.shapes<scene::Cylinder>()[0];
  CHECK((cylinder.centro == glm::dvec3(1, 0, 0) && cylinder.vector == glm::dvec3(0, 0, 1)));
  CHECK((cylinder.radio == 3 && cylinder.altura == 3));
  const auto disc = i.scene.shapes<scene::Disc>()[0];
  CHECK((disc.centro == glm::dvec3(-0.5, 0, 0) && disc.vector == glm::dvec3(-1, 0, 0) && disc.radio == 1));
  const auto planes = i.scene.shapes<scene::Plane>();
  CHECK((planes[0].centro == glm::dvec3(0, 6, 0) && planes[0].vector == glm::dvec3(0, 1, 0)));
  CHECK((planes[1].centro == glm::dvec3(0, 0, 1) && is_near(planes[1].vector, glm::normalize(glm::dvec3(1, 2, 0)))));
  const scene::Triangle triangle = i.scene.shapes<scene::Triangle>()[0];
  CHECK(triangle.vertices == std::array<glm::dvec3, 3>{{{0, 1, 0}, {1, 1, 0}, {0, 3, 0}}});
}

TEST_CASE("A polygon is a group of triangles, closed or not, with holes that go round either way") {
  for (const char* points : {"4, <0, 0>, <2, 0>, <2, 2>, <0, 2>", "5, 0, 2*x, <2, 2, 0>, 2*y, 0"}) {
    const io::Imported i = import_text(std::string("polygon { ") + points + " translate z }");
    const auto triangles = i.scene.shapes<scene::Triangle>();
    REQUIRE(triangles.size() == 2);
    for (const scene::Triangle& triangle : triangles)
      for (const glm::dvec3& vertex : triangle.vertices) CHECK(vertex.z == 1);
    CHECK(i.groups.table().at("m1").elementos.size() == 2);
  }
  for (const char* hole :
       {"<1, 1>, <2, 1>, <1, 2>, <1, 1>", "<1, 1>, <1, 2>, <2, 1>, <1, 1>", "<1, 1>, <2, 1>, <1, 2>"}) {
    const io::Imported i = import_text(std::string("polygon { ") + (std::string(hole).size() > 25 ? "12" : "11") +
                                       ", 0, 9*x, 9*y, 0, <3, 3>, <4, 3>, <3, 4>, <3, 3>, " + hole + " }");
    CHECK(i.lost == Lines{"11 objects without a texture: of no material, where POV-Ray's is black"});
    double area = 0;
    for (const scene::Triangle& t : i.scene.shapes<scene::Triangle>())
      area += glm::length(glm::cross(t.vertices[1] - t.vertices[0], t.vertices[2] - t.vertices[0])) / 2;
    CHECK(area == Approx(40.5 - 2 * 0.5));
  }
  CHECK(import_text("polygon { 8, 0, 9*x, 9*y, 0, <-1, 1>, <-2, 1>, <-1, 2>, <-1, 1> } polygon { 4, 0, <1, 1>, x, y }"
                    "polygon { 6, 0, 9*x, 9*y, 0, x, 0 }")
            .lost == Lines{"3 polygon that touches itself, or of several parts, left out: a scene has none"});
}

TEST_CASE("A prism is a group of triangles, open or closed, that goes up straight or to a point") {
  const auto bounds = [](const io::Imported& i) {
    glm::dvec3 low(1e9), high(-1e9);
    for (const scene::Triangle& triangle : i.scene.shapes<scene::Triangle>())
      for (const glm::dvec3& vertex : triangle.vertices) low = glm::min(low, vertex), high = glm::max(high, vertex);
    return std::pair(low, high);
  };
  const std::string square = "4, <0, 0>, <2, 0>, <2, 3>, <0, 3>";
  const io::Imported box = import_text("prism { linear_sweep linear_spline 1, 2, " + square + " }");
  CHECK(box.scene.shapes<scene::Triangle>().size() == 12);
  CHECK(bounds(box) == std::pair(glm::dvec3(0, 1, 0), glm::dvec3(2, 2, 3)));
  CHECK(box.groups.table().at("m1").elementos.size() == 12);
  CHECK(import_text("prism { 1, 2, " + square + " open translate x }").scene.size() == 8);
  const io::Imported pyramid =
      import_text("prism { conic_sweep 0, 2, 5, <-1, -1>, <1, -1>, <1, 1>, <-1, 1>, <-1, -1> }");
  CHECK(pyramid.scene.size() == 6);
  CHECK(bounds(pyramid) == std::pair(glm::dvec3(-2, 0, -2), glm::dvec3(2, 2, 2)));
  const io::Imported ring = import_text("prism { 0, 1, 9, 0, 9*x, 9*y, 0, <1, 1>, <1, 2>, <2, 2>, <2, 1>, <1, 1> }");
  double area = 0;
  for (const scene::Triangle& t : ring.scene.shapes<scene::Triangle>())
    if (t.vertices[0].y == 1 && t.vertices[1].y == 1 && t.vertices[2].y == 1)
      area += glm::length(glm::cross(t.vertices[1] - t.vertices[0], t.vertices[2] - t.vertices[0])) / 2;
  CHECK(area == Approx(39.5));
  CHECK(import_text("prism { cubic_spline 0, 1, 6, 0, 9*x, 9*y, 0, x, y } prism { 0, 1, 4, 0, <1, 1>, x, y }").lost ==
        Lines{"2 prism of curves that is closed, or whose outline touches itself, left out: a scene has none"});
}

TEST_CASE("Other transformations make exact copies, with their caps") {
  const io::Imported i = import_text(
      "sphere { x, 1 scale <2, 2, 1> } cone { 0, 1, y, 0.5 scale <1, 2, 3> } cylinder { 0, y, 1 open scale <1, 2, 3> "
      "}");
  REQUIRE(i.scene.size() == 5);
  const auto instance = [&](const char* name) {
    return std::get<scene::Instance>(i.scene.body(i.scene.find(name).value())->form);
  };
  CHECK(is_ball(std::get<scene::Sphere>(instance("b1").shape), {1, 0, 0}, 1));
  CHECK(instance("b1").mapa == model::Mapa{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 1}});
  CHECK(std::holds_alternative<scene::TruncatedCone>(instance("b2").shape));
  CHECK(std::holds_alternative<scene::Disc>(instance("b3").shape));
  CHECK(std::holds_alternative<scene::Disc>(instance("b4").shape));
  CHECK(std::holds_alternative<scene::Cylinder>(instance("b5").shape));
  CHECK(i.groups.table().at("u1").elementos == std::set<std::string, std::less<>>{"b2", "b3", "b4"});
}

TEST_CASE("What is in a union or a solid is moved by its own transformations first") {
  CHECK(import_text("union { sphere { x, 1 translate y } rotate 90*z }").scene.shapes<scene::Sphere>()[0].centro ==
        glm::dvec3(-1, 1, 0));
  CHECK(
      is_ball(import_text("object { object { sphere { x, 1 } scale 2 } translate y }").scene.shapes<scene::Sphere>()[0],
              {2, 1, 0}, 2));
  const io::Imported i =
      import_text("difference { box { 0, 1 translate x } sphere { 0, 1 scale 2 } rotate 90*z scale 2 }");
  const auto solid = std::get<scene::Compound>(i.scene.body(i.scene.find("b1").value())->form);
  REQUIRE(solid.parts.size() == 2);
  CHECK(is_ball(std::get<scene::Sphere>(std::get<scene::Instance>(solid.parts[1].form).shape), {0, 0, 0}, 4));
}

TEST_CASE("Lights and cameras are moved, also with what they stand in") {
  const io::Imported i = import_text(
      "light_source { x, rgb 1 spotlight point_at 0 translate y } union { sphere { 0, 1 } light_source { 0, rgb 1 } "
      "translate 5*z }\n"
      "light_source { -y, rgb 1 parallel rotate 90*z } camera { location -z look_at 0 rotate 90*y translate x }");
  const scene::Stage& stage = i.scene.stage();
  REQUIRE(stage.lights.size() == 2);
  CHECK((stage.lights[0].position == glm::dvec3(1, 1, 0) && stage.lights[0].cone->towards == glm::dvec3(0, 1, 0)));
  CHECK(stage.lights[1].position == glm::dvec3(0, 0, 5));
  CHECK(stage.directional_lights.at(0).direction == glm::dvec3(-1, 0, 0));
  CHECK((stage.camera->eye == glm::dvec3(0, 0, 0) && stage.camera->look_at == glm::dvec3(1, 0, 0)));
}

TEST_CASE("What no scene has is left out, and named with its number") {
  CHECK(import_text(
            "torus { 1, 0.5 } text { ttf \"a.ttf\" \"A\", 1, 0 } torus { 2, 1 } fog { distance 9 } sphere { 0, 1 }")
            .lost == Lines{bare, "1 fog left out: a scene has none", "1 text left out: a scene has none",
                           "2 surfaces left out: a scene has such by a Z text alone (--with)"});
  CHECK(import_text(
            "difference { sphere { 0, 1 } torus { 1, 0.5 } } merge { sphere { 0, 1 } cone { 0, 1, z, 0.5 open } }\n"
            "intersection { sphere { 0, 1 } disc { 0, z, 1 } } difference { box { 0, 1 } sphere { 0, 1 inverse } }")
            .lost == Lines{"1 surface left out: a scene has such by a Z text alone (--with)",
                           "4 solids left out: a part of it bounds nothing that a scene has"});
  CHECK(import_text("sphere { 0, 0 } cylinder { 0, x, -1 open } disc { 0, y, 1, 0.5 } sphere { 0, 1 clipped_by { plane "
                    "{ x, 0 } } }")
            .lost == Lines{"2 surfaces left out: a scene has such by a Z text alone (--with)",
                           "1 object left out: a scene's have radio? ∈ Rmas (Agregar_Cilindro.pre.2)",
                           "1 object left out: a scene's have radio? ∈ Rmas (Agregar_Esfera.pre.2)"});
  CHECK(import_text(
            "camera { orthographic location -z look_at 0 } camera { angle 180 } light_source { 0, rgb -1 }\n"
            "light_source { y, rgb 1 cylinder } light_source { y, rgb 1 spotlight falloff 20 } background { rgb -1 }")
            .lost == Lines{"2 cameras left out: a scene's sees by straight rays from one point",
                           "3 light_sources left out: no light of a scene is such",
                           "1 global setting left out: a scene has none such"});
  CHECK(import_text("sphere { 0, 1 scale <1, 0, 1> }").lost ==
        Lines{bare, "1 0 that scale: taken for 1, as POV-Ray does"});
  const io::Imported looks =
      import_text("sphere { 0, 1 pigment { checker rgb 1, rgb <0, 0.5, 0> } } sphere { 0, 1 pigment { rgb 2 } }");
  CHECK(looks.scene.stage().materials.at(0).color == glm::dvec3(0.5, 0.75, 0.5));
  CHECK(looks.lost[0].starts_with("1 texture left out"));
  CHECK(looks.lost[1] == "1 pigment of several colours: their mean");
}

TEST_CASE("What #default tells is the look of what tells of none, and what others begin with") {
  const io::Imported i = import_text(
      "#default { pigment { rgb <0, 1, 0> } finish { ambient 0 diffuse 0.25 } } sphere { 0, 1 } sphere { 0, 2 pigment "
      "{ rgb x } }");
  REQUIRE(i.scene.stage().materials.size() == 2);
  CHECK(i.scene.stage().materials[0] == scene::Material{.name = "f1", .color = {0, 1, 0}, .k_d = 0.25});
  CHECK(i.scene.stage().materials[1] == scene::Material{.name = "f2", .color = {1, 0, 0}, .k_d = 0.25});
  CHECK(i.lost.empty());
}
