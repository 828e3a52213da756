// POV-Ray's language, read: what each word becomes, what comes back of an exported scene, and what is refused.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <set>

#include "durero/io/json/groups_file.hpp"
#include "durero/io/json/scene_file.hpp"
#include "durero/io/pov/pov.hpp"
#include "durero/scene/camera.hpp"
#include "durero/scene/stage.hpp"
#include "io/malformed.hpp"
#include "io/random_scene.hpp"
#include "support/catch.hpp"
#include "support/property.hpp"
#include "support/tree.hpp"

using namespace durero;
using Lines = std::vector<std::string>;

namespace {

const auto reading = [](const io::Source& s) { return io::read_pov(s); };
std::string error_at(const std::string& with_mark) { return test::error_at_mark(with_mark, reading); }
io::Imported import_as_it_stands(const std::string& text) { return io::read_pov(io::Source("f", text)); }
/// Of a text whose numbers are linear: a version holds for the whole text, wherever it stands.
io::Imported import_text(const std::string& text) { return import_as_it_stands(text + "\n#version 3.7;"); }
std::string json_of(const io::Imported& i) { return io::scene_text(i.scene, i.groups); }

const std::string sample = R"(// povray +W640 +H480 -A
#version 3.7; /* a /* comment */ within another */
global_settings { assumed_gamma 1 max_trace_level 7 adc_bailout 0 }
#declare Odd = function(A) { floor(A) - 2*floor(A/2) }
#declare White = color rgb <1, 1, 1>;
camera { location <0, 0, -4> direction <0, 0, 2> right <-4, 0, 0> up <0, 3, 0> }
background { rgb <0.1, 0.2, 0.3> }
light_source { <1, 2, 3>, rgb <0.5, 0.25, 1> }
light_source { <0, 8, 0>, color rgb 1 parallel point_at <0, 0, 0> }
sphere { <1, 2, 3>, 4 texture { pigment { rgb <1, 0.5, 0> } finish { ambient 0 diffuse 0.5 } } }
union {
  object { cylinder { <0, 0, 0>, <0, 0, 3>, 2 open } pigment { rgb <0, 0, 0.5> } }
  union {
    cylinder { <0, 0, 0>, <0, 3, 0>, 2 }
    cone { <0, 6, 0>, 1 <0, 2, 0>, 2 }
    cone { <0, 4, 0>, 0, <0, 2, 0>, 2 hollow }
  }
  mesh {
    triangle { <0, 0, 0>, <1, 0, 0>, <0, 1, 0> }
    smooth_triangle { <0, 0, 0>, z, <1, 0, 0>, z, <0, 2, 0>, z }
    triangle { <0, 0, 0>, <1, 0, 0>, <2, 0, 0> }
  }
  pigment { rgb <1, 0.5, 0> }
  finish { ambient rgb <0, 0.5, 1> diffuse 0.25 phong 0.5 phong_size 20 reflection 0.125 }
}
plane { -y, 1 }
plane { <0, 0, 4>, 0 translate <1, 2, 3> }
disc { <0, 0, 9>, -z, 3 }
)";
}  // namespace

TEST_CASE("Every object of POV-Ray becomes what a scene has for it, with caps, and unions become groups") {
  const io::Imported i = import_text(sample);
  CHECK(json_of(i) == R"({"format":"durero-scene","version":1,
"camera":{"eye":[0,0,-4],"look_at":[0,0,4],"up":[0,3,0],"fov_y":73.73979529168804},
"resolution":[640,480],
"background":[0.1,0.2,0.3],
"lights":[
{"position":[1,2,3],"color":[0.5,0.25,1]}],
"directional_lights":[
{"direction":[0,-8,0],"color":[1,1,1]}],
"materials":{
"f1":{"color":[1,0.5,0],"k_d":0.5},
"f2":{"color":[0,0,0.5],"k_d":0.6,"ambient":[0,0,0.05]},
"f3":{"color":[1,0.5,0],"k_d":0.25,"k_s":0.5,"e":20,"k_ps":0.125,"ambient":[0,0.25,0]}},
"max_depth":7,
"groups":{
"c2":{"elementos":["c2","c2:base","c2:top"]},
"k1":{"elementos":["k1","k1:base"]},
"m1":{"elementos":["v1","v2"]},
"t1":{"elementos":["t1","t1:base","t1:top"]},
"u1":{"groups":["c2","k1","t1"]},
"u2":{"elementos":["c1"],"groups":["m1","u1"]}},
"elementos":[
{"id":"c1","tipo":"cilindro","centro":[0,0,0],"radio":2,"vector":[0,0,1],"altura":3,"material":"f2"},
{"id":"c2","tipo":"cilindro","centro":[0,0,0],"radio":2,"vector":[0,1,0],"altura":3,"material":"f3"},
{"id":"c2:base","tipo":"disco","centro":[0,0,0],"radio":2,"vector":[-0,-1,-0],"material":"f3"},
{"id":"c2:top","tipo":"disco","centro":[0,3,0],"radio":2,"vector":[0,1,0],"material":"f3"},
{"id":"d1","tipo":"disco","centro":[0,0,9],"radio":3,"vector":[0,0,-1]},
{"id":"k1","tipo":"cono","centro":[0,2,0],"proporcion":1,"vector":[0,1,0],"altura":2,"material":"f3"},
{"id":"k1:base","tipo":"disco","centro":[0,2,0],"radio":2,"vector":[-0,-1,-0],"material":"f3"},
{"id":"p1","tipo":"plano","centro":[0,-1,0],"vector":[0,-1,0]},
{"id":"p2","tipo":"plano","centro":[1,2,3],"vector":[0,0,1]},
{"id":"s1","tipo":"esfera","centro":[1,2,3],"radio":4,"material":"f1"},
{"id":"t1","tipo":"tronco","centro":[0,2,0],"radio":1,"proporcion":0.25,"vector":[0,1,0],"altura":4,"material":"f3"},
{"id":"t1:base","tipo":"disco","centro":[0,2,0],"radio":2,"vector":[-0,-1,-0],"material":"f3"},
{"id":"t1:top","tipo":"disco","centro":[0,6,0],"radio":1,"vector":[0,1,0],"material":"f3"},
{"id":"v1","tipo":"triangulo","vertices":[[0,0,0],[1,0,0],[0,1,0]],"material":"f3"},
{"id":"v2","tipo":"triangulo","vertices":[[0,0,0],[1,0,0],[0,2,0]],"material":"f3","normals":[[0,0,1],[0,0,1],[0,0,1]]}
]}
)");
  CHECK(i.lost == Lines{"1 parallel light read as directional: a scene has none that some things stand behind",
                        "1 triangle left out: the vertices lie on one line",
                        "3 objects without a texture: of no material, where POV-Ray's is black",
                        "1 attribute left out: no picture shows it"});
}

