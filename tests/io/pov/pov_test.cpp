#include "durero/io/pov/pov.hpp"

#include <tuple>

#include "durero/io/json/scene_file.hpp"
#include "support/catch.hpp"

using namespace durero;

namespace {

io::Exported exported(const std::string& scene) {
  return io::pov_text(io::read_scene(io::Source("f", R"({"format":"durero-scene","version":1,)" + scene + "}")));
}

bool has(const io::Exported& out, const std::string& text) { return out.text.find(text) != std::string::npos; }

}  // namespace

TEST_CASE("every element becomes the object of POV-Ray that has its points") {
  const io::Exported out = exported(R"("elementos":[
    {"id":"s","tipo":"esfera","centro":[1,2,3],"radio":0.5},
    {"id":"c","tipo":"cilindro","centro":[0,0,0],"radio":2,"vector":[0,0,1],"altura":3},
    {"id":"k","tipo":"cono","centro":[1,0,0],"proporcion":0.5,"vector":[0,1,0],"altura":4},
    {"id":"t","tipo":"tronco","centro":[0,0,0],"radio":1,"proporcion":0.25,"vector":[1,0,0],"altura":4},
    {"id":"p","tipo":"plano","centro":[0,-1,0],"vector":[0,1,0]},
    {"id":"d","tipo":"disco","centro":[0,0,9],"radio":3,"vector":[0,0,-1]},
    {"id":"v","tipo":"triangulo","vertices":[[0,0,0],[1,0,0],[0,1,0]]}])");
  for (const char* object : {"sphere { <1, 2, 3>, 0.5 }", "cylinder { <0, 0, 0>, <0, 0, 3>, 2 open }",
                             "cone { <1, 0, 0>, 2, <1, 4, 0>, 0 open }", "cone { <0, 0, 0>, 2, <4, 0, 0>, 1 open }",
                             "plane { <0, 1, 0>, 0 translate <0, -1, 0> }", "disc { <0, 0, 9>, <0, 0, -1>, 3 }",
                             "triangle { <0, 0, 0>, <1, 0, 0>, <0, 1, 0> }"}) {
    CAPTURE(object);
    CHECK(has(out, std::string("object { ") + object +
                       " texture { pigment { rgb <0.8, 0.8, 0.8> } finish { ambient 0 "
                       "diffuse 1 } } }  // "));
  }
  CHECK(out.lost == std::vector<std::string>{"no camera in the scene: no view was written"});
}

TEST_CASE("the view is that of the camera, pixel for pixel, and lights, background and depth are as they were") {
  const io::Exported out = exported(R"("camera":{"eye":[0,0,-5],"look_at":[0,0,0],"up":[0,1,0],"fov_y":90},
    "resolution":[40,20],"max_depth":3,"background":[0.1,0.2,0.3],
    "lights":[{"position":[1,2,3],"color":[0.5,0.25,1]}],
    "directional_lights":[{"direction":[0,-1e-200,0],"color":[1,1,1]}],"elementos":[])");
  CHECK(out.text.starts_with("// povray +W40 +H20 -A File_Gamma=sRGB\n#version 3.7;\n"));
  CHECK(has(out, "global_settings { assumed_gamma 1 max_trace_level 3 adc_bailout 0 }\n"));
  CHECK(has(out, "camera { location <0, 0, -5> direction <"));
  CHECK(has(out, "background { rgb <0.1, 0.2, 0.3> }\n"));
  CHECK(has(out, "light_source { <1, 2, 3>, rgb <0.5, 0.25, 1> }\n"));
  CHECK(has(out, "rgb <1, 1, 1> parallel point_at <0, 0, 0> }\n"));
  CHECK(has(out, ", 1000000, "));
  CHECK(out.lost.size() == 1);
}

TEST_CASE("a mirrored camera is written with its right on the other side") {
  const std::string camera = R"("camera":{"eye":[0,0,-5],"look_at":[0,0,0],"up":[0,1,0],"fov_y":90)";
  const auto right = [](const io::Exported& out) { return out.text.find(" right <-") != std::string::npos; };
  CHECK(right(exported(camera + R"(},"elementos":[])")));
  CHECK_FALSE(right(exported(camera + R"(,"mirrored":true},"elementos":[])")));
}

