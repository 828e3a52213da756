#include "durero/io/nff/nff.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <set>

#include "durero/io/json/scene_file.hpp"
#include "durero/model/operaciones.hpp"
#include "durero/scene/stage.hpp"
#include "io/malformed.hpp"
#include "io/random_scene.hpp"
#include "support/catch.hpp"
#include "support/property.hpp"
#include "support/spd.hpp"

using namespace durero;

namespace {

const auto reading = [](const io::Source& s) { return io::read_nff(s); };
std::string error_at(const std::string& with_mark) { return test::error_at_mark(with_mark, reading); }
io::Imported import_text(const std::string& text) { return io::read_nff(io::Source("f", text)); }

constexpr auto sample = R"(# a view
b 0.1 0.2 0.3
v
from 0 0 -5
at 0 0 0
up 0 1 0
angle 45
hither 0.5
resolution 640 480
l 1 2 3
l 4 5 6 1 0.5 0
l 1 1 1
l 2 2 2
s 9 9 9 1
f 1 0.5 0 0.5 0 0 0 0
s 1 2 3 4
c 0 0 0 2 0 0 3 2
f 1 1 1 1 0.5 100 0 0
c
1 2 3 0.5
1 6 3 0
f 1 0.5 0 0.5 0 0 0 0
c 1 2 3 0 1 -2 3 8
p 3
0 0 0
1 0 0
0 1 0
pp 3
0 0 0 0 0 1 1 0 0 0 0 1 0 1 0 0 0 1
c 0 0 0 2 0 0 3 1
s 0 0 0 -2
)";

std::size_t count(const io::Imported& i, model::Tipo tipo) {
  std::size_t count = 0;
  i.scene.for_each([&](scene::ElementRef element, const auto&) { count += element.tipo == tipo; });
  return count;
}

}  // namespace

TEST_CASE("Every entity of NFF becomes what a scene has for it") {
  const io::Imported i = import_text(sample);
  const double half = 0.5;  // four lights: those without colour are 1/√4
  CHECK(io::scene_text(i.scene) == R"({"format":"durero-scene","version":1,
"camera":{"eye":[0,0,-5],"look_at":[0,0,0],"up":[0,1,0],"fov_y":45},
"resolution":[640,480],
"background":[0.1,0.2,0.3],
"lights":[
{"position":[1,2,3],"color":[0.5,0.5,0.5]},
{"position":[4,5,6],"color":[1,0.5,0]},
{"position":[1,1,1],"color":[0.5,0.5,0.5]},
{"position":[2,2,2],"color":[0.5,0.5,0.5]}],
"materials":{
"f1":{"color":[0.5,0.25,0]},
"f2":{"color":[1,1,1],"k_s":0.5,"e":100,"k_ps":0.5}},
"elementos":[
{"id":"c1","tipo":"cilindro","centro":[0,0,0],"radio":2,"vector":[0,0,1],"altura":3,"material":"f1"},
{"id":"k1","tipo":"cono","centro":[1,2,3],"proporcion":0.125,"vector":[0,1,0],"altura":4,"material":"f2"},
{"id":"k2","tipo":"cono","centro":[1,-2,3],"proporcion":2,"vector":[0,1,0],"altura":4,"material":"f1"},
{"id":"p1","tipo":"triangulo","vertices":[[0,0,0],[1,0,0],[0,1,0]],"material":"f1"},
{"id":"p2","tipo":"triangulo","vertices":[[0,0,0],[1,0,0],[0,1,0]],"material":"f1","normals":[[0,0,1],[0,0,1],[0,0,1]]},
{"id":"s1","tipo":"esfera","centro":[9,9,9],"radio":1},
{"id":"s2","tipo":"esfera","centro":[1,2,3],"radio":4,"material":"f1"},
{"id":"s3","tipo":"esfera","centro":[0,0,0],"radio":2,"material":"f1"},
{"id":"t1","tipo":"tronco","centro":[0,0,0],"radio":1,"proporcion":0.3333333333333333,"vector":[0,0,1],"altura":3,"material":"f1"}
]}
)");
  CHECK(i.scene.stage().lights[0].color.x == half);
}

