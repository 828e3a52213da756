// Scenes as texts of pbrt: what each thing becomes, what comes back the same, and what is counted.
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "durero/io/pbrt/pbrt.hpp"
#include "durero/scene/body.hpp"
#include "durero/scene/camera.hpp"
#include "io/written.hpp"
#include "support/catch.hpp"
#include "support/property.hpp"

using namespace durero;
using Lines = std::vector<std::string>;

namespace {

io::Exported to_pbrt(const std::string& body) {
  const scene::GroupedScene of = test::scene_of(body);
  return io::pbrt_text(of.scene, of.groups);
}
io::Imported from_pbrt(const io::Exported& out) { return io::read_pbrt(io::Source("f", out.text)); }
bool tells(const io::Exported& out, const std::string& text) { return out.text.find(text) != std::string::npos; }

const std::string view_missing = "no camera in the scene: no view was written";

/// The elements but for cylinders, whose length the reader finds by their ends.
std::vector<std::string> exact_ones(const scene::Scene& scene) {
  std::vector<std::string> all = test::shapes_and_looks(scene);
  std::erase_if(all, [](const std::string& text) { return text.starts_with(scene::Cylinder::word); });
  return all;
}

}  // namespace

TEST_CASE("Shapes of pbrt come back the same, each named in a comment") {
  const scene::GroupedScene of = test::scene_of(R"("materials":{"m":{"color":[0.5,0.25,1]}},"elementos":[
    {"id":"s","tipo":"esfera","centro":[1,2,3],"radio":0.5,"material":"m"},
    {"id":"c","tipo":"cilindro","centro":[4,5,6],"radio":2,"vector":[0,1,0],"altura":3,"material":"m"},
    {"id":"d","tipo":"disco","centro":[0,0,9],"radio":3,"vector":[0,0,-1],"material":"m"},
    {"id":"v","tipo":"triangulo","vertices":[[0,0,0],[1,0,0],[0,1,0.1]],"material":"m"},
    {"id":"w","tipo":"triangulo","vertices":[[0,0,0],[1,0,0],[0,1,0.2]],"material":"m",
     "normals":[[0,0,1],[0,0,1],[0,1,1]]}])");
  const io::Exported out = io::pbrt_text(of.scene, of.groups);
  CHECK(out.lost == Lines{view_missing});
  CHECK(tells(out,
              "AttributeBegin  # s\nNamedMaterial \"m\"\nTranslate 1 2 3\nShape \"sphere\" \"float radius\" "
              "0.5\nAttributeEnd\n"));
  CHECK(tells(
      out,
      "Translate 4 5 6\nRotate 90 -1 0 0\nShape \"cylinder\" \"float radius\" 2 \"float zmin\" 0 \"float zmax\" 3\n"));
  CHECK(tells(out, "Translate 0 0 9\nRotate 180 1 0 0\nShape \"disk\" \"float radius\" 3\n"));
  const io::Imported again = from_pbrt(out);
  CHECK(test::shapes_and_looks(again.scene) == test::shapes_and_looks(of.scene));
  std::size_t smooth = 0;
  again.scene.for_each([&](scene::ElementRef e, const auto&) {
    const auto normals = again.scene.vertex_normals(e);
    smooth += normals && (*normals)[2] == glm::dvec3(0, 1, 1);
  });
  CHECK(smooth == 1);
  CHECK(to_pbrt(R"("elementos":[{"id":"k","tipo":"cono","centro":[1,0,0],"proporcion":0.5,"vector":[0,1,0],"altura":4},
    {"id":"p","tipo":"plano","centro":[0,-1,0],"vector":[0,1,0]}])")
            .lost ==
        Lines{"1 cone left out: not written to pbrt", "1 plane left out: not written to pbrt", view_missing});
}