TEST_CASE("a term of a material is a texture of an average, so many times itself; glass has an opaque twin") {
  const std::string ball = R"("elementos":[{"id":"b","tipo":"esfera","centro":[0,0,0],"radio":1,"material":"m"}])";
  const auto of = [&](const std::string& material) {
    return exported(R"("materials":{"m":{)" + material + "}}," + ball);
  };
  CHECK(
      has(of(R"("color":[0.5,0.25,0],"k_s":0.5,"e":20,"k_ps":0.25,"M_PS":[1,0,1])"),
          "texture { pigment { rgb <0.5, 0.25, 0> } finish { ambient 0 diffuse 1 phong 0.5 phong_size 20 reflection { "
          "rgb <0.25, 0, 0.25> } } } }"));
  CHECK(has(
      of(R"("color":[0.5,0.25,0],"k_a":0.125,"k_d":0.5,"k_ps":0.25)"),
      "texture { average texture_map { [1 pigment { rgb <1, 0.5, 0> } finish { ambient 0 diffuse 0.5 reflection { rgb "
      "<0.5, 0.5, 0.5> } }] [1 pigment { rgb <1, 0.5, 0> } finish { ambient 0 diffuse 0.125 brilliance 0 }] } }"));
  CHECK(has(of(R"("color":[0,0,0],"emission":[1,2,0],"ambient":[0,1,0])"),
            "texture { pigment { rgb <1, 3, 0> } finish { ambient 0 diffuse 0 emission 1 } }"));
  CHECK(has(of(R"("color":[0,0,0])"), "texture { pigment { rgb <0, 0, 0> } finish { ambient 0 diffuse 0 } }"));
  const io::Exported glass = of(R"("color":[0,0,0],"k_t":0.75,"M_T":[1,0.5,1],"index":1.5)");
  CHECK(has(glass,
            "object { sphere { <0, 0, 0>, 1 } texture { pigment { rgb <1, 0.5, 1> filter 0.75 } finish { ambient 0 "
            "diffuse 0 } } interior { ior 1.5 } no_shadow }  // b\n"));
  CHECK(has(glass, "object { sphere { <0, 0, 0>, 1 } no_image no_reflection }  // its shadow\n"));
}

TEST_CASE("a base beyond binary64 is counted, and what POV-Ray has no place for") {
  const io::Exported out = exported(R"("camera":{"eye":[0,0,-5],"look_at":[0,0,0],"up":[0,1,0],"fov_y":90},"elementos":[
    {"id":"k","tipo":"cono","centro":[1,0,0],"proporcion":1e300,"vector":[0,1,0],"altura":1e300}])");
  CHECK(out.lost == std::vector<std::string>{"1 element left out: the radius of its base is beyond binary64"});
  CHECK_FALSE(has(out, "object"));
}

TEST_CASE("what ends in binary64 do not give is left out; what they round is counted") {
  const auto lost = [](const std::string& elemento) {
    auto lines = exported(R"("elementos":[{"id":"e",)" + elemento + "}]").lost;
    lines.erase(lines.begin());  // there is no camera
    return lines;
  };
  using Lines = std::vector<std::string>;
  const std::string left_out = "1 element left out: no ends in binary64 give it",
                    rounded = "1 axis rounded: POV-Ray holds end points";
  CHECK(lost(R"("tipo":"cilindro","centro":[0,0,1e300],"radio":1,"vector":[0,0,1],"altura":1)") == Lines{left_out});
  CHECK(lost(R"("tipo":"cilindro","centro":[0,0,1.7e308],"radio":1,"vector":[0,0,1],"altura":1e308)") ==
        Lines{left_out});
  CHECK(lost(R"("tipo":"cono","centro":[0,0,0],"proporcion":5e-324,"vector":[0,0,1],"altura":0.25)") ==
        Lines{left_out});
  CHECK(lost(R"("tipo":"cono","centro":[0,0,9007199254740992],"proporcion":5e-324,"vector":[0,0,1],"altura":1.2)") ==
        Lines{left_out});
  CHECK(lost(R"("tipo":"tronco","centro":[0,0,0],"radio":1,"proporcion":1e-17,"vector":[0,0,1],"altura":1)") ==
        Lines{"1 truncated cone written as a cylinder: its radii round to one",
              "1 proportion rounded: POV-Ray holds the radii of the ends"});
  CHECK(lost(R"("tipo":"cilindro","centro":[0,1000,0],"radio":1,"vector":[0,0.6,0.8],"altura":0.3)") == Lines{rounded});
}

