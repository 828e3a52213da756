#include "durero/io/mesh/gltf.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <bit>
#include <cmath>

#include "durero/io/output_file.hpp"
#include "io/malformed.hpp"
#include "support/catch.hpp"
#include "support/folder.hpp"

using namespace durero;

namespace {

const auto reading = [](const io::Source& s) { return io::read_gltf(s); };
std::string error_at(const std::string& with_mark) { return test::error_at_mark(with_mark, reading); }
io::Imported import_text(const std::string& text) { return io::read_gltf(io::Source("m.gltf", text)); }

/// The bytes of a whole number, the least first.
std::string number_bytes(std::uint64_t number, std::size_t size) {
  std::string text;
  for (std::size_t i = 0; i < size; ++i) text += static_cast<char>(number >> 8 * i & 0xffU);
  return text;
}
std::string floats(const std::vector<float>& numbers) {
  std::string text;
  for (const float x : numbers) text += number_bytes(std::bit_cast<std::uint32_t>(x), 4);
  return text;
}
std::string whole(const std::vector<int>& numbers, std::size_t size) {
  std::string text;
  for (const int x : numbers) text += number_bytes(static_cast<std::uint64_t>(x), size);
  return text;
}

std::string base64(const std::string& text) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  for (std::size_t i = 0; i < text.size(); i += 3) {
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k)
      bits = bits << 8 | (i + k < text.size() ? static_cast<std::uint8_t>(text[i + k]) : 0);
    for (std::size_t k = 0; k < 4; ++k) out += i + k > text.size() ? '=' : digits[bits >> (18 - 6 * k) & 63];
  }
  return out;
}

/// A file in the making. What is empty is left out.
struct File {
  std::vector<std::string> accessors{}, views{};
  std::string bytes{}, meshes{}, nodes = R"({"mesh":0})", more{};

  /// An accessor of its own view; the number of it.
  std::size_t add(const std::string& data, int type, std::string_view shape, std::size_t count,
                  std::string_view further = "", std::string_view of_view = "") {
    views.push_back(
        fmt::format(R"({{"buffer":0,"byteOffset":{},"byteLength":{}{}}})", bytes.size(), data.size(), of_view));
    bytes += data;
    accessors.push_back(fmt::format(R"({{"bufferView":{},"componentType":{},"type":"{}","count":{}{}}})",
                                    views.size() - 1, type, shape, count, further));
    return accessors.size() - 1;
  }
  std::size_t add_floats(const std::vector<float>& data, std::size_t width) {
    return add(floats(data), 5126, fmt::format("VEC{}", width), data.size() / width);
  }
  /// The text; the buffer's URI and length stand in it where it has bytes.
  std::string text(const std::string& buffer) const {
    return fmt::format(
        "{{\"asset\":{{\"version\":\"2.0\"}},\n\"scenes\":[{{\"nodes\":[0]}}],\n\"nodes\":[{}],\n\"meshes\":[{}],\n"
        "\"accessors\":[{}],\n\"bufferViews\":[{}],\n\"buffers\":[{{{}\"byteLength\":{}}}]{}}}",
        nodes, meshes, fmt::join(accessors, ",\n"), fmt::join(views, ",\n"), buffer, bytes.size(), more);
  }
  std::string text() const {
    return text(fmt::format(R"("uri":"data:application/octet-stream;base64,{}",)", base64(bytes)));
  }
  std::string binary() const {
    std::string json = text(""), data = bytes;
    while (json.size() % 4 != 0) json += ' ';
    while (data.size() % 4 != 0) data += '\0';
    return "glTF" + number_bytes(2, 4) + number_bytes(12 + 8 + json.size() + 8 + data.size(), 4) +
           number_bytes(json.size(), 4) + "JSON" + json + number_bytes(data.size(), 4) + std::string("BIN\0", 4) + data;
  }
};

/// Four corners of a square, one of them beyond binary32's grid of ordinary numbers.
const std::vector<float> square{0, 0, 0, 0.1F, 0, 0, 1, 1, 0, 0, 1, 0};

/// Two triangles, their indices of that size.
File sample(std::size_t size = 2) {
  File file;
  file.add_floats(square, 3);
  file.add(whole({0, 1, 2, 0, 2, 3}, size), size == 1 ? 5121 : size == 2 ? 5123 : 5125, "SCALAR", 6);
  file.meshes = R"({"primitives":[{"attributes":{"POSITION":0},"indices":1}]})";
  return file;
}

