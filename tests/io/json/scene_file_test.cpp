#include "durero/io/json/scene_file.hpp"

#include <algorithm>
#include <tuple>

#include "durero/model/operaciones.hpp"
#include "durero/scene/stage.hpp"
#include "io/malformed.hpp"
#include "io/random_scene.hpp"
#include "support/catch.hpp"
#include "support/property.hpp"

using namespace durero;

namespace {

const auto reading = [](const io::Source& source) { return io::read_scene(source); };
std::string error_of(const std::string& text) { return test::error_of(text, reading); }

// What is wrong at the place that ^ marks.
std::string error_at(const std::string& with_mark) { return test::error_at_mark(with_mark, reading); }

// A scene file around the text of its elements.
std::string with_elements(const std::string& elements) {
  return "{\"format\":\"durero-scene\",\"version\":1,\n\"elementos\":[" + elements + "]}";
}
std::string sphere(const std::string& tail) { return R"({"id":"a","tipo":"esfera","centro":[0,0,0],)" + tail + "}"; }
std::string with_part(const std::string& part) {
  return "{\"format\":\"durero-scene\",\"version\":1,\"elementos\":[],\n" + part + "}";
}

const std::string sample = R"({"format":"durero-scene","version":1,
"camera":{"eye":[0,0,-5],"look_at":[0,0,0],"up":[0,1,0],"fov_y":45,"aperture":0.5,"focus":3,"shutter":0.25,"motion":[1,0,0]},
"resolution":[640,480],
"background":[0.1,0.2,0.3],
"lights":[
{"position":[1,2,3],"color":[1,1,1]},
{"position":[-1e+300,2,3],"color":[0,0,0.5]},
{"position":[0,9,0],"color":[1,1,1],"disc":{"radius":0.5,"normal":[0,-1,0]}},
{"position":[0,9,0],"color":[1,1,1],"sphere":{"radius":0.5}},
{"position":[0,9,0],"color":[1,1,1],"triangle":{"edges":[[1,0,0],[0,0,1]]}},
{"position":[0,9,0],"color":[1,1,1],"rectangle":{"edges":[[1,0,0],[0,0,1]]}}],
"directional_lights":[
{"direction":[0,-1,2],"color":[0.5,0,1]}],
"environment":{"gradient":[[0,0,0],[0.5,0.5,2]]},
"textures":{
"a":{"image":"a.png","repeat":[2,0.5],"filter":"mipmap","edges":"clamp","curve":"linear","near":3},
"b":{"p6m":[[1,1,1],[0,0,0]]}},
"materials":{
"red":{"color":[1,0,0]},
"rojo ñ":{"color":[1,0,0],"k_a":0.1,"k_d":0.2,"k_s":0.3,"e":20,"k_ps":0.4,"M_PS":[1,0.5,0],"gloss":30,"k_t":0.5,"M_T":[0,1,1],"index":1.5,"emission":[2,0,0],"ambient":[0,0.1,0],"textures":{"color":"a","k_s":"b"},"bump":{"texture":"a","height":-0.5,"delta":0.25}}},
"max_depth":7,
"elementos":[
{"id":"c1","tipo":"cilindro","centro":[0,0,0],"radio":0.5,"vector":[0,1,0],"altura":2},
{"id":"k1","tipo":"cono","centro":[0,0,0],"proporcion":0.5,"vector":[0,1,0],"altura":2,"material":"rojo ñ"},
{"id":"s1","tipo":"esfera","centro":[0,-0,5e-324],"radio":1,"material":"red","motion":[0,0.5,0]}
]}
)";

}  // namespace

TEST_CASE("A scene reads back from its text") {
  test::property("any scene", [] {
    const scene::Scene scene = test::any_scene();
    const std::string text = io::scene_text(scene);
    const scene::Scene back = io::read_scene(io::Source("f", text));
    RC_ASSERT(test::same_scene(scene, back));
    RC_ASSERT(io::scene_text(back) == text);
  });
  test::property("also after removals, which move rows", [] {
    scene::Scene scene = test::any_scene(12);
    while (scene.size() > 1 && *rc::gen::arbitrary<bool>()) {
      scene.apply(model::Eliminar_Elemento{model::Elemento{test::described(scene).begin()->first}});
    }
    const std::string text = io::scene_text(scene);
    RC_ASSERT(io::scene_text(io::read_scene(io::Source("f", text))) == text);
  });
}

