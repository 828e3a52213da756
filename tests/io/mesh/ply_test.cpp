#include "durero/io/mesh/ply.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <limits>

#include "durero/io/json/scene_file.hpp"
#include "io/malformed.hpp"
#include "support/catch.hpp"

using namespace durero;

namespace {

const auto reading = [](const io::Source& s) { return io::read_ply(s); };
std::string error_at(const std::string& with_mark) { return test::error_at_mark(with_mark, reading); }
io::Imported import_text(const std::string& text) { return io::read_ply(io::Source("m.ply", text)); }

constexpr auto sample = R"(ply
format ascii 1.0
comment a sheet
obj_info of six corners
element vertex 6
property double x
property double y
property uchar red
property double z
element edge 1
property int vertex1
property int vertex2
element face 3
property list uchar int vertex_indices
property float area
end_header
0 0 255 0
2 0 0 0
2 1 0 0
1 1 0 0
1 2 0 0
0 2 0 0.1
0 1
6 0 1 2 3 4 5 3.5
3 0 1 5 2
3 0 3 0 0
)";

// The bytes of a number, the least first or last.
template <class Number>
std::string bytes(Number number, bool little) {
  const auto raw = std::bit_cast<std::array<char, sizeof(Number)>>(number);
  std::string text(raw.begin(), raw.end());
  if (little != (std::endian::native == std::endian::little)) std::ranges::reverse(text);
  return text;
}

// A binary mesh of these faces over three vertices.
std::string binary(bool little, const std::vector<std::vector<std::int32_t>>& faces, double last = 1) {
  std::string text = fmt::format(
      "ply\nformat binary_{}_endian 1.0\nelement vertex 3\nproperty float x\nproperty double y\nproperty double z\n"
      "element face {}\nproperty list uint8 int32 vertex_index\nend_header\n",
      little ? "little" : "big", faces.size());
  for (const glm::dvec3& v : {glm::dvec3{0.5, 0, 0}, {0.1F, 0.1, 0}, {0, 0, last}})
    text += bytes(static_cast<float>(v.x), little) + bytes(v.y, little) + bytes(v.z, little);
  for (const auto& face : faces) {
    text += static_cast<char>(face.size());
    for (const std::int32_t vertex : face) text += bytes(vertex, little);
  }
  return text;
}

}  // namespace

TEST_CASE("The faces of a PLY become triangles, named by file and number") {
  const io::Imported i = import_text(sample);
  CHECK(io::scene_text(i.scene) == R"({"format":"durero-scene","version":1,
"elementos":[
{"id":"m.ply:1","tipo":"triangulo","vertices":[[0,0,0],[2,0,0],[1,1,0]]},
{"id":"m.ply:2","tipo":"triangulo","vertices":[[0,0,0],[1,1,0],[0,2,0.1]]},
{"id":"m.ply:3","tipo":"triangulo","vertices":[[2,0,0],[2,1,0],[1,1,0]]},
{"id":"m.ply:4","tipo":"triangulo","vertices":[[1,1,0],[1,2,0],[0,2,0.1]]},
{"id":"m.ply:5","tipo":"triangulo","vertices":[[0,0,0],[2,0,0],[0,2,0.1]]}
]}
)");
  CHECK(i.lost == std::vector<std::string>{"1 property of element vertex left out: a triangle has its vertices alone",
                                           "1 item of element \"edge\" left out: a scene has none",
                                           "1 property of element face left out: a triangle has its vertices alone",
                                           "1 triangle left out: the vertices lie on one line"});
}

TEST_CASE("The normals of the vertices make triangles smooth, whatever the order of the properties") {
  const auto mesh = [](const std::string& normal) {
    return "ply\nformat ascii 1.0\nelement vertex 3\nproperty float nx\nproperty float x\nproperty float y\nproperty "
           "float z\n"
           "property float ny\nproperty double nz\nelement face 1\nproperty list uchar int "
           "vertex_indices\nend_header\n" +
           normal + "\n0 2 0 0 1 2\n0.5 0 2 0 0 1\n3 0 1 2\n";
  };
  const io::Imported i = import_text(mesh("0 0 0 0 0 3"));
  REQUIRE(i.scene.vertex_normals(*i.scene.find("m.ply:1")));
  CHECK(*i.scene.vertex_normals(*i.scene.find("m.ply:1")) == scene::VertexNormals{{{0, 0, 3}, {0, 1, 2}, {0.5, 0, 1}}});
  CHECK(i.lost.empty());
  const io::Imported flat = import_text(mesh("0 0 0 0 0 0"));
  CHECK_FALSE(flat.scene.vertex_normals(*flat.scene.find("m.ply:1")));
  CHECK(flat.lost == std::vector<std::string>{"1 triangle kept flat: a normal at a vertex has no direction"});
}