std::vector<scene::Corners> triangles(const io::Imported& read) {
  std::vector<scene::Corners> all;
  for (std::size_t i = 1; i <= read.scene.size(); ++i) {
    const auto found = read.scene.find("m.gltf:" + std::to_string(i));
    REQUIRE(found);
    all.push_back(read.scene.shapes<scene::Triangle>()[found->index].vertices);
  }
  return all;
}

std::vector<scene::Corners> square_triangles(double z = 0) {
  const glm::dvec3 a(0, 0, z), b(double{0.1F}, 0, z), c(1, 1, z), d(0, 1, z);
  return {{a, b, c}, {a, c, d}};
}

}  // namespace

TEST_CASE("glTF's triangles are named by file and number, and their coordinates are the binary32 that stand there") {
  for (const std::size_t size : {1U, 2U, 4U}) {
    const io::Imported text = import_text(sample(size).text()), binary = import_text(sample(size).binary());
    CHECK(triangles(text) == square_triangles());
    CHECK(triangles(binary) == square_triangles());
    CHECK(text.lost.empty());
    CHECK(binary.lost.empty());
  }
}

TEST_CASE("corners without indices, strips and fans are triangles in the order of glTF") {
  const auto read = [](std::string_view mode, bool indexed) {
    File file = sample();
    file.accessors[1] = R"({"bufferView":1,"componentType":5123,"type":"SCALAR","count":4,"byteOffset":2})";  // 1 2 0 2
    file.meshes = fmt::format(R"({{"primitives":[{{"attributes":{{"POSITION":0}},"mode":{}{}}}]}})", mode,
                              indexed ? R"(,"indices":1)" : "");
    return import_text(file.text());
  };
  const glm::dvec3 a(0, 0, 0), b(double{0.1F}, 0, 0), c(1, 1, 0), d(0, 1, 0);
  CHECK(triangles(read("5", false)) == std::vector<scene::Corners>{{a, b, c}, {b, d, c}});
  CHECK(triangles(read("6", false)) == std::vector<scene::Corners>{{b, c, a}, {c, d, a}});
  CHECK(triangles(read("5", true)) == std::vector{scene::Corners{b, c, a}});
  CHECK(read("5", true).lost == std::vector<std::string>{"1 triangle left out: the vertices lie on one line"});
  CHECK(triangles(read("6", true)) == std::vector<scene::Corners>{{c, a, b}, {a, c, b}});
  File file;
  file.add_floats({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 2, 0, 0, 0, 2, 0}, 3);
  file.meshes = R"({"primitives":[{"attributes":{"POSITION":0}}]})";
  CHECK(triangles(import_text(file.text()))[1][1] == glm::dvec3(2, 0, 0));
}

TEST_CASE("elements stand at their stride, and those of a sparse accessor in the place of others") {
  File file = sample();
  const std::string point = floats({0, 0, 0, 9, 0.1F, 0, 0, 9, 1, 1, 0, 9, 0, 1, 0});
  file.accessors[0] = fmt::format(
      R"({{"bufferView":2,"byteOffset":4,"componentType":5126,"type":"VEC3","count":4,"sparse":{{"count":2,
      "indices":{{"bufferView":3,"componentType":5123,"byteOffset":2}},"values":{{"bufferView":4}}}}}})");
  file.add(floats({7}) + point, 5126, "VEC3", 1, "", R"(,"byteStride":16)");
  file.add(whole({7, 1, 3}, 2), 5123, "SCALAR", 1);
  file.add_floats({5, 6, 7, 0, 1, 0}, 3);
  const auto read = triangles(import_text(file.text()));
  CHECK(read[0] == scene::Corners{glm::dvec3(0, 0, 0), {5, 6, 7}, {1, 1, 0}});
  CHECK(read[1] == square_triangles()[1]);

  File zeros = sample();
  zeros.accessors[0] = R"({"componentType":5126,"type":"VEC3","count":4,"sparse":{"count":2,)"
                       R"("indices":{"bufferView":2,"componentType":5121},"values":{"bufferView":3}}})";
  zeros.add(whole({1, 2}, 1), 5121, "SCALAR", 1);
  zeros.add_floats({1, 0, 0, 0, 1, 0}, 3);
  const io::Imported some = import_text(zeros.text());
  CHECK(triangles(some) == std::vector{scene::Corners{glm::dvec3(0, 0, 0), {1, 0, 0}, {0, 1, 0}}});
  CHECK(some.lost == std::vector<std::string>{"1 triangle left out: the vertices lie on one line"});
}