TEST_CASE("The canonical text is a fixed point, and is what it says") {
  CHECK(io::scene_text(io::read_scene(io::Source("f", sample))) == sample);
  CHECK(io::scene_text(scene::Scene()) == "{\"format\":\"durero-scene\",\"version\":1,\n\"elementos\":[]}\n");
}

TEST_CASE("Order of keys and space mean nothing") {
  const std::string text =
      " {\"elementos\" : [ {\"material\":\"m\",\"radio\":2E0,\"centro\":[ 1,2 , 3],\t\"tipo\":"
      "\"esfera\",\"id\":\"\\u0061\"}\r\n],\"materials\":{\"m\":{\"color\":[0,0,0]}},\"version\":1.0,"
      "\"format\":\"durero-scene\"}";
  const scene::Scene scene = io::read_scene(io::Source("f", text));
  REQUIRE(scene.size() == 1);
  CHECK(scene.shapes<scene::Sphere>()[0].centro == glm::dvec3(1, 2, 3));
  CHECK(scene.shapes<scene::Sphere>()[0].radio == 2);
  CHECK(scene.find("a").has_value());
  CHECK(scene.material(*scene.find("a")) == 0U);
}

TEST_CASE("A scene is read alike however its lines end") {
  std::string cr = sample;
  std::ranges::replace(cr, '\n', '\r');
  CHECK(io::scene_text(io::read_scene(io::Source("f", cr))) == sample);
  CHECK(error_at("{\r\"format\":\"durero-scene\",\r\n\"version\":^0}") == "version is 0; expected 1");
}

TEST_CASE("A scene's numbers may have more digits than RapidJSON's own arithmetic holds") {
  const std::string zeros(400, '0');
  const scene::Scene scene = io::read_scene(io::Source("f", with_elements(sphere("\"radio\":2" + zeros + "e-400"))));
  CHECK(scene.find("a").has_value());
  CHECK(io::scene_text(scene).find("\"radio\":2}") != std::string::npos);
}

TEST_CASE("Errors of value stand at the value and name the label that is broken") {
  const auto error = [](const std::string& element) { return error_at(with_elements(element)); };
  CHECK(error(sphere(R"("radio":^0)")) == "radio (radius) is 0; expected r > 0 (Rmas.inv.1)");
  CHECK(error(sphere(R"("radio":^-0.0)")) == "radio (radius) is -0; expected r > 0 (Rmas.inv.1)");
  CHECK(error(sphere(R"("radio":^-1)")) == "radio (radius) is -1; expected r > 0 (Rmas.inv.1)");
  CHECK(error(sphere(R"("radio":^1e-999)")) == "radio (radius) is 0; expected r > 0 (Rmas.inv.1)");
  CHECK(error(sphere(R"("radio":^1e999)")) == "radio (radius) is \"1e999\", beyond binary64; expected a finite number");
  CHECK(error(sphere(R"("radio":^NaN)")).starts_with("\"N\" stands here; expected a JSON value"));
  CHECK(error(sphere(R"("radio":^Infinity)")).starts_with("\"I\" stands here; expected a JSON value"));
  const std::string axis = R"({"id":"a","tipo":"cilindro","centro":[0,0,0],"radio":1,"vector":)";
  CHECK(
      error(axis + "^[0,1.1,0],\"altura\":1}") ==
      "vector is (0, 1.1, 0); expected a unit vector, 1 − tolerancia_unidad ≤ d.x * d.x + d.y * d.y + d.z * d.z ≤ 1 + "
      "tolerancia_unidad (Unitario.inv.1)");
  CHECK(error(axis + "[0,1,0],\"altura\":^0}") == "altura (height) is 0; expected r > 0 (Rmas.inv.1)");
  CHECK(error(R"({"id":"a","tipo":"cono","centro":[0,0,0],"proporcion":^-2,"vector":[0,1,0],"altura":1})") ==
        "proporcion (proportion) is -2; expected r > 0 (Rmas.inv.1)");
  CHECK(error(sphere(R"("radio":1)") + ",\n" + R"({"id":^"a","tipo":"esfera","centro":[0,0,1],"radio":1})") ==
        "id is \"a\": elemento_ya_existe (element_already_exists); expected e? ∉ elementos (Agregar_Elemento.pre.1)");
}

namespace {

std::string triangle(const std::string& rest) {
  return R"({"id":"a","tipo":"triangulo","vertices":[[0,0,0],[1,2,3],[2,4,7]],)" + rest + "}";
}

}  // namespace

