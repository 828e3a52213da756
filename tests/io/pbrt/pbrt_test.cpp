#include "durero/io/pbrt/pbrt.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "durero/io/output_file.hpp"
#include "durero/scene/body.hpp"
#include "durero/scene/stage.hpp"
#include "io/malformed.hpp"
#include "support/catch.hpp"
#include "support/folder.hpp"

using namespace durero;

namespace {

const auto reading = [](const io::Source& s) { return io::read_pbrt(s); };
std::string error_at(const std::string& with_mark) { return test::error_at_mark(with_mark, reading); }
io::Imported import_text(const std::string& text) { return io::read_pbrt(io::Source("f", text)); }
bool loses(const io::Imported& i, const std::string& line) { return std::ranges::count(i.lost, line) == 1; }
const scene::Material& material_of(const io::Imported& i, const std::string& name) {
  return i.scene.stage().materials[i.scene.material(i.scene.find(name).value()).value()];
}

/// Something of everything.
const std::string sample = R"(# a scene
LookAt 0 0 -5  0 0 0  0 1 0
Camera "perspective" "float fov" 40 "float lensradius" [0.25] "float focaldistance" [7]
Film "rgb" "integer xresolution" [64] "integer yresolution" [48] "string filename" "a.exr"
Sampler "halton" "integer pixelsamples" 8
WorldBegin
LightSource "point" "rgb I" [1 2 3] "point3 from" [1 2 3]
LightSource "infinite" "rgb L" [0.5 0.25 0] "float scale" 2
MakeNamedMaterial "red" "string type" "diffuse" "rgb reflectance" [0.5 0.25 0]
AttributeBegin
  NamedMaterial "red"
  Translate 1 2 3 Scale 2 2 2
  Shape "sphere" "float radius" 1.5
AttributeEnd
TransformBegin Rotate 90 0 1 0 Shape "cylinder" "float radius" [0.5] "float zmin" 0 "float zmax" 2 TransformEnd
Texture "t" "spectrum" "constant" "rgb value" [0.125 0.25 0.5]
Material "conductor" "texture reflectance" "t"
Shape "trianglemesh" "integer indices" [0 1 2 0 2 3] "point3 P" [0 0 0 1 0 0 1 1 0 0 1 0]
ObjectBegin "o"
  Material "dielectric" "float eta" 1.25
  Shape "disk" "float height" 1 "float radius" 2
  ReverseOrientation Shape "cone" "float radius" 1 "float height" 2
ObjectEnd
AttributeBegin ConcatTransform [1 0 0 0 0 1 0 0 0 0 1 0 5 6 7 1] ObjectInstance "o" AttributeEnd
AttributeBegin AreaLightSource "diffuse" "rgb L" [3 3 3] Scale 1 2 1 Shape "sphere" AttributeEnd
Shape "bilinearmesh" "point3 P" [0 0 0 1 0 0 0 1 0 1 1 0]
)";

}  // namespace

TEST_CASE("An instance of pbrt is put where its own transformation puts what its object has put") {
  const io::Imported i = import_text(
      "ObjectBegin \"o\" Translate 1 0 0 Shape \"sphere\" ObjectEnd AttributeBegin Scale 2 2 2 ObjectInstance \"o\" "
      "AttributeEnd Rotate 90 0 1 0 ObjectInstance \"o\"");
  const auto spheres = i.scene.singles<scene::Sphere>();
  REQUIRE(spheres.size() == 2);
  CHECK((spheres[0].centro == glm::dvec3(2, 0, 0) && spheres[0].radio == 2));
  CHECK((spheres[1].centro == glm::dvec3(0, 0, -1) && spheres[1].radio == 1));
}