TEST_CASE("What is not counted as rounded or left out comes back from pbrt bit for bit, but for lengths of cylinders") {
  std::size_t same = 0;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    test::Random random(seed);
    const scene::Scene of = test::scene_to_write(random, 2);
    const io::Exported out = io::pbrt_text(of, {});
    INFO("seed " << seed << "\n" << out.text);
    scene::Scene bare = from_pbrt(out).scene;
    bare.for_each([&](scene::ElementRef e, const auto&) { bare.set_material(e, std::nullopt); });
    if (!test::has_line(out.lost, "left out")) CHECK(bare.size() == of.size());
    if (out.lost != Lines{view_missing}) continue;
    CHECK(exact_ones(bare) == exact_ones(of));
    for (const scene::Cylinder& c : bare.singles<scene::Cylinder>())
      CHECK(std::ranges::any_of(of.singles<scene::Cylinder>(), [&](const scene::Cylinder& d) {
        return c.centro == d.centro && c.vector == d.vector && c.radio == d.radio &&
               c.altura == Approx(d.altura).epsilon(1e-14);
      }));
    ++same;
  }
  CHECK((same > 50 && same < 350));
}

TEST_CASE("Any scene is written as a text that pbrt's reader reads") {
  test::property("any scene", [] {
    const scene::Scene of = test::any_scene();
    try {
      from_pbrt(io::pbrt_text(of, {}));
    } catch (const io::InputError& error) {  // a direction between points beyond binary64 is none
      CHECK(std::string(error.what()).find("LookAt gives no direction") != std::string::npos);
    }
  });
}

TEST_CASE("A copy is a shape under its map, and a box a mesh") {
  const scene::GroupedScene of = test::scene_of(R"("elementos":[{"id":"s","tipo":"esfera","centro":[1,2,3],"radio":0.5},
    {"id":"i","tipo":"instancia","de":"s","mapa":[[2,0,0.25,-1],[0,1,0,-1],[0,0,1,0]]},
    {"id":"b","tipo":"caja","esquinas":[[-2,0,-1],[-1.5,1,0]]},
    {"id":"r","tipo":"instancia","de":"s","mapa":[["1/3",0,0,0],[0,1,0,0],[0,0,1,0]]},
    {"id":"u","tipo":"union","de":["b",{"tipo":"esfera","centro":[0,0,0],"radio":2}]}])");
  const io::Exported out = io::pbrt_text(of.scene, of.groups);
  CHECK(out.lost == Lines{"1 solid left out: not written to pbrt", "1 box written as twelve triangles",
                          "1 map rounded: an entry is no binary64", view_missing});
  CHECK(tells(out, "ConcatTransform [2 0 0 0 0 1 0 0 0.25 0 1 0 -1 -1 0 1]\nTranslate 1 2 3\n"));
  const scene::Scene again = from_pbrt(out).scene;
  CHECK(again.singles<scene::Triangle>().size() == 12);
  glm::dvec3 low(9), high(-9), sum(0);
  double volume = 0;
  for (const scene::Triangle& triangle : again.singles<scene::Triangle>()) {
    const auto& [a, b, c] = triangle.vertices;
    for (const glm::dvec3& v : {a, b, c}) low = glm::min(low, v), high = glm::max(high, v);
    sum += glm::abs(glm::cross(b - a, c - a)) / 2.0;
    volume += glm::dot(a, glm::cross(b, c)) / 6;
  }
  CHECK((low == glm::dvec3(-2, 0, -1) && high == glm::dvec3(-1.5, 1, 0)));
  CHECK(sum == glm::dvec3(2, 1, 1));  // each face twice, as seen along an axis
  CHECK(volume == Approx(0.5));       // of faces that are seen from outside
  std::size_t copies = 0;
  again.for_each([&](scene::ElementRef e, const auto&) {
    if (const scene::Body* const body = again.body(e)) {
      const auto& instance = std::get<scene::Instance>(body->form);
      const auto centre = model::puesto(instance.mapa, model::ExactPoint(model::Punto(0, 0, 0)));
      copies += centre == model::ExactPoint(model::Punto(1.75, 1, 3));  // 2·1 + 3/4 − 1
    }
  });
  CHECK(copies == 1);
}