TEST_CASE("Groups that are exported come back as groups of the same elements; those of nothing are told of") {
  const scene::GroupedScene read = io::read_grouped_scene(io::Source("f", R"({"format":"durero-scene","version":1,
"materials":{"g":{"color":[0,0,0],"k_t":0.5}},
"groups":{"a":{"elementos":["s2"],"groups":["b"]},"b":{"elementos":["d1","s3"]},"c":{},"d":{"elementos":["k1"],"groups":["c"]}},
"elementos":[
{"id":"d1","tipo":"disco","centro":[0,0,0],"radio":1,"vector":[0,0,1],"material":"g"},
{"id":"k1","tipo":"cono","centro":[0,0,0],"proporcion":1e300,"vector":[0,0,1],"altura":1e300},
{"id":"s1","tipo":"esfera","centro":[0,0,0],"radio":1},
{"id":"s2","tipo":"esfera","centro":[0,0,0],"radio":2},
{"id":"s3","tipo":"esfera","centro":[0,0,0],"radio":3}]})"));
  const io::Exported exported = io::pov_text(read.scene, read.groups);
  CHECK(exported.lost == Lines{"no camera in the scene: no view was written",
                               "1 element left out: the radius of its base is beyond binary64",
                               "2 groups left out: nothing is in it"});
  const io::Imported back = import_text(exported.text);
  CHECK(back.groups.table() == scene::Groups::Table{{"u1", {.elementos = {"d1", "s3"}, .groups = {}}},
                                                    {"u2", {.elementos = {"s2"}, .groups = {"u1"}}}});
  CHECK(back.lost.empty());
}

TEST_CASE("Solids are closed as an edit closes them, and what that rounds is counted") {
  CHECK(import_text("cone { 0, 1, <0, 0, 3>, 0.1 texture { pigment { rgb 1 } } }").lost ==
        Lines{"1 proportion rounded: a scene holds how much a cone narrows by its height",
              "1 solid closed but for the rounding of its rims"});
}

TEST_CASE("Axes, normals and planes that a scene cannot hold as they stand are rounded, and counted") {
  const io::Imported i = import_text(
      "cone { <0, 0, 0>, 1, <0, 0, 3>, 0.1 open } cylinder { <0, 1000, 0>, <0, 1000.18, 0.24>, 1 open }\n"
      "disc { 0, <1, 2, 2>, 1 } plane { <1, 2, 2>, 3 } plane { y, 1 translate x } plane { <3, 0, 0>, 5 }");
  CHECK(i.lost == Lines{"1 axis rounded: a scene holds a direction and a length",
                        "1 proportion rounded: a scene holds how much a cone narrows by its height",
                        "2 directions rounded: those of a scene have length 1",
                        "2 planes rounded: a scene holds a point of it",
                        "6 objects without a texture: of no material, where POV-Ray's is black"});
  const auto planes = i.scene.shapes<scene::Plane>();
  CHECK(planes[0].centro == glm::dvec3(1, 2, 2));
  CHECK(planes[1].centro == glm::dvec3(1, 1, 0));
  CHECK((planes[2].centro == glm::dvec3(5, 0, 0) && planes[2].vector == glm::dvec3(1, 0, 0)));
}

