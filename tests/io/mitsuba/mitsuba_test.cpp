#include "durero/io/mitsuba/mitsuba.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "durero/io/output_file.hpp"
#include "durero/scene/body.hpp"
#include "durero/scene/by_name.hpp"
#include "durero/scene/stage.hpp"
#include "io/malformed.hpp"
#include "support/catch.hpp"
#include "support/folder.hpp"

using namespace durero;

namespace {

const auto reading = [](const io::Source& s) { return io::read_mitsuba(s); };
std::string error_at(const std::string& with_mark) { return test::error_at_mark(with_mark, reading); }
io::Imported import_scene(const std::string& parts) {
  return io::read_mitsuba(io::Source("f", "<scene version=\"3.0.0\">" + parts + "</scene>"));
}
std::string shape(const std::string& type, const std::string& parts) {
  return fmt::format("<shape type=\"{}\">{}</shape>", type, parts);
}
std::string moved(const std::string& parts) { return "<transform name=\"to_world\">" + parts + "</transform>"; }
bool loses(const io::Imported& i, const std::string& line) { return std::ranges::count(i.lost, line) == 1; }
const scene::Material& material_of(const io::Imported& i, const std::string& name) {
  return i.scene.stage().materials[i.scene.material(i.scene.find(name).value()).value()];
}

/// Something of everything.
const std::string sample = R"(<?xml version="1.0"?>
<!-- a comment -->
<scene version="3.0.0">
<default name="r" value="0.5"/><default name="re" value="2"/>
<sensor type="perspective"><float name="fov" value="40"/><transform name="toWorld"><lookAt origin="0,0,-5" target="0 0 0" up="0 1 0"/></transform>
<film type="hdrfilm"><integer name="width" value="64"/><integer name="height" value="48"/></film></sensor>
<bsdf type="twosided" id="red"><bsdf type="diffuse"><rgb name="reflectance" value="0.5, 0.25 0"/></bsdf></bsdf>
<shape type="sphere"><point name="center" x="1" y="2" z="3"/><float name="radius" value="$re"/><ref id="red"/></shape>
<shape type="cylinder"><point name="p1" value="0 0 2"/><float name="radius" value="$r"/><transform name="to_world"><scale x="1" y="2" z="1"/></transform></shape>
<shape type="rectangle"><emitter type="area"><rgb name="radiance" value="3"/></emitter></shape>
<shape type="cube"><transform name="to_world"><rotate x="1" angle="30"/><translate x="4"/></transform></shape>
<shape type="shapegroup" id="g"><shape type="disk"/></shape>
<shape type="instance"><ref id="g"/><transform name="to_world"><matrix value="1 0 0 5 0 1 0 6 0 0 1 7 0 0 0 1"/></transform></shape>
<emitter type="point"><point name="position" x="1" y="2" z="3"/><spectrum name="intensity" value="400:1 700:3"/></emitter>
<emitter type="constant"><rgb name="radiance" value="#ff0000"/></emitter>
</scene>)";

}  // namespace

TEST_CASE("A disc of Mitsuba turns with its transform") {
  const auto disc = import_scene(shape("disk", moved("<rotate y=\"1\" angle=\"90\"/><scale value=\"3\"/>")))
                        .scene.singles<scene::Disc>()[0];
  CHECK((disc.vector == glm::dvec3(1, 0, 0) && disc.radio == 3));
}

