// Scenes as texts of Mitsuba: what each thing becomes, what comes back the same, and what is counted.
#include <glm/geometric.hpp>

#include "durero/io/exported_files.hpp"
#include "durero/io/mitsuba/mitsuba.hpp"
#include "durero/scene/body.hpp"
#include "durero/scene/camera.hpp"
#include "io/written.hpp"
#include "support/catch.hpp"
#include "support/folder.hpp"
#include "support/property.hpp"

using namespace durero;
using Lines = std::vector<std::string>;

namespace {

io::Exported to_mitsuba(const scene::GroupedScene& of) { return io::mitsuba_text(of.scene, of.groups, "room"); }
io::Exported to_mitsuba(const std::string& body) { return to_mitsuba(test::scene_of(body)); }
io::Imported from_mitsuba(const io::Exported& out) {
  const test::Folder folder;
  io::ExportedFiles(folder.file("room.xml"), "").write(out);
  return io::read_mitsuba(io::read_source(folder.file("room.xml")));
}
bool says(const io::Exported& out, const std::string& text) { return out.text.find(text) != std::string::npos; }

const std::string no_view = "no camera in the scene: no view was written";
const std::string sphere = R"({"id":"s","tipo":"esfera","centro":[1,2,3],"radio":0.5})";

}  // namespace

TEST_CASE("Shapes of Mitsuba come back the same, triangles by files beside the text") {
  scene::GroupedScene of = test::scene_of(R"("materials":{"m":{"color":[0.5,0.25,1]}},"elementos":[
    {"id":"s","tipo":"esfera","centro":[1,2,3],"radio":0.5,"material":"m"},
    {"id":"c","tipo":"cilindro","centro":[0,0,0],"radio":2,"vector":[0,0,1],"altura":3,"material":"m"},
    {"id":"d","tipo":"disco","centro":[0,0,9],"radio":3,"vector":[0,-1,0],"material":"m"},
    {"id":"v","tipo":"triangulo","vertices":[[0,0,0],[1,0,0],[0,1,0.1]],"material":"m"},
    {"id":"w","tipo":"triangulo","vertices":[[0,0,0],[1,0,0],[0,1,0.2]],"material":"m",
     "normals":[[0,0,1],[0,0,1],[0,1,1]]}])");
  const io::Exported out = to_mitsuba(of);
  CHECK(out.lost == Lines{no_view});
  CHECK(says(
      out,
      R"(<shape id="s" type="sphere"><point name="center" x="1" y="2" z="3"/><float name="radius" value="0.5"/><ref id="m"/></shape>)"));
  CHECK(says(
      out,
      R"(<shape id="d" type="disk"><transform name="to_world"><scale value="3"/><rotate x="1" y="0" angle="90"/>)"));
  REQUIRE(out.beside.size() == 2);
  CHECK((out.beside[0].name == "room.mesh1.ply" && out.beside[1].name == "room.mesh2.ply"));
  CHECK(says(out, R"(value="room.mesh1.ply"/><boolean name="face_normals" value="true"/>)"));
  CHECK(says(out, R"(value="room.mesh2.ply"/><ref)"));
  const io::Imported again = from_mitsuba(out);
  CHECK(test::shapes_and_looks(again.scene) == test::shapes_and_looks(of.scene));
  std::size_t smooth = 0;
  again.scene.for_each([&](scene::ElementRef e, const auto&) {
    const auto normals = again.scene.vertex_normals(e);
    smooth += normals && (*normals)[2] == glm::dvec3(0, 1, 1);
  });
  CHECK(smooth == 1);
  CHECK(
      to_mitsuba(R"("elementos":[{"id":"k","tipo":"cono","centro":[1,0,0],"proporcion":0.5,"vector":[0,1,0],"altura":4},
    {"id":"t","tipo":"tronco","centro":[0,0,0],"radio":1,"proporcion":0.25,"vector":[1,0,0],"altura":4},
    {"id":"p","tipo":"plano","centro":[0,-1,0],"vector":[0,1,0]}])")
          .lost == Lines{"1 cone left out: not written to Mitsuba", "1 truncated cone left out: not written to Mitsuba",
                         "1 plane left out: not written to Mitsuba", no_view});
}