TEST_CASE("A camera that is told where to look has the same rays, and one that a scene cannot hold is told of") {
  const std::string changed = "1 camera changed: a scene's has square pixels and right angles";
  const auto lost = [](const std::string& camera) {
    return import_text("// +w400 -H300\ncamera { location <1, 2, -7> " + camera + " }").lost;
  };
  CHECK(lost("right <-4, 0, 0> up <0, 3, 0> direction <0, 0, 3>").empty());
  CHECK(lost("right <-4, 0, 0> up <0, 3, 0> look_at <1, 0, 0>").empty());
  CHECK(lost("right -x*4 up y*3 look_at <1, 0, 0>").empty());
  CHECK(lost("right <-4, 0, 0> up <0, 3, 0> angle 50 look_at <1, 0, 0>").empty());
  CHECK(lost("right <4, 0, 0> up <0, 3, 0> look_at <1, 0, 0>").empty());  // of a left-handed system
  CHECK(lost("right <4, 0, 0> up <0, -3, 0> direction <0, 0, 3>").empty());
  CHECK(lost("right <-3, 0, 0> up <0, 3, 0> look_at <1, 0, 0>") == Lines{changed});  // of another form
  CHECK(lost("right <-4, 1, 0> up <0, 3, 0> direction <0, 0, 3>") == Lines{changed});
  const auto camera = [](const std::string& told) {
    return *import_text("camera { location <1, 2, -7> right <-4, 0, 0> " + told + " }").scene.stage().camera;
  };
  CHECK(camera("angle 90 look_at <1, 0, 0>") ==
        scene::Camera{{1, 2, -7}, {1, 0, 0}, {0, 1, 0}, camera("angle 90").fov_y});
  CHECK(std::abs(camera("up <0, 4, 0> angle 90").fov_y - 90) < 1e-12);
  CHECK(std::abs(std::tan(glm::radians(camera("up <0, 2, 0> angle 90").fov_y / 2)) - 0.5) < 1e-15);
  CHECK(camera("sky <0, 1, 1> look_at <1, 0, 0>").up == glm::dvec3(0, 1, 1));
  const auto height = [](const std::string& text) {
    const auto size = import_text(text).scene.stage().resolution;
    return size ? int(size->height) : 0;
  };
  CHECK(height("camera { look_at z }") == 480);  // POV-Ray's is 4 by 3
  CHECK(height("camera { right x look_at z }") == 640);
  CHECK(height("camera { right x*16/9 look_at z }") == 0);  // as usual here
  CHECK(height("camera { right x look_at z } camera { right x*16/9 look_at z }") == 0);
  CHECK(height("camera { right x*0.7 look_at z }") == 914);  // and 2/7
  CHECK(height("// +W20 +H10\ncamera { look_at z }") == 10);
  const auto is_mirrored = [](const std::string& told) {
    return import_text("camera { location <1, 2, -7> " + told + " }").scene.stage().camera->mirrored;
  };
  CHECK_FALSE(camera("look_at 0").mirrored);
  CHECK(is_mirrored("look_at 0"));
  CHECK(is_mirrored("direction z"));
  CHECK(is_mirrored("look_at 0 rotate <20, 30, 40>"));
  CHECK_FALSE(is_mirrored("look_at 0 scale <-1, 1, 1>"));
  CHECK_FALSE(is_mirrored("direction -z"));
  CHECK_FALSE(is_mirrored("direction -z look_at 2*x"));  // it keeps its hand where it is turned
}

TEST_CASE("The words of a camera say the same in any order") {
  std::vector<std::string> words{"location <1, 2, -7>",   "look_at <0.5, 0.25, 0>", "angle 42",
                                 "right <-16, 1, 0>",     "up <0, 9, 1>",           "sky <0.25, 1, 0>",
                                 "direction <0, 0.25, 2>"};
  const auto read = [&](const std::string& before) {
    std::string text;
    for (const std::string& word : words) text += word + " ";
    const io::Imported i = import_as_it_stands(before + "camera { " + text + "}");
    return std::pair(i.scene.stage().camera.value(), i.lost);
  };
  const auto as_written = read("");
  CHECK(std::abs(as_written.first.fov_y - 24.468) < 0.001);
  CHECK(as_written.second.size() == 1);  // no right angles
  std::ranges::sort(words);
  do {
    INFO(words.front() << words[1] << words[2]);
    REQUIRE(read("") == as_written);
  } while (std::ranges::next_permutation(words).found);
  // Before version 3.5 they were carried out one by one.
  CHECK(error_at("#version 3.1; camera { look_at x ^location y }") ==
        "\"location\" stands here; expected it before look_at, which turns the camera where it stands by #version 3.1");
  CHECK(error_at("#version 3.1; camera { location y look_at x right -x } ^}").starts_with("\"}\" is not read"));
  CHECK(error_at("#version 3.5; camera { look_at x location y } ^}").starts_with("\"}\" is not read"));
}

namespace {

constexpr auto sums = ": sums and slopes of light are other than its own";

/// The background of a text that says this of its gamma.
glm::dvec3 background_by(const std::string& before, const std::string& after = "") {
  return import_as_it_stands(before + " background { rgb <0.5, 0.25, 0.03> } " + after)
      .scene.stage()
      .background.value();
}

}  // namespace

TEST_CASE("The numbers of colours are the light that POV-Ray shows, by the version and the gamma of the text") {
  const auto is = [](const glm::dvec3& c, const glm::dvec3& wanted) { return glm::distance(c, wanted) < 1e-8; };
  const glm::dvec3 plain(0.5, 0.25, 0.03), srgb(0.21404114, 0.05087609, 0.03 / 12.92),
      power(0.21763764, 0.04736614, 0.00044634098);
  CHECK(is(background_by(""), srgb));
  CHECK(is(background_by("#version 3.6;"), srgb));
  CHECK(is(background_by("#version 3.69;"), srgb));
  CHECK(background_by("#version 3.7;") == plain);
  CHECK(background_by("#version unofficial 3.7;") == plain);
  CHECK(background_by("#version 3.8;") == plain);
  for (const char* const version : {"", "#version 3.6; ", "#version 3.7; "}) {
    const auto by = [&](const std::string& gamma) {
      return background_by(fmt::format("{}global_settings {{ assumed_gamma {} }}", version, gamma));
    };
    CHECK(by("1") == plain);
    CHECK(is(by("2.2"), power));
    CHECK(is(by("srgb"), srgb));
  }
  // The last version and the first gamma hold, wherever they stand.
  CHECK(is(background_by("#version 3.7;", "#version 3.6;"), srgb));
  CHECK(background_by("#version 3.6;", "#version 3.7;") == plain);
  CHECK(background_by("", "global_settings { assumed_gamma 1 }") == plain);
  CHECK(is(background_by("global_settings { assumed_gamma 2.2 assumed_gamma 1 }", "#version 3.7;"), power));
  CHECK(error_at("global_settings { assumed_gamma ^0 }") == "assumed_gamma is 0; expected a number above 0, or srgb");
  CHECK(error_at("global_settings { assumed_gamma ^-1 }") == "assumed_gamma is -1; expected a number above 0, or srgb");
  CHECK(error_at("#version 3.7; global_settings { ^assumed_gamma 3 } background { rgb 1e200 }") ==
        "the light of a colour is beyond binary64; expected colours of finite light");
  CHECK(error_at("^background { rgb 1e200 }") ==
        "the light of a colour is beyond binary64; expected colours of finite light");
}

