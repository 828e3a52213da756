// Scenes as texts of Radiance: what each thing becomes, what comes back the same, and what is counted.
#include <glm/common.hpp>

#include "durero/io/radiance/radiance.hpp"
#include "durero/scene/body.hpp"
#include "io/written.hpp"
#include "support/catch.hpp"
#include "support/property.hpp"

using namespace durero;
using Lines = std::vector<std::string>;

namespace {

io::Exported written(const std::string& body) {
  const scene::GroupedScene of = test::scene_of(body);
  return io::radiance_text(of.scene, of.groups);
}
io::Imported read_back(const std::string& text) { return io::read_radiance(io::Source("f", text)); }
bool has(const io::Exported& out, const std::string& text) { return out.text.find(text) != std::string::npos; }

const std::string no_view = "no camera in the scene: no view was written";
const std::string ball = R"({"id":"s","tipo":"esfera","centro":[1,2,3],"radio":0.5})";
const std::string every_shape = R"("elementos":[{"id":"s","tipo":"esfera","centro":[1,2,3],"radio":0.5},
  {"id":"c","tipo":"cilindro","centro":[0,0,0],"radio":2,"vector":[0,0,1],"altura":3},
  {"id":"k","tipo":"cono","centro":[1,0,0],"proporcion":0.5,"vector":[0,1,0],"altura":4},
  {"id":"t","tipo":"tronco","centro":[0,0,0],"radio":1,"proporcion":0.25,"vector":[1,0,0],"altura":4},
  {"id":"d","tipo":"disco","centro":[0,0,9],"radio":3,"vector":[0,0,-1]},
  {"id":"v","tipo":"triangulo","vertices":[[0,0,0],[1,0,0],[0,1,0]]}])";

/// The material of the only element, written and read back.
scene::Material look_again(const std::string& fields, Lines& lost) {
  const io::Exported out = written(R"("materials":{"m":{)" + fields + R"(}},"elementos":[)" +
                                   ball.substr(0, ball.size() - 1) + R"(,"material":"m"}])");
  lost = out.lost;
  lost.erase(std::find(lost.begin(), lost.end(), no_view));
  return read_back(out.text).scene.stage().materials.at(0);
}

}  // namespace

TEST_CASE("Every shape but planes is a surface of Radiance, and comes back the same") {
  const io::Exported out = written(every_shape);
  for (const char* line : {"plain sphere s 0 0 4 1 2 3 0.5\n", "plain cylinder c 0 0 7 0 0 0 0 0 3 2\n",
                           "plain cone k 0 0 8 1 0 0 1 4 0 2 0\n", "plain cone t 0 0 8 0 0 0 4 0 0 2 1\n",
                           "plain ring d 0 0 8 0 0 9 0 0 -1 0 3\n", "plain polygon v 0 0 9 0 0 0 1 0 0 0 1 0\n",
                           "void plastic plain 0 0 5 0.8 0.8 0.8 0 0\n"}) {
    CAPTURE(line);
    CHECK(has(out, line));
  }
  CHECK(out.lost == Lines{no_view});
  scene::Scene of = test::scene_of(every_shape).scene;
  of.stage().materials = {{"m", glm::dvec3(0.8)}};
  of.for_each([&](scene::ElementRef e, const auto&) { of.set_material(e, 0); });
  CHECK(test::shapes_and_looks(read_back(out.text).scene) == test::shapes_and_looks(of));
  CHECK(written(R"("elementos":[{"id":"p","tipo":"plano","centro":[0,-1,0],"vector":[0,1,0]}])").lost ==
        Lines{"1 plane left out: not written to Radiance", no_view});
}

TEST_CASE("What is not counted as rounded or left out comes back bit for bit") {
  std::size_t same = 0;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    test::Random random(seed);
    const scene::Scene of = test::scene_to_write(random, 2);
    const io::Exported out = io::radiance_text(of, {});
    INFO("seed " << seed << "\n" << out.text);
    const io::Imported again = read_back(out.text);
    scene::Scene bare = again.scene;
    bare.for_each([&](scene::ElementRef e, const auto&) { bare.set_material(e, std::nullopt); });
    const bool is_same = test::shapes_and_looks(bare) == test::shapes_and_looks(of);
    CHECK(is_same == (out.lost == Lines{no_view}));
    same += is_same;
    if (!test::has_line(out.lost, "left out")) CHECK(again.scene.size() == of.size());
  }
  CHECK((same > 50 && same < 350));
}