TEST_CASE("NFF is read alike however its lines end") {
  std::string cr = sample, crlf;
  for (char& c : cr) {
    crlf += c == '\n' ? std::string("\r\n") : std::string(1, c);
    if (c == '\n') c = '\r';
  }
  CHECK(io::scene_text(import_text(cr).scene) == io::scene_text(import_text(sample).scene));
  CHECK(io::scene_text(import_text(crlf).scene) == io::scene_text(import_text(sample).scene));
  CHECK(error_at("# a sphere\rs 0 0\r\n0 ^x") == "\"x\" in s; expected a finite number");
}

TEST_CASE("What a scene cannot hold is counted and named") {
  CHECK(import_text(sample).lost ==
        std::vector<std::string>{"1 surface seen from inside only: kept, seen from both sides",
                                 "1 near plane (hither) left out: a scene's camera has none"});
  CHECK(import_text("s 0 0 0 1\n").lost.empty());
  CHECK(import_text("c 4.66 1.8 6.14 1.74 -2.87 -3.76 6.61 0.64\n").lost ==
        std::vector<std::string>{"1 axis rounded: a scene holds a direction and a length",
                                 "1 proportion rounded: a scene holds how much a cone narrows by its height"});
  CHECK(import_text("Q 2\nZ 200\ns 0 0 0 1\n").lost ==
        std::vector<std::string>{"2 settings of another tracer (Q, Z) left out"});
}

TEST_CASE("Patches keep the normals of their corners, there and back; one without a direction leaves a flat triangle") {
  const io::Imported i = import_text("pp 4\n0 0 0 0 0 1\n2 0 0 1 0 2\n2 2 0 0 1 1\n0 2 0 -1 0 1\n");
  REQUIRE(i.scene.size() == 2);
  const std::string again = io::nff_text(i.scene).text;
  CHECK(again.find("pp 3\n") != std::string::npos);
  CHECK(again.find("2 0 0 1 0 2\n") != std::string::npos);
  CHECK(io::scene_text(import_text(again).scene) == io::scene_text(i.scene));
  const io::Imported flat = import_text("pp 3\n0 0 0 0 0 1\n2 0 0 0 0 0\n2 2 0 0 1 1\n");
  CHECK(flat.lost == std::vector<std::string>{"1 triangle kept flat: a normal at a vertex has no direction"});
  CHECK_FALSE(flat.scene.vertex_normals(*flat.scene.find("p1")));
}

TEST_CASE("Polygons, concave or not, are cut into triangles of their own vertices") {
  const io::Imported i = import_text(
      "p 6\n0 0 1\n2 0 1\n2 1 1\n1 1 1\n1 2 1\n0 2 1\n"
      "p 4\n0 0 0 0.1 0 0 0.1 0.1 0.1 0 0.1 0\n"  // not flat
      "p 4 0 0 0 1 1 0 1 0 0 0 1 0\np 3 0 0 0 0.1 0.1 0.1 0.2 0.2 0.2\np 3 0 0 0 1 0 0 0 0 1\n");
  CHECK(i.lost == std::vector<std::string>{"1 triangle left out: the vertices lie on one line",
                                           "1 polygon left out: edges touch or cross"});
  std::vector<scene::Corners> triangles;
  for (const scene::Triangle& t : i.scene.shapes<scene::Triangle>()) triangles.push_back(t.vertices);
  const glm::dvec3 o{0, 0, 1}, e{2, 0, 1}, f{2, 1, 1}, inner{1, 1, 1}, g{1, 2, 1}, h{0, 2, 1};
  REQUIRE(triangles.size() == 7);
  CHECK(std::vector(triangles.begin(), triangles.begin() + 4) ==
        std::vector<scene::Corners>{{o, e, inner}, {o, inner, h}, {e, f, inner}, {inner, g, h}});
  CHECK(triangles[6] == scene::Corners{glm::dvec3{0, 0, 0}, {1, 0, 0}, {0, 0, 1}});
  CHECK(i.scene.find("p8").has_value());
  CHECK_FALSE(i.scene.find("p7").has_value());  // what is left out keeps its number
}

