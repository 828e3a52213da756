// Scenes as glTF: triangles, groups, materials, camera and lights, and what is counted.
#include <fmt/core.h>

#include <glm/geometric.hpp>
#include <map>

#include "durero/io/mesh/gltf.hpp"
#include "durero/scene/stage.hpp"
#include "io/mesh/buffer_uri.hpp"
#include "io/written.hpp"
#include "support/catch.hpp"

using namespace durero;
using Lines = std::vector<std::string>;

namespace {

io::Exported to_gltf(const std::string& body) {
  const scene::GroupedScene of = test::scene_of(body);
  return io::gltf_text(of.scene, of.groups);
}
io::Imported from_gltf(const std::string& text) { return io::read_gltf(io::Source("f", text)); }
bool holds(const io::Exported& out, const std::string& text) { return out.text.find(text) != std::string::npos; }

const std::string unseen = "no camera in the scene: no view was written";
const std::string named = "2 names of elements left out: glTF has none of triangles";

/// Triangles of binary32, alone and in a mesh; the mesh is smooth and has uv.
const std::string triangles = R"("materials":{"m":{"color":[0.5,0.25,1]}},"elementos":[
  {"id":"v","tipo":"triangulo","vertices":[[0,0,0],[1,0,0],[0,1,0.125]],"material":"m"},
  {"id":"w","tipo":"triangulo","vertices":[[0,0,0],[1,0,0],[0,1.5,0]]}],
  "mallas":[{"id":"sheet","puntos":[[0,0,5],[1,0,5],[1,1,5],[0,1,5]],"caras":[[0,1,2],[0,2,3]],
    "normals":[[0,0,2],[0,0,1],[0,1,0],[3,0,0]],"uv":[[0,0],[1,0],[1,0.25],[0,0.5]]}],
  "groups":{"in":{"elementos":["w"]},"out":{"groups":["in"]}})";

/// Of a scene, each triangle with its group, its normals made of length 1, and its uv.
std::vector<std::string> all_of(const scene::Scene& scene, const scene::Groups& groups, bool names_meshes) {
  std::vector<std::string> all;
  scene.for_each([&](scene::ElementRef e, const auto&) {
    if (e.tipo != scene::Triangle::tipo) return;
    std::string text(groups.of_element(scene.name(e).name()));
    if (const auto face = scene.face(e); face && text.empty() && names_meshes) text = face->mesh.m.name();
    const auto add = [&](const glm::dvec3& x) { text += fmt::format(" ({} {} {})", x.x + 0.0, x.y + 0.0, x.z + 0.0); };
    for (const glm::dvec3& v : scene.shapes<scene::Triangle>()[e.index].vertices) add(v);
    if (const auto normals = scene.vertex_normals(e))
      for (const glm::dvec3& n : *normals) add(glm::normalize(n));
    if (const auto wrap = scene.wrap(e))
      for (const glm::dvec2& uv : wrap->uv) add({uv, 9});
    all.push_back(text);
  });
  std::ranges::sort(all);
  return all;
}

}  // namespace

TEST_CASE("Triangles of binary32 come back from glTF the same, with normals, uv and groups, as text and as bytes") {
  const scene::GroupedScene of = test::scene_of(triangles);
  const io::Exported text = io::gltf_text(of.scene, of.groups), bytes = io::gltf_bytes(of.scene, of.groups);
  CHECK(text.lost == Lines{named, unseen});
  CHECK(bytes.lost == text.lost);
  CHECK(bytes.text.starts_with("glTF"));
  for (const std::string& written : {text.text, bytes.text}) {
    const io::Imported again = from_gltf(written);
    CHECK(all_of(again.scene, again.groups, false) == all_of(of.scene, of.groups, true));
    CHECK(again.groups.of_group("in") == "out");
  }
  CHECK(holds(text, R"("min":[0,0,0],"max":[1,1,0.125])"));
  CHECK(holds(
      text,
      R"({"name":"m","pbrMetallicRoughness":{"baseColorFactor":[0.5,0.25,1,1],"metallicFactor":0,"roughnessFactor":1},"doubleSided":true})"));
}

TEST_CASE(
    "Any triangles are written to glTF: numbers that binary32 has not are rounded, or left out with the triangle") {
  std::size_t rounded = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    test::Random random(seed);
    const scene::Scene of = test::scene_to_write(random, 20);
    if (of.shapes<scene::Triangle>().empty()) continue;
    const io::Exported out = io::gltf_text(of, {});
    INFO("seed " << seed << "\n" << out.text);
    const io::Imported again = from_gltf(out.text);
    REQUIRE(again.scene.shapes<scene::Triangle>().size() == of.shapes<scene::Triangle>().size());
    scene::Scene nearest;
    for (const scene::Triangle& triangle : of.singles<scene::Triangle>()) {
      scene::Triangle floats = triangle;
      for (glm::dvec3& v : floats.vertices) v = glm::dvec3(glm::vec3(v));
      nearest.add(model::Elemento("t" + std::to_string(nearest.size())), floats);
    }
    CHECK(all_of(again.scene, {}, false) == all_of(nearest, {}, false));
    const bool is_same = all_of(of, {}, false) == all_of(nearest, {}, false);
    CHECK(is_same != test::has_line(out.lost, "rounded: glTF has binary32"));
    rounded += !is_same;
  }
  CHECK(rounded > 30);
  const io::Exported far = to_gltf(R"("elementos":[
    {"id":"v","tipo":"triangulo","vertices":[[0,0,0],[1,0,0],[0,1e39,0]]},
    {"id":"w","tipo":"triangulo","vertices":[[0,0,0],[1,0,0],[0,1,0]]},{"id":"s","tipo":"esfera","centro":[1,2,3],"radio":0.5},
    {"id":"i","tipo":"instancia","de":"s","mapa":[[2,0,0,0],[0,1,0,0],[0,0,1,0]]},{"id":"b","tipo":"caja","esquinas":[[0,0,0],[1,1,1]]}])");
  CHECK(far.lost == Lines{"1 sphere left out: not written to glTF", "1 instance left out: not written to glTF",
                          "1 solid left out: not written to glTF",
                          "1 triangle left out: a coordinate is beyond binary32", named, unseen});
  CHECK(from_gltf(far.text).scene.size() == 1);
  CHECK(test::has_line(to_gltf(R"("elementos":[{"id":"v","tipo":"triangulo","vertices":[[0,0,0],[1,0,0],[0,1,0]],
    "uv":[[0,0],[1,0.1],[0,1]]}])")
                           .lost,
                       "1 coordinate of uv rounded"));
}

