#include "durero/io/mesh/obj.hpp"

#include <fmt/format.h>

#include "durero/io/json/scene_file.hpp"
#include "io/malformed.hpp"
#include "support/catch.hpp"

using namespace durero;

namespace {

const auto reading = [](const io::Source& s) { return io::read_obj(s); };
std::string error_at(const std::string& with_mark) { return test::error_at_mark(with_mark, reading); }
io::Imported import_text(const std::string& text, const std::string& name = "f") {
  return io::read_obj(io::Source(name, text));
}

constexpr auto sample = R"(# a sheet
mtllib sheet.mtl
o sheet
v 0 0 0
v 2 0 0 1
v 2 1 0 0.5 0.5 0.5
v 1 1 0
vn 0 0 1
vt 0.5 0.5
vt 1 1
v 1 2 0
v 0 2 0
usemtl red
s off
f 1/1/1 2/2/1 3//1 4 5/1 6
f -6 -5 -1  # by distance
f 1 4 1
f 1 3 2 6
)";

}  // namespace

TEST_CASE("The faces of an OBJ become triangles, named by file and number") {
  const io::Imported i = import_text(sample, "folder/sheet.obj");
  CHECK(io::scene_text(i.scene) == R"({"format":"durero-scene","version":1,
"elementos":[
{"id":"sheet.obj:1","tipo":"triangulo","vertices":[[0,0,0],[2,0,0],[1,1,0]]},
{"id":"sheet.obj:2","tipo":"triangulo","vertices":[[0,0,0],[1,1,0],[0,2,0]]},
{"id":"sheet.obj:3","tipo":"triangulo","vertices":[[2,0,0],[2,1,0],[1,1,0]]},
{"id":"sheet.obj:4","tipo":"triangulo","vertices":[[1,1,0],[1,2,0],[0,2,0]]},
{"id":"sheet.obj:5","tipo":"triangulo","vertices":[[0,0,0],[2,0,0],[0,2,0]]}
]}
)");
  const scene::Names all{"sheet.obj:1", "sheet.obj:2", "sheet.obj:3", "sheet.obj:4", "sheet.obj:5"};
  CHECK(i.groups.table() == scene::Groups::Table{{"sheet", {all, {}}}});
  CHECK(i.lost == std::vector<std::string>{"1 normal left out: no face has them at all of its corners",
                                           "2 texture coordinates left out: no face has them at all of its corners",
                                           "2 weights or colours of vertices left out: a scene has none",
                                           "2 uses of materials left out: OBJ keeps them in another file",
                                           "1 other statement left out: no vertex, no face",
                                           "1 triangle left out: the vertices lie on one line",
                                           "1 polygon left out: edges touch or cross"});
}

TEST_CASE("OBJ is read alike however its lines end and its words stand apart") {
  const std::string wanted = io::scene_text(import_text(sample).scene);
  std::string cr = sample, crlf, tabs = sample;
  for (char& c : cr) {
    crlf += c == '\n' ? std::string("\r\n") : std::string(1, c);
    if (c == '\n') c = '\r';
  }
  for (char& c : tabs)
    if (c == ' ') c = '\t';
  CHECK(io::scene_text(import_text(cr).scene) == wanted);
  CHECK(io::scene_text(import_text(crlf).scene) == wanted);
  CHECK(io::scene_text(import_text(tabs).scene) == wanted);
}

TEST_CASE("A coordinate of OBJ is the binary64 nearest to what is written") {
  const io::Imported i = import_text(
      "v 0.1 1e23 9007199254740993\n"
      "v 2.2250738585072011e-308 1e-999 179769313486231570814527423731704356798070567525844996598917e249\n"
      "v 0.500000000000000166533453693773481063544750213623046875 +1.5 -.5E1\n"
      "f 1 2 3\n");
  const scene::Corners& v = i.scene.shapes<scene::Triangle>()[0].vertices;
  CHECK(v[0] == glm::dvec3(0.1, 1e23, 9007199254740992));
  CHECK(v[1] == glm::dvec3(2.2250738585072011e-308, 0, 0x1.fffffffffffffp1023));
  CHECK(v[2] == glm::dvec3(0.5000000000000002, 1.5, -5));
}

TEST_CASE("A file's name that no element could have is changed, and that is said") {
  const std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  const io::Imported spaced = import_text(text, "a folder/my ñ.obj");
  CHECK(spaced.scene.find("my___.obj:1").has_value());
  CHECK(spaced.lost == std::vector<std::string>{"elements are named my___.obj: not every file's name can be theirs"});
  const std::string most(117, 'x'), first = most + ":1";
  const io::Imported longest = import_text(text, most);
  CHECK(longest.scene.find(first).has_value());
  CHECK(longest.lost.empty());
  const io::Imported longer = import_text(text, most + "x");
  CHECK(longer.scene.find(first).has_value());
  CHECK(longer.lost.size() == 1);
}