TEST_CASE("More than nine fills keep their elements, whatever the order of the names") {
  std::string text;
  for (int n = 0; n < 12; ++n)
    text += "f 0 0 " + std::to_string(n / 16.0) + " 1 0 0 0 1\ns 0 0 0 " + std::to_string(n + 1) + "\n";
  const io::Imported i = import_text(text);
  for (const auto& s : i.scene.shapes<scene::Sphere>()) {
    const auto index = static_cast<std::uint32_t>(&s - i.scene.shapes<scene::Sphere>().data());
    const auto material = i.scene.material({model::Tipo::soy_esfera, index});
    REQUIRE(material.has_value());
    CHECK(i.scene.stage().materials[*material].color.z == (s.radio - 1) / 16);
  }
  CHECK(std::ranges::is_sorted(i.scene.stage().materials, {}, &scene::Material::name));
}

TEST_CASE("Any two points give an axis in Unitario, and an apex where it was") {
  test::property("cones and cylinders", [] {
    const auto moderate_triple = [] { return glm::dvec3{*test::moderate(), *test::moderate(), *test::moderate()}; };
    const glm::dvec3 base = moderate_triple(), apex = moderate_triple();
    RC_PRE(base != apex);
    const auto numbers = [](const glm::dvec3& v) { return fmt::format("{} {} {}", v.x, v.y, v.z); };
    const io::Imported i =
        import_text(fmt::format("c {} 2 {} 0\nc {} 0 {} 2\nc {} 1 {} 1\n", numbers(base), numbers(apex), numbers(apex),
                                numbers(base), numbers(base), numbers(apex)));
    RC_ASSERT(i.scene.shapes<scene::Cone>().size() == 2U);
    RC_ASSERT(i.scene.shapes<scene::Cylinder>().size() == 1U);
    for (const scene::Cone& k : i.scene.shapes<scene::Cone>()) {
      RC_ASSERT(k.centro == base);
      RC_ASSERT(model::Unitario::contains(model::Vector{k.vector}));
      const glm::dvec3 off = k.centro + k.altura * k.vector - apex;
      RC_ASSERT(std::sqrt(glm::dot(off, off)) <= 0x1p-50 * 1024);  // coordinates are below 2⁹: a few ulps of them
      RC_ASSERT(std::abs(k.proporcion * k.altura - 2) <= 0x1p-51);  // quotient and product each within 2⁻⁵³ of itself
    }
  });
}

TEST_CASE("What was exported reads back, up to names, where no loss is named for it") {
  test::property("any scene", [] {
    const scene::Scene scene = test::any_scene();
    const io::Exported exported = io::nff_text(scene);
    const auto loses_geometry = [](const std::string& loss) {
      return loss.find("rounded") != loss.npos || loss.find("plane") != loss.npos || loss.find("disc") != loss.npos ||
             loss.find("left out: no ends") != loss.npos || loss.find("beyond") != loss.npos;
    };
    const bool kept = std::ranges::none_of(exported.lost, loses_geometry);
    RC_PRE(kept);
    const io::Imported back = import_text(exported.text);
    const auto values = [](const scene::Scene& s) {
      std::multiset<std::string> all;
      scene::Scene bare = s;
      for (auto [name, text] : test::described(bare)) {
        for (const auto& m : s.stage().materials) {
          if (text.ends_with(' ' + m.name)) {
            text.resize(text.size() - m.name.size());
            text += fmt::format("{} {} {}", m.color.x, m.color.y, m.color.z);
            break;
          }
        }
        all.insert(text);
      }
      return all;
    };
    RC_ASSERT(values(back.scene) == values(scene));
    auto camera = scene.stage().camera;
    if (camera) camera->mirrored = false;  // NFF has no mirrored one
    RC_ASSERT(back.scene.stage().camera == camera);
    std::vector<scene::Light> around = scene.stage().lights;  // NFF has no cones
    for (scene::Light& light : around) light.cone.reset();
    RC_ASSERT(back.scene.stage().lights == around);
    RC_ASSERT(back.scene.stage().background == scene.stage().background);
    if (scene.stage().camera && scene.stage().resolution) {
      RC_ASSERT(back.scene.stage().resolution == scene.stage().resolution);
    }
    RC_ASSERT(back.lost.empty());
  });
}