namespace {

/// The text of one element that wears a texture t.
io::Exported worn(const std::string& texture, const std::string& material, const std::string& element) {
  return exported(R"("camera":{"eye":[0,0,-5],"look_at":[0,0,0],"up":[0,1,0],"fov_y":90},"textures":{"t":{)" + texture +
                  R"(}},"materials":{"m":{)" + material + R"(}},"elementos":[{"id":"e","material":"m",)" + element +
                  "}]");
}
const std::string plano = R"("tipo":"plano","centro":[1,2,3],"vector":[0,1,0])";
/// The axes across +y are +x and -z; the pattern begins half a unit below.
const std::string on_plane = "matrix <1, 0, 0, 0, 0, -1, 0, 1, 0, 1, 1.5, 3>";

}  // namespace

TEST_CASE("a checker and stripes are POV-Ray's own patterns, laid on the surface") {
  const io::Exported squares = worn(R"("checker":[[1,0,0],[0.5,1,0]],"repeat":[2,3])",
                                    R"("color":[1,0.5,0.25],"textures":{"color":"t"})", plano);
  CHECK(squares.lost.empty());
  CHECK_FALSE(has(squares, "#declare"));
  CHECK(has(squares, "texture { pigment { checker rgb <1, 0, 0>, rgb <0.5, 0.5, 0> scale <1/2, 1/3, 1> " + on_plane +
                         " } finish { ambient 0 diffuse 1 } }"));
  const std::string stripes = R"("stripes":[[1,1,1],[0,0,0.5]],"repeat":[0.5,1])",
                    color = R"("color":[1,1,1],"textures":{"color":"t"})";
  const auto of = [&](const std::string& element) { return worn(stripes, color, element); };
  const std::string two =
      "pigment { gradient x color_map { [0.5 rgb <1, 1, 1>] [0.5 rgb <0, 0, 0.5>] } scale <2/0.5, 1/1, ";
  CHECK(has(of(plano), two + "1> " + on_plane + " }"));
  CHECK(has(of(R"("tipo":"disco","centro":[1,0,0],"radio":2,"vector":[0,0,1])"),
            two + "1> matrix <4, 0, 0, 0, 4, 0, 0, 0, 1, -1, -2, -0.5> }"));
  CHECK(has(of(R"("tipo":"triangulo","vertices":[[1,0,0],[3,0,0],[1,4,0]])"),
            two + "1> matrix <2, 0, 0, 0, 4, 0, 0, 0, 1, 1, 0, -0.5> }"));
  CHECK(has(of(R"("tipo":"esfera","centro":[1,2,3],"radio":2)"),
            two + "4> warp { spherical dist_exp 0 } matrix <1, 0, 0, 0, 1, 0, 0, 0, -1, 1, 2, 3> }"));
  CHECK(has(of(R"("tipo":"cilindro","centro":[1,2,3],"radio":2,"vector":[0,1,0],"altura":5)"),
            two + "4> warp { cylindrical dist_exp 0 } matrix <1, 0, 0, 0, 5, 0, 0, 0, -1, 1, 2, 3> }"));
  CHECK(has(of(R"("tipo":"cono","centro":[1,2,3],"proporcion":0.5,"vector":[0,1,0],"altura":4)"),
            two + "4> warp { cylindrical dist_exp 0 } matrix <1, 0, 0, 0, 4, 0, 0, 0, -1, 1, 2, 3> }"));
  CHECK(has(of(R"("tipo":"tronco","centro":[1,2,3],"radio":1,"proporcion":0.5,"vector":[0,1,0],"altura":4)"),
            two + "6> warp { cylindrical dist_exp 0 } matrix"));
  // The vertices are (1, 0), (0, 1) and (0, 0) of the square, so that its u goes from c to a, and its v from c to b.
  CHECK(has(of(R"("tipo":"triangulo","vertices":[[1,0,0],[3,0,0],[1,4,0]],"uv":[[1,0],[0,1],[0,0]])"),
            two + "1> matrix <0, -4, 0, 2, -4, 0, 0, 0, 1, 1, 4, -0.5> }"));
  CHECK(has(of(R"("tipo":"triangulo","vertices":[[1,0,0],[3,0,0],[1,4,0]],"uv":[[1,0],[0,0],[2,0]])"),
            "pigment { function { Odd(0.5*("));
}