TEST_CASE("How textures lie on a triangle is read, written and kept by edits of others") {
  const std::string text = R"({"format":"durero-scene","version":1,
"elementos":[
{"id":"a","tipo":"triangulo","vertices":[[0,0,0],[1,2,3],[2,4,7]]},
{"id":"b","tipo":"triangulo","vertices":[[0,0,0],[1,2,3],[2,4,7]],"uv":[[0,0.5],[-1,0],[0,3]]},
{"id":"c","tipo":"triangulo","vertices":[[0,0,0],[1,2,3],[2,4,7]],"uv":[[0,0],[1,0],[0,1]],"tangents":[[[1,0,0],[0,1,0]],[[2,0,0],[0,1,0]],[[1,0,0],[0,1,3]]]}
]}
)";
  scene::Scene scene = io::read_scene(io::Source("scene.json", text));
  CHECK(io::scene_text(scene) == text);
  CHECK_FALSE(scene.wrap(*scene.find("a")));
  REQUIRE(scene.wrap(*scene.find("b")));
  CHECK(scene.wrap(*scene.find("b"))->uv[2] == glm::dvec2(0, 3));
  scene.apply(model::Eliminar_Triangulo{model::Elemento("a")});  // the last row comes into the gap
  REQUIRE(scene.wrap(*scene.find("c")));
  CHECK(scene.wrap(*scene.find("c"))->tangents->at(2)[1] == glm::dvec3(0, 1, 3));
  CHECK_FALSE(scene.wrap(*scene.find("b"))->tangents.has_value());
  scene.apply(model::Agregar_Esfera{model::Elemento("s"), {0, 0, 0}, 1});
  CHECK_THROWS_AS(scene.set_wrap(*scene.find("s"), {}), std::domain_error);
}

TEST_CASE("The normals of a triangle's vertices are read and written, with a texture and without") {
  const std::string text = R"({"format":"durero-scene","version":1,
"elementos":[
{"id":"a","tipo":"triangulo","vertices":[[0,0,0],[1,2,3],[2,4,7]],"normals":[[0,0,1],[0,2,0],[-1,0.5,0]]},
{"id":"b","tipo":"triangulo","vertices":[[0,0,0],[1,2,3],[2,4,7]],"uv":[[0,0.5],[-1,0],[0,3]],"normals":[[0,0,1],[0,0,1],[0,0,1]]}
]}
)";
  const scene::Scene scene = io::read_scene(io::Source("scene.json", text));
  CHECK(io::scene_text(scene) == text);
  REQUIRE(scene.vertex_normals(*scene.find("a")));
  CHECK(scene.vertex_normals(*scene.find("a"))->at(2) == glm::dvec3(-1, 0.5, 0));
  CHECK(scene.wrap(*scene.find("b"))->uv[2] == glm::dvec2(0, 3));
}