TEST_CASE("What NFF cannot hold of a scene is counted and named") {
  scene::Scene scene;
  scene.stage().materials = {{"red", {1, 0, 0}}};
  scene.stage().resolution = {4, 3};
  scene.apply(model::Agregar_Esfera{model::Elemento{"a"}, model::Punto{0, 0, 0}, 1});
  scene.apply(
      model::Agregar_Cono{model::Elemento{"k"}, model::Punto{0, 1000, 0}, 0.1, model::Vector{0, 0.6, 0.8}, 0.3});
  scene.apply(model::Agregar_Plano{model::Elemento{"p"}, model::Punto{0, 0, 0}, model::Vector{0, 1, 0}});
  CHECK(io::nff_text(scene).lost ==
        std::vector<std::string>{
            "no camera in the scene: no view was written", "1 resolution left out: it is part of a view",
            "3 names of elements left out: NFF has none", "1 name of a material left out: NFF has none",
            "1 plane left out: NFF has none", "1 axis rounded: NFF holds end points",
            "1 proportion rounded: NFF holds the radii of the ends"});
  scene::Scene turned;
  turned.stage().camera = scene::Camera{{0, 0, -4}, {0, 0, 0}, {0, 1, 0}, 40};
  turned.stage().camera->mirrored = true;
  turned.stage().resolution = {4, 3};
  CHECK(io::nff_text(turned).lost == std::vector<std::string>{"1 mirrored camera written unmirrored: NFF has none"});
}

TEST_CASE("What ends in binary64 do not give is left out, so that what is written is read again") {
  scene::Scene scene;
  const auto add = [&](const char* name, const auto& shape) { REQUIRE(scene.add(model::Elemento{name}, shape).ok()); };
  add("beyond", scene::Cylinder{{0, 0, 1.7e308}, 1, {0, 0, 1}, 1e308});
  add("flat", scene::Cylinder{{0, 0, 1e300}, 1, {0, 0, 1}, 1});
  add("thin", scene::Cone{{0, 0, 0}, 5e-324, {0, 0, 1}, 0.25});
  add("whole", scene::Cone{{0, 0, 0}, 0.5, {0, 0, 1}, 2});
  const io::Exported exported = io::nff_text(scene);
  CHECK(exported.text == "c 0 0 0 1 0 0 2 0\n");
  CHECK(std::ranges::count(exported.lost, "3 elements left out: no ends in binary64 give it") == 1);
  CHECK(import_text(exported.text).scene.size() == 1);
}