TEST_CASE("a share that a pattern changes is two textures, and terms of one pattern share a pigment") {
  const std::string squares = R"("checker":[[1,1,1],[0.25,0.5,0]],"repeat":[2,3])";
  const io::Exported mirror = worn(squares, R"("color":[1,1,1],"k_ps":0.5,"textures":{"k_ps":"t"})", plano);
  const auto black = [](const std::string& of) {
    return "texture { pigment { rgb <0, 0, 0> } finish { ambient 0 diffuse 0 reflection { rgb " + of + " } } }";
  };
  CHECK(has(mirror,
            "texture { average texture_map { [1 pigment { rgb <2, 2, 2> } finish { ambient 0 diffuse 1 }] [1 checker " +
                black("<1, 1, 1>") + " " + black("<0.25, 0.25, 0.25>") + " scale <1/2, 1/3, 1> " + on_plane + "] } }"));
  // What shines of itself is a factor of the pigment, if it wears the same.
  const std::string same = R"("color":[0.5,1,1],"ambient":[0.25,0.125,0],"textures":{"color":"t","ambient":"t"})";
  CHECK(has(worn(squares, same, plano),
            "texture { pigment { checker rgb <0.5, 1, 1>, rgb <0.125, 0.5, 0> scale <1/2, 1/3, 1> " + on_plane +
                " } finish { ambient 0 diffuse 1 emission rgb <0.5, 0.125, 0> } }"));
  const std::string other = R"("color":[0.5,1,1],"ambient":[0.25,0.125,0],"textures":{"color":"t"})";
  CHECK(
      has(worn(squares, other, plano), "[1 pigment { rgb <0.5, 0.25, 0> } finish { ambient 0 diffuse 0 emission 1 }]"));
  // Two factors of one term that wear one pattern are the product at each of its ends.
  const std::string twice = R"("color":[1,1,1],"textures":{"color":"t","k_d":"t"})";
  CHECK(has(worn(squares, twice, plano), "checker rgb <1, 1, 1>, rgb <0.0625, 0.125, 0> scale"));
  // Between the colours of waves it is no mixture of these.
  const std::string waves = R"("waves":[[1,1,1],[0.25,0.5,0]])";
  CHECK(has(worn(waves, twice, plano), "average pigment_map { [1 function { (1 + (-0.75)*(0.5 + 0.5*sin("));
  CHECK(has(worn(waves, R"("color":[1,1,1],"textures":{"color":"t"})", plano),
            ") } color_map { [0 rgb <1, 1, 1>] [1 rgb <0.25, 0.5, 0>] } }"));
}