TEST_CASE("Errors of an element stand at its value or key") {
  using Case = std::pair<std::string, std::string>;
  const Case cases[] = {
      {sphere(R"("radio":^"1")"), "radio (radius) is a string; expected a number"},
      {sphere(R"("radio":^[1])"), "radio (radius) is an array; expected a number"},
      {sphere(R"("radio":^null)"), "radio (radius) is null; expected a number"},
      {sphere(R"("radio":1,^"color":2)"),
       "unknown key \"color\" in an element; expected one of id, tipo (type), centro (center), radio (radius), vector, "
       "altura (height), proporcion (proportion), "
       "vertices, material, uv, tangents, normals, motion"},
      {sphere(R"("radio":1,^"radio":1)"), "key \"radio\" (radius) stands twice; expected it once"},
      {sphere(R"("radio":1,^"altura":1)"),
       "unknown key \"altura\" (height) in an element of tipo esfera (sphere); expected the attributes of its tipo "
       "only"},
      {'^' + sphere(R"("material":"m")"),
       "key \"radio\" (radius) is missing in an element of tipo esfera (sphere); expected it"},
      {sphere(R"("radio":1,"material":^"m")"), "unknown material \"m\"; expected one of the scene's materials"},
      {sphere(R"("radio":1,"material":^3)"), "material is a number; expected a string"},
      {R"(^{"id":"a","centro":[0,0,0],"radio":1})", "key \"tipo\" (type) is missing in an element; expected it"},
      {R"({"id":^"a b","tipo":"esfera","centro":[0,0,0],"radio":1})",
       "id is \"a b\"; expected 1 to 128 of A-Z a-z 0-9 _ . : -"},
      {R"({"id":^"","tipo":"esfera","centro":[0,0,0],"radio":1})",
       "id is \"\"; expected 1 to 128 of A-Z a-z 0-9 _ . : -"},
      {R"({"id":"a","tipo":^"cubo","centro":[0,0,0],"radio":1})",
       "tipo (type) is \"cubo\"; expected one of esfera (sphere), cilindro (cylinder), cono (cone), tronco "
       "(truncated_cone), plano (plane), disco (disc), triangulo (triangle)"},
      {R"({"id":"a","tipo":"esfera","centro":^[0,0],"radio":1})",
       "centro (center) has 2 items; expected three numbers"},
      {R"({"id":"a","tipo":"esfera","centro":[0,0,0,^0],"radio":1})",
       "centro (center) has a fourth item; expected three numbers"},
      {R"({"id":"a","tipo":"esfera","centro":[0,^true,0],"radio":1})",
       "centro (center) is true or false; expected a number"},
      {R"({"id":"a","tipo":"esfera","centro":[0,^{"x":1},0],"radio":1})",
       "centro (center) is an object; expected a number"},
      {R"({"id":"a","tipo":"triangulo","vertices":^[[0,0,0],[1,0,0]]})", "vertices has 2 items; expected three points"},
      {R"({"id":"a","tipo":"triangulo","vertices":[[0,0,0],[1,0,0],^7]})", "vertices is a number; expected an array"},
      {R"({"id":"a","tipo":"triangulo","vertices":[[0,0,0],[1,0,0],^[0,1]]})",
       "vertices has 2 items; expected three numbers"},
      {R"({"id":"a","tipo":"triangulo","vertices":^[[0,0,0],[1,2,3],[2,4,6]]})",
       "vertices is three points on one line; expected the corners of a triangle (Vertices.inv.1)"},
      {R"({"id":"a","tipo":"triangulo","vertices":[[0,0,0],[1,2,3],[2,4,7]],^"centro":[0,0,0]})",
       "unknown key \"centro\" (center) in an element of tipo triangulo (triangle); expected the attributes of its "
       "tipo only"},
      {sphere(R"("radio":1,^"uv":[[0,0],[1,0],[0,1]])"),
       "unknown key \"uv\" in an element of tipo esfera (sphere); expected the attributes of its tipo only"},
      {sphere(R"("radio":1,^"normals":[[0,0,1],[0,0,1],[0,0,1]])"),
       "unknown key \"normals\" in an element of tipo esfera (sphere); expected the attributes of its tipo only"},
      {triangle(R"("normals":^[[0,0,1],[0,0,1]])"), "normals has 2 items; expected the normals of three vertices"},
      {triangle(R"("normals":[[0,0,1],^[0,0,-0.0],[0,0,1]])"),
       "a normal is (0, 0, 0); expected a direction of any length but 0"},
      {triangle(R"("uv":^[[0,0],[1,0]])"), "uv has 2 items; expected [u,v] of three vertices"},
      {triangle(R"("uv":[[0,0],[1,0],^[0]])"), "uv has 1 items; expected two numbers, u and v"},
      {triangle(R"("uv":[[0,0],[1,0],[0,^true]])"), "uv is true or false; expected a number"},
      {triangle(R"(^"tangents":[[[1,0,0],[0,1,0]],[[1,0,0],[0,1,0]],[[1,0,0],[0,1,0]]])"),
       "tangents without uv; expected uv too"},
      {triangle(R"("uv":[[0,0],[1,0],[0,1]],"tangents":[^[[1,0,0]],[[1,0,0],[0,1,0]],[[1,0,0],[0,1,0]]])"),
       "tangents has 1 items; expected two tangents, along u and v"},
      {R"(^{"id":"a","tipo":"disco","centro":[0,0,0],"vector":[0,0,1]})",
       "key \"radio\" (radius) is missing in an element of tipo disco (disc); expected it"},
      {"^3", "an element is a number; expected an object"},
      {"^[[[[]]]]", "an element is an array; expected an object"},
  };
  for (const auto& [element, expected] : cases) {
    INFO(element);
    CHECK(error_at(with_elements(element)) == expected);
  }
  const auto named = [](std::size_t length) {
    return with_elements(R"({"id":")" + std::string(length, 'x') + R"(","tipo":"esfera","centro":[0,0,0],"radio":1})");
  };
  CHECK_FALSE(error_of(named(129)).empty());
  CHECK(error_of(named(128)).empty());
}