TEST_CASE("Any scene is written as a text that is read") {
  test::property("any scene", [] {
    const scene::Scene of = test::any_scene();
    const io::Exported out = io::radiance_text(of, {});
    CHECK_NOTHROW(read_back(out.text));
  });
}

TEST_CASE("A material is the one of Radiance that is read to the same, or is counted") {
  Lines lost;
  for (const char* same : {R"("color":[0.5,0.25,1])", R"("color":[0.5,0.25,1],"k_d":0.75,"k_ps":0.25)",
                           R"("color":[0.5,0.25,1],"k_d":0.75,"k_ps":0.25,"M_PS":[0.5,0.25,1])",
                           R"("color":[0.5,0.25,1],"k_d":0.75,"k_s":0.25,"e":8)",
                           R"("color":[0,0,0],"k_d":0,"k_ps":1,"M_PS":[0.5,0.25,1])",
                           R"("color":[0,0,0],"k_d":0,"k_t":1,"M_T":[0.5,0.25,1],"index":1.5)",
                           R"("color":[0,0,0],"k_d":0,"k_t":1,"M_T":[0.5,0.25,1])",
                           R"("color":[0.5,0.25,1],"k_d":0.25,"k_t":0.75,"M_T":[0.5,0.25,1])",
                           R"("color":[0.5,0.25,1],"k_d":0.375,"k_t":0.375,"k_ps":0.25,"M_T":[0.5,0.25,1])",
                           R"("color":[0,0,0],"k_d":0,"emission":[2,3,4])"}) {
    CAPTURE(same);
    const scene::Material again = look_again(same, lost);
    const auto meant = test::scene_of(R"("materials":{"m":{)" + std::string(same) + R"(}},"elementos":[])");
    CHECK(test::look_text(again) == test::look_text(meant.scene.stage().materials[0]));
    CHECK(lost.empty());
  }
  const Lines other{"1 material written otherwise: Radiance has none of just these shares of light"};
  for (const char* otherwise :
       {R"("color":[0.5,0.25,1],"k_a":0.5)", R"("color":[0.5,0.25,1],"k_d":0.5)",
        R"("color":[0.5,0.25,1],"ambient":[1,0,0])", R"("color":[0.5,0.25,1],"emission":[1,0,0])",
        R"("color":[1,1,1],"k_d":0.75,"k_ps":0.25,"M_PS":[0.5,0.25,1])",
        R"("color":[1,1,1],"k_d":0.5,"k_ps":0.25,"k_s":0.25,"e":8)",
        R"("color":[1,1,1],"k_d":0.75,"k_s":0.25,"e":1e7)"}) {
    CAPTURE(otherwise);
    look_again(otherwise, lost);
    CHECK(lost == other);
  }
  CHECK(look_again(R"("color":[0.5,0.25,1],"k_d":0.5)", lost).color == glm::dvec3(0.25, 0.125, 0.5));
  CHECK(look_again(R"("color":[1,1,1],"k_d":0.75,"k_s":0.25,"e":21)", lost).e == Approx(21).epsilon(1e-14));
  CHECK(lost == Lines{"1 highlight rounded: Radiance holds a roughness"});
}

TEST_CASE("A group is an identifier, and names that would be taken for another are changed") {
  const io::Exported out = written(R"("elementos":[)" + ball + R"(,
    {"id":"a","tipo":"esfera","centro":[0,0,0],"radio":1},{"id":"g","tipo":"esfera","centro":[0,0,5],"radio":1}],
    "mallas":[{"id":"m","puntos":[[0,0,0],[1,0,0],[0,1,0],[0,0,1]],"caras":[[0,1,2],[0,1,3]]}],
    "groups":{"g":{"elementos":["a"]},"h":{"groups":["g"]}})");
  CHECK(has(out, " sphere g 0 0 4 0 0 0 1\n"));
  CHECK(has(out, " sphere g_ 0 0 4 0 0 5 1\n"));
  CHECK(has(out, " polygon m 0 0 9 0 0 0 1 0 0 0 0 1\n"));
  CHECK(out.lost == Lines{"1 name of an element left out: its group is its identifier",
                          "1 place of a group in another left out: an identifier of Radiance is in none", no_view});
  const scene::Groups groups = read_back(out.text).groups;
  CHECK(groups.table().at("g").elementos == scene::Names{"s3"});
  CHECK(groups.table().at("m").elementos == scene::Names{"p1", "p2"});
  CHECK(has(
      written(
          R"("materials":{"a b":{"color":[1,1,1]},"m1":{"color":[1,0,1]},"void":{"color":[0,0,1]}},"elementos":[])"),
      "void plastic m1 0 0 5 1 1 1 0 0\nvoid plastic m1_ 0 0 5 1 0 1 0 0\nvoid plastic m3 0 0 5 0 0 1 0 0\n"));
}

