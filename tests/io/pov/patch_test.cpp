// The bicubic patches of POV-Ray's language, as triangles.
#include <algorithm>

#include "durero/io/pov/pov.hpp"
#include "support/catch.hpp"

using namespace durero;

namespace {

io::Imported import_text(const std::string& text) { return io::read_pov(io::Source("f", text + "\n#version 3.7;")); }

/// The points (u, height, v) of a patch for u and v of 0 to 3, where only those inside may be high.
std::string points(double inside) {
  std::string all;
  for (int u = 0; u < 4; ++u)
    for (int v = 0; v < 4; ++v) {
      const bool is_inside = u % 3 != 0 && v % 3 != 0;
      all += " <" + std::to_string(u) + ", " + std::to_string(is_inside ? inside : 0) + ", " + std::to_string(v) + ">";
    }
  return all;
}

const scene::Scene& scene_of(const io::Imported& read) { return read.scene; }

}  // namespace

TEST_CASE("A patch is halved along both sides as often as its steps say") {
  for (const auto& [u, v] : {std::pair{0, 0}, std::pair{1, 0}, std::pair{0, 2}, std::pair{2, 2}, std::pair{3, 1}}) {
    const io::Imported read = import_text("bicubic_patch { type 1 flatness 0 u_steps " + std::to_string(u) +
                                          " v_steps " + std::to_string(v) + points(1) + " }");
    CHECK(scene_of(read).shapes<scene::Triangle>().size() == (2U << u << v));
    CHECK(read.groups.table().contains("m1"));
  }
}

TEST_CASE("The middle of a patch is where its points put it, and its triangles have normals") {
  const io::Imported read = import_text("bicubic_patch { u_steps 1 v_steps 1," + points(1) + " }");
  double highest = 0;
  for (const scene::Triangle& triangle : scene_of(read).shapes<scene::Triangle>())
    for (const glm::dvec3& vertex : triangle.vertices) highest = std::max(highest, vertex.y);
  CHECK(highest == 0.5625);  // (3/8 + 3/8)²
  const auto first = scene_of(read).find("v1");
  REQUIRE(first);
  CHECK(scene_of(read).vertex_normals(*first));
}

TEST_CASE("A part that is as flat as the text asks is not halved") {
  const auto count = [](const std::string& flatness, double inside, const std::string& move = "") {
    return scene_of(import_text("bicubic_patch { type 0 flatness " + flatness + " u_steps 2 v_steps 2" +
                                points(inside) + " " + move + " }"))
        .shapes<scene::Triangle>()
        .size();
  };
  CHECK(count("0.5", 0.25) == 2);
  CHECK(count("0.25", 0.25) == 8);
  CHECK(count("0.1", 0.25) == 32);
  CHECK(count("0.5", 0.25, "scale 4") == 32);  // it is as flat as it is where it is put
  CHECK(count("0.5", 4, "scale 1/16") == 2);
  CHECK(count("0.2", 0.25) == 8);
  CHECK(count("0", 0) == 32);
}

TEST_CASE("A patch that comes to a point lacks a triangle there, and steps have bounds") {
  std::string all = "bicubic_patch { flatness 0";
  for (int u = 0; u < 4; ++u)
    for (int v = 0; v < 4; ++v) all += " <" + std::to_string(u * v) + ", 0, " + std::to_string(u) + ">";
  CHECK(scene_of(import_text(all + " }")).shapes<scene::Triangle>().size() == 1);
  CHECK(import_text("bicubic_patch { u_steps 11 v_steps 10" + points(1) + " }").lost ==
        std::vector<std::string>{"1 bicubic_patch of more than 20 steps in all left out: a scene has none"});
  CHECK_THROWS_AS(import_text("bicubic_patch { u_steps 1.5" + points(1) + " }"), io::InputError);
  CHECK_THROWS_AS(import_text("bicubic_patch { u_steps 1 <1, 2, 3> }"), io::InputError);
}
