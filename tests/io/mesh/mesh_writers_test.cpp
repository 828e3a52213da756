// OBJ, PLY and STL as they are written: each reads back to the same triangles, and is written the same again.
#include <bit>
#include <map>

#include "durero/io/mesh/obj.hpp"
#include "durero/io/mesh/ply.hpp"
#include "durero/io/mesh/stl.hpp"
#include "durero/scene/stage.hpp"
#include "support/catch.hpp"
#include "support/property.hpp"
#include "support/scenes.hpp"
#include "support/shapes.hpp"

using namespace durero;
using namespace durero::test;

namespace {

using Numbers = std::vector<std::uint64_t>;

/// The looks of triangles that a format keeps.
struct Kept {
  bool groups = false, normals = false, uv = false;
};

/// The bits of a triangle's vertices and, where it has them, of its normals and of its uv, each behind a mark.
Numbers bits_of(const scene::Scene& scene, scene::ElementRef element, const Kept& kept) {
  Numbers bits;
  const auto add_bits = [&](const glm::dvec3& x) {
    for (int i = 0; i < 3; ++i) bits.push_back(std::bit_cast<std::uint64_t>(x[i]));
  };
  for (const glm::dvec3& vertex : scene.shapes<scene::Triangle>()[element.index].vertices) add_bits(vertex);
  if (const auto normals = scene.vertex_normals(element); normals && kept.normals)
    for (const glm::dvec3& normal : *normals) add_bits(normal);
  if (const auto wrap = scene.wrap(element); wrap && kept.uv)
    for (const glm::dvec2& uv : wrap->uv) add_bits({uv, 7});
  return bits;
}

/// The triangles, sorted, each with the name of its group.
std::vector<std::pair<std::string, Numbers>> contents(const scene::Scene& scene, const scene::Groups& groups,
                                                      const Kept& kept) {
  std::vector<std::pair<std::string, Numbers>> all;
  scene.for_each([&](scene::ElementRef e, const auto&) {
    all.emplace_back(groups.of_element(scene.name(e).name()), bits_of(scene, e, kept));
  });
  std::ranges::sort(all);
  return all;
}

struct Grouped {
  scene::Scene scene;
  scene::Groups groups;
};

/// Triangles that share vertices, with numbers of every kind; some of them, or all, with normals, and some with uv; two
/// groups.
Grouped some_mesh(Random& random, bool all_smooth) {
  Grouped mesh;
  std::vector<glm::dvec3> points{{0, 0, 0}, {-0.0, 1, 0.1}, {1e-300, 0x1p-1074, 1e300}, {1, 0, 0x1.fffffffffffffp0}};
  for (int i = 0; i < 4; ++i) points.push_back(random.in_cube(3));
  for (int i = 0; i < 25; ++i) {
    const auto point = [&] { return points[random.below(points.size())]; };
    const std::string name = "m:" + std::to_string(i + 1);
    if (!mesh.scene.add(model::Elemento(name), scene::Triangle{std::array{point(), point(), point()}}).ok()) continue;
    if (all_smooth || i % 3 == 0)
      mesh.scene.set_vertex_normals(*mesh.scene.find(name),
                                    {random.direction(), random.direction(), random.in_cube(9)});
    if (i % 4 < 2) {
      const auto uv = [&] { return glm::dvec2(points[random.below(points.size())]); };
      mesh.scene.set_wrap(*mesh.scene.find(name), {.uv = {uv(), uv(), uv()}});
    }
    const std::string group = i % 2 == 0 ? "even" : "odd";
    if (i % 5 == 0) continue;
    auto members = mesh.groups.table().contains(group) ? mesh.groups.table().at(group) : scene::Group{};
    if (mesh.groups.table().contains(group)) mesh.groups.apply_total(scene::Ungrouping{group}, mesh.scene);
    members.elementos.insert(name);
    mesh.groups.apply_total(scene::Grouping{group, members}, mesh.scene);
  }
  return mesh;
}

using Write = io::Exported (*)(const scene::Scene&, const scene::Groups&);
using Read = io::Imported (*)(const io::Source&);

void check_round_trip(Write write, Read read, const Kept& kept, bool all_smooth) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    Random random(seed);
    const Grouped mesh = some_mesh(random, all_smooth);
    const std::string text = write(mesh.scene, mesh.groups).text;
    const io::Imported again = read(io::Source("m", text));
    INFO("seed " << seed << "\n" << text);
    CHECK(contents(again.scene, again.groups, {true, true, true}) ==
          contents(mesh.scene, kept.groups ? mesh.groups : scene::Groups(), kept));
    CHECK(write(again.scene, again.groups).text == text);
  }
}

}  // namespace

TEST_CASE("OBJ keeps triangles, normals, uv and groups, bit for bit") {
  check_round_trip(io::obj_text, io::read_obj, {.groups = true, .normals = true, .uv = true}, false);
}