TEST_CASE("Shapes of pbrt are those of a scene, where the transformations put them") {
  const io::Imported i = import_text(sample);
  const auto spheres = i.scene.singles<scene::Sphere>();
  const auto at = [&](const char* name) { return i.scene.find(name).value().index; };
  CHECK((spheres[at("s1")].centro == glm::dvec3(1, 2, 3) && spheres[at("s1")].radio == 3));
  CHECK(material_of(i, "s1").color == glm::dvec3(0.5, 0.25, 0));
  const auto& cylinder = i.scene.singles<scene::Cylinder>()[0];
  CHECK((cylinder.vector == glm::dvec3(1, 0, 0) && cylinder.altura == 2 && cylinder.radio == 0.5));
  CHECK(i.scene.singles<scene::Triangle>().size() == 4);
  CHECK((material_of(i, "v1").M_PS == glm::dvec3(0.125, 0.25, 0.5) && material_of(i, "v1").k_ps == 1));
  const auto& disc = i.scene.singles<scene::Disc>()[0];
  CHECK((disc.centro == glm::dvec3(5, 6, 8) && disc.radio == 2 && disc.vector == glm::dvec3(0, 0, 1)));
  const auto& cone = i.scene.singles<scene::Cone>()[0];
  CHECK((cone.centro == glm::dvec3(5, 6, 7) && cone.proporcion == 0.5 && cone.altura == 2));
  CHECK((material_of(i, "d1").index == 1.25 && material_of(i, "d1").k_t == 1));
  CHECK(i.groups.table().at("u1").elementos == scene::Names{"d1", "k1"});
  CHECK(i.scene.body(i.scene.find("b1").value())->form.index() == 0);  // a spheroid: a copy
  CHECK(material_of(i, "b1").emission == glm::dvec3(3));
  const scene::Stage& stage = i.scene.stage();
  CHECK(stage.background == glm::dvec3(1, 0.5, 0));
  CHECK((stage.lights[0].position == glm::dvec3(1, 2, 3) && stage.lights[0].color == glm::dvec3(1, 2, 3)));
  CHECK((stage.camera->eye == glm::dvec3(0, 0, -5) && stage.camera->aperture == 0.5 && stage.camera->focus == 7));
  CHECK((stage.camera->fov_y == 40 && stage.camera->mirrored));
  CHECK_FALSE(import_text("Scale -1 1 1 Camera \"perspective\"").scene.stage().camera->mirrored);
  CHECK(stage.resolution == scene::Resolution{64, 48});
  CHECK(loses(i, "1 setting left out: how a picture is drawn, the call says"));
  CHECK(loses(i, "1 parameter \"filename\" left out: no scene has such"));
}

TEST_CASE("A transformation of pbrt does what stands behind it first, and states bring back what they began with") {
  const auto first = [](const std::string& text) {
    const io::Imported i = import_text(text);
    return i.scene.singles<scene::Sphere>()[0];
  };
  CHECK(first("Translate 0 1 0 Scale 2 2 2 Translate 1 0 0 Shape \"sphere\"").centro == glm::dvec3(2, 1, 0));
  CHECK(first("Scale 2 2 2 Identity Translate 1 0 0 Shape \"sphere\"").radio == 1);
  CHECK(first("Translate 9 9 9 Transform [2 0 0 0 0 2 0 0 0 0 2 0 1 2 3 1] Shape \"sphere\"").centro ==
        glm::dvec3(1, 2, 3));
  CHECK(first("Transform [2 0 0 0 0 2 0 0 0 0 2 0 1 2 3 2] Shape \"sphere\"").centro == glm::dvec3(0.5, 1, 1.5));
  CHECK(first("Translate 1 0 0 CoordinateSystem \"here\" Translate 1 0 0 CoordSysTransform \"here\" Shape \"sphere\"")
            .centro.x == 1);
  CHECK(first("AttributeBegin Translate 1 0 0 AttributeEnd Shape \"sphere\"").centro.x == 0);
  CHECK(first("Translate 1 0 0 WorldBegin Shape \"sphere\"").centro.x == 0);
  CHECK(first("ActiveTransform EndTime Translate 1 0 0 ActiveTransform All Translate 0 1 0 Shape \"sphere\"").centro ==
        glm::dvec3(0, 1, 0));
  CHECK(glm::distance(first("LookAt 0 0 -5 0 0 0 0 1 0 Translate 0 0 1 Shape \"sphere\"").centro, {0, 0, 6}) < 1e-12);
  CHECK(glm::distance(first("LookAt 0 0 -5 0 0 0 0 1 0 Camera \"perspective\" WorldBegin CoordSysTransform \"camera\" "
                            "Shape \"sphere\"")
                          .centro,
                      {0, 0, -5}) < 1e-12);
  const io::Imported both =
      import_text("TransformBegin Material \"matte\" \"rgb Kd\" [1 0 0] Translate 1 0 0 TransformEnd Shape \"sphere\"");
  CHECK((material_of(both, "s1").color == glm::dvec3(1, 0, 0) && both.scene.singles<scene::Sphere>()[0].centro.x == 0));
}