TEST_CASE("A face whose corners all have normals is smooth; they may stand below it, and be none") {
  const io::Imported i = import_text(R"(v 0 0 0
v 2 0 0
v 2 2 0
v 0 2 0
f 1//1 2//2 3//1 4//1
vn 0 0 1
vn 1 0 2
f 1//-1 2//-2 3//1
f 1//2 2//2 3
vn 0 nan 0
f 1//1 2//3 3//1
)",
                                     "m");
  const auto normals = [&](const char* name) { return i.scene.vertex_normals(i.scene.find(name).value()); };
  REQUIRE(normals("m:1"));
  CHECK(*normals("m:1") == scene::VertexNormals{{{0, 0, 1}, {1, 0, 2}, {0, 0, 1}}});
  CHECK(*normals("m:2") == scene::VertexNormals{{{1, 0, 2}, {0, 0, 1}, {0, 0, 1}}});
  CHECK(*normals("m:3") == scene::VertexNormals{{{1, 0, 2}, {0, 0, 1}, {0, 0, 1}}});
  CHECK_FALSE(normals("m:4"));
  CHECK_FALSE(normals("m:5"));
  CHECK(i.lost == std::vector<std::string>{"1 triangle kept flat: a normal at a vertex has no direction"});
}

TEST_CASE("Names of groups and objects are groups of the triangles that follow, one of each name") {
  // As a modelling program writes two objects, of which the second has faces of two materials.
  const io::Imported i = import_text(R"(# www.example.org
mtllib rooms.mtl
o Floor_Plane.001
v -1 0 1
v 1 0 1
v -1 0 -1
v 1 0 -1
vn 0 1 0
usemtl Wood
s off
f 1//1 2//1 4//1 3//1
o Lamp
v 0 2 0
v 0.5 2 0
v 0 2 0.5
v 0 3 0
g Lamp_Shade upper all
usemtl Paper
f 5 6 8
f 6 7 8
f 5 5 6
g Lamp_Base
f 5 7 6
g
f 7 5 8
g Lamp_Shade
f -4 -1 -2
g a+b
f 1 2 3
o Nothing_of_it
)",
                                     "rooms.obj");
  const scene::Groups::Table expected{
      {"Floor_Plane.001", {{"rooms.obj:1", "rooms.obj:2"}, {}}},
      {"Lamp_Base", {{"rooms.obj:6"}, {}}},
      {"Lamp_Shade", {{"rooms.obj:3", "rooms.obj:4", "rooms.obj:8"}, {}}},
  };
  CHECK(i.groups.table() == expected);
  CHECK(i.scene.find("rooms.obj:7").has_value());
  CHECK(i.scene.find("rooms.obj:9").has_value());
  CHECK(i.lost == std::vector<std::string>{
                      "3 uses of materials left out: OBJ keeps them in another file",
                      "1 name of a group left out: expected 1 to 128 of A-Z a-z 0-9 _ . : -",
                      "2 further names of groups left out: a triangle is in one group",
                      "1 other statement left out: no vertex, no face",
                      "1 triangle left out: the vertices lie on one line",
                      "2 groups left out: no triangle is in it",
                  });
}

TEST_CASE("Where each corner of a face names a texture coordinate, so do the vertices of its triangles") {
  const io::Imported i = import_text(R"(v 0 0 0
v 2 0 0
v 2 1 0
v 0 1 0
vt 0 0
vt 1
f 1/1 2/2 3/3 4/4  # which stand below, two of them
vt 1 0.5 7
vt 0 0.5
f 1/-4 2/-3 3/3
f 1/1 2 3/3
vt 9 9
)",
                                     "sheet.obj");
  const auto uv = [&](const char* name) {
    const auto wrap = i.scene.wrap(*i.scene.find(name));
    return wrap ? wrap->uv : std::array<glm::dvec2, 3>();
  };
  // Of a rectangle of half the height (u, v) of a point is half of x, and half of y, whichever way it is cut.
  for (const char* const name : {"sheet.obj:1", "sheet.obj:2", "sheet.obj:3"}) {
    const auto& vertices = i.scene.shapes<scene::Triangle>()[i.scene.find(name)->index].vertices;
    for (std::size_t k = 0; k < 3; ++k) CHECK(uv(name)[k] == glm::dvec2(vertices[k].x / 2, vertices[k].y / 2));
  }
  CHECK_FALSE(i.scene.wrap(*i.scene.find("sheet.obj:4")));
  CHECK(i.lost == std::vector<std::string>{"1 texture coordinate left out: no face has them at all of its corners"});
}