TEST_CASE("All colours and shares of light become linear, and how many is said") {
  const io::Imported i = import_as_it_stands(R"(global_settings { assumed_gamma 2 }
background { rgb <0.5, 1, 0> }
light_source { <1, 2, 3>, rgb <0.5, 0.25, 1> }
light_source { <0, 8, 0>, rgb 0.5 parallel }
sphere { 0, 1 pigment { rgb <0.5, 0.25, 1> }
  finish { ambient 0.5 diffuse 0.5 phong 0.25 phong_size 20 reflection rgb <0.5, 0.25, 0.5> } }
sphere { 0, 2 pigment { rgb <1, 0.5, 1> filter 0.5 } finish { ambient 0 diffuse 0 } interior { ior 1.5 } no_shadow }
sphere { 0, 3 pigment { rgb <0, 1, 0> } finish { ambient 0 diffuse 0.5 brilliance 0 emission 0.5 } })");
  const scene::Stage& stage = i.scene.stage();
  CHECK(stage.background == glm::dvec3(0.25, 1, 0));
  CHECK(stage.lights.at(0).color == glm::dvec3(0.25, 0.0625, 1));
  CHECK(stage.directional_lights.at(0).color == glm::dvec3(0.25));
  CHECK(stage.materials.at(0) == scene::Material{.name = "f1",
                                                 .color = {0.25, 0.0625, 1},
                                                 .k_d = 0.25,
                                                 .k_s = 0.0625,
                                                 .e = 20,
                                                 .k_ps = 0.25,
                                                 .M_PS = {1, 0.25, 1},
                                                 .ambient = {0.0625, 0.015625, 0.25}});
  CHECK(stage.materials.at(1) == scene::Material{.name = "f2", .k_t = 0.25, .M_T = {1, 0.25, 1}, .index = 1.5});
  CHECK(stage.materials.at(2) ==
        scene::Material{.name = "f3", .color = {0, 1, 0}, .k_a = 0.25, .k_d = 0, .emission = {0, 0.25, 0}});
  CHECK(std::ranges::count(i.lost,
                           std::string("12 colours and shares of light made linear from assumed_gamma 2") + sums) == 1);
  CHECK(import_as_it_stands("background { rgb <0.5, 1, 0> }").lost ==
        Lines{std::string("1 colour or share of light made linear from sRGB, which POV-Ray shows as they stand here") +
              sums});
  CHECK(import_as_it_stands("background { rgb <0, 1, 0> }").lost.empty());
  CHECK(import_as_it_stands("#version 3.7; background { rgb 0.5 }").lost.empty());
  CHECK(import_as_it_stands("global_settings { assumed_gamma 1 } background { rgb 0.5 }").lost.empty());
}

TEST_CASE("Terms of a material come back from an average; what a material has no place for is left out and counted") {
  const auto looks = [](const std::string& attributes) { return import_text("sphere { 0, 1 " + attributes + " }"); };
  const auto material = [&](const std::string& attributes) { return looks(attributes).scene.stage().materials.at(0); };
  CHECK(material("texture { average texture_map { [1 pigment { rgb <1, 0.5, 0> } finish { ambient 0 diffuse 0.5 "
                 "reflection { rgb <0.5, 0.25, 0.5> } }] [1 pigment { rgb <1, 0.5, 0> } finish { ambient 0 diffuse "
                 "0.125 brilliance 0 }] } }") ==
        scene::Material{
            .name = "f1", .color = {0.5, 0.25, 0}, .k_a = 0.125, .k_d = 0.5, .k_ps = 0.25, .M_PS = {1, 0.5, 1}});
  CHECK(material("pigment { rgb <1, 0.5, 1> filter 0.75 } finish { ambient 0 diffuse 0 } interior { ior 1.5 }") ==
        scene::Material{.name = "f1", .k_t = 0.75, .M_T = {1, 0.5, 1}, .index = 1.5});
  CHECK(material("pigment { rgbt <1, 0.5, 0, 0.25> } finish { diffuse 0.5 ambient 0 }") ==
        scene::Material{.name = "f1", .color = {1, 0.5, 0}, .k_d = 0.375, .k_t = 0.25});
  CHECK(material("pigment { rgb <1, 3, 0> } finish { ambient 0 diffuse 0 emission 1 }") ==
        scene::Material{.name = "f1", .emission = {1, 3, 0}});
  const std::string other =
      "1 texture left out: read are pigments of one colour, or of two as export writes them, with a finish, and "
      "averages of such";
  for (const char* texture :
       {"texture { T_Gold }", "pigment { wood }",
        "texture { pigment { rgb 1 } } texture { pigment { rgbt <0, 0, 0, 0.5> } }",
        "pigment { rgb <1, 0, 0> filter 0.25 transmit 0.25 }",
        "texture { average texture_map { [1 function { x } texture_map { [0 pigment { rgb 0 }] }] } }",
        "texture { average texture_map { [2 pigment { rgb 1 }] [1 pigment { rgb 0 }] } }",
        "texture { average texture_map { [1 pigment { rgb x }] [1 pigment { rgb y }] } }"}) {
    CAPTURE(texture);
    CHECK(looks(texture).lost == Lines{other});
    CHECK(looks(texture).scene.stage().materials.empty());
  }
  CHECK(looks("pigment { rgb 0.5 } finish { specular 0.5 metallic brilliance 2 irid { 0.25 thickness 1 } } normal { "
              "bumps 0.5 }")
            .lost == Lines{"1 relief (normal) left out",
                           "4 values of finishes or interiors left out: a material has no place for it"});
}