TEST_CASE("Parts of shapes, and shapes that no scene has, are left out by name") {
  const auto lost = [](const std::string& shape) { return import_text("Shape " + shape).lost; };
  const auto out = [](const std::string& what) {
    return std::vector<std::string>{"1 shape \"" + what + "\" left out: a scene has none"};
  };
  CHECK(lost(R"("sphere" "float radius" 2 "float zmin" -1)") == out("sphere in part"));
  CHECK(lost(R"("sphere" "float radius" 2 "float zmax" 1)") == out("sphere in part"));
  CHECK(lost(R"("sphere" "float radius" 2 "float zmin" -2 "float zmax" 2 "float phimax" 360)").empty());
  CHECK(lost(R"("sphere" "float phimax" 90)") == out("sphere in part"));
  CHECK(lost(R"("cylinder" "float phimax" 90)") == out("cylinder in part"));
  CHECK(lost(R"("cone" "float phimax" 90)") == out("cone in part"));
  CHECK(lost(R"("disk" "float phimax" 90)") == out("disk in part"));
  CHECK(lost(R"("disk" "float innerradius" 0.5)") == out("disk with a hole"));
  CHECK(lost(R"("curve")") == out("curve"));
  CHECK(lost(R"("plymesh" "string filename" "a.ply.gz")") == out("plymesh of a packed file"));
  CHECK(lost(R"("sphere" "float radus" 2)") ==
        std::vector<std::string>{"1 parameter \"radus\" left out: no scene has such"});
  CHECK(lost(R"("sphere" "float radius" 2 "float radius" 3)") ==
        std::vector<std::string>{"1 parameter \"radius\" left out: no scene has such"});
}

TEST_CASE("A bilinear patch is two triangles where it is flat and convex, exactly, and else left out") {
  const auto triangles = [](const std::string& points) {
    return import_text("Shape \"bilinearmesh\" \"point3 P\" [" + points + "]").scene.singles<scene::Triangle>().size();
  };
  CHECK(triangles("0 0 0 1 0 0 0 1 0 1 1 0") == 2);
  CHECK(triangles("0 0 0 1 0 0 0 1 0 1 1 1e-300") == 0);
  CHECK(triangles("0 0 0 1 0 0 0 1 0 0.5 0.5 0") == 0);    // a triangle, with a corner on its side
  CHECK(triangles("0 0 0 1 0 0 0 1 0 0.25 0.25 0") == 0);  // it is not convex
  CHECK(triangles("0 0 0 1 0 0 1 1 0 0 1 0") == 0);        // it overlaps itself
  CHECK(triangles("0.1 0.1 0.1 1.1 0.1 0.1 0.1 1.1 0.1 1.1 1.1 0.1") == 2);
  CHECK(import_text("Shape \"bilinearmesh\" \"integer indices\" [0 1 2 3] \"point3 P\" [0 0 0 2 0 0 0 1 0 3 1 0]")
            .scene.size() == 2);
}

TEST_CASE("Meshes have the normals of their vertices, and the files that they name are read") {
  const io::Imported i = import_text(
      R"(Rotate 90 1 0 0 Shape "trianglemesh" "point P" [0 0 0 1 0 0 0 1 0] "normal N" [0 0 1 0 0 1 0 0 2])");
  const auto normals = i.scene.vertex_normals(i.scene.find("v1").value());
  REQUIRE(normals);
  CHECK((*normals)[2] == glm::dvec3(0, -2, 0));
  CHECK(loses(import_text(R"(Shape "trianglemesh" "point P" [0 0 0 1 0 0 0 1 0] "normal N" [0 0 1 0 0 1 0 0 0])"),
              "1 triangle kept flat: a normal at a vertex has no direction"));
  CHECK(loses(import_text(R"(Shape "trianglemesh" "point P" [0 0 0 1 0 0 2 0 0])"),
              "1 triangle left out: the vertices lie on one line"));
  const test::Folder folder;
  std::filesystem::create_directory(folder.file("below"));
  const auto write = [&](const std::string& name, const std::string& text) {
    io::OutputFile out(folder.file(name));
    out.write(text);
    out.commit();
  };
  write(
      "below/one.ply",
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
      "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  write("below/part.pbrt",
        "Translate 0 0 5 Shape \"plymesh\" \"string filename\" \"below/one.ply\" Material \"matte\" \"float Kd\" 1");
  write("again.pbrt", "Include \"again.pbrt\"");
  write("open.pbrt", "AttributeBegin");
  const auto read = [&](const std::string& text) { return io::read_pbrt(io::Source(folder.file("f"), text)); };
  const io::Imported included = read("Include \"below/part.pbrt\" Shape \"sphere\"");
  CHECK(included.scene.singles<scene::Triangle>()[0].vertices[0] == glm::dvec3(0, 0, 5));
  CHECK(included.scene.singles<scene::Sphere>()[0].centro == glm::dvec3(0, 0, 5));
  CHECK(material_of(included, "s1").color == glm::dvec3(1));
  const io::Imported imported = read("Import \"below/part.pbrt\" Shape \"sphere\"");
  CHECK(imported.scene.singles<scene::Triangle>().size() == 1);
  CHECK(imported.scene.singles<scene::Sphere>()[0].centro == glm::dvec3(0, 0, 0));
  CHECK(material_of(imported, "s1").color == glm::dvec3(0.5));
  for (const std::string text :
       {"Include \"../x\"", "Include \"/etc/passwd\"", "Include \"again.pbrt\"", "Import \"open.pbrt\"",
        "Include \"open.pbrt\"", "Shape \"plymesh\" \"string filename\" \"no.ply\"",
        "Shape \"plymesh\" \"string filename\" \"below/part.pbrt\""}) {
    INFO(text);
    CHECK_THROWS_AS(read(text), io::InputError);
  }
}