TEST_CASE("What OBJ says besides faces is left out, line by line, and counted") {
  // As programs of modelling, of animation and of subdivision write it.
  const io::Imported i = import_text(R"(v 0 0 0 nan inf -nan
v 1 0 0
v 0 1 0
fo 1 2 3
l 1 2 3
l 1/1 2/2
p 1 2
mg 1 0.5
maplib textures.map
vw 0 1 0.5
t crease 2/1/0 0 1 4.0
curv2 1 2 3
f 1 3 2
)");
  CHECK(i.scene.size() == 2);
  CHECK(i.lost == std::vector<std::string>{"1 weight or colour of a vertex left out: a scene has none",
                                           "8 other statements left out: no vertex, no face"});
}

TEST_CASE("A line of OBJ goes on behind a backslash at its end, and a corner need not name what it leaves open") {
  const std::string wanted = io::scene_text(import_text("v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\nf 3 2 1\n").scene);
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    std::string
        text = "v 0 0 \\\n0\nv 1 \\\n  0\\\n 0\n# C:\\meshes\\\nv 1 1 0 # no more \\\nf 1// \\\n2// 3//\nf 3/ 2/ 1/\n",
        lines;
    for (const char c : text) lines += c == '\n' ? end : std::string(1, c);
    const io::Imported i = import_text(lines);
    CHECK(io::scene_text(i.scene) == wanted);
    CHECK(i.lost.empty());
  }
}

TEST_CASE("A face of OBJ may name vertices below it, and its line may end in a comment") {
  const std::string vertices = "v 0 0 0\nv 1 0 0\n\tv 0 1 0#3\n";
  const std::string wanted = io::scene_text(import_text(vertices + "f 1 2 3\n").scene);
  CHECK(io::scene_text(import_text("f 1 2 3\n" + vertices).scene) == wanted);
  CHECK(io::scene_text(import_text(vertices + "f 1 2 3#c\n").scene) == wanted);
  CHECK(io::scene_text(import_text(vertices + "f 1 2 3 #c 1\n").scene) == wanted);
  CHECK(io::scene_text(import_text(vertices + "vt 0\nf 1/" + std::string(300, '0') + "1 2 3\n").scene) == wanted);
}