TEST_CASE("Glass with the shadow of a stone is one element; other shadows are told of") {
  const std::string glass = "texture { pigment { rgb 1 filter 0.5 } finish { ambient 0 diffuse 0 } }";
  const auto lost = [](const std::string& text) { return import_text(text).lost; };
  const std::string both =
      "object { sphere { 0, 1 } " + glass + " no_shadow } object { sphere { 0, 1 } no_image no_reflection }";
  CHECK(lost(both).empty());
  CHECK(import_text(both).scene.size() == 1);
  CHECK(lost("object { sphere { 0, 1 } " + glass + " no_shadow } object { sphere { 0, 2 } no_image no_reflection }") ==
        Lines{"1 object left out: nothing but a shadow would show it", "1 object without a shadow: kept, with one"});
  CHECK(lost("sphere { 0, 1 " + glass + " }") ==
        Lines{"1 object that light goes through: its shadow is that of a stone"});
  CHECK(lost("sphere { 0, 1 pigment { rgb 1 } no_image }") == Lines{"1 object not seen everywhere: kept, and seen"});
}

TEST_CASE("An index that stands apart from the texture is told of") {
  CHECK(import_text("object { sphere { 0, 1 pigment { rgb 1 } } interior { ior 1.5 } }").lost ==
        Lines{"1 value of a finish or an interior left out: a material has no place for it"});
}

TEST_CASE("Settings that a scene does not have are counted") {
  CHECK(import_as_it_stands("#version 3.6; global_settings { assumed_gamma 2.2 assumed_gamma 1 ambient_light rgb <1, "
                            "1, 1> radiosity { count 100 } "
                            "charset utf8 adc_bailout 0.01 } sky_sphere { pigment { rgb 1 } } union { hollow }")
            .lost == Lines{"1 sky_sphere left out", "6 global settings left out: a scene has none such",
                           "1 #version read as 3.7", "1 group left out: nothing is in it",
                           "1 attribute left out: no picture shows it"});
}

namespace {

/// What is seen of a material, whatever share it is made of.
std::vector<double> seen(const scene::Material& m) {
  std::vector<double> all;
  for (const glm::dvec3& v : {m.k_d * m.color, m.k_a * m.color, m.k_ps * m.M_PS, m.k_t * m.M_T, m.emission + m.ambient,
                              glm::dvec3(m.k_s, m.k_s > 0 ? m.e : 0, m.k_t > 0 ? m.index : 0)})
    for (int k = 0; k < 3; ++k) all.push_back(v[k]);
  return all;
}

bool near(double a, double b, double off) {
  return a == b || std::abs(a - b) <= off * std::max(std::abs(a), std::abs(b));
}

/// The numbers of an element.
std::vector<double> numbers(const scene::Scene& scene, scene::ElementRef element) {
  std::vector<double> all;
  scene.visit(element, [&]<class Shape>(const Shape& shape) {
    scene::for_each_attribute<Shape>([&](const auto& attribute) {
      const auto& value = shape.*attribute.field;
      const auto add = [&](const glm::dvec3& v) { all.insert(all.end(), {v.x, v.y, v.z}); };
      if constexpr (requires { value.x; })
        add(value);
      else if constexpr (requires { value.size(); })
        std::ranges::for_each(value, add);
      else
        all.push_back(value);
    });
  });
  return all;
}

/// The elements, by type and then by name: in the order of the names that a reader gives.
std::vector<scene::ElementRef> in_order(const scene::Scene& scene) {
  std::vector<scene::ElementRef> all;
  scene.for_each([&](scene::ElementRef element, const auto&) { all.push_back(element); });
  std::ranges::stable_sort(all, {},
                           [&](scene::ElementRef e) { return std::pair(e.tipo, scene.name(e).name().size()); });
  return all;
}
std::vector<scene::ElementRef> in_order_of_names(const scene::Scene& scene) {
  std::vector<scene::ElementRef> all;
  scene.for_each([&](scene::ElementRef element, const auto&) { all.push_back(element); });
  std::ranges::sort(all, {}, [&](scene::ElementRef e) { return std::pair(e.tipo, scene.name(e).name()); });
  return all;
}

void check_elements(const scene::Scene& scene, const scene::Scene& back, double off) {
  const auto before = in_order_of_names(scene), after = in_order(back);
  REQUIRE(before.size() == after.size());
  for (std::size_t i = 0; i < before.size(); ++i) {
    CAPTURE(scene.name(before[i]).name(), back.name(after[i]).name());
    REQUIRE(before[i].tipo == after[i].tipo);
    const auto a = numbers(scene, before[i]), b = numbers(back, after[i]);
    CHECK(std::ranges::equal(a, b, [&](double x, double y) { return near(x, y, off); }));
    const auto look = scene.material(before[i]), look_back = back.material(after[i]);
    const scene::Material material = look ? scene.stage().materials[*look] : scene::Material{.color = glm::dvec3(0.8)};
    if (material.textures.any() || material.bump) continue;
    REQUIRE(look_back.has_value());
    CHECK(std::ranges::equal(seen(material), seen(back.stage().materials[*look_back]),
                             [](double x, double y) { return near(x, y, 1e-15); }));
  }
}

/// Whether a light comes back: a triangle as a point, and a disc up to the rounding of its axes.
bool is_read_back(const scene::Light& light, const scene::Light& back) {
  if (light.position != back.position || light.color != back.color || light.cone != back.cone) return false;
  const scene::LightExtent &from = light.extent, &to = back.extent;
  if (from.shape == scene::LightShape::triangle) return to.is_point();
  if (from.shape == scene::LightShape::disc)
    return to.shape == from.shape && near(from.radius, to.radius, 1e-15) &&
           glm::distance(glm::normalize(from.normal), glm::normalize(to.normal)) < 1e-15;
  return from == to;
}

void check_stage(const scene::Stage& stage, const scene::Stage& back) {
  const auto size = stage.resolution.value_or(scene::default_resolution);
  CHECK(back.resolution == size);
  CHECK(back.background == (stage.environment ? std::nullopt : stage.background));
  CHECK(std::ranges::equal(stage.lights, back.lights, is_read_back));
  CHECK(back.max_depth == stage.max_depth.value_or(15));
  REQUIRE(back.directional_lights.size() == stage.directional_lights.size());
  for (std::size_t i = 0; i < stage.directional_lights.size(); ++i)
    CHECK(glm::distance(glm::normalize(stage.directional_lights[i].direction),
                        glm::normalize(back.directional_lights[i].direction)) < 1e-15);
  REQUIRE(back.camera.has_value() == stage.camera.has_value());
  if (!stage.camera) return;
  CHECK(back.camera->eye == stage.camera->eye);
  const scene::PrimaryRays here(*stage.camera, size), there(*back.camera, size);
  for (const std::uint32_t x : {0U, size.width / 3, size.width - 1})
    for (const std::uint32_t y : {0U, size.height - 1})
      CHECK(glm::distance(here.ray(x, y).v().xyz(), there.ray(x, y).v().xyz()) < 1e-14);
}

}  // namespace