TEST_CASE("a picture is POV-Ray's where nothing multiplies it; else functions stand for it, and are declared") {
  const auto of = [](const std::string& texture, const std::string& material) {
    return worn(texture, material, plano);
  };
  const std::string white = R"("color":[1,1,1],"k_a":0.25,"textures":{"color":"t"})",
                    grey = R"("color":[0.5,0.5,0.5],"textures":{"color":"t"})";
  const io::Exported own = of(R"("image":"a.jpeg","filter":"nearest","curve":"linear","repeat":[2,2])", white);
  CHECK(has(own, "[1 pigment { image_map { jpeg \"a.jpeg\" gamma 1 } scale <1/2, 1/2, 1> " + on_plane +
                     " } finish { ambient 0 diffuse 2 }]"));
  CHECK(has(own, "finish { ambient 0 diffuse 0.5 brilliance 0 }]"));
  CHECK_FALSE(has(own, "#declare"));
  for (const auto& [texture, material, declared, used] :
       {std::tuple(
            R"("image":"a\"b.PNG","edges":"clamp")", white,
            "#declare Image0 = function { pigment { image_map { png \"a\\\"b.PNG\" gamma srgb interpolate 2 } } }\n",
            "Image0(min(max(1*("),
        {R"("image":"a.jpeg","filter":"nearest","curve":"linear")", grey,
         "#declare Image0 = function { pigment { image_map { jpeg \"a.jpeg\" gamma 1 } } }\n", "Image0(1*("},
        {R"("p6m":[[1,1,1],[0,0,0]])", white, "#declare Hexagons", "function { Hexagons(1*("}}) {
    CAPTURE(texture);
    const io::Exported out = of(texture, material);
    CHECK(has(out, declared));
    CHECK(has(out, used));
    CHECK_FALSE(has(out, "#declare Turn"));
    CHECK(out.lost.empty());
  }
}