TEST_CASE("A PLY of text is read alike however its lines end") {
  const std::string wanted = io::scene_text(import_text(sample).scene);
  std::string cr = sample, crlf;
  for (char& c : cr) {
    crlf += c == '\n' ? std::string("\r\n") : std::string(1, c);
    if (c == '\n') c = '\r';
  }
  CHECK(io::scene_text(import_text(cr).scene) == wanted);
  CHECK(io::scene_text(import_text(crlf).scene) == wanted);
}

TEST_CASE("A binary PLY keeps the bits of its coordinates, in either order of bytes") {
  for (const bool little : {true, false}) {
    const double blanks = 0x1.00d0a0b0c090dp0;  // its bytes are those of line ends and tabs
    const io::Imported i = import_text(binary(little, {{0, 1, 2}, {2, 1, 0}}, blanks));
    REQUIRE(i.scene.shapes<scene::Triangle>().size() == 2);
    const scene::Corners& v = i.scene.shapes<scene::Triangle>()[0].vertices;
    CHECK(v == scene::Corners{glm::dvec3{0.5, 0, 0}, {double{0.1F}, 0.1, 0}, {0, 0, blanks}});
    CHECK(i.lost.empty());
  }
}

TEST_CASE("What is written of a float is the nearest binary32, of a double the nearest binary64") {
  const std::string head =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float64 y\nproperty float32 z\n";
  const io::Imported i = import_text(head +
                                     "element face 1\nproperty list ushort uint vertex_indices\nend_header\n"
                                     "0.1 0.1 16777217\n1e-999 1e23 0.50000002980232239\n0 1 0\n3 0 1 2\n");
  const scene::Corners& v = i.scene.shapes<scene::Triangle>()[0].vertices;
  CHECK(v[0] == glm::dvec3{double{0.1F}, 0.1, 16777216});
  CHECK(v[1] == glm::dvec3{0, 1e23, 0.5 + 0x1p-24});
}

TEST_CASE("A malformed header of PLY is an error with its place") {
  const std::string head = "ply\nformat ascii 1.0\n";
  const std::string vertex = "element vertex 1\nproperty double x\nproperty double y\nproperty double z\n";
  const std::string face = "element face 1\nproperty list uchar int vertex_indices\n";
  const std::string end = "end_header\n0 0 0\n3 0 0 0\n";
  using Case = std::pair<std::string, std::string>;
  const Case cases[] = {
      {"^", "the text ends in its header; expected end_header"},
      {"^v 0 0 0", "\"v\" stands here; expected ply: no PLY file begins otherwise"},
      {"ply ^x\n", "\"x\" stands here; expected the end of the line"},
      {"ply\n^element vertex 1", "\"element\" stands here; expected format"},
      {"ply\nformat ^text 1.0", "\"text\" stands here; expected one of ascii, binary_little_endian, binary_big_endian"},
      {"ply\nformat ascii ^2.0", "\"2.0\" stands here; expected 1.0"},
      {head + "^", "the text ends in its header; expected end_header"},
      {head + "^\n", "\"\" stands here; expected one of comment, obj_info, element, property, end_header"},
      {head + "^vertex 3\n",
       "\"vertex\" stands here; expected one of comment, obj_info, element, property, end_header"},
      {head + "element vertex ^-1\n", "\"-1\" in element; expected how many there are"},
      {head + "element vertex ^1x\n", "\"1x\" in element; expected how many there are"},
      {head + "element vertex ^99999999999999999999\n",
       "\"99999999999999999999\" in element; expected how many there are"},
      {head + "^property double x\n", "a property of no element; expected element before it"},
      {head + "element vertex 1\nproperty ^real x\n",
       "unknown type \"real\"; expected one of list, char, int8, uchar, uint8, short, int16, ushort, uint16, int, "
       "int32, uint, uint32, "
       "float, float32, double, float64"},
      {head + "element vertex 1\nproperty double^\n", "the line ends; expected the name of a property"},
      {head + "element vertex 1\nproperty list uchar int ^\n", "the line ends; expected the name of a property"},
      {head + vertex + "element face 1\nproperty list ^int int vertex_indices\n",
       "\"int\" stands here; expected one of uchar, uint8, ushort, uint16, which count a list"},
      {head + vertex + "^" + vertex + face + end, "a second element vertex; expected one"},
      {head + vertex + "^end_header\n", "no element face in the header; expected one of face, faces"},
      {head + "^element vertex 1\nproperty double x\nproperty double x\n" + face + end,
       "two properties \"x\"; expected names of their own"},
      {head + "^element vertex 1\nproperty double x\nproperty double y\n" + face + end,
       "a vertex without a coordinate z; expected x, y and z, each one of float, float32, double, float64"},
      {head + "^element vertex 1\nproperty double x\nproperty double y\nproperty int z\n" + face + end,
       "a vertex without a coordinate z; expected x, y and z, each one of float, float32, double, float64"},
      {head + vertex + "^element face 1\nproperty list uchar short vertex_indices\n" + end,
       "a face without a list of vertices; expected one of vertex_indices, vertex_index, a list of one of int, int32, "
       "uint, uint32"},
      {head + vertex + face + "^element rest 99999999999\n" + end,
       "element \"rest\" without a property; expected some"},
  };
  for (const auto& [text, expected] : cases) {
    INFO(text);
    CHECK(error_at(text) == expected);
  }
}