TEST_CASE("The scenes of demo/ come back as they were exported: elements, looks, lights and every ray") {
  std::size_t scenes = 0;
  for (const char* folder : {"/demo", "/demo/gallery"}) {
    for (const auto& entry : std::filesystem::directory_iterator(test::source_dir() + folder)) {
      if (entry.path().extension() != ".json") continue;
      CAPTURE(entry.path().string());
      const scene::Scene scene = io::read_scene(io::read_source(entry.path()), io::Bodies::read);
      if (scene.has_bodies()) continue;  // their parts come back as other numbers
      const scene::Scene back = import_text(io::pov_text(scene).text).scene;
      check_elements(scene, back, 1e-14);
      check_stage(scene.stage(), back.stage());
      ++scenes;
    }
  }
  CHECK(scenes >= 13);
}

TEST_CASE("What was exported reads back, number for number where no loss is named") {
  test::property("any scene", [] {
    scene::Scene scene = test::any_scene();
    scene.stage().camera.reset();
    const io::Exported exported = io::pov_text(scene);
    const io::Imported back = import_text(exported.text);
    const auto is_named = [&](std::string_view what) {
      return std::ranges::any_of(exported.lost, [&](const std::string& line) { return line.find(what) != line.npos; });
    };
    RC_PRE(!is_named("element"));
    RC_ASSERT(back.scene.size() == scene.size());
    RC_PRE(!is_named("rounded") && !is_named("cylinder"));
    const auto values = [](const scene::Scene& s) {
      std::multiset<std::vector<double>> all;
      s.for_each([&](scene::ElementRef element, const auto&) { all.insert(numbers(s, element)); });
      return all;
    };
    RC_ASSERT(values(back.scene) == values(scene));
    RC_ASSERT(back.scene.stage().lights == scene.stage().lights);
  });
}