TEST_CASE("Errors of the other parts stand at their value or key") {
  using Case = std::pair<std::string, std::string>;
  const std::string camera = R"("camera":{"eye":[0,0,0],"look_at":[0,0,1],"up":[0,1,0],"fov_y":)";
  const Case cases[] = {
      {"^[]", "a scene is an array; expected an object"},
      {"^{}", "key \"format\" is missing in a scene; expected it"},
      {R"(^{"format":"durero-scene","version":1})", "key \"elementos\" (elements) is missing in a scene; expected it"},
      {R"({"format":^"obj"})", "format is \"obj\"; expected \"durero-scene\""},
      {R"({"format":"durero-scene","version":^2})",
       "version 2 of durero-scene; expected 1 (written by a newer durero?)"},
      {R"({"layers":[],"elementos":7,"version":^2,"format":"durero-scene"})",
       "version 2 of durero-scene; expected 1 (written by a newer durero?)"},
      {R"({"format":"durero-scene","version":^"1"})", "version is a string; expected a number"},
      {R"({"format":"durero-scene","version":1,"elementos":^{}})",
       "elementos (elements) is an object; expected an array"},
      {with_part(R"(^"elements":[])"), "unknown key \"elements\" in a scene; expected elementos (elements)"},
      {with_part(R"(^"layers":[])"),
       "unknown key \"layers\" in a scene; expected one of format, version, elementos (elements), camera, resolution, "
       "background, lights, directional_lights, materials, max_depth, groups, textures, environment, prototypes, "
       "mallas (meshes)"},
      {with_part(camera + "^180}"), "fov_y is 180; expected an angle in degrees, above 0 and below 180"},
      {with_part(camera + "^0}"), "fov_y is 0; expected an angle in degrees, above 0 and below 180"},
      {with_part(R"("camera":^{"eye":[0,0,0]})"), "key \"look_at\" is missing in camera; expected it"},
      {with_part(R"("camera":^{"eye":[0,0,0],"look_at":[0,0,0],"up":[0,1,0],"fov_y":45})"),
       "the camera looks at its own eye; expected look_at elsewhere"},
      {with_part(R"("camera":{"up":^[0,0,0]})"), "up is the null vector; expected a direction"},
      {with_part(R"("resolution":[^0,1])"), "resolution is 0; expected whole numbers of pixels, 1 to 65535"},
      {with_part(R"("resolution":[1,^1.5])"), "resolution is 1.5; expected whole numbers of pixels, 1 to 65535"},
      {with_part(R"("resolution":[65535,^65536])"),
       "resolution is 65536; expected whole numbers of pixels, 1 to 65535"},
      {with_part(R"("materials":{"a":{"color":^[0,-1,0]}})"),
       "color is no share of light; expected red, green and blue, each from 0 to 1 (Material.inv.6)"},
      {with_part(R"("lights":[{"position":[0,0,0],"color":^[-1,0,0]}])"),
       "color is negative; expected red, green and blue, each from 0 (Fuente.inv.1)"},
      {with_part(R"("resolution":^[1])"), "resolution has 1 items; expected width and height"},
      {with_part(R"("resolution":[1,2,^3])"), "resolution has a third item; expected width and height"},
      {with_part(R"("background":^[0,-1,0])"), "background is negative; expected red, green and blue, each from 0"},
      {with_part(R"("lights":[^{"position":[0,0,0]}])"), "key \"color\" is missing in a light; expected it"},
      {with_part(R"("materials":{"a":{"color":^[0,2,0]}})"),
       "color is no share of light; expected red, green and blue, each from 0 to 1 (Material.inv.6)"},
      {with_part(R"("materials":{"a":{"color":[0,0,0]},^"a":{"color":[0,0,0]}})"),
       "material \"a\" stands twice; expected it once"},
      {with_part(R"("directional_lights":[{"direction":^[0,-0,0],"color":[1,1,1]}])"),
       "direction is the null vector; expected a direction"},
      {with_part(R"("directional_lights":[^{"color":[1,1,1]}])"),
       "key \"direction\" is missing in a directional light; expected it"},
      {with_part(R"("materials":{"a":{"color":[0,0,0],"k_ps":^1.5}})"),
       "k_ps is 1.5; expected a share of light, 0 to 1 (Material.inv.4)"},
      {with_part(R"("materials":{"a":{"color":[0,0,0],"k_t":^-0.5}})"),
       "k_t is -0.5; expected a share of light, 0 to 1 (Material.inv.5)"},
      {with_part(R"("materials":{"a":{"color":[0,0,0],"e":^-1}})"),
       "e is -1; expected a number from 0 (Material.inv.11)"},
      {with_part(R"("materials":{"a":{"color":[0,0,0],"index":^0}})"),
       "index is 0; expected a number above 0 (Material.inv.12)"},
      {with_part(R"("materials":{"a":{"color":[0,0,0],"M_T":^[0,0,2]}})"),
       "M_T is no share of light; expected red, green and blue, each from 0 to 1 (Material.inv.8)"},
      {with_part(R"("materials":{"a":{"color":[0,0,0],"emission":^[0,0,-1]}})"),
       "emission is negative; expected red, green and blue, each from 0 (Material.inv.9)"},
      {with_part(R"("materials":{"a":^{"k_ps":1}})"), "key \"color\" is missing in a material; expected it"},
      {with_part(R"("max_depth":^1000000)"),
       "max_depth is 1000000; expected a whole number of rays in a row, 1 to 1000"},
      {with_part(R"("max_depth":^0)"), "max_depth is 0; expected a whole number of rays in a row, 1 to 1000"},
      {with_part(R"("materials":{^"":{"color":[0,0,0]}})"), "the name of a material is empty; expected a name"},
  };
  for (const auto& [text, expected] : cases) {
    INFO(text);
    CHECK(error_at(text) == expected);
  }
}

