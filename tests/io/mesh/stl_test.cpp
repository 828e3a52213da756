#include "durero/io/mesh/stl.hpp"

#include <bit>

#include "durero/io/json/scene_file.hpp"
#include "io/malformed.hpp"
#include "support/catch.hpp"

using namespace durero;

namespace {

const auto reading = [](const io::Source& s) { return io::read_stl(s); };
std::string error_at(const std::string& with_mark) { return test::error_at_mark(with_mark, reading); }
io::Imported import_text(const std::string& text) { return io::read_stl(io::Source("m.stl", text)); }

constexpr auto sample = R"(solid lid
 facet normal 0 0 1
  outer loop
   vertex 0 0 0.1
   vertex 1e0 0 0
   vertex 0 1 0
  endloop
 endfacet
endsolid lid
SOLID two words
FACET NORMAL 0 0 0 OUTER LOOP VERTEX 0 0 0 VERTEX 2 0 0 VERTEX 0 0
2 ENDLOOP ENDFACET
ENDSOLID
)";

/// The bytes of a whole number, the least first.
std::string bytes(std::uint32_t number, std::size_t size) {
  std::string text;
  for (std::size_t i = 0; i < size; ++i) text += static_cast<char>(number >> 8 * i & 0xff);
  return text;
}

/// A binary mesh with these vertices, three a facet.
std::string binary(const std::vector<std::array<float, 3>>& vertices, std::uint32_t attribute = 0,
                   const std::string& title = "solid in name alone") {
  std::string text =
      title + std::string(80 - title.size(), ' ') + bytes(static_cast<std::uint32_t>(vertices.size() / 3), 4);
  const auto add = [&](const std::array<float, 3>& v) {
    for (const float x : v) text += bytes(std::bit_cast<std::uint32_t>(x), 4);
  };
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    if (i % 3 == 0) add({0, 0, 1});
    add(vertices[i]);
    if (i % 3 == 2) text += bytes(attribute, 2);
  }
  return text;
}

}  // namespace

TEST_CASE("a text's facets are triangles, and its solids groups, whatever the lines") {
  const io::Imported read = import_text(sample);
  REQUIRE(read.scene.size() == 2);
  const auto triangles = read.scene.shapes<scene::Triangle>();
  CHECK(triangles[read.scene.find("m.stl:1")->index].vertices ==
        std::array{glm::dvec3(0, 0, 0.1), glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0)});
  CHECK(triangles[read.scene.find("m.stl:2")->index].vertices ==
        std::array{glm::dvec3(0, 0, 0), glm::dvec3(2, 0, 0), glm::dvec3(0, 0, 2)});
  CHECK(read.groups.of_element("m.stl:1") == "lid");
  CHECK(read.groups.of_element("m.stl:2").empty());
  CHECK(read.lost == std::vector<std::string>{"1 normal of a facet left out: a triangle's follows from its vertices",
                                              "1 name of a solid left out: expected 1 to 128 of A-Z a-z 0-9 _ . : -"});
}

TEST_CASE("a binary file's coordinates are the binary32 that stand there, whatever its title") {
  const io::Imported read =
      import_text(binary({{0.1F, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, 7));
  REQUIRE(read.scene.size() == 1);
  CHECK(read.scene.shapes<scene::Triangle>()[0].vertices[0].x == static_cast<double>(0.1F));
  CHECK(read.lost == std::vector<std::string>{"2 normals of facets left out: a triangle's follows from its vertices",
                                              "2 attributes of facets left out: a scene has none",
                                              "1 triangle left out: the vertices lie on one line"});
  CHECK_THROWS_WITH(
      import_text(binary({{0, 0, 0}, {1, 0, 0}, {0, HUGE_VALF, 0}})),
      "m.stl:1:1: facet 1, counted from 1, has a number that is not finite; expected three finite numbers "
      "of its normal and of each vertex");
  CHECK_THROWS_AS(import_text(binary({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}).substr(0, 133)), io::InputError);
}

TEST_CASE("a malformed text is refused where it stands") {
  CHECK(error_at("^facet") ==
        "\"facet\" stands here; expected solid, or a binary file: 80 bytes, a number n, and 50 "
        "bytes for each of n facets");
  CHECK(error_at("^") ==
        "the text ends; expected solid, or a binary file: 80 bytes, a number n, and 50 bytes for each "
        "of n facets");
  CHECK(error_at("solid\nfacet ^nomal") == "\"nomal\" stands here; expected normal");
  CHECK(error_at("solid\nfacet normal 0 0 ^1e999") == "\"1e999\" in normal; expected a finite decimal number");
  CHECK(error_at("solid\nfacet normal 0 0 1\nouter loop vertex 0 ^0x1 0") ==
        "\"0x1\" in vertex; expected a finite decimal number");
  CHECK(error_at("solid\nfacet normal 0 0 1\nouter loop vertex 0 0^") ==
        "\"\" in vertex; expected a finite decimal number");
  CHECK(error_at("solid\nfacet normal 0 0 1 outer loop vertex 0 0 0 vertex 1 0 0 ^endloop") ==
        "\"endloop\" stands here; expected vertex");
  CHECK(error_at("solid a\n^# endsolid") == "\"#\" stands here; expected facet or endsolid");
  CHECK(error_at("solid a\nendsolid a\n^x") == "\"x\" stands here; expected solid, or the end");
  CHECK(error_at("solid a\nendsolid a\n^") == "no mesh; expected facets");
}