TEST_CASE("integers are the numbers that they stand for, rounded once") {
  const auto corner = [](int type, bool normalized, const std::string& data) {
    File file = sample();
    file.add(data, type, "VEC3", 4, normalized ? R"(,"normalized":true)" : "");
    file.meshes = R"({"primitives":[{"attributes":{"POSITION":2},"indices":1}]})";
    return triangles(import_text(file.text()))[0][1];
  };
  const std::vector<int> some{0, 0, 0, 1, 128, 254, 3, 0, 0, 0, 3, 0}, more{0, 0, 0, 1, 32768, 65534, 3, 0, 0, 0, 3, 0};
  CHECK(corner(5121, false, whole(some, 1)) == glm::dvec3(1, 128, 254));
  CHECK(corner(5121, true, whole(some, 1)) == glm::dvec3(1 / 255.0, 128 / 255.0, 254 / 255.0));
  CHECK(corner(5120, false, whole(some, 1)) == glm::dvec3(1, -128, -2));
  CHECK(corner(5120, true, whole(some, 1)) == glm::dvec3(1 / 127.0, -1, -2 / 127.0));
  CHECK(corner(5122, true, whole(more, 2)) == glm::dvec3(1 / 32767.0, -1, -2 / 32767.0));
  CHECK(corner(5123, true, whole(more, 2)) == glm::dvec3(1 / 65535.0, 32768 / 65535.0, 65534 / 65535.0));
}

TEST_CASE("nodes place meshes, and a place that turns right into left turns the corners") {
  File file = sample();
  file.nodes =
      R"({"children":[1,2,3],"translation":[0,0,1]},{"mesh":0},{"mesh":0,"scale":[1,1,-1],"translation":[0,0,1]},
{"mesh":0,"matrix":[1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,3,1]})";
  file.meshes = R"({"primitives":[{"attributes":{"POSITION":0},"indices":1,"material":0}]})";
  const io::Imported read = import_text(file.text());
  std::vector<scene::Corners> wanted = square_triangles(1), mirrored = square_triangles(2), moved = square_triangles(4);
  for (scene::Corners& corners : mirrored) std::swap(corners[1], corners[2]);
  wanted.insert(wanted.end(), mirrored.begin(), mirrored.end());
  wanted.insert(wanted.end(), moved.begin(), moved.end());
  CHECK(triangles(read) == wanted);
  CHECK(read.lost == std::vector<std::string>{"1 use of a material left out: a scene has none of this kind"});
}

TEST_CASE("triangles have their normals, by the transposed inverse, and their uv, in which v grows upwards") {
  File file = sample();
  file.nodes = R"({"mesh":0,"scale":[2,1,4],"rotation":[0,0,1,1]})";
  file.meshes = R"({"primitives":[{"attributes":{"POSITION":0,"NORMAL":2,"TEXCOORD_0":3},"indices":1},
{"attributes":{"POSITION":0},"indices":1}]})";
  file.add_floats({1, 0, 0, 0, 3, 0, 0, 0, 1, 0, 0, NAN}, 3);
  file.add(whole({0, 255, 51, 0, 1, 1, 2, 2}, 1), 5121, "VEC2", 4, R"(,"normalized":true)");
  const io::Imported read = import_text(file.text());
  REQUIRE(read.scene.size() == 4);
  const auto normals = read.scene.vertex_normals(*read.scene.find("m.gltf:1"));
  REQUIRE(normals);
  CHECK(*normals == scene::VertexNormals{{{0, 0.5, 0}, {-3, 0, 0}, {0, 0, 0.25}}});
  CHECK_FALSE(read.scene.vertex_normals(*read.scene.find("m.gltf:2")));
  CHECK_FALSE(read.scene.vertex_normals(*read.scene.find("m.gltf:3")));
  const auto wrap = read.scene.wrap(*read.scene.find("m.gltf:1"));
  REQUIRE(wrap);
  CHECK(wrap->uv == std::array<glm::dvec2, 3>{{{0, 0}, {51 / 255.0, 1}, {1 / 255.0, 254 / 255.0}}});
  CHECK_FALSE(read.scene.wrap(*read.scene.find("m.gltf:3")));
  CHECK(read.lost == std::vector<std::string>{"1 triangle kept flat: a normal at a vertex has no direction"});

  file.nodes = R"({"mesh":0,"scale":[2,1,0]})";  // no inverse
  CHECK(import_text(file.text()).lost ==
        std::vector<std::string>{"2 triangles kept flat: a normal at a vertex has no direction"});
}