TEST_CASE(
    "a relief of waves is a normal of the same slopes, and turned over where a flat element is seen from behind") {
  const auto of = [&](const std::string& eye, const std::string& bump) {
    return exported(
        R"("camera":{"eye":)" + eye +
        R"(,"look_at":[0,0,0],"up":[0,1,0],"fov_y":90},"textures":{"t":{"waves":[[0,0,0],[1,1,1]],"repeat":[1,4]}},
      "materials":{"m":{"color":[1,1,1],"bump":{"texture":"t")" +
        bump +
        R"(}}},"elementos":[{"id":"d","tipo":"disco","centro":[0,0,0],"radio":2,"vector":[0,0,1],"material":"m"}])");
  };
  const io::Exported before = of("[0,0,5]", R"(,"height":0.5)"), behind = of("[0,0,-5]", R"(,"height":0.5)");
  CHECK(has(before, " pigment { rgb <1, 1, 1> } normal { function { 0.25 + ("));
  CHECK(has(before, ")/6 } bump_size 7.5 accuracy 1e-05 } finish { ambient 0 diffuse 1 }"));
  CHECK(has(behind, "bump_size -7.5 "));
  CHECK(before.lost.empty());
  CHECK(of("[0,0,5]", R"(,"delta":0.5)").lost.size() == 1);
}

TEST_CASE("no relief turns the term of k_a, nor what shines of itself") {
  const io::Exported out = exported(R"("textures":{"t":{"waves":[[0,0,0],[1,1,1]]}},
    "materials":{"m":{"color":[1,1,1],"k_a":0.5,"k_s":0.25,"ambient":[1,0,0],"bump":{"texture":"t"}}},
    "elementos":[{"id":"d","tipo":"disco","centro":[0,0,0],"radio":2,"vector":[0,0,1],"material":"m"}])");
  CHECK(has(out, "[1 pigment { rgb <2, 2, 2> } finish { ambient 0 diffuse 0.5 brilliance 0 }]"));
  CHECK(has(out, "[1 pigment { rgb <2, 2, 2> } normal {"));
  CHECK(has(out, "finish { ambient 0 diffuse 1 emission rgb <1, 0, 0> phong 0.5 phong_size 1 }]"));
}

TEST_CASE("what is around is a sky of the same colours") {
  const auto of = [](const std::string& environment) {
    return exported(R"("camera":{"eye":[0,0,-5],"look_at":[0,0,0],"up":[0,1,0],"fov_y":90},"background":[1,0,0],
      "environment":{)" +
                    environment + R"(},"elementos":[])");
  };
  const io::Exported gradient = of(R"("gradient":[[0.5,0,0],[1,2,3]])");
  CHECK(
      has(gradient,
          "sky_sphere { pigment { gradient y color_map { [0 rgb <0.5, 0, 0>] [1 rgb <1, 2, 3>] } scale 2 translate <0, "
          "-1, 0> } }\n"));
  CHECK_FALSE(has(gradient, "background"));
  CHECK(has(of(R"("equirectangular":"a.png")"), "Sky0(0.5 + atan2(x, -z)/(2*pi), "));
  CHECK(has(of(R"("spherical":"a.png")"), "1*Sky0(min(max(0.5 + 0.5*x/max(sqrt("));
  CHECK(has(of(R"("box":["a.png","b.png","c.png","d.png","e.png","f.png"])"),
            "select(-z - max(abs(x), abs(y)), 0, 1)*Sky5("));
}

TEST_CASE("pictures that POV-Ray cannot tell by name, levels and reliefs are counted") {
  const io::Exported out = exported(R"("camera":{"eye":[0,0,-5],"look_at":[0,0,0],"up":[0,1,0],"fov_y":90},
    "textures":{"squares":{"image":"squares"},"steps":{"image":"a.png","filter":"mipmap","near":2}},
    "materials":{"m":{"color":[1,1,1],"textures":{"color":"squares"},"bump":{"texture":"steps"}}},
    "environment":{"spherical":"sky.gif"},
    "elementos":[{"id":"p","tipo":"plano","centro":[0,0,0],"vector":[0,1,0],"material":"m"}])");
  CHECK(out.lost ==
        std::vector<std::string>{"1 environment left out: by their names its files are neither PNG nor JPEG",
                                 "1 texture left out: by its name a file is neither PNG nor JPEG",
                                 "1 mipmap drawn by the picture alone: POV-Ray has no levels",
                                 "1 relief drawn by the differences of POV-Ray: only those of waves are slopes"});
  CHECK(has(out, "texture { pigment { rgb <1, 1, 1> } normal { function { 0.25 + (Image1("));
}

TEST_CASE("lens, shapes and cones of lights are written, and what moves is left out and named") {
  const io::Exported out = exported(R"("camera":{"eye":[0,0,-5],"look_at":[0,0,0],"up":[0,1,0],"fov_y":45,
"aperture":0.5,"focus":3,"shutter":1,"motion":[1,0,0]},"materials":{"m":{"color":[1,1,1],"gloss":9}},
"lights":[{"position":[0,9,0],"color":[1,1,1],"sphere":{"radius":1}},{"position":[1,9,0],"color":[1,1,1]},
{"position":[2,9,0],"color":[1,1,1],"disc":{"radius":0.5,"normal":[0,0,2]}},
{"position":[3,9,0],"color":[1,1,1],"rectangle":{"edges":[[1,0,0],[0,0,2]]}},
{"position":[4,9,0],"color":[1,1,1],"triangle":{"edges":[[1,0,0],[0,0,2]]}},
{"position":[5,9,0],"color":[1,1,1],"spot":{"towards":[1,2,3],"inner":10,"outer":20,"tightness":4}}],
"elementos":[{"id":"a","tipo":"esfera","centro":[0,0,0],"radio":1,"material":"m","motion":[0,1,0]}])");
  CHECK(out.lost == std::vector<std::string>{"1 triangle that shines written as a point: POV-Ray has no such light",
                                             "1 shutter left out: not written to POV-Ray",
                                             "2 motions left out: not written to POV-Ray",
                                             "1 gloss left out: not written to POV-Ray"});
  CHECK(has(out, " aperture 1 focal_point <0, 0, -2> blur_samples 64 variance 0 }\n"));
  CHECK(has(out,
            "light_source { <0, 9, 0>, rgb <1, 1, 1> area_light <2, 0, 0>, <0, 2, 0>, 9, 9 jitter "
            "area_illumination circular orient }\n"));
  CHECK(has(out, "light_source { <1, 9, 0>, rgb <1, 1, 1> }\n"));
  CHECK(has(out,
            "light_source { <3, 9, 0>, rgb <1, 1, 1> area_light <1, 0, 0>, <0, 0, 2>, 9, 9 jitter "
            "area_illumination }\n"));
  CHECK(has(out, "light_source { <4, 9, 0>, rgb <1, 1, 1> }\n"));
  CHECK(has(out,
            "light_source { <5, 9, 0>, rgb <1, 1, 1> spotlight point_at <1, 2, 3> radius 10 falloff 20 tightness 4 "
            "}\n"));
  CHECK(has(out, " 9, 9 jitter area_illumination circular }\n"));
}