TEST_CASE("A malformed OBJ file is an error with its place") {
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\n",
                    statements =
                        "v, f, fo, vn, vt, o, g, usemtl, mtllib, p, l, s, mg, vp, vw, t, bevel, c_interp, d_interp, "
                        "lod, maplib, usemap, shadow_obj, trace_obj, ctech, stech, cstype, deg, bmat, step, curv, "
                        "curv2, surf, parm, trim, hole, scrv, sp, end, con, bsp, bzp, cdc, cdp, res";
  using Case = std::pair<std::string, std::string>;
  const Case cases[] = {
      {"^", "no mesh; expected vertices (v) and faces (f)"},
      {vertices + "^", "no mesh; expected vertices (v) and faces (f)"},
      {"v 0 0 0\nv 1 0 0\nv 0 1 ^", "\"\" in v; expected a finite decimal number"},
      {"v 0 ^x 0", "\"x\" in v; expected a finite decimal number"},
      {"v 0 ^0x 0", "\"0x\" in v; expected a finite decimal number"},
      {vertices + "v 0 0 ^3abc\nf 1 2 3", "\"3abc\" in v; expected a finite decimal number"},
      {vertices + "v 0 0 ^0x1p3\nf 1 2 3", "\"0x1p3\" in v; expected a finite decimal number"},
      {vertices + "v ^0x1p3 0 0\nf 1 2 3", "\"0x1p3\" in v; expected a finite decimal number"},
      {vertices + "v 0 0^", "\"\" in v; expected a finite decimal number"},
      {vertices + "v 0 0 ^1e999\nf 1 2 3", "\"1e999\" in v; expected a finite decimal number"},
      {vertices + "v 0 0 ^nan\nf 1 2 3", "\"nan\" in v; expected a finite decimal number"},
      {vertices + "v 0 0 0 1 1 1 ^x\nf 1 2 3", "\"x\" in v; expected a number"},
      {vertices + "v 0 0 0 1 1 1 1 ^1\nf 1 2 3",
       "an eighth number in v; expected x y z, a weight and a colour at most"},
      {vertices + "^f 1 2", "a face of 2 vertices; expected 3 or more"},
      {vertices + "^f", "a face of 0 vertices; expected 3 or more"},
      {vertices + "f 1 2 ^4", "\"4\" names no vertex; expected 1 to 3, or a distance back to one above"},
      {vertices + "f 1 2 ^-4", "\"-4\" names no vertex; expected 1 to 3, or a distance back to one above"},
      {vertices + "vt ^x\nf 1 2 3", "\"x\" in vt; expected a finite number"},
      {vertices + "vt ^\nf 1 2 3", "\"\" in vt; expected a finite number"},
      {vertices + "vt 1 2 3 ^4\nf 1 2 3", "a fourth number in vt; expected u, v and a third at most"},
      {vertices + "vt 0 0\nf 1/1 2/1 ^3/2",
       "\"3/2\" names no texture coordinate; expected 1 to 1, or a distance back to one above"},
      {vertices + "vt 0 0\nf 1/1 2/1 ^3/-2",
       "\"3/-2\" names no texture coordinate; expected 1 to 1, or a distance back to one above"},
      {vertices + "f 1 2 ^0\nv 0 0 0\n",
       "\"0\" in f; expected v, v/vt, v//vn or v/vt/vn, of whole numbers other than 0"},
      {vertices + "f 1 2 ^3//1", "\"3//1\" names no normal; expected a vn before it: there is none"},
      {vertices + "vn 0 0 1\nf 1 2 ^3//2",
       "\"3//2\" names no normal; expected 1 to 1, or a distance back to one above"},
      {vertices + "vn 0 0 ^x", "\"x\" in vn; expected a number"},
      {vertices + "vn 0 0 1 ^2", "a fourth number in vn; expected x y z"},
      {vertices + "f 1 2 ^x", "\"x\" in f; expected v, v/vt, v//vn or v/vt/vn, of whole numbers other than 0"},
      {vertices + "f 1 2 3 ^x", "\"x\" in f; expected v, v/vt, v//vn or v/vt/vn, of whole numbers other than 0"},
      {vertices + "f 1 2 ^3.5", "\"3.5\" in f; expected v, v/vt, v//vn or v/vt/vn, of whole numbers other than 0"},
      {vertices + "f 1 2 ^/3", "\"/3\" in f; expected v, v/vt, v//vn or v/vt/vn, of whole numbers other than 0"},
      {vertices + "f 1 2 ^3///", "\"3///\" in f; expected v, v/vt, v//vn or v/vt/vn, of whole numbers other than 0"},
      {vertices + "f 1 2 ^3/1/1/1",
       "\"3/1/1/1\" in f; expected v, v/vt, v//vn or v/vt/vn, of whole numbers other than 0"},
      {vertices + "f 1 2 ^99999999999",
       "\"99999999999\" in f; expected v, v/vt, v//vn or v/vt/vn, of whole numbers other than 0"},
      {vertices + "f 1 2 ^\\ 3", "\"\\\" in f; expected v, v/vt, v//vn or v/vt/vn, of whole numbers other than 0"},
      {vertices + "f 1 2 3 ^\\", "\"\\\" in f; expected v, v/vt, v//vn or v/vt/vn, of whole numbers other than 0"},
      {vertices + "f \\\n1 \\\r\n2 \\\r^x",
       "\"x\" in f; expected v, v/vt, v//vn or v/vt/vn, of whole numbers other than 0"},
      {vertices + "f 1 2 3\nv 1 \\\n1 \\\n^x", "\"x\" in v; expected a finite decimal number"},
      {vertices + "# \\\n^face", "unknown statement \"face\"; expected one of " + statements},
      {vertices + "^f 1 2 3#c 1", "f with numbers in a comment; expected spaces before a comment"},
      {vertices + "^f 1 2 3#4 2//1 1", "f with numbers in a comment; expected spaces before a comment"},
      {vertices + "f 1 2 ^2147483648",
       "\"2147483648\" in f; expected v, v/vt, v//vn or v/vt/vn, of whole numbers other than 0"},
      {vertices + "f 1 2 ^5\n\tv\t0 0 0", "\"5\" names no vertex; expected 1 to 4, or a distance back to one above"},
      {vertices + "f 1 2 3\n^face 1 2 3", "unknown statement \"face\"; expected one of " + statements},
      {vertices + "f 1 2 3\n^usemtll red", "unknown statement \"usemtll\"; expected usemtl"},
      {vertices + "f 1 2 3\n^call other.obj", "unknown statement \"call\"; expected one of " + statements},
      {"f ^1 2 3", "\"1\" names no vertex; expected a v before it: there is none"},
      {"f ^-1 2 3", "\"-1\" names no vertex; expected a v before it: there is none"},
      {vertices + "f ^1/-1 2/-1 3/-1\nvt 0 0",
       "\"1/-1\" names no texture coordinate; expected a vt before it: there is none"},
      {vertices + "f ^1/1 2/1 3/1", "\"1/1\" names no texture coordinate; expected a vt before it: there is none"},
  };
  for (const auto& [text, expected] : cases) {
    INFO(text);
    CHECK(error_at(text) == expected);
  }
}

TEST_CASE("No damage to OBJ does worse than an error") {
  CHECK(test::refused_after_damage(sample, 20000, reading) > 5000);
}