TEST_CASE("The chunks of a GLB file are of whole words") {
  for (const std::string name : {"a", "ab", "abc", "abcd"}) {
    const scene::GroupedScene of =
        test::scene_of(R"("materials":{")" + name + R"(":{"color":[1,1,1]}},"elementos":[])");
    CHECK(io::gltf_bytes(of.scene, of.groups).text.size() % 4 == 0);
  }
}

TEST_CASE("A mirror, glass and what shines are materials of glTF's extensions") {
  const auto of = [](const std::string& fields) {
    return to_gltf(R"("materials":{"m":{)" + fields + R"(}},"elementos":[])");
  };
  CHECK(holds(of(R"("color":[0,0,0],"k_d":0,"k_ps":1,"M_PS":[0.5,0.25,1])"),
              R"("baseColorFactor":[0.5,0.25,1,1],"metallicFactor":1,"roughnessFactor":0})"));
  const io::Exported glass = of(R"("color":[0,0,0],"k_d":0,"k_t":1,"index":1.5)");
  CHECK(holds(glass, R"("KHR_materials_transmission":{"transmissionFactor":1},"KHR_materials_ior":{"ior":1.5})"));
  CHECK(holds(glass, R"("extensionsUsed":["KHR_materials_transmission","KHR_materials_ior"])"));
  CHECK(glass.lost == Lines{unseen});
  const Lines otherwise{"1 material written otherwise: of one colour, a mirror or glass, by the greatest share",
                        unseen};
  CHECK(of(R"("color":[0,0,0],"k_d":0,"k_t":1,"index":0.5)").lost == otherwise);
  CHECK(of(R"("color":[1,1,1],"k_s":0.5)").lost == otherwise);
  CHECK(holds(of(R"("color":[1,1,1],"emission":[0.5,0.25,1])"), R"("emissiveFactor":[0.5,0.25,1],"doubleSided")"));
  CHECK(holds(
      of(R"("color":[1,1,1],"emission":[4,2,1])"),
      R"("emissiveFactor":[1,0.5,0.25],"doubleSided":true,"extensions":{"KHR_materials_emissive_strength":{"emissiveStrength":4}})"));
}

TEST_CASE("Camera and lights look along their own -z in glTF") {
  const io::Exported out =
      to_gltf(R"("camera":{"eye":[0,0,-5],"look_at":[0,0,3],"up":[0,1,0],"fov_y":90,"mirrored":true,
    "aperture":1},"resolution":[40,20],"background":[0.1,0.2,0.3],
    "lights":[{"position":[1,2,3],"color":[2,1,0]},{"position":[1,2,3],"color":[1,1,1],
      "spot":{"towards":[1,2,9],"inner":45,"outer":45,"tightness":2}}],
    "directional_lights":[{"direction":[0,-3,0],"color":[0,0.5,0]}],"elementos":[])");
  CHECK(holds(out, R"({"camera":0,"matrix":[-1,0,0,0,0,1,0,0,0,0,-1,0,0,0,-5,1]})"));
  CHECK(holds(out, R"("yfov":1.5707963267948966,"aspectRatio":2,"znear":0.0078125})"));
  CHECK(holds(out, R"({"type":"point","color":[1,0.5,0],"intensity":2})"));
  CHECK(holds(out, R"("innerConeAngle":0.7853981633974482,"outerConeAngle":0.7853981633974483})"));
  CHECK(holds(out, R"({"type":"directional","color":[0,1,0],"intensity":0.5})"));
  CHECK(holds(out, R"({"translation":[1,2,3],"extensions":{"KHR_lights_punctual":{"light":0}}})"));
  CHECK(holds(out, R"({"translation":[1,2,3],"rotation":[1,0,0,)"));  // half a turn: −z becomes z
  CHECK(holds(out, R"({"rotation":[-0.707106781186547)"));
  CHECK(out.lost == Lines{"2 lights fading with the distance, as those of glTF do",
                          "1 tightness of a light left out: not written to glTF",
                          "1 mirrored camera written unmirrored: glTF has none", "1 lens left out: not written to glTF",
                          "1 background left out: not written to glTF",
                          "1 resolution written as the form of the picture alone"});
}

TEST_CASE("Bytes in base64 are read to the same bytes, whatever their number") {
  std::string bytes;
  for (int n = 0; n < 70; ++n) {
    CHECK(io::buffer_bytes(io::Source("f", ""), "data:;base64," + io::base64_text(bytes), 0, 100) == bytes);
    bytes += static_cast<char>(n * 37);
  }
}