TEST_CASE("A camera of pbrt has its angle across the shorter side, or that of its window") {
  const auto camera = [](const std::string& more) {
    return import_text("Camera \"perspective\" \"float fov\" 90 " + more +
                       " Film \"rgb\" \"integer xresolution\" 100 \"integer yresolution\" 200");
  };
  CHECK(std::abs(camera("").scene.stage().camera->fov_y - 126.86989764584402) < 1e-12);
  CHECK(std::abs(camera("\"float screenwindow\" [-1 1 -2 2]").scene.stage().camera->fov_y - 126.86989764584402) <
        1e-12);
  CHECK(std::abs(camera("\"float screenwindow\" [-0.5 0.5 -1 1]").scene.stage().camera->fov_y - 90) < 1e-12);
  for (const char* const other :
       {"\"float screenwindow\" [-1 1 -1 1]", "\"float screenwindow\" [0 1 -1 1]", "\"float frameaspectratio\" 2"})
    CHECK(loses(camera(other),
                "1 camera left out: a scene has perspective cameras whose pixels are square and about the view"));
  CHECK(loses(import_text("Camera \"orthographic\""),
              "1 camera left out: a scene has perspective cameras whose pixels are square and about the view"));
}

TEST_CASE("Lights of pbrt are put where the transformation says, and materials are of their colours") {
  const scene::Stage stage =
      import_text(R"(Translate 1 0 0 LightSource "spot" "point from" [0 0 0] "point to" [0 0 2] "float coneangle" 40
Rotate 90 0 0 1 LightSource "distant" "point from" [1 0 0] "point to" [0 0 0] "color L" [1 2 3] "color scale" [2 2 2])")
          .scene.stage();
  CHECK(stage.lights[0].cone == scene::LightCone{{1, 0, 2}, 35, 40, 0});
  CHECK((stage.directional_lights[0].direction == glm::dvec3(0, -1, 0) &&
         stage.directional_lights[0].color == glm::dvec3(2, 4, 6)));
  CHECK(loses(import_text("LightSource \"infinite\" \"string filename\" \"a.exr\""),
              "1 light \"infinite\" left out: a scene has none"));
  const auto look = [](const std::string& material) {
    return material_of(import_text(material + " Shape \"sphere\""), "s1");
  };
  CHECK(look(R"(Material "matte" "spectrum Kd" [400 0.25 700 0.75])").color == glm::dvec3(0.5));
  CHECK(look(R"(Material "plastic" "rgb Kd" [0.1 0.2 0.3])").color == glm::dvec3(0.1, 0.2, 0.3));
  CHECK(look(R"(Material "mirror")").M_PS == glm::dvec3(0.9));
  CHECK(look(R"(Material "glass" "float index" 1.25)").index == 1.25);
  CHECK((look(R"(Material "")").k_t == 1 && look(R"(Material "")").index == 1));
  CHECK(look(R"(Texture "a" "color" "checkerboard" "rgb tex1" [1 0 0] Material "matte" "texture Kd" "a")").color ==
        glm::dvec3(0.5, 0, 0));
  CHECK(look(R"(Texture "a" "color" "imagemap" "string filename" "x" Material "matte" "texture Kd" "a")").color ==
        glm::dvec3(0.5));
  CHECK(loses(import_text("NamedMaterial \"none\" Shape \"sphere\""),
              "1 name of a material that nothing above has: a grey of one half"));
}