TEST_CASE("What is not counted as rounded or left out comes back from Mitsuba bit for bit") {
  std::size_t same = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    test::Random random(seed);
    const scene::Scene of = test::scene_to_write(random, 2);
    const io::Exported out = to_mitsuba({of, {}});
    INFO("seed " << seed << "\n" << out.text);
    scene::Scene bare = from_mitsuba(out).scene;
    bare.for_each([&](scene::ElementRef e, const auto&) { bare.set_material(e, std::nullopt); });
    if (!test::has_line(out.lost, "left out")) CHECK(bare.size() == of.size());
    if (out.lost != Lines{no_view}) continue;
    CHECK(test::shapes_and_looks(bare) == test::shapes_and_looks(of));
    ++same;
  }
  CHECK((same > 30 && same < 250));
}

TEST_CASE("Any scene is written as a text that Mitsuba's reader reads") {
  test::property("any scene", [] {
    const scene::Scene of = test::any_scene();
    const io::Exported out = to_mitsuba({of, {}});
    try {
      from_mitsuba(out);
    } catch (const io::InputError& error) {  // a direction between points beyond binary64 is none
      CHECK(std::string(error.what()).find("lookat gives no direction") != std::string::npos);
    }
  });
}

TEST_CASE("A copy is an instance of one shape by the same map, and a box a cube") {
  const scene::GroupedScene of = test::scene_of(R"("elementos":[)" + sphere + R"(,
    {"id":"i","tipo":"instancia","de":"s","mapa":[[2,0,0.25,-1],[0,1,0,-1],[0,0,1,0]]},
    {"id":"b","tipo":"caja","esquinas":[[-2,0,-1],[-1.5,1,0]]},
    {"id":"j","tipo":"instancia","de":"b","mapa":[[2,0,0.5,5],[0,1,0,0],[0,0,1,0]]},
    {"id":"r","tipo":"instancia","de":"s","mapa":[["1/3",0,0,0],[0,1,0,0],[0,0,1,0]]},
    {"id":"far","tipo":"instancia","de":"s","mapa":[["1)" +
                                                std::string(400, '0') +
                                                R"(",0,0,0],[0,1,0,0],[0,0,1,0]]},
    {"id":"u","tipo":"union","de":["b",{"tipo":"esfera","centro":[0,0,0],"radio":2}]}])");
  const io::Exported out = to_mitsuba(of);
  CHECK(out.lost == Lines{"1 solid left out: not written to Mitsuba", "1 map rounded: an entry is no binary64",
                          "1 element left out: an entry of its map is beyond binary64", no_view});
  CHECK(says(out, R"(<matrix value="2 0 0.25 -1  0 1 0 -1  0 0 1 0  0 0 0 1"/>)"));
  CHECK(says(out, R"(<matrix value="0.25 0 0 -1.75  0 0.5 0 0.5  0 0 0.5 -0.5  0 0 0 1"/>)"));
  const scene::Scene again = from_mitsuba(out).scene;
  std::vector<scene::Instance> copies;
  std::size_t boxes = 0;
  again.for_each([&](scene::ElementRef e, const auto&) {
    const scene::Body* const body = again.body(e);
    if (body == nullptr) return;
    if (const auto* const instance = std::get_if<scene::Instance>(&body->form))
      copies.push_back(*instance);
    else
      boxes += std::get<scene::Compound>(body->form).parts.size() == 6;
  });
  REQUIRE(copies.size() == 2);
  CHECK(boxes == 2);
  const auto& original = std::get<scene::Instance>(of.scene.body(*of.scene.find("i"))->form);
  CHECK(copies[0].mapa == original.mapa);
  CHECK(std::get<scene::Sphere>(copies[0].shape).centro == glm::dvec3(1, 2, 3));
}