TEST_CASE("PLY keeps triangles, and normals where all have them, bit for bit") {
  for (const Write write : {io::ply_text, io::ply_bytes}) {
    check_round_trip(write, io::read_ply, {.normals = true}, true);
    check_round_trip(write, io::read_ply, {}, false);
  }
}

TEST_CASE("STL keeps triangles and groups, bit for bit") {
  check_round_trip(io::stl_text, io::read_stl, {.groups = true}, false);
}

TEST_CASE("binary STL keeps coordinates of binary32, and counts those that it rounds or leaves out") {
  scene::Scene scene;
  constexpr double greatest = 0x1.fffffep127, half_a_step_beyond = 0x1.ffffffp127;
  const auto add_with = [&](double x) {
    add(scene, scene::Triangle{std::array{glm::dvec3(x, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, -0x1p-149)}});
  };
  add_with(double{0.1F});
  add_with(greatest);
  const io::Exported kept = io::stl_bytes(scene, {});
  CHECK(kept.text.size() == 84 + 2 * 50);
  CHECK(kept.lost == std::vector<std::string>{"2 names of elements left out: STL has none"});
  const io::Imported again = io::read_stl(io::Source("m", kept.text));
  CHECK(contents(again.scene, {}, {}) == contents(scene, {}, {}));
  CHECK(io::stl_bytes(again.scene, {}).text == kept.text);

  add_with(0.1);
  add_with(std::nextafter(half_a_step_beyond, 0));
  add_with(-half_a_step_beyond);
  const io::Exported rounded = io::stl_bytes(scene, {});
  CHECK(rounded.text.size() == 84 + 4 * 50);
  CHECK(rounded.lost == std::vector<std::string>{"1 triangle left out: a coordinate is beyond binary32",
                                                 "2 coordinates rounded: binary STL has binary32",
                                                 "5 names of elements left out: STL has none"});
  const auto triangles = io::read_stl(io::Source("m", rounded.text)).scene;
  CHECK(triangles.shapes<scene::Triangle>()[2].vertices[0].x == double{0.1F});
  CHECK(triangles.shapes<scene::Triangle>()[3].vertices[0].x == greatest);

  Random random(1);
  const Grouped mesh = some_mesh(random, false);
  const std::vector<std::string> lost = io::stl_bytes(mesh.scene, mesh.groups).lost;
  CHECK(std::ranges::count(lost, "2 groups left out: binary STL has none") == 1);
}

TEST_CASE("a point is written once, and what is lost is named") {
  scene::Scene scene;
  add(scene, scene::Triangle{std::array{glm::dvec3(0, 0, 0), glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0)}});
  add(scene, scene::Triangle{std::array{glm::dvec3(1, 0, 0), glm::dvec3(1, 1, 0), glm::dvec3(0, 1, 0)}});
  add(scene, scene::Sphere{{0, 0, 0}, 1});
  scene.set_vertex_normals(*scene.find("e1"), {glm::dvec3(0, 0, 1), glm::dvec3(0, 0, 1), glm::dvec3(0, 0, 2)});
  scene.set_wrap(*scene.find("e0"), {.uv = {glm::dvec2(0, 0), glm::dvec2(1, 0), glm::dvec2(0, 0)}});
  scene.stage().background = glm::dvec3(0, 0, 0.5);
  const io::Exported obj = io::obj_text(scene, {});
  CHECK(obj.text ==
        "v 0 0 0\nvt 0 0\nv 1 0 0\nvt 1 0\nv 0 1 0\nvn 0 0 1\nv 1 1 0\nvn 0 0 2\nf 1/1 2/2 3/1\nf 2//1 4//1 3//2\n");
  CHECK(obj.lost == std::vector<std::string>{"1 element left out: OBJ has triangles alone",
                                             "2 names of elements left out: OBJ has none",
                                             "1 background left out: OBJ has none"});
  const io::Exported ply = io::ply_text(scene, {});
  CHECK(
      ply.text ==
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double y\nproperty double z\nelement face "
      "2\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n3 0 1 2\n3 1 3 2\n");
  CHECK(ply.lost[0] == "1 smooth triangle written flat: PLY has normals of all vertices, or of none");
  CHECK(ply.lost[3] == "1 uv of a triangle left out: they are not written to PLY");
  CHECK(io::ply_bytes(scene, {}).lost == ply.lost);
  const io::Exported stl = io::stl_text(scene, {});
  CHECK(stl.text ==
        "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nfacet "
        "normal 0 0 1\nouter loop\nvertex 1 0 0\nvertex 1 1 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid\n");
  CHECK(stl.lost[0] == "1 smooth triangle written flat: STL has no normals of vertices");
  scene.set_wrap(*scene.find("e1"), {.uv = {}, .tangents = std::array<scene::VertexTangents, 3>{}});
  CHECK(std::ranges::count(io::obj_text(scene, {}).lost, "1 triangle with tangents written without them") == 1);
}