TEST_CASE("A value of Mitsuba has a million characters at most, once its names stand for theirs") {
  const std::string half(500'000, '0');
  const auto radius = [&](const std::string& value) {
    return import_scene("<default name=\"a\" value=\"" + half + "\"/>" +
                        shape("sphere", "<float name=\"radius\" value=\"" + value + "\"/>"));
  };
  CHECK(radius("$a.5").scene.singles<scene::Sphere>()[0].radio == 0.5);
  CHECK_THROWS_WITH(radius("$a$a$a.5"), Catch::Contains("a value of more than 1000000 characters"));
}

TEST_CASE("Shapes of Mitsuba are those of a scene, where their transforms put them") {
  const io::Imported i = io::read_mitsuba(io::Source("f", sample));
  const auto spheres = i.scene.singles<scene::Sphere>();
  CHECK((spheres[0].centro == glm::dvec3(1, 2, 3) && spheres[0].radio == 2));
  CHECK(material_of(i, "s1").color == glm::dvec3(0.5, 0.25, 0));
  CHECK(i.scene.body(i.scene.find("b1").value())->form.index() == 0);  // an elliptical cylinder: a copy
  CHECK(i.scene.singles<scene::Triangle>().size() == 2);
  CHECK(material_of(i, "v1").emission == glm::dvec3(3));
  CHECK(i.scene.body(i.scene.find("b2").value())->form.index() == 1);  // a turned cube: a solid
  CHECK((i.scene.singles<scene::Disc>()[0].centro == glm::dvec3(5, 6, 7) &&
         i.scene.singles<scene::Disc>()[0].radio == 1));
  CHECK(i.groups.table().at("u1").elementos == scene::Names{"d1"});
  CHECK(i.groups.table().at("m1").elementos == scene::Names{"v1", "v2"});
  const scene::Stage& stage = i.scene.stage();
  CHECK_FALSE(stage.camera->mirrored);
  CHECK((stage.resolution == scene::Resolution{64, 48} && stage.camera->eye == glm::dvec3(0, 0, -5)));
  CHECK((stage.lights[0].position == glm::dvec3(1, 2, 3) && stage.lights[0].color == glm::dvec3(2)));
  CHECK(stage.background == glm::dvec3(1, 0, 0));
  CHECK(loses(i, "1 spectrum kept as a grey of its mean"));
  CHECK(loses(i, "1 surface with a light: it shines on both of its sides"));
  CHECK(loses(i, "1 light as bright at every distance: in Mitsuba it fades"));
}

TEST_CASE("The parts of a transform are carried out in their order, and a similarity keeps the type of a shape") {
  const auto sphere = [](const std::string& parts) {
    return import_scene(shape("sphere", moved(parts) + R"(<point name="center" value="1 0 0"/>)")).scene;
  };
  const auto first = [&](const std::string& parts) { return sphere(parts).singles<scene::Sphere>()[0]; };
  CHECK(first(R"(<translate y="1"/><scale value="2"/>)").centro == glm::dvec3(2, 2, 0));
  CHECK(first(R"(<scale value="2"/><translate y="1"/>)").centro == glm::dvec3(2, 1, 0));
  CHECK(first(R"(<scale x="-2" y="2" z="2"/>)").radio == 2);
  CHECK(first(R"(<rotate z="1" angle="90"/>)").centro == glm::dvec3(0, 1, 0));
  CHECK(first(R"(<matrix value="0 0 2 1 2 0 0 0 0 2 0 0 0 0 0 1"/>)").centro == glm::dvec3(1, 2, 0));
  CHECK(first(R"(<matrix value="0 0 2  2 0 0  0 2 0"/>)").radio == 2);
  CHECK(first(R"(<lookat origin="0 0 9" target="0 0 10" up="0 1 0"/>)").centro == glm::dvec3(1, 0, 9));
  CHECK(sphere(R"(<scale x="2"/>)").has_bodies());
  CHECK(sphere(R"(<matrix value="0.6 0.8 0 0 -0.8 0.6 0 0 0 0 1 0 0 0 0 1"/>)").has_bodies());
  CHECK(sphere(R"(<rotate x="2" angle="90"/>)").has_bodies());  // Mitsuba stretches by such an axis
  CHECK(sphere(R"(<rotate x="0.70711" y="0.70711" angle="90"/>)").singles<scene::Sphere>()[0].radio == 1);
  const io::Imported flat = import_scene(shape("sphere", moved(R"(<scale x="0"/>)")));
  CHECK((flat.scene.size() == 0 && loses(flat, "1 shape left out: a transformation leaves nothing of its volume")));
  const io::Imported far = import_scene(shape("sphere", moved(R"(<scale value="1e200"/><scale value="1e200"/>)")));
  CHECK((far.scene.size() == 0 && loses(far, "1 shape left out: a transformation puts it beyond binary64")));
  const io::Imported none = import_scene(shape("sphere", R"(<float name="radius" value="0"/>)"));
  CHECK(loses(none, "1 shape left out: a scene's have radio? ∈ Rmas (Agregar_Esfera.pre.2)"));
}

TEST_CASE("Materials are of the colours of a bsdf, or mirrors or glass, and what is simplified is named") {
  const auto look = [](const std::string& bsdf) {
    const io::Imported i = import_scene(shape("sphere", bsdf));
    return std::pair(material_of(i, "s1"), i.lost);
  };
  CHECK(look("").first.color == glm::dvec3(0.5));
  CHECK(look(R"(<bsdf type="diffuse"><rgb name="reflectance" value="1 0.5 2"/></bsdf>)").second ==
        std::vector<std::string>{"1 colour out of its range: the nearest in it stands for it"});
  const auto mirror = look(R"(<bsdf type="conductor"/>)").first;
  CHECK((mirror.k_ps == 1 && mirror.k_d == 0));
  const auto glass =
      look(R"(<bsdf type="dielectric"><float name="intIOR" value="1.5"/><float name="ext_ior" value="1"/></bsdf>)")
          .first;
  CHECK((glass.k_t == 1 && glass.index == 1.5));
  CHECK(
      look(
          R"(<bsdf type="dielectric"><string name="int_ior" value="diamond"/><string name="ext_ior" value="vacuum"/></bsdf>)")
          .first.index == 2.419);
  CHECK(look(R"(<bsdf type="thindielectric"/>)").first.index == 1);
  CHECK(look(R"(<bsdf type="plastic"><rgb name="diffuse_reflectance" value="0.1 0.2 0.3"/></bsdf>)").first.color ==
        glm::dvec3(0.1, 0.2, 0.3));
  CHECK(look(R"(<bsdf type="mask"><bsdf type="hair"/></bsdf>)").second ==
        std::vector<std::string>{
            "1 use of a bsdf \"hair\" simplified: a material has one colour, or is a mirror or glass",
            "1 use of a bsdf \"mask\" simplified: a material has one colour, or is a mirror or glass"});
  const auto pattern = look(
      R"(<bsdf type="diffuse"><texture name="reflectance" type="checkerboard"><rgb name="color0" value="1"/></texture></bsdf>)");
  CHECK(pattern.first.color == glm::dvec3(0.6));
  CHECK(
      pattern.second ==
      std::vector<std::string>{
          "1 texture or file of a colour left out: a grey of one half stands for it, or the mean of a pattern of two"});
}

TEST_CASE("Sensors are cameras with the angle across the side that they say, and the first is kept") {
  const auto camera = [](const std::string& parts) {
    return import_scene(
        "<sensor type=\"perspective\"><film type=\"hdrfilm\"><integer name=\"width\" value=\"200\"/>"
        "<integer name=\"height\" value=\"100\"/></film>" +
        parts + "</sensor>");
  };
  const auto angle = [&](const std::string& parts) { return camera(parts).scene.stage().camera->fov_y; };
  CHECK(angle(R"(<float name="fov" value="50"/><string name="fov_axis" value="y"/>)") == 50);
  CHECK(angle(R"(<float name="fov" value="50"/><string name="fovAxis" value="smaller"/>)") == 50);
  CHECK(std::abs(angle(R"(<float name="fov" value="90"/>)") - 53.13010235415598) < 1e-12);
  CHECK(angle("") == angle(R"(<string name="focal_length" value="50mm"/>)"));
  CHECK(loses(camera(R"(<float name="fov" value="180"/>)"),
              "1 sensor left out: a scene has perspective cameras of a told angle"));
  const io::Imported lens = import_scene(
      "<sensor type=\"thinlens\"><float name=\"fov\" value=\"40\"/><float name=\"aperture_radius\" value=\"0.25\"/>"
      "<float name=\"focus_distance\" value=\"7\"/></sensor><sensor type=\"perspective\"/>");
  CHECK((lens.scene.stage().camera->aperture == 0.5 && lens.scene.stage().camera->focus == 7));
  CHECK(lens.scene.stage().resolution == scene::Resolution{768, 576});
  CHECK(loses(lens, "1 sensor left out: the first draws the picture"));
}

TEST_CASE("Emitters are lights, along the +z of their frames") {
  const scene::Stage stage =
      import_scene(
          R"(<emitter type="spot"><float name="cutoff_angle" value="40"/><transform name="to_world"><translate x="1"/></transform></emitter>
<emitter type="directional"><vector name="direction" x="1" y="2" z="3"/><rgb name="irradiance" value="2"/></emitter>
<emitter type="directional"><transform name="to_world"><rotate x="1" angle="90"/></transform></emitter>)")
          .scene.stage();
  CHECK(stage.lights[0].position == glm::dvec3(1, 0, 0));
  CHECK(stage.lights[0].cone == scene::LightCone{{1, 0, 1}, 30, 40, 0});
  CHECK((stage.directional_lights[0].direction == glm::dvec3(1, 2, 3) &&
         stage.directional_lights[0].color == glm::dvec3(2)));
  CHECK(stage.directional_lights[1].direction == glm::dvec3(0, -1, 0));
  CHECK(loses(import_scene("<emitter type=\"envmap\"/>"), "1 emitter \"envmap\" left out: a scene has none"));
}

TEST_CASE("Files in the folder of a scene and beneath it are read, and no others") {
  const test::Folder folder;
  std::filesystem::create_directory(folder.file("below"));
  std::filesystem::create_directory(folder.file("below/meshes"));
  const auto write = [&](const std::string& name, const std::string& text) {
    io::OutputFile out(folder.file(name));
    out.write(text);
    out.commit();
  };
  write("below/one.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nf 1//1 2//1 3//1\np 1\n");
  write("below/meshes/two.obj", "v 0 0 0\nv 2 0 0\nv 0 2 0\nf 1 2 3\n");
  write("below/part.xml",
        "<scene version=\"3.0.0\"><path value=\"meshes\"/>" +
            shape("obj", "<string name=\"filename\" value=\"one.obj\"/>") +
            shape("obj", "<string name=\"filename\" value=\"two.obj\"/>" + moved("<translate z=\"$z\"/>")) +
            "</scene>");
  write("below/alone.xml", shape("sphere", ""));
  write("again.xml", "<scene version=\"3.0.0\"><include filename=\"again.xml\"/></scene>");
  const auto read = [&](const std::string& parts) {
    return io::read_mitsuba(io::Source(folder.file("f"), "<scene version=\"3.0.0\">" + parts + "</scene>"));
  };
  const io::Imported i = read(
      "<default name=\"z\" value=\"5\"/><path value=\"../..\"/><include filename=\"below/part.xml\"/><include "
      "filename=\"below/alone.xml\"/>");
  REQUIRE(i.scene.singles<scene::Triangle>().size() == 2);
  CHECK(i.scene.singles<scene::Triangle>()[1].vertices[0] == glm::dvec3(0, 0, 5));
  CHECK(i.scene.vertex_normals(i.scene.find("v1").value()));
  CHECK(i.scene.singles<scene::Sphere>().size() == 1);
  CHECK(loses(i, "1 path out of the scene's folder: nothing is read there"));
  CHECK(loses(i, "1 other statement left out: no vertex, no face"));
  const io::Imported flat = read(shape(
      "obj", "<string name=\"filename\" value=\"below/one.obj\"/><boolean name=\"face_normals\" value=\"true\"/>"));
  CHECK_FALSE(flat.scene.vertex_normals(flat.scene.find("v1").value()));
  for (const std::string name : {"../x.obj", "/etc/passwd", "below", "no.obj"})
    CHECK_THROWS_AS(read(shape("obj", "<string name=\"filename\" value=\"" + name + "\"/>")), io::InputError);
  CHECK_THROWS_AS(read(shape("ply", "<string name=\"filename\" value=\"below/one.obj\"/>")), io::InputError);
  CHECK_THROWS_AS(read("<include filename=\"again.xml\"/>"), io::InputError);
}

TEST_CASE("What is wrong in a scene of Mitsuba is named where it stands") {
  const auto scene = [](const std::string& parts) { return "<scene>" + parts + "</scene>"; };
  const struct {
    const char *parts, *error;
  } all[] = {
      {R"(^<shape/>)", "shape without type; expected an attribute type"},
      {R"(^<shap type="sphere"/>)", "element \"shap\" is not read; expected shape"},
      {R"(<shape type="sphere"><float ^name="radus" value="1"/></shape>)", "\"radus\" in sphere; expected radius"},
      {R"(<shape type="sphere"><float name="radius" ^value="x"/></shape>)", "\"x\" in float; expected a finite number"},
      {R"(<shape type="sphere"><float name="radius" ^value="1 2"/></shape>)", "2 numbers in float; expected one"},
      {R"(<shape type="sphere"><point name="center" ^value="1 2"/></shape>)",
       "2 numbers in point; expected three, or one for all"},
      {R"(<shape type="sphere"><float name="radius" value="1"/><float ^name="radius" value="1"/></shape>)",
       "a second \"radius\"; expected one"},
      {R"(<shape type="sphere"><float name="radius" ^value="$r"/></shape>)",
       "\"$r\" has no value; expected the name of a default above"},
      {R"(<shape type="sphere" ^type="cube"/>)", "a second \"type\"; expected one"},
      {R"(<shape type="sphere"><ref ^id="x"/></shape>)", "\"x\" is the id of nothing; expected the id of an element"},
      {R"(<bsdf id="a" type="diffuse"/><bsdf ^id="a" type="diffuse"/>)", "a second id \"a\"; expected another"},
      {R"(<shape type="sphere"><transform name="to_world">^<lookat origin="0 0 0" target="0 0 0" up="0 1 0"/></transform></shape>)",
       "lookat gives no direction; expected two points, and up across the way between them"},
      {R"(<shape type="sphere"><transform name="to_world"><matrix ^value="1 2"/></transform></shape>)",
       "a matrix of 2 numbers; expected 16, or 9"},
      {R"(<shape type="sphere"><transform name="to_world"><matrix ^value="1 0 0 0 0 1 0 0 0 0 1 0 0 0 1 1"/></transform></shape>)",
       "a matrix whose last row is another; expected 0 0 0 1"},
      {R"(^<shape type="instance"/>)", "an instance of nothing; expected a ref to a shapegroup"},
      {R"(<bsdf type="mask" id="a"><ref id="a"/></bsdf><shape type="sphere"><ref id="a"/></shape>)", ""},
      {R"(<sensor type="perspective"><float name="fov" value="40"/><string name="fov_axis" ^value="z"/></sensor>)",
       "\"z\" as fov_axis; expected one of x, y, smaller, larger, diagonal"},
      {R"(<shape type="obj"><string name="filename" ^value="x.obj"/></shape>)",
       "no file \"x.obj\"; expected a file in the folder of the scene or beneath it"},
      {R"(<include ^filename="../x.xml"/>)",
       "no file \"../x.xml\"; expected a file in the folder of the scene or beneath it"}};
  for (const auto& one : all) {
    INFO(one.parts);
    if (*one.error != 0)
      CHECK(error_at(scene(one.parts)) == one.error);
    else
      CHECK(test::error_of(scene(one.parts), reading)
                .ends_with("bsdf within each other, deeper than 32; expected 32 at most"));
  }
  CHECK(error_at("^").starts_with("no XML: "));
  CHECK(test::error_of("<scene><shape></scene>", reading).starts_with("f:1:"));
  CHECK(error_at("^<shape type=\"sphere\"/>") == "no scene; expected an element scene that holds all others");
  CHECK(error_at(std::string("<scene/>^\0", 10)) == "a byte 0; expected a text in XML");
  CHECK(error_at("^<scene/><scene/>") == "2 outermost elements; expected one");
}

TEST_CASE("A scene of Mitsuba that grows without end is refused in one line") {
  std::string deep, doubled = "<default name=\"a0\" value=\"0123456789\"/>", turns;
  for (int i = 0; i < 200; ++i) deep += "<shape type=\"shapegroup\">";
  for (int i = 0; i < 40; ++i) doubled += fmt::format("<default name=\"a{}\" value=\"$a{}$a{}\"/>", i + 1, i, i);
  for (int i = 0; i < 300; ++i) turns += "<rotate x=\"1\" angle=\"1\"/>";
  for (int i = 0; i < 200; ++i) deep += "</shape>";
  const auto error = [](const std::string& parts) { return test::error_of("<scene>" + parts + "</scene>", reading); };
  CHECK(error(deep).ends_with("elements within each other, deeper than 100; expected 100 at most"));
  CHECK(error(doubled).ends_with("a value of more than 1000000 characters; expected a shorter one"));
  CHECK(error(shape("sphere", moved(turns)))
            .ends_with("more than 256 transformations one after another; expected fewer"));
  std::string laughs =
      "<?xml version=\"1.0\"?><!DOCTYPE lolz [<!ENTITY lol \"lol\"><!ENTITY lol2 \"&lol;&lol;\">]><scene><default "
      "name=\"&lol2;\" value=\"1\"/></scene>";
  CHECK(test::error_of(laughs, reading).empty());  // no entity is replaced
}

TEST_CASE("No damage to a scene of Mitsuba does worse than an error") {
  CHECK(test::error_of(sample, reading).empty());
  CHECK(test::refused_after_damage(sample, 20000, reading) > 8000);
}