TEST_CASE("What is no JSON in UTF-8 has its place too") {
  CHECK(error_at("^") == "the text is empty; expected a JSON value");
  CHECK(error_at("^\xEF\xBB\xBF" + sample) == "a byte order mark; expected UTF-8 without one");
  CHECK(error_at(sample + "^{}") == "\"{\" stands here after the value; expected the end of the text");
  CHECK(error_at("[[1,2]^}") == "\"}\" stands here; expected , or ] after an item");
  CHECK(error_at(with_part("\"materials\":{\"ro^\xFFjo\":{}}")) ==
        "\"\\xff\" stands here inside a string; expected UTF-8 without control characters");
}

TEST_CASE("Every prefix of a scene is refused, and no damage does worse") {
  for (std::size_t n = 0; n < sample.find_last_of('}'); ++n) {
    INFO(n);
    CHECK_FALSE(error_of(sample.substr(0, n)).empty());
  }
  const std::size_t refused = test::refused_after_damage(sample, 20000, reading);
  CHECK(refused > 10000);  // most damage is seen
  CHECK(refused < 20000);  // and some text is still a scene
}

TEST_CASE("Nesting a million deep is an error line") {
  const std::string deep(1000000, '[');
  CHECK(error_of(deep) ==
        "f:1:1000001: the text ends; expected a JSON value: object, array, string, finite number, true, false or null");
  const std::string closed = deep + std::string(1000000, ']');
  CHECK(error_of(closed) == "f:1:1: a scene is an array; expected an object");
  CHECK(error_of(with_elements(closed)) == "f:2:14: an element is an array; expected an object");
  CHECK(error_of(with_elements(R"({"id":"a","tipo":"esfera","centro":)" + closed + "}")) ==
        "f:2:50: centro (center) is an array; expected a number");
}