TEST_CASE("a triangle is in the group of its node, of its mesh, or of the nearest node above") {
  File file = sample();
  file.nodes = R"({"name":"root","children":[1,2,3]},{"mesh":0,"name":"leaf"},{"mesh":0,"name":"a leaf"},{"mesh":1})";
  file.meshes += R"(,{"name":"own","primitives":[{"attributes":{"POSITION":0},"indices":1}]})";
  const io::Imported read = import_text(file.text());
  CHECK(read.groups.of_element("m.gltf:1") == "leaf");
  CHECK(read.groups.of_element("m.gltf:3") == "root");
  CHECK(read.groups.of_element("m.gltf:6") == "own");
  CHECK(read.groups.table().size() == 3);
  CHECK(read.groups.of_group("root").empty());
  CHECK(read.groups.of_group("leaf") == "root");
  CHECK(read.groups.of_group("own") == "root");
  CHECK(read.lost ==
        std::vector<std::string>{"1 name of a node or a mesh left out: expected 1 to 128 of A-Z a-z 0-9 _ . : -"});
  file.nodes = R"({"name":"root","children":[1,2]},{"name":"empty"},{"mesh":1,"name":"n"})";
  const io::Imported other = import_text(file.text());
  CHECK(other.groups.of_group("n") == "root");
  CHECK(other.lost == std::vector<std::string>{"1 mesh left out: no node of the scene shows it",
                                               "1 name of a mesh left out: the triangles are in the group of its node",
                                               "1 group left out: no triangle is in it"});
}

TEST_CASE("nodes of one name are one group, where the first of them is") {
  File file = sample();
  file.nodes = R"({"name":"a","children":[1,2]},{"name":"b","children":[3]},{"name":"c","children":[4,5]},
{"mesh":0,"name":"n"},{"mesh":0,"name":"n"},{"mesh":0,"name":"c","children":[6]},{"mesh":0,"name":"a"})";
  const io::Imported read = import_text(file.text());
  CHECK(read.groups.of_group("n") == "b");
  CHECK(read.groups.of_group("b") == "a");
  CHECK(read.groups.of_group("c") == "a");
  CHECK(read.groups.of_element("m.gltf:1") == "n");
  CHECK(read.groups.of_element("m.gltf:3") == "n");
  CHECK(read.groups.of_element("m.gltf:5") == "c");
  CHECK(read.groups.of_element("m.gltf:7") == "a");
  CHECK(read.lost == std::vector<std::string>{"2 places of nodes left out: another of the same name is elsewhere"});
}

TEST_CASE("what no scene keeps of a glTF is counted") {
  File file = sample();
  file.nodes = R"({"mesh":0,"skin":0,"camera":0},{"mesh":0})";
  file.meshes = R"({"primitives":[{"attributes":{"POSITION":0,"COLOR_0":0,"_OWN":0},"indices":1,"material":0,
"targets":[{},{}]},{"attributes":{"POSITION":0},"mode":0},{"attributes":{}}]},{"primitives":[]})";
  file.more = R"(,"animations":[{}],"cameras":[{},{}],"extensionsUsed":["KHR_mesh_quantization","KHR_\"x"],
"extensionsRequired":["KHR_mesh_quantization"],"unknown":[1,{"a":[]}])";
  const io::Imported read = import_text(file.text());
  CHECK(triangles(read) == square_triangles());
  CHECK(read.lost ==
        std::vector<std::string>{
            "1 node left out: the scene has none of them", "1 mesh left out: no node of the scene shows it",
            "1 primitive of points or lines left out: no triangles", "1 primitive left out: without positions",
            "2 attributes of primitives left out: a triangle has positions, normals and one uv",
            "1 use of a material left out: a scene has none of this kind",
            "2 morph targets left out: a triangle keeps its form",
            "1 skin of a node left out: a mesh stands as its node places it", "1 animation left out: nothing moves",
            "2 cameras left out: a mesh has none", "1 extension left out: \"KHR_\"x\""});
}