TEST_CASE(
    "Checkers, stripes and a sky between two colours come back, number for number, where they are their surface's") {
  const std::string scene = R"({"format":"durero-scene","version":1,"environment":{"gradient":[[0.5,0,0],[1,2,3]]},
"textures":{"p1":{"checker":[[1,0,0.1],[0.5,1,0.3]],"repeat":[49,0.3]},"p2":{"stripes":[[0.7,0.1,0],[0,0,1]]}},
"materials":{"f1":{"color":[1,1,1],"k_a":0.25,"k_d":0.5,"emission":[0.25,0.5,0],"textures":{"color":"p1","emission":"p1"}},
"f2":{"color":[1,1,1],"k_s":0.5,"e":20,"textures":{"color":"p2"}},"f3":{"color":[0,0,0],"k_t":0.5,"textures":{"M_T":"p2"}}},
"elementos":[{"id":"d1","tipo":"disco","centro":[1,2,3],"radio":0.7,"vector":[0,0.6,0.8],"material":"f1"},
{"id":"s1","tipo":"esfera","centro":[0.1,0.2,0.3],"radio":0.3,"material":"f2"},
{"id":"v1","tipo":"triangulo","vertices":[[0,0,0.1],[1,0,0.3],[0,0.7,0]],"material":"f3"}]})";
  const scene::Scene first = io::read_scene(io::Source("f", scene));
  const io::Exported out = io::pov_text(first);
  const io::Imported back = import_text(out.text);
  CHECK(back.lost.empty());
  const scene::Stage &stage = back.scene.stage(), &before = first.stage();
  CHECK(stage.textures == before.textures);
  CHECK(stage.environment == before.environment);
  REQUIRE(stage.materials.size() == 3);
  CHECK(stage.materials[0] == before.materials[0]);
  CHECK(stage.materials[1] == before.materials[1]);
  CHECK(stage.materials[2].textures == before.materials[2].textures);
  // On another surface it would be another texture.
  const auto lost = [&](const std::string& from, const std::string& to) {
    std::string text = out.text;
    const std::size_t at = text.find(from);
    REQUIRE(at != text.npos);
    return import_text(text.replace(at, from.size(), to)).lost;
  };
  const Lines left_out{
      "1 texture left out: read are pigments of one colour, or of two as export writes them, with a finish, and "
      "averages "
      "of such"};
  CHECK(lost("sphere { <0.1, 0.2, 0.3>, 0.3 }", "sphere { <0.1, 0.2, 0.3>, 0.25 }") == left_out);
  for (const auto& [from, to] : {std::pair("scale <1/49,", "scale <2/49,"),
                                 {"1/0.3, 1>", "1/-0.3, 1>"},
                                 {"[0.5 rgb", "[0.25 rgb"},
                                 {"checker rgb", "hexagon rgb"},
                                 {"warp {", "warp { spherical }, warp {"}}) {
    CAPTURE(from);
    const Lines mean = lost(from, to);
    CHECK(std::ranges::find(mean, "1 pigment of several colours: their mean") != mean.end());
  }
  CHECK(lost("checker rgb <2,", "checker rgb <3,") == left_out);
  CHECK(lost("[1 rgb <1, 2, 3>]", "[1 rgb <1, 2, -3>]") == Lines{"1 sky_sphere left out"});
  CHECK(lost("scale 2 translate", "scale 3 translate") == Lines{"1 sky_sphere left out"});
  // Their colours are numbers of the text's gamma.
  std::string curved = out.text;
  curved.replace(curved.find("assumed_gamma 1"), 15, "assumed_gamma 2");
  const scene::Stage squared = import_text(curved).scene.stage();
  CHECK(squared.textures.front().colors[1] == glm::dvec3(0.25, 1, 0.3 * 0.3));
  CHECK(squared.environment->colors[1] == glm::dvec3(1, 4, 9));
}

TEST_CASE("Cones and cylinders of an ordinary scene come back up to the rounding of their ends") {
  test::property("moderate numbers", [] {
    const auto positive = [] { return std::abs(*test::nonZero(test::moderate())); };
    const auto triple = [] { return glm::dvec3{*test::moderate(), *test::moderate(), *test::moderate()}; };
    const scene::Cylinder c{triple(), positive(), test::any_axis(), positive()};
    const scene::Cone k{triple(), positive(), test::any_axis(), positive()};
    const scene::TruncatedCone t{triple(), positive(), positive(), test::any_axis(), positive()};
    scene::Scene scene;
    scene.add(model::Elemento{"c"}, c);
    scene.add(model::Elemento{"k"}, k);
    scene.add(model::Elemento{"t"}, t);
    const io::Imported back = import_text(io::pov_text(scene).text);
    RC_PRE(back.scene.shapes<scene::TruncatedCone>().size() == 1U);  // its radii may round to one
    for (const char* name : {"c", "k", "t"}) {
      const auto a = numbers(scene, scene.find(name).value()),
                 b = numbers(back.scene, back.scene.find(name + std::string("1")).value());
      // An end is below 2^18 and rounded by 2^-35 at most, of an axis of 2^-8 and more.
      for (std::size_t i = 0; i < a.size(); ++i)
        RC_ASSERT(std::abs(a[i] - b[i]) <= 0x1p-20 * std::max(1.0, std::abs(a[i])));
    }
  });
}