TEST_CASE("Malformed data of PLY are an error with their place, in a binary file that of the element in the header") {
  const std::string head =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\nproperty float z\n"
      "element face 2\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n";
  const std::string vertices = head + "1 0 0\n0 1 0\n";
  using Case = std::pair<std::string, std::string>;
  const Case cases[] = {
      {head + "0 1 ^x\n", "\"x\" after 1 vertices and 0 faces; expected 3 vertices and 2 faces"},
      {head + "0 1 ^1e39\n", "\"1e39\" after 1 vertices and 0 faces; expected 3 vertices and 2 faces"},
      {head + "0 ^nan 0\n", "\"nan\" after 1 vertices and 0 faces; expected 3 vertices and 2 faces"},
      {head + "0 1 0\n^", "the data end after 2 vertices and 0 faces; expected 3 vertices and 2 faces"},
      {vertices + "3 0 1 2\n3 0 ^1.5 2\n", "\"1.5\" after 3 vertices and 1 faces; expected 3 vertices and 2 faces"},
      {vertices + "3 0 1 2\n3 0 1^", "the data end after 3 vertices and 1 faces; expected 3 vertices and 2 faces"},
      {vertices + "3 0 1 2\n^2 0 1\n", "face 1 has 2 vertices; expected 3 or more"},
      {vertices + "3 0 1 2\n^3 0 1 3\n", "face 1 names vertex 3; expected one of 3, counted from 0"},
      {vertices + "^3 0 1 -1\n3 0 1 2\n", "face 0 names vertex -1; expected one of 3, counted from 0"},
      {vertices + "^65536 0 1 2\n3 0 1 2\n", "\"65536\" after 3 vertices and 0 faces; expected 3 vertices and 2 faces"},
      {vertices + "^256 0 1 2\n3 0 1 2\n", "\"256\" after 3 vertices and 0 faces; expected 3 vertices and 2 faces"},
      {vertices + "^-1 0 1 2\n3 0 1 2\n", "\"-1\" after 3 vertices and 0 faces; expected 3 vertices and 2 faces"},
      {vertices + "3 0 1 ^2147483648\n3 0 1 2\n",
       "\"2147483648\" after 3 vertices and 0 faces; expected 3 vertices and 2 faces"},
      {vertices + "3 0 1 ^99999999999999999999\n3 0 1 2\n",
       "\"99999999999999999999\" after 3 vertices and 0 faces; expected 3 vertices and 2 faces"},
      {head + "0 1 ^0x1\n", "\"0x1\" after 1 vertices and 0 faces; expected 3 vertices and 2 faces"},
      {head + "0 1 ^0-1\n", "\"0-1\" after 1 vertices and 0 faces; expected 3 vertices and 2 faces"},
      {head + "^0,5 1 0\n", "\"0,5\" after 1 vertices and 0 faces; expected 3 vertices and 2 faces"},
      {vertices + "3 0 1 2\n3 0 1 2\n \n^7\n", "data behind the last element; expected as many as the header tells of"},
  };
  for (const auto& [text, expected] : cases) {
    INFO(text);
    CHECK(error_at(text) == expected);
  }
  const auto error = [](const std::string& text) { return test::error_of(text, reading); };
  const std::string whole = binary(true, {{0, 1, 2}, {2, 1, 0}});
  CHECK(error(whole.substr(0, whole.size() - 1)) ==
        "f:7:1: the data end after 3 vertices and 1 faces; expected 3 vertices and 2 faces");
  CHECK(error(whole + " ") == "f:7:1: data behind the last element; expected as many as the header tells of");
  CHECK(error(binary(false, {{0, 1, 7}})) == "f:7:1: face 0 names vertex 7; expected one of 3, counted from 0");
  CHECK(error(binary(false, {{0, 1, -1}})) == "f:7:1: face 0 names vertex -1; expected one of 3, counted from 0");
  CHECK(error(binary(false, {{0, 1}})) == "f:7:1: face 0 has 2 vertices; expected 3 or more");
  CHECK(error(binary(true, {{0, 1, 2}}, std::numeric_limits<double>::infinity())) ==
        "f:3:1: vertex 2 is (0, 0, inf); expected finite numbers");
}