TEST_CASE("the scene that a file names is read, else its first, else the nodes that are in no other") {
  const auto read = [](std::string_view scenes) {
    std::string text = sample().text();
    const std::string_view before = R"("scenes":[{"nodes":[0]}])";
    text.replace(text.find(before), before.size(), scenes);
    const std::string_view node = R"("nodes":[{"mesh":0}])";
    text.replace(text.find(node), node.size(), R"("nodes":[{"mesh":0},{"children":[0],"translation":[0,0,7]}])");
    const io::Imported imported = import_text(text);
    return std::pair(triangles(imported)[0][0].z, imported.lost.empty() ? "" : imported.lost[0]);
  };
  const std::string other = "1 scene left out: one of a file is read";
  CHECK(read(R"("scenes":[{"nodes":[0]},{"nodes":[1]}])") == std::pair(0.0, other));
  CHECK(read(R"("scene":1,"scenes":[{"nodes":[0]},{"nodes":[1]}])") == std::pair(7.0, other));
  CHECK(read(R"("scenes":[])").first == 7);
}

TEST_CASE("a buffer is a file beside the glTF, or beneath its folder") {
  const test::Folder folder;
  const File file = sample();
  const auto read = [&](const std::string& uri) {
    return io::read_gltf(io::Source(folder.file("m.gltf"), file.text("\"uri\":\"" + uri + "\",")));
  };
  std::filesystem::create_directory(folder.file("in"));
  for (const std::string name : {"a b.bin", "in/c.bin"}) {
    io::OutputFile out(folder.file(name));
    out.write(file.bytes + "more");
    out.commit();
  }
  CHECK(triangles(read("a%20b.bin")) == square_triangles());
  CHECK(triangles(read("a b.bin")) == square_triangles());
  CHECK(triangles(read("./in/c.bin")) == square_triangles());
  const std::string place = folder.file("m.gltf") + ":9:19: ";
  CHECK_THROWS_WITH(read("none.bin"),
                    place + "uri is \"none.bin\": No such file or directory; expected a readable file");
  CHECK_THROWS_WITH(read("in"), place + "uri is \"in\": Is a directory; expected a readable file");
  for (const std::string uri :
       {"/etc/passwd", "../a.bin", "in/../../a", "%2e%2e/a", "http://a/b", "a:b", "", "%2", "%zz"})
    CHECK_THROWS_WITH(read(uri), place + "uri is \"" + uri +
                                     "\"; expected a file in the folder of the scene or beneath it, or data:");
}