TEST_CASE("Shine and transparency come back from NFF as they were; another look is named") {
  scene::Scene scene;
  scene.stage().materials = {
      {.name = "f1", .color = {1, 0.5, 0}, .k_s = 0.25, .e = 30, .k_ps = 0.25, .k_t = 0.5, .index = 1.5},
      {.name = "f2", .color = {1, 0.5, 0}}};
  for (const char* name : {"s1", "s2"})
    scene.apply(model::Agregar_Esfera{model::Elemento{name}, model::Punto{0, 0, 0}, 1});
  scene.set_material(*scene.find("s1"), 0);
  scene.set_material(*scene.find("s2"), 1);
  const io::Exported exported = io::nff_text(scene);
  CHECK(exported.text == "f 1 0.5 0 1 0.25 30 0.5 1.5\ns 0 0 0 1\nf 1 0.5 0 1 0 0 0 1\ns 0 0 0 1\n");
  CHECK(import_text(exported.text).scene.stage().materials == scene.stage().materials);
  const auto losses = [&](const scene::Material& look) {
    scene.stage().materials[0] = look;
    const auto lost = io::nff_text(scene).lost;
    return std::ranges::count(
        lost, "1 material written otherwise: NFF has one colour, and one share for highlight and mirror");
  };
  CHECK(losses({}) == 0);
  CHECK(losses({.k_s = 0.5, .k_ps = 0.5}) == 0);
  for (const scene::Material& look : std::vector<scene::Material>{{.k_a = 0.5},
                                                                  {.k_d = 0.5},
                                                                  {.k_s = 0.5},
                                                                  {.e = 2},
                                                                  {.k_ps = 0.5},
                                                                  {.M_PS = {1, 1, 0}},
                                                                  {.M_T = {1, 1, 0}},
                                                                  {.index = 2},
                                                                  {.emission = {1, 0, 0}},
                                                                  {.ambient = {1, 0, 0}}})
    CHECK(losses(look) == 1);
}

TEST_CASE("A truncated cone is exported by its two radii, and comes back; what they cannot hold is named") {
  const auto exported = [](double radio, double proporcion, double altura) {
    scene::Scene scene;
    scene.apply(model::Agregar_Tronco{model::Elemento{"t1"}, model::Punto{1, 2, 3}, radio, proporcion,
                                      model::Vector{0, 0, 1}, altura});
    return io::nff_text(scene);
  };
  const auto losses = [](const io::Exported& e) { return std::vector<std::string>(e.lost.begin() + 2, e.lost.end()); };
  const io::Exported exact = exported(1, 0.5, 4);
  CHECK(exact.text == "c 1 2 3 3 1 2 7 1\n");
  CHECK(losses(exact).empty());
  const io::Imported back = import_text(exact.text);
  REQUIRE(back.scene.shapes<scene::TruncatedCone>().size() == 1);
  const scene::TruncatedCone& t = back.scene.shapes<scene::TruncatedCone>()[0];
  CHECK(t.centro == glm::dvec3(1, 2, 3));
  CHECK((t.radio == 1 && t.proporcion == 0.5 && t.altura == 4));
  CHECK(losses(exported(1, 0.1, 3)) ==
        std::vector<std::string>{"1 proportion rounded: NFF holds the radii of the ends"});
  CHECK(losses(exported(1, 1e-17, 1)) ==
        std::vector<std::string>{"1 truncated cone written as a cylinder: its radii round to one",
                                 "1 proportion rounded: NFF holds the radii of the ends"});
  CHECK(losses(exported(1e308, 1e308, 10)) ==
        std::vector<std::string>{"1 element left out: the radius of its base is beyond binary64"});
  CHECK(exported(1e308, 1e308, 10).text.empty());
}