TEST_CASE("A directional light is a sun, a background a source all around, a camera a comment, and other lights none") {
  const io::Exported out = written(R"("camera":{"eye":[0,0,-5],"look_at":[0,0,0],"up":[0,1,0],"fov_y":90},
    "resolution":[40,20],"background":[0.1,0.2,0.3],"directional_lights":[{"direction":[0,-3,4],"color":[0.1,0.2,3]}],
    "lights":[{"position":[1,2,3],"color":[1,1,1]}],"elementos":[])");
  CHECK(out.text.starts_with("# rpict -vtv -vp 0 0 -5 -vd 0 0 5 -vu 0 1 0 -vh 126.8698976458"));
  CHECK(has(out, " -vv 90 -x 40 -y 20\n"));
  CAPTURE(out.text);
  CHECK(has(out, "sun1 source sun1 0 0 4 -0 3 -4 0.4476235620376596\n"));
  CHECK(out.lost == Lines{"1 light left out: Radiance has none without a size"});
  const scene::Stage stage = read_back(out.text).scene.stage();
  CHECK(stage.background == glm::dvec3(0.1, 0.2, 0.3));
  CHECK((stage.directional_lights.size() == 1 && stage.directional_lights[0].direction == glm::dvec3(0, -3, 4)));
  CHECK(stage.directional_lights[0].color == glm::dvec3(0.1, 0.2, 3));
  const io::Exported seen = written(
      R"("camera":{"eye":[0,0,-5],"look_at":[0,0,0],"up":[0,1,0],"fov_y":90,"aperture":0.5,"focus":2,"mirrored":true},
      "elementos":[])");
  CHECK(has(seen, "-vd 0 0 2 -vu 0 1 0 "));
  CHECK(has(seen, " -pd 0.5 -x 640 -y 360\n"));
  CHECK(seen.lost == Lines{"1 mirrored camera written unmirrored: Radiance has none"});
  CHECK(written(R"("directional_lights":[{"direction":[0,0,1],"color":[1e308,0,0]}],
    "elementos":[])")
            .lost == Lines{"1 directional light left out: its radiance is beyond binary64", no_view});
}

TEST_CASE("A box is six polygons, and what else Radiance has no place for is left out") {
  const io::Exported out = written(R"("elementos":[{"id":"b","tipo":"caja","esquinas":[[4,2,8],[1,6,3]]},
    {"id":"i","tipo":"instancia","de":{"tipo":"esfera","centro":[0,0,0],"radio":1},"mapa":[[2,0,0,0],[0,1,0,0],[0,0,1,0]]}])");
  CHECK(out.lost == Lines{"1 instance left out: not written to Radiance", "1 box written as six polygons", no_view});
  const io::Imported again = read_back(out.text);
  CHECK(again.scene.shapes<scene::Triangle>().size() == 12);
  glm::dvec3 low(9), high(-9);
  for (const scene::Triangle triangle : again.scene.shapes<scene::Triangle>())
    for (const glm::dvec3& v : triangle.vertices) low = glm::min(low, v), high = glm::max(high, v);
  CHECK((low == glm::dvec3(1, 2, 3) && high == glm::dvec3(4, 6, 8)));
  const auto planes = [](const std::string& first) {
    return written(R"("elementos":[{"id":"b","tipo":"interseccion","de":[{"tipo":"plano","centro":[0,0,0],"vector":)" +
                   first +
                   R"(},{"tipo":"plano","centro":[1,1,1],"vector":[1,0,0]},
      {"tipo":"plano","centro":[0,0,0],"vector":[0,-1,0]},{"tipo":"plano","centro":[1,1,1],"vector":[0,1,0]},
      {"tipo":"plano","centro":[0,0,0],"vector":[0,0,-1]},{"tipo":"plano","centro":[1,1,1],"vector":[0,0,1]}]}])")
        .lost;
  };
  CHECK(planes("[-1,0,0]") == Lines{"1 box written as six polygons", no_view});
  CHECK(planes("[-0.6,0.8,0]") == Lines{"1 solid left out: not written to Radiance", no_view});
}