TEST_CASE("a malformed glTF is refused where it stands") {
  const auto wrong = [](std::string_view old, std::string_view with_mark) {
    std::string text = sample().text();
    const std::size_t at = text.find(old);
    REQUIRE(at != text.npos);
    return error_at(text.replace(at, old.size(), with_mark));
  };
  using Case = std::array<std::string_view, 3>;
  const Case cases[] = {
      {R"("2.0")", R"(^"1.0")", R"(version "1.0" of glTF; expected "2.0")"},
      {R"("2.0")", R"(^"20.0")", R"(version "20.0" of glTF; expected "2.0")"},
      {R"("2.0")", R"(^2.0)", R"(version is a number; expected a string)"},
      {R"("2.0")", R"("2.0","minVersion":^"2.1")", R"(minVersion is "2.1"; expected "2.0")"},
      {R"("scenes":[{)", R"("scene":^1,"scenes":[{)", R"(scene is 1; expected one of 1, counted from 0)"},
      {R"("nodes":[0])", R"("nodes":[^1])", R"(nodes is 1; expected one of 1, counted from 0)"},
      {R"("nodes":[0])", R"("nodes":[0,^0])",
       R"(node 0 stands a second time in the scene; expected it once: nodes are a forest)"},
      {R"([{"nodes":[0]}])", R"([^7])", R"(an item of scenes is a number; expected an object)"},
      {R"({"mesh":0})", R"({"children":[^0]})",
       R"(node 0 stands a second time in the scene; expected it once: nodes are a forest)"},
      {R"({"mesh":0})", R"(^7)", R"(an item of nodes is a number; expected an object)"},
      {R"("mesh":0)", R"("mesh":^1)", R"(mesh is 1; expected one of 1, counted from 0)"},
      {R"("mesh":0)", R"("mesh":^0.5)", R"(mesh is 0.5; expected one of 1, counted from 0)"},
      {R"("mesh":0)", R"("mesh":0,"rotation":^[0,0,0,0])", R"(rotation is 0; expected a quaternion x y z w)"},
      {R"("mesh":0)", R"("mesh":0,"rotation":^[0,0,0,1,1])", R"(rotation has 5 items; expected 4 numbers)"},
      {R"("mesh":0)", R"("mesh":0,"matrix":^[1,0,0,1,0,1,0,0,0,0,1,0,0,0,0,1])",
       R"(the last row of matrix is not 0 0 0 1; expected that of an affine map)"},
      {R"("mesh":0)", R"("mesh":0,"matrix":[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],"scale":^[1,1,1])",
       R"(a node with a matrix and parts of one; expected matrix, or translation, rotation and scale)"},
      {R"({"mesh":0})", R"(^{"mesh":0,"scale":[1e308,1,1],"translation":[1e308,0,0]})",
       R"(node 0 places a vertex beyond binary64; expected finite coordinates)"},
      {R"({"primitives":[)", R"(^3,{"primitives":[)", R"(an item of meshes is a number; expected an object)"},
      {R"({"attributes":{"POSITION":0},"indices":1})", R"(^3)",
       R"(an item of primitives is a number; expected an object)"},
      {R"({"attributes":{"POSITION":0},"indices":1})", R"(^{"attributes":{"POSITION":0}})",
       R"(a primitive of 4 corners; expected a multiple of 3, or 3 or more of a strip or a fan)"},
      {R"("POSITION":0)", R"("POSITION":^2)", R"(POSITION is 2; expected one of 2, counted from 0)"},
      {R"("indices":1)", R"("indices":1,"mode":^7)", R"(mode is 7; expected 0 to 6)"},
      {R"("indices":1)", R"("indices":^"1")", R"(indices is a string; expected a number)"},
      {R"({"bufferView":0,"componentType":5126)", R"(^{"componentTyp":5126)",
       R"(accessor 0 lacks a key; expected componentType, type and count)"},
      {R"("componentType":5126)", R"("componentType":^5124)",
       R"(componentType is 5124; expected one of 5120, 5121, 5122, 5123, 5125, 5126)"},
      {R"("type":"VEC3")", R"("type":^"VEC5")",
       R"(type is "VEC5"; expected one of SCALAR, VEC2, VEC3, VEC4, MAT2, MAT3, MAT4)"},
      {R"({"bufferView":0,"componentType":5126,"type":"VEC3")",
       R"(^{"bufferView":0,"componentType":5126,"type":"MAT3")",
       R"(accessor 0 is MAT3 of float; expected VEC3 of float, bytes or shorts)"},
      {R"({"bufferView":0,"componentType":5126)", R"(^{"bufferView":0,"componentType":5125)",
       R"(accessor 0 is VEC3 of unsigned int; expected VEC3 of float, bytes or shorts)"},
      {R"({"bufferView":0,"componentType":5126)", R"(^{"normalized":true,"bufferView":0,"componentType":5126)",
       R"(accessor 0 has a float that is normalized; expected bytes or shorts)"},
      {R"("count":4)", R"("count":^0)", R"(count is 0; expected a whole number from 1 to 2^53)"},
      {R"({"bufferView":0,"componentType":5126,"type":"VEC3","count":4)",
       R"(^{"bufferView":0,"componentType":5126,"type":"VEC3","count":5)",
       R"(accessor 0 needs 60 bytes from 0 on of bufferView 0, which has 48; expected it within its view)"},
      {R"({"bufferView":0,"componentType":5126)", R"(^{"byteOffset":1,"bufferView":0,"componentType":5126)",
       R"(accessor 0 needs 48 bytes from 1 on of bufferView 0, which has 48; expected it within its view)"},
      {R"({"bufferView":0,"componentType":5126,"type":"VEC3","count":4)",
       R"(^{"componentType":5126,"type":"VEC3","count":1048577)",
       R"(accessor 0 has 1048577 elements and no bufferView; expected 1048576 at most)"},
      {R"({"bufferView":1,"componentType":5123)", R"(^{"bufferView":1,"componentType":5122)",
       R"(accessor 1 is SCALAR of short; expected SCALAR of unsigned byte, short or int)"},
      {R"({"bufferView":1,"componentType":5123)", R"(^{"normalized":true,"bufferView":1,"componentType":5123)",
       R"(accessor 1 is normalized SCALAR of unsigned short; expected SCALAR of unsigned byte, short or int)"},
      {R"("count":4},
{"bufferView":1)",
       R"("count":3},
^{"bufferView":1)",
       R"(accessor 1 names vertex 3 in element 5, counted from 0; expected one of 3, and not the greatest number of its type)"},
      {R"({"bufferView":1,"componentType":5123)", R"(^{"byteOffset":2,"bufferView":1,"componentType":5123)",
       R"(accessor 1 needs 12 bytes from 2 on of bufferView 1, which has 12; expected it within its view)"},
      {R"("count":6)", R"("count":6,"sparse":^{"count":1})",
       R"(a sparse accessor without indices or values; expected a bufferView of each, and indices of componentType 5121, 5123 or 5125)"},
      {R"("count":6)",
       R"("count":6,"sparse":^{"count":2,"indices":{"bufferView":1,"componentType":5123,"byteOffset":4},"values":{"bufferView":1}})",
       R"(index 1 of a sparse accessor is 0; expected numbers below 6 that ascend)"},
      {R"({"buffer":0,"byteOffset":0,"byteLength":48})", R"(^{})",
       R"(an item of bufferViews without buffer; expected one)"},
      {R"({"buffer":0,"byteOffset":0,"byteLength":48})", R"(^{"buffer":0,"byteOffset":48,"byteLength":13})",
       R"(a view of bytes 48 to 61 of buffer 0, which has 60; expected one within its buffer)"},
      {R"("byteLength":48)", R"("byteLength":48,"byteStride":^3)", R"(byteStride is 3; expected 4 to 252)"},
      {R"("byteLength":60)", R"("byteLength":^6.5)", R"(byteLength is 6.5; expected a whole number up to 2^53)"},
      {R"({"uri")", R"(^{"url")",
       R"(buffer 0 without bytes; expected a uri, or in a GLB file the chunk behind the JSON for the first)"},
      {R"("byteLength":60}])", R"("byteLength":60}],"extensionsRequired":[^"KHR_draco_mesh_compression"])",
       R"(the file needs the extension "KHR_draco_mesh_compression"; expected none but KHR_mesh_quantization: neither compressed meshes nor others are read)"},
      {R"("byteLength":60}])", R"("byteLength":60}]^])", R"("]" stands here; expected , or } after a member)"},
  };
  for (const auto& [old, with_mark, expected] : cases) {
    INFO(with_mark);
    CHECK(wrong(old, with_mark) == expected);
  }
  const std::string beginning = "\"buffers\":[{";
  std::string longer = sample().text();
  longer.replace(longer.rfind(":60"), 3, ":61").insert(longer.find(beginning) + beginning.size() - 1, "^");
  CHECK(error_at(longer) == "buffer 0 has 60 bytes; expected the 61 of its byteLength");
  CHECK(error_at("^[1]") == "a glTF file is an array; expected an object");
  CHECK(error_at("^{\"asset\":{}}") ==
        "no version in the asset of a glTF file; expected \"asset\":{\"version\":\"2.0\"}");
  CHECK(error_at("{\"asset\":{\"version\":\"2.0\"}}^") == "no mesh; expected triangles");
  for (const std::string_view bad : {R"(^"data:;base64)", R"(^"data:,)", R"(^"data:;base64,*)", R"(^"data:;base64,A)"})
    CHECK(wrong(R"("data:application/octet-stream;base64,)", bad).ends_with("expected bytes in base64 behind data:"));
}