TEST_CASE("Every property of PLY is passed by its type, and a face may stand before its vertices") {
  const std::string wanted = io::scene_text(import_text("ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\n"
                                                        "property double y\nproperty double z\nelement face 1\n"
                                                        "property list uchar int vertex_index\nend_header\n"
                                                        "0 0 1\n1 0 2\n0 1 3\n3 2 1 0\n")
                                                .scene);
  const std::string properties =
      "element faces 1\nproperty list uint8 double weights\nproperty list ushort uint vertex_indices\n"
      "property char c\nelement vertices 3\nproperty double z\nproperty int8 i1\nproperty uint8 u1\n"
      "property float64 x\nproperty int16 i2\nproperty uint16 u2\nproperty double y\nproperty int32 i4\n"
      "property uint32 u4\nproperty float32 f4\nproperty list uchar short vertex_index\nend_header\n";
  const io::Imported text = import_text("ply\nformat ascii 1.0\n" + properties +
                                        "2 0.5 -1e300 3 2 +1 0 -128\n"
                                        "1 -128 255 0 -32768 65535 0 -2147483648 4294967295 -1e38 0\n"
                                        "2 127 0 1 32767 0 0 2147483647 0 1e-50 1 -7\n"
                                        "3 0\n0 0 0 0 1 0 0\n1. 2\t1 2\n");
  CHECK(io::scene_text(text.scene) == wanted);
  for (const bool little : {true, false}) {
    const auto b = [&](auto number) { return bytes(number, little); };
    std::string data = b(std::uint8_t{2}) + b(0.5) + b(-1e300) + b(std::uint16_t{3}) + b(2U) + b(1U) + b(0U) + "c";
    for (const auto& [x, y, z] : {std::array{0.0, 0.0, 1.0}, {1.0, 0.0, 2.0}, {0.0, 1.0, 3.0}})
      data += b(z) + "iu" + b(x) + b(std::int16_t{-1}) + b(std::uint16_t{1}) + b(y) + b(-1) + b(1U) + b(1.0F) +
              b(std::uint8_t{1}) + b(std::int16_t{-7});
    CHECK(io::scene_text(import_text(fmt::format("ply\nformat binary_{}_endian 1.0\n", little ? "little" : "big") +
                                     properties + data)
                             .scene) == wanted);
  }
}

TEST_CASE("No damage to PLY does worse than an error") {
  CHECK(test::refused_after_damage(sample, 20000, reading) > 5000);
  CHECK(test::refused_after_damage(binary(true, {{0, 1, 2}, {2, 1, 0}}), 20000, reading) > 5000);
}