TEST_CASE("A malformed POV-Ray text is an error with its place") {
  using Case = std::pair<std::string, std::string>;
  const std::string
      objects =
          "sphere, cylinder, cone, disc, plane, triangle, smooth_triangle, mesh, mesh2, polygon, union, object, merge, "
          "intersection, difference, box, prism, lathe, sor, superellipsoid, blob, isosurface, bicubic_patch",
      statements = objects + ", camera, light_source, background, global_settings, sky_sphere, #version",
      attributes =
          "texture, pigment, finish, normal, interior, material, translate, rotate, scale, matrix, transform, "
          "no_shadow, no_image, no_reflection, hollow, split_union, double_illuminate, sturm, hierarchy, "
          "inside_vector, "
          "uv_mapping, photons, radiosity, no_radiosity, cutaway_textures, interior_texture, bounded_by, clipped_by";
  const Case cases[] = {
      {"^spere { 0, 1 }", "\"spere\" is not read; expected sphere"},
      {"^}", "\"}\" is not read; expected one of " + statements},
      {"merge { sphere { 0, 1 } ^sphere { 0, 0 } }",
       "radio_no_positivo; expected radio? ∈ Rmas (Agregar_Esfera.pre.2)"},
      {"box { 0, 1 ^sphere { 0, 1 } }", "\"sphere\" is not read in box; expected one of " + attributes},
      {"mesh { triangle { 0, x, y } ^sphere { 0, 1 } }",
       "\"sphere\" is not read in mesh; expected one of triangle, smooth_triangle, " + attributes},
      {"union { sphere { 0, 1 } hollow ^sphere { 0, 1 } }",
       "\"sphere\" is not read in union; expected one of " + attributes},
      {"mesh { triangle { 0, x, y } hollow ^triangle { 0, x, y } }",
       "\"triangle\" is not read in mesh; expected one of " + attributes},
      {"object { ^Ball }", "\"Ball\" is not read in object; expected one of " + objects},
      {"sphere { 0, 1 ^textur { } }", "\"textur\" is not read in sphere; expected texture"},
      {"sphere { 0, 1 ^", "the text ends; expected } behind sphere"},
      {"sphere ^0, 1 }", "\"0\" stands here; expected { behind sphere"},
      {"sphere { 0, ^", "the text ends in sphere; expected a number"},
      {"sphere { ^R, 1 }", "\"R\" in sphere; expected a finite number"},
      {"sphere { 0, ^1e999 }", "\"1e999\" stands here; expected a finite number"},
      {"sphere { 0, 2*^}", "\"}\" stands here; expected a finite number"},
      {"^cylinder { x, x, 1 }", "the ends of cylinder give no axis; expected two points, a finite distance apart"},
      {"plane { ^0, 1 }", "the normal of plane gives no direction; expected a vector of finite length above 0"},
      {"sphere { 0, 1 finish { phong ^big } }", "\"big\" in phong; expected a finite number"},
      {"sphere { 0, 1 pigment { checker^", "the text ends; expected } for each {"},
      {"sphere { 0, 1 finish { specular^", "the text ends; expected } for each {"},
      {"sphere { 0, 1 texture { average texture_map { [1 pigment { rgb 1 }] ^",
       "the text ends; expected } behind texture_map"},
      {"camera { ^orthographi }",
       "\"orthographi\" stands here; expected one of location, direction, right, up, sky, angle, look_at, aperture, "
       "focal_point, blur_samples, confidence, variance, perspective, orthographic, fisheye, ultra_wide_angle, "
       "omnimax, panoramic, cylinder, spherical, mesh_camera, normal, translate, rotate, scale, matrix, transform, or "
       "}"},
      {"camera { right x*^wide }", "\"wide\" stands here; expected a finite number"},
      {"light_source { 0, rgb 1 ^look_like }",
       "\"look_like\" stands here; expected one of parallel, spotlight, point_at, radius, falloff, tightness, "
       "area_light, adaptive, jitter, circular, orient, area_illumination, translate, rotate, scale, matrix, "
       "transform, "
       "or }"},
      {"light_source { ^y, rgb 1 area_light x, x*2, 3, 3 }",
       "an area_light has parallel sides; expected sides with an area between them"},
      {"light_source { ^y, rgb 1 area_light x, z*2, 3, 3 circular }",
       "a circular area_light is no circle; expected sides of one length, at right angles"},
      {"global_settings { ^", "the text ends; expected } for each {"},
      {"#declare R ^", "the text ends; expected = behind the name of a declaration"},
      {"#version ^official", "\"official\" stands here; expected a finite number"},
      {"#version unofficial^", "the text ends; expected a number"},
      {"^/* /* */ sphere", "a comment that does not end; expected */"},
      {"sphere { 0, 1 } ^\"a\\\"", "a text that does not end; expected \""},
  };
  for (const auto& [text, expected] : cases) {
    INFO(text);
    CHECK(error_at(text) == expected);
  }
  std::string nested;
  for (int depth = 0; depth < 200; ++depth) nested += "union { ";
  CHECK(error_at(nested + "^sphere { 0, 1 }") == "objects in objects, deeper than 200; expected 200 at most");
}

TEST_CASE("No damage to a POV-Ray text does worse than an error") {
  CHECK(test::refused_after_damage(sample, 20000, reading) > 10000);
}

TEST_CASE("Spotlights, area_lights and lenses are read, and the places where POV-Ray has them") {
  const io::Imported i =
      import_as_it_stands(R"(camera { location -z*5 look_at 0 aperture 0.5 focal_point z blur_samples 20, 40 }
light_source { <1, 2, 3>, rgb 1 spotlight point_at <0, 1, 0> radius 10 falloff 20 tightness 3 }
light_source { <1, 2, 3>, rgb 1 spotlight }
light_source { y*3, rgb 1 area_light x*2, z*4, 5, 5 adaptive 1 jitter area_illumination on }
light_source { y*3, rgb 1 area_light x*2, z*2, 5, 5 circular }
light_source { y*3, rgb 1 area_light x*2, z*2, 5, 5 circular orient }
sphere { 0, 1 })");
  const scene::Stage& stage = i.scene.stage();
  CHECK((stage.camera->aperture == 0.25 && stage.camera->focus == 6));
  REQUIRE(stage.lights.size() == 5);
  CHECK(stage.lights[0].cone == scene::LightCone{{0, 1, 0}, 10, 20, 3});
  CHECK(stage.lights[1].cone == scene::LightCone{{1, 2, 4}});
  using Shape = scene::LightShape;
  CHECK(stage.lights[2].extent == scene::LightExtent{.shape = Shape::rectangle, .edges = {{{2, 0, 0}, {0, 0, 4}}}});
  CHECK(stage.lights[3].extent == scene::LightExtent{.shape = Shape::disc, .radius = 1, .normal = {0, -1, 0}});
  CHECK(stage.lights[4].extent == scene::LightExtent{.shape = Shape::sphere, .radius = 1});
}