TEST_CASE("accessors that do not suit each other are refused") {
  const auto error = [](const File& file) { return test::error_of(file.text(), reading); };
  File file = sample();
  file.meshes = R"({"primitives":[{"attributes":{"POSITION":0,"NORMAL":2},"indices":1}]})";
  file.add_floats({0, 0, 1}, 3);
  CHECK(error(file) == "f:7:1: accessor 2 has 1 elements; expected 4, one for each position");
  file.meshes = R"({"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":2},"indices":1}]})";
  CHECK(error(file) == "f:7:1: accessor 2 is VEC3 of float; expected VEC2 of float, bytes or shorts");
  file.add_floats({0, 0, 1, 0, 1, INFINITY, 0, 0}, 2);
  file.meshes = R"({"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":3},"indices":1}]})";
  CHECK(error(file) ==
        "f:8:1: accessor 3 has a number that is not finite in element 2, counted from 0; expected finite numbers");
  file.add_floats({0, 0, 0, 0, NAN, 0, 0, 0, 0, 0, 0, 0}, 3);
  file.meshes = R"({"primitives":[{"attributes":{"POSITION":4},"indices":1}]})";
  CHECK(error(file) ==
        "f:9:1: accessor 4 has a number that is not finite in element 1, counted from 0; expected finite numbers");
  file.meshes = R"({"primitives":[{"attributes":{"POSITION":0},"indices":2,"mode":5}]})";
  CHECK(error(file) == "f:7:1: accessor 2 is VEC3 of float; expected SCALAR of unsigned byte, short or int");

  File great = sample();
  great.add(std::string(256 * 3, '\0'), 5121, "VEC3", 256);
  great.add(whole({0, 254, 255}, 1), 5121, "SCALAR", 3);
  great.meshes = R"({"primitives":[{"attributes":{"POSITION":2},"indices":3}]})";
  CHECK(error(great) ==
        "f:8:1: accessor 3 names vertex 255 in element 2, counted from 0; expected one of 256, and not "
        "the greatest number of its type");
  great.accessors[3] = R"({"bufferView":3,"componentType":5121,"type":"SCALAR","count":2})";
  great.meshes = R"({"primitives":[{"attributes":{"POSITION":2},"indices":3,"mode":6}]})";
  CHECK(error(great) == "f:4:26: a primitive of 2 corners; expected a multiple of 3, or 3 or more of a strip or a fan");

  File packed = sample();
  packed.accessors[0] = R"({"componentType":5126,"type":"VEC3","count":4})";
  packed.meshes = R"({"primitives":[{"attributes":{"POSITION":0},"extensions":{"KHR_draco_mesh_compression":{}}}]})";
  CHECK(error(packed) == "f:4:98: a primitive that is compressed; expected one that is not");
  packed.views[0] = R"({"buffer":0,"byteLength":48,"byteStride":8})";
  packed.accessors[0] = R"({"bufferView":0,"componentType":5126,"type":"VEC3","count":4})";
  CHECK(error(packed) == "f:5:14: accessor 0 has elements of 12 bytes and a stride of 8; expected a longer stride");
}