TEST_CASE("A look of pbrt is one of a colour, a mirror or clear glass; what shines does so on both sides") {
  const auto material = [](const std::string& fields) {
    return to_pbrt(R"("materials":{"m":{)" + fields +
                   R"(}},"elementos":[{"id":"s","tipo":"esfera","centro":[1,2,3],"radio":0.5,"material":"m"}])");
  };
  for (const char* same :
       {R"("color":[0.5,0.25,1])", R"("color":[0,0,0],"k_d":0,"k_ps":1,"M_PS":[0.5,0.25,1])",
        R"("color":[0,0,0],"k_d":0,"k_t":1,"index":1.25)", R"("color":[0.5,0.25,1],"emission":[2,3,4])"}) {
    CAPTURE(same);
    const io::Exported out = material(same);
    CHECK(out.lost == Lines{view_missing});
    const auto meant = test::scene_of(R"("materials":{"m":{)" + std::string(same) + R"(}},"elementos":[])");
    const io::Imported again = from_pbrt(out);
    CHECK(test::look_text(again.scene.stage().materials.at(0)) == test::look_text(meant.scene.stage().materials[0]));
    CHECK_FALSE(test::has_line(again.lost, "with a light"));
  }
  CHECK(material(R"("color":[0,0,0],"k_d":0,"k_t":1,"M_T":[0.5,0.25,1],"index":1.25)").lost ==
        Lines{"1 material written otherwise: of one colour, a mirror or clear glass, by the greatest share",
              view_missing});
  CHECK(tells(to_pbrt(R"("materials":{"a\"b":{"color":[1,1,1]},"material1":{"color":[0,1,1]}},"elementos":[])"),
              "MakeNamedMaterial \"material1\" \"string type\" \"diffuse\" \"rgb reflectance\" [1 1 1]\n"
              "MakeNamedMaterial \"material1_\" "));
}

TEST_CASE("pbrt's camera has the same rays, of either hand and form, and lens, lights and background come back") {
  for (const std::string hand : {"false", "true"})
    for (const std::string size : {"[80,45]", "[45,80]"}) {
      const scene::GroupedScene of =
          test::scene_of(R"("camera":{"eye":[3,2,6],"look_at":[0,0.25,0],"up":[0,1,0],"fov_y":40,
        "aperture":0.25,"focus":3,"mirrored":)" +
                         hand + R"(},"resolution":)" + size + R"(,"background":[0.1,0.2,0.3],
        "lights":[{"position":[1,2,3],"color":[1,2,1]},{"position":[1,2,3],"color":[1,1,1],
          "spot":{"towards":[1,0,7],"inner":20,"outer":50,"tightness":2}}],
        "directional_lights":[{"direction":[0,-3,4],"color":[0.1,0.2,3]}],"elementos":[])");
      const io::Exported out = io::pbrt_text(of.scene, of.groups);
      CHECK(out.lost == Lines{"2 lights fading with the distance, as those of pbrt do",
                              "1 tightness of a light left out: not written to pbrt"});
      const scene::Stage &stage = of.scene.stage(), again = from_pbrt(out).scene.stage();
      REQUIRE(again.camera);
      CHECK((again.resolution == stage.resolution && again.background == stage.background));
      CHECK((again.camera->aperture == 0.25 && again.camera->focus == 3));
      const scene::PrimaryRays before(*stage.camera, *stage.resolution), after(*again.camera, *again.resolution);
      for (const auto& [x, y] : {std::pair{0U, 0U}, {44U, 0U}, {40U, 44U}})
        CHECK(glm::length(before.ray(x, y).v().xyz() - after.ray(x, y).v().xyz()) < 1e-14);
      CHECK(again.directional_lights == stage.directional_lights);
      REQUIRE(again.lights.size() == 2);
      CHECK(again.lights[0] == stage.lights[0]);
      scene::Light spot = stage.lights[1];
      spot.cone->tightness = 0;
      CHECK(again.lights[1] == spot);
    }
  CHECK(test::has_line(
      to_pbrt(R"("lights":[{"position":[1,2,3],"color":[1,1,1],"spot":{"towards":[1,0,7],"inner":1e-20,"outer":50}}],
    "elementos":[])")
          .lost,
      "1 cone of a light rounded"));
}