TEST_CASE("A malformed NFF file is an error with its place") {
  using Case = std::pair<std::string, std::string>;
  const Case cases[] = {
      {"^polygon 3", "unknown entity \"polygon\"; expected one of v, b, l, f, s, c, p, pp, Q, Z"},
      {"s 0 0 0 1 ^2", "unknown entity \"2\"; expected one of v, b, l, f, s, c, p, pp, Q, Z"},
      {"s 0 0 0 ^0", "radio_no_positivo; expected radio? ∈ Rmas (Agregar_Esfera.pre.2)"},
      {"s 0 0 ^x 1", "\"x\" in s; expected a finite number"},
      {"s 0 0 ^1e999 1", "\"1e999\" in s; expected a finite number"},
      {"s 0 0 0^", "the text ends in s; expected a number"},
      {"c ^1 1 1 2 1 1 1 2", "the ends of c give no axis; expected two points, a finite distance apart"},
      {"c ^0 0 0 0 0 0 1 0", "radio_no_positivo; expected radio? ∈ Rmas (Agregar_Cilindro.pre.2)"},
      {"c ^-1e308 0 0 1 1e308 0 0 1", "the ends of c give no axis; expected two points, a finite distance apart"},
      {"p 3 0 0 0 1 ^x 0 0 1 0", "\"x\" in p; expected a finite number"},
      {"p ^2\n0 0 0 1 1 1", "a polygon of 2 vertices; expected a whole number from 3"},
      {"p ^3.5", "a polygon of 3.5 vertices; expected a whole number from 3"},
      {"p 1e300 0 0 0^", "the text ends in p; expected a number"},
      {"f ^1 1 1 2 0 0 0 0",
       "the colour of f, times Kd, is no share of light; expected red, green and blue, each from 0 to 1"},
      {"f 1 1 1 1 ^1.5 0 0 0", "Ks is 1.5; expected a share of light, 0 to 1"},
      {"f 1 1 1 1 1 ^-1 0 0", "Shine is -1; expected a number from 0"},
      {"f 1 1 1 1 0 0 ^-1 0", "T is -1; expected a share of light, 0 to 1"},
      {"f 1 1 1 1 0 0 1 ^0", "the index of refraction is 0; expected a number above 0"},
      {"b ^-1 0 0", "the colour of b is negative; expected red, green and blue, each from 0"},
      {"b 0 0 0\n^b 0 0 0", "a second background; expected one"},
      {"v\nfrom 0 0 0\n^from 0 0 0",
       "\"from\" in a view; expected each of from, at, up, angle, hither, resolution once"},
      {"v\nfrom 0 0 0\n^", "\"\" in a view; expected each of from, at, up, angle, hither, resolution once"},
      {"v\nangle ^180", "angle is 180; expected an angle in degrees, above 0 and below 180"},
      {"v\nup ^0 0 0", "up is the null vector; expected a direction"},
      {"v\nresolution ^0 5", "resolution is 0 5; expected whole numbers of pixels, 1 to 65535"},
      {"^v\nfrom 0 0 0\nat 0 0 0\nup 0 1 0\nangle 45\nhither 0\nresolution 4 3", "from is at; expected two points"},
  };
  for (const auto& [text, expected] : cases) {
    INFO(text);
    CHECK(error_at(text) == expected);
  }
}

TEST_CASE("No damage to NFF does worse than an error") {
  CHECK(test::refused_after_damage(sample, 20000, reading) > 10000);
}

TEST_CASE("Real scenes: the standard procedural databases") {
  struct Expected {
    const char* name;
    std::size_t spheres, cylinders, truncated_cones, triangles;
    std::vector<std::string> lost;  // of what is no element
  };
  const std::string near_plane = "1 near plane (hither) left out: a scene's camera has none";
  const auto axes = [](int n) { return fmt::format("{} axes rounded: a scene holds a direction and a length", n); };
  const Expected all[] = {
      {"balls", 7381, 0, 0, 2, {near_plane}},
      {"rings", 4200, 4200, 0, 2, {axes(675), near_plane}},
      {"lattice", 1331, 3630, 0, 0, {}},
      {"jacks", 3510, 1755, 0, 0, {axes(361), near_plane}},
      {"tree",
       4095,
       0,
       4095,
       2,
       {axes(77), "8 proportions rounded: a scene holds how much a cone narrows by its height", near_plane}}};
  for (const Expected& e : all) {
    const auto path = test::spd_path(e.name);
    if (!path) continue;
    INFO(e.name);
    const io::Imported i = io::read_nff(io::read_source(*path));
    CHECK(count(i, model::Tipo::soy_esfera) == e.spheres);
    CHECK(count(i, model::Tipo::soy_cilindro) == e.cylinders);
    CHECK(count(i, model::Tipo::soy_cono) == 0);
    CHECK(count(i, model::Tipo::soy_tronco) == e.truncated_cones);
    CHECK(count(i, model::Tipo::soy_triangulo) == e.triangles);
    CHECK(i.lost == e.lost);
    const std::string text = io::scene_text(i.scene);
    CHECK(io::scene_text(io::read_scene(io::Source("f", text))) == text);
  }
}