TEST_CASE("A look is a bsdf of two sides, a mirror or glass, by the greatest share") {
  const auto material = [](const std::string& fields) {
    return to_mitsuba(R"("materials":{"m":{)" + fields + R"(}},"elementos":[)" + sphere.substr(0, sphere.size() - 1) +
                      R"(,"material":"m"}])");
  };
  for (const char* same : {R"("color":[0.5,0.25,1])", R"("color":[0,0,0],"k_d":0,"k_ps":1,"M_PS":[0.5,0.25,1])",
                           R"("color":[0,0,0],"k_d":0,"k_t":1,"M_T":[0.5,0.25,1],"index":1.5)",
                           R"("color":[0.5,0.25,1],"emission":[2,3,4])"}) {
    CAPTURE(same);
    const io::Exported out = material(same);
    CHECK(out.lost == Lines{no_view});
    const auto meant = test::scene_of(R"("materials":{"m":{)" + std::string(same) + R"(}},"elementos":[])");
    CHECK(test::look_text(from_mitsuba(out).scene.stage().materials.at(0)) ==
          test::look_text(meant.scene.stage().materials[0]));
  }
  for (const char* otherwise :
       {R"("color":[1,1,1],"k_d":0.5)", R"("color":[1,1,1],"k_s":0.5)", R"("color":[1,1,1],"k_d":0.25,"k_ps":0.5)",
        R"("color":[1,1,1],"k_d":0.25,"k_t":0.5)"}) {
    CAPTURE(otherwise);
    CHECK(material(otherwise).lost ==
          Lines{"1 material written otherwise: of one colour, a mirror or glass, by the greatest share", no_view});
  }
  CHECK(says(material(R"("color":[1,1,1],"k_d":0.25,"k_ps":0.5)"),
             R"(name="specular_reflectance" value="0.5, 0.5, 0.5")"));
  CHECK(to_mitsuba(R"("materials":{"m":{"color":[1,1,1],"emission":[1,1,1]}},"elementos":[{"id":"i","tipo":"instancia",
    "de":{"tipo":"esfera","centro":[0,0,0],"radio":1},"mapa":[[2,0,0,0],[0,1,0,0],[0,0,1,0]],"material":"m"}])")
            .lost == Lines{"1 copy written without its light: Mitsuba has no copies that shine", no_view});
}

TEST_CASE("Names of things are one set in Mitsuba: a second one is changed") {
  const io::Exported out =
      to_mitsuba(R"("materials":{"s":{"color":[1,1,1]},"a b":{"color":[0,1,1]}},"elementos":[)" + sphere + "]");
  CHECK(says(out, "id=\"s\"><bsdf"));
  CHECK(says(out, "<shape id=\"s_\" "));
  CHECK(says(out, "id=\"material1\"><bsdf"));
  CHECK_NOTHROW(from_mitsuba(out));
  const scene::GroupedScene triangle =
      test::scene_of(R"("elementos":[{"id":"v","tipo":"triangulo","vertices":[[0,0,0],[1,0,0],[0,1,0]]}])");
  const io::Exported two = to_mitsuba(R"("materials":{"m":{"color":[1,1,1]}},"elementos":[
    {"id":"v","tipo":"triangulo","vertices":[[0,0,0],[1,0,0],[0,1,0]]},
    {"id":"w","tipo":"triangulo","vertices":[[0,0,0],[1,0,0],[0,0,1]],"material":"m"}])");
  CHECK(two.beside.size() == 2);
  CHECK(io::mitsuba_text(triangle.scene, {}, "a$b&\"c").beside.at(0).name == "a_b__c.mesh1.ply");
}

TEST_CASE("The rays of a camera come back, also mirrored, and so do lens, lights and background") {
  for (const std::string hand : {"false", "true"}) {
    const scene::GroupedScene of =
        test::scene_of(R"("camera":{"eye":[3,2,6],"look_at":[0,0.25,0],"up":[0,1,0],"fov_y":40,
      "aperture":0.25,"focus":3,"mirrored":)" +
                       hand + R"(},"resolution":[80,45],"background":[0.1,0.2,0.3],
      "lights":[{"position":[1,2,3],"color":[1,2,1]},{"position":[1,2,3],"color":[1,1,1],
        "spot":{"towards":[1,0,3],"inner":20,"outer":50,"tightness":2}}],
      "directional_lights":[{"direction":[0,-3,4],"color":[0.1,0.2,3]}],"elementos":[])");
    const io::Exported out = to_mitsuba(of);
    CHECK(out.lost == Lines{"2 lights fading with the distance, as those of Mitsuba do",
                            "1 tightness of a light left out: not written to Mitsuba"});
    const scene::Stage &stage = of.scene.stage(), again = from_mitsuba(out).scene.stage();
    REQUIRE(again.camera);
    CHECK((again.resolution == stage.resolution && again.background == stage.background));
    CHECK((again.camera->aperture == 0.25 && again.camera->focus == 3));
    const scene::PrimaryRays before(*stage.camera, *stage.resolution), after(*again.camera, *again.resolution);
    for (const auto& [x, y] : {std::pair{0U, 0U}, {79U, 0U}, {40U, 44U}})
      CHECK(glm::length(before.ray(x, y).v().xyz() - after.ray(x, y).v().xyz()) < 1e-14);
    CHECK(again.directional_lights == stage.directional_lights);
    REQUIRE(again.lights.size() == 2);
    CHECK(again.lights[0] == stage.lights[0]);
    CHECK((again.lights[1].cone->inner == 20 && again.lights[1].cone->outer == 50));
    CHECK(again.lights[1].cone->towards == glm::dvec3(1, 1, 3));
  }
}