TEST_CASE("What is wrong in a scene of pbrt is named where it stands") {
  const struct {
    const char *text, *error;
  } all[] = {
      {"^Shap \"sphere\"", "\"Shap\" is no statement; expected Shape"},
      {"^\"Shape\"", "\"Shape\" is no statement; expected Shape"},
      {"Shape ^sphere", "\"sphere\" stands here; expected a type of shape in quotes"},
      {"Shape ^\"sphere", "a text in quotes without an end; expected \" on the same line"},
      {"Translate 1 2^", "the file ends here; expected what the statement needs"},
      {"Translate 1 2 ^x", "\"x\" in Translate; expected 3 finite numbers"},
      {"Translate [1 2 3 ^4]", "\"4\" in Translate; expected ] behind 3 numbers"},
      {"Rotate 1 0 0 ^0", "Rotate about no axis; expected an angle, and x, y and z of an axis"},
      {"LookAt 0 0 0 0 0 0 0 1 ^0",
       "LookAt gives no direction; expected two points, and up across the way between them"},
      {"Transform [1 0 0 0 0 1 0 0 0 0 1 1 0 0 0 1^]",
       "Transform of another last column; expected 0, 0, 0 and 1 in it"},
      {"Shape \"sphere\" ^\"radius\" 1", "\"radius\" stands here; expected a type and a name"},
      {"Shape \"sphere\" \"float radius\" [1 ^\"a\"]", "texts and numbers in radius; expected values of one kind"},
      {"Shape \"sphere\" \"float radius\" ^x", "\"x\" in radius; expected a finite number, or a text in quotes"},
      {"Shape \"sphere\" ^\"float radius\" [1 2]", "radius of 2 numbers; expected one"},
      {"^Shape \"trianglemesh\"", "a mesh without P; expected its points"},
      {"Shape \"trianglemesh\" ^\"point P\" [1 2]", "P of 2 numbers; expected three for each point"},
      {"^Shape \"trianglemesh\" \"point P\" [1 2 3]", "a mesh without indices; expected them, or 3 points"},
      {"Shape \"trianglemesh\" \"point P\" [1 2 3] ^\"integer indices\" [0 0 1]",
       "1 in indices; expected one of 1 points, from 0"},
      {"Shape \"trianglemesh\" \"point P\" [1 2 3] ^\"integer indices\" [0 0]",
       "indices of 2 numbers; expected 3 for each face"},
      {"Shape \"trianglemesh\" \"point P\" [0 0 0 1 0 0 0 1 0] ^\"normal N\" [0 0 1]",
       "1 normals; expected one for each of 3 points"},
      {"^AttributeEnd", "the end of AttributeBegin stands here; expected its beginning before it"},
      {"AttributeBegin ^TransformEnd", "the end of TransformBegin stands here; expected that of AttributeBegin"},
      {"ObjectBegin \"a\" ObjectBegin ^\"b\"", "an object within another; expected ObjectEnd before it, and a name"},
      {"ObjectInstance ^\"a\"", "\"a\" names no object; expected one from above"},
      {"ObjectBegin \"a\" ObjectInstance ^\"a\"", "an instance within an object; expected it outside, as pbrt does"},
      {"CoordSysTransform ^\"a\"", "\"a\" names no system of coordinates; expected one from above"},
      {"ActiveTransform ^None", "\"None\" stands here; expected StartTime, EndTime or All"},
      {"Film \"rgb\" ^\"integer xresolution\" 0", "xresolution is 0; expected a whole number of pixels, 1 to 65535"},
      {"Include ^\"no.pbrt\"", "no file \"no.pbrt\"; expected a file in the folder of the scene or beneath it"}};
  for (const auto& one : all) {
    INFO(one.text);
    CHECK(error_at(one.text) == one.error);
  }
  CHECK(test::error_of("AttributeBegin", reading).ends_with("AttributeBegin has no end; expected it"));
}

TEST_CASE("A scene of pbrt that grows without end is refused in one line") {
  std::string turns, states;
  for (int i = 0; i < 300; ++i) turns += "Rotate 1 1 1 1 ";
  for (int i = 0; i < 10001; ++i) states += "AttributeBegin ";
  CHECK(test::error_of(turns, reading).ends_with("more than 256 transformations one after another; expected fewer"));
  CHECK(test::error_of(states, reading).ends_with("states within each other, deeper than 10000; expected fewer"));
}

TEST_CASE("No damage to a scene of pbrt does worse than an error") {
  CHECK(test::error_of(sample, reading).empty());
  CHECK(test::refused_after_damage(sample, 20000, reading) > 8000);
}