TEST_CASE("nodes are as deep as exact maps allow") {
  const auto chain = [](std::size_t deep) {
    File file = sample();
    file.nodes.clear();
    for (std::size_t i = 1; i < deep; ++i) file.nodes += fmt::format(R"({{"children":[{}],"scale":[2,2,2]}},)", i);
    file.nodes += R"({"mesh":0})";
    return file.text();
  };
  CHECK(triangles(import_text(chain(256)))[0][2].x == std::ldexp(1.0, 255));
  CHECK(test::error_of(chain(257), reading).ends_with("node 256 is in 256 others; expected 255 at most"));
}

TEST_CASE("a malformed GLB is refused, with the byte of its chunk") {
  const std::string whole = sample().binary();
  const auto error = [](const std::string& text) { return test::error_of(text, reading); };
  const auto with = [&](std::size_t at, const std::string& bytes) {
    return std::string(whole).replace(at, bytes.size(), bytes);
  };
  CHECK(error("glTF") == "f:1:1: the file ends in the header of a GLB file; expected 12 bytes");
  CHECK(error(with(4, number_bytes(1, 4))) == "f:1:1: version 1 of GLB; expected 2");
  CHECK(error(whole + "x") ==
        fmt::format("f:1:1: a GLB file of {} bytes says that it has {}; expected the bytes that it says",
                    whole.size() + 1, whole.size()));
  CHECK(error(with(12, number_bytes(0xffffffff, 4))) ==
        "f:1:1: the file ends in the chunk at byte 12; expected a length, a type and as many bytes");
  CHECK(error(with(16, "json")) == "f:1:1: the chunk at byte 12 is not JSON; expected the JSON of a glTF file");
  CHECK(error(with(8, number_bytes(16, 4)).substr(0, 16)) ==
        "f:1:1: the file ends in the chunk at byte 12; expected a length, a type and as many bytes");
  const std::size_t second = whole.find("BIN") - 4;
  CHECK(error(with(second + 4, "BOX"))
            .find("buffer 0 without bytes; expected a uri, or in a GLB file the chunk behind the "
                  "JSON for the first") != std::string::npos);
}

TEST_CASE("no damage to glTF does worse than an error") {
  CHECK(test::refused_after_damage(sample().text(), 20000, reading) > 5000);
  CHECK(test::refused_after_damage(sample().binary(), 20000, reading) > 5000);
}