TEST_CASE("what is wrong with a texture, an environment or what a material has of them") {
  const auto at = [](const std::string& part) {
    return error_at("{\"format\":\"durero-scene\",\"version\":1,\"elementos\":[],\n" + part + "}");
  };
  const auto texture = [&](const std::string& text) { return at("\"textures\":{\"a\":" + text + "}"); };
  const auto environment = [&](const std::string& text) { return at("\"environment\":" + text); };
  const auto material = [&](const std::string& text) {
    return at(R"("textures":{"a":{"checker":[[1,1,1],[0,0,0]]}},"materials":{"m":{"color":[1,1,1],)" + text + "}}");
  };
  CHECK(texture("^{}") == "a texture is made of nothing; expected one of image, checker, stripes, p6m, waves");
  CHECK(texture(R"({"image":"a.png",^"waves":[[0,0,0],[1,1,1]]})") == "a texture is made of two things; expected one");
  CHECK(texture(R"({"image":^""})") == "image is empty; expected the name of a PNG or JPEG file");
  CHECK(texture(R"({"checker":[[1,1,1],[0,0,0]],^"filter":"linear"})") ==
        "only an image has this key; expected none but repeat");
  CHECK(texture(R"(^{"image":"a.png","filter":"mipmap"})") ==
        "a mipmap lacks near; expected the distance up to which it is M₀");
  CHECK(texture(R"(^{"image":"a.png","near":1})") == "near without a mipmap; expected \"filter\":\"mipmap\"");
  CHECK(texture(R"({"image":"a.png","filter":^"cubic"})") ==
        "filter is \"cubic\"; expected one of nearest, linear, mipmap");
  CHECK(texture(R"({"image":"a.png","edges":^"mirror"})") == "edges is \"mirror\"; expected one of repeat, clamp");
  CHECK(texture(R"({"image":"a.png","curve":^"gamma"})") == "curve is \"gamma\"; expected one of srgb, linear");
  CHECK(texture(R"({"checker":[[1,1,1],^[0,0,2]]})") ==
        "checker is no share of light; expected red, green and blue, each from 0 to 1");
  CHECK(texture(R"({"checker":^[[1,1,1]]})") == "checker has 1 items; expected two colours");
  CHECK(texture(R"({"checker":[[1,1,1],[1,1,1],^[1,1,1]]})") == "checker has a third item; expected two colours");
  CHECK(texture(R"({"image":"a.png","repeat":[1,^0]})") == "repeat is 0; expected a number above 0");
  CHECK(texture(R"({"image":"a.png","repeat":^[1]})") == "repeat has 1 items; expected two numbers above 0");
  CHECK(at(R"("textures":{"a":{"image":"b"},^"a":{"image":"b"}})") == "texture \"a\" stands twice; expected it once");
  CHECK(at(R"("textures":{^"":{"image":"b"}})") == "the name of a texture is empty; expected a name");
  CHECK(environment("^{}") == "environment is nothing; expected one of gradient, box, spherical, equirectangular");
  CHECK(environment(R"({"spherical":"a",^"box":[]})") == "environment is two things; expected one");
  CHECK(environment(R"({"box":^["a","b"]})") == "box has 2 items; expected six pictures, +x, -x, +y, -y, +z, -z");
  CHECK(environment(R"({"gradient":[[0,0,0],^[0,-1,0]]})") ==
        "gradient is negative; expected red, green and blue, each from 0");
  CHECK(material(R"("textures":{"color":^"b"})") == "unknown texture \"b\"; expected one of the scene's textures");
  CHECK(material(R"("bump":{"texture":^"b"})") == "unknown texture \"b\"; expected one of the scene's textures");
  CHECK(material(R"("bump":^{"height":1})") == "key \"texture\" is missing in bump; expected it");
  CHECK(material(R"("bump":{"texture":"a","delta":^0})") == "delta is 0; expected a number above 0");
  CHECK(material(R"("textures":{"k_a":^""})") == "k_a is empty; expected the name of a texture");
}

TEST_CASE("what blurs a picture is read, and each number is where it belongs") {
  const scene::Scene scene = io::read_scene(io::Source("f", sample));
  const scene::Camera& camera = *scene.stage().camera;
  CHECK(
      (camera.aperture == 0.5 && camera.focus == 3 && camera.shutter == 0.25 && camera.motion == glm::dvec3(1, 0, 0)));
  const auto& lights = scene.stage().lights;
  REQUIRE(lights.size() == 6);
  CHECK(lights[0].extent.shape == scene::LightShape::point);
  CHECK((lights[2].extent.shape == scene::LightShape::disc && lights[2].extent.normal == glm::dvec3(0, -1, 0)));
  CHECK((lights[3].extent.shape == scene::LightShape::sphere && lights[3].extent.radius == 0.5));
  CHECK((lights[4].extent.shape == scene::LightShape::triangle && lights[4].extent.edges[1] == glm::dvec3(0, 0, 1)));
  CHECK(lights[5].extent.shape == scene::LightShape::rectangle);
  CHECK(scene.stage().materials[1].gloss == 30);
  CHECK(*scene.motion(*scene.find("s1")) == glm::dvec3(0, 0.5, 0));
  CHECK(scene.motion(*scene.find("c1")) == nullptr);
}

TEST_CASE("errors of what blurs a picture stand at the value") {
  const auto camera = [](const std::string& keys) {
    return error_at(with_part(R"("camera":{"eye":[0,0,-5],"look_at":[0,0,0],"up":[0,1,0],"fov_y":45,)" + keys + "}"));
  };
  CHECK(camera(R"("aperture":^-1)") == "aperture is -1; expected a number from 0 (Lente.inv.2)");
  CHECK(camera(R"("focus":^0)") == "focus is 0; expected a number above 0 (Lente.inv.3)");
  CHECK(camera(R"("shutter":^-0.5)") == "shutter is -0.5; expected a number from 0");
  CHECK(camera(R"("motion":^[1,2])") == "motion has 2 items; expected three numbers");
  const auto light = [](const std::string& keys) {
    return error_at(with_part(R"("lights":[{"position":[0,0,0],"color":[1,1,1],)" + keys + "}]"));
  };
  CHECK(light(R"("sphere":{"radius":^0})") == "radius is 0; expected a number above 0");
  CHECK(light(R"("disc":{"radius":1,"normal":^[0,0,0]})") == "normal is the null vector; expected a direction");
  CHECK(light(R"("disc":^{"radius":1})").starts_with("key \"normal\" is missing"));
  CHECK(light(R"("rectangle":{"edges":^[[1,0,0],[2,0,0]]})") ==
        "edges is two parallel vectors; expected edges with an area between them");
  CHECK(light(R"("triangle":{"edges":^[[1,0,0]]})") == "edges has 1 items; expected two edges");
  CHECK(light(R"("sphere":{"radius":1},^"disc":{"radius":1,"normal":[0,1,0]})") ==
        "a light has two shapes; expected one");
  const auto spot = [&](const std::string& keys) { return light("\"spot\":{" + keys + "}"); };
  CHECK(light(R"("spot":^{"inner":3})") == "key \"towards\" is missing in spot; expected it");
  CHECK(spot(R"("towards":[1,2,3],"inner":^-1)") ==
        "inner is -1; expected an angle in degrees, from 0 to 90 (Cono_de_Luz.inv.2)");
  CHECK(spot(R"("towards":[1,2,3],"outer":^0)") ==
        "outer is 0; expected an angle in degrees, above 0, up to 90 (Cono_de_Luz.inv.2)");
  CHECK(spot(R"("towards":[1,2,3],"outer":^90.5)") ==
        "outer is 90.5; expected an angle in degrees, above 0, up to 90 (Cono_de_Luz.inv.2)");
  CHECK(spot(R"("towards":[1,2,3],"tightness":^-1)") ==
        "tightness is -1; expected a number from 0 (Cono_de_Luz.inv.3)");
  CHECK(light(R"("spot":^{"towards":[1,2,3],"outer":29})") ==
        "the light is full up to 30 degrees and ends at 29; expected an end no sooner (Cono_de_Luz.inv.2)");
  CHECK(error_at(with_part(R"("lights":[^{"position":[1,2,3],"color":[1,1,1],"spot":{"towards":[1,2,3]}}])")) ==
        "the cone of a light leads to its own place; expected another place (Cono_de_Luz.inv.1)");
  CHECK(error_at(with_part(R"("materials":{"m":{"color":[1,1,1],"gloss":^-1}})")) ==
        "gloss is -1; expected a number from 0");
}

TEST_CASE("the cone of a light is read and written, and what it leaves out is as in POV-Ray") {
  const auto read = [](const std::string& spot) {
    return io::read_scene(
        io::Source("f", R"({"format":"durero-scene","version":1,"lights":[{"position":[1,2,3],"color":[1,1,1],)" +
                            spot + R"(}],"elementos":[]})"));
  };
  const scene::Scene plain = read(R"("spot":{"towards":[0,0,1]})");
  const scene::LightCone cone = plain.stage().lights.at(0).cone.value();
  CHECK((cone.towards == glm::dvec3(0, 0, 1) && cone.inner == 30 && cone.outer == 45 && cone.tightness == 0));
  const scene::Scene whole =
      read(R"("sphere":{"radius":2},"spot":{"towards":[0,0,1],"inner":7,"outer":8,"tightness":9})");
  const scene::LightCone narrow = whole.stage().lights.at(0).cone.value();
  CHECK((narrow.inner == 7 && narrow.outer == 8 && narrow.tightness == 9));
  CHECK(whole.stage().lights.at(0).extent.radius == 2);
  for (const scene::Scene* const scene : {&plain, &whole}) {
    const std::string text = io::scene_text(*scene);
    CHECK(io::read_scene(io::Source("g", text)).stage() == scene->stage());
  }
}
