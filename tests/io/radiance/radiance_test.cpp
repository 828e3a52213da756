// Texts of Radiance: what each primitive and each command becomes, and what is refused.
#include "durero/io/radiance/radiance.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <glm/geometric.hpp>
#include <numbers>

#include "durero/io/json/groups_file.hpp"
#include "durero/scene/stage.hpp"
#include "io/malformed.hpp"
#include "support/catch.hpp"
#include "support/folder.hpp"

using namespace durero;
using Lines = std::vector<std::string>;

namespace {

const auto reading = [](const io::Source& s) { return io::read_radiance(s); };
std::string error_at(const std::string& with_mark) { return test::error_at_mark(with_mark, reading); }
io::Imported import_text(const std::string& text) { return io::read_radiance(io::Source("f", text)); }

const std::string sample = R"(# every surface
void plastic red 0 0 5 0.75 0.25 0.5 0 0
red sphere ball 0 0 4 1 2 3 0.5
red bubble hollow
0
0
4 1 2 3 0.25
red cylinder post 0 0 7 0 0 0 0 0 2 0.5
red tube pipe 0 0 7 0 0 2 0 0 0 0.25
red cone tip 0 0 8 0 0 0 0 0 2 0 1
red cup mug 0 0 8 0 0 0 0 0 2 1 0.5
red ring lid 0 0 8 1 1 1 0 0 2 0 3
void polygon floor 0 0 12 0 0 0 4 0 0 4 4 0 0 4 0
!xform -n left -rz 90 -a 2 -t 1 0 0 "no.rad" | not-run
!genbox red box 1 2 3 | xform -t 5 0 0
)";

scene::Material look_of(const std::string& material) {
  const io::Imported i = import_text("void " + material + "\nm sphere s 0 0 4 0 0 0 1");
  return i.scene.stage().materials.at(0);
}
void write(const test::Folder& folder, const std::string& name, const std::string& text) {
  const std::filesystem::path path = folder.file(name);
  std::filesystem::create_directories(path.parent_path());
  std::ofstream(path) << text;
}
/// The lines of what is lost of a text.
Lines lost(const std::string& text) { return import_text(text).lost; }

}  // namespace

TEST_CASE("Every surface of Radiance is an element, open as it is there, in the group of its identifier") {
  const io::Imported i = import_text(sample);
  const auto& scene = i.scene;
  CHECK((scene.shapes<scene::Sphere>().size() == 2 && scene.shapes<scene::Cylinder>().size() == 2));
  CHECK((scene.shapes<scene::Cone>().size() == 1 && scene.shapes<scene::TruncatedCone>().size() == 1));
  CHECK((scene.shapes<scene::Disc>().size() == 1 && scene.shapes<scene::Triangle>().size() == 14));
  const scene::Cone tip = scene.shapes<scene::Cone>()[0];
  CHECK((tip.centro == glm::dvec3(0, 0, 2) && tip.vector == glm::dvec3(0, 0, -1) && tip.proporcion == 0.5));
  const scene::Disc lid = scene.shapes<scene::Disc>()[0];
  CHECK((lid.centro == glm::dvec3(1, 1, 1) && lid.vector == glm::dvec3(0, 0, 1) && lid.radio == 3));
  CHECK(i.groups.table().at("mug").elementos == scene::Names{"t1"});
  CHECK(i.groups.table().at("floor").elementos == scene::Names{"p1", "p2"});
  CHECK(i.groups.table().at("box.6457").elementos == scene::Names{"p13", "p14"});
  CHECK(scene.stage().materials.at(0).color == glm::dvec3(0.75, 0.25, 0.5));
  CHECK_FALSE(scene.material(scene.find("p1").value()));
  CHECK(scene.material(scene.find("p3").value()) == 0);
  CHECK(i.lost == Lines{"1 command not carried out: \"xform\""});
}

TEST_CASE("xform moves, turns, scales, mirrors and repeats what its files, or the program before it, say") {
  const test::Folder folder;
  write(folder, "ball.rad", "m sphere ball 0 0 4 1 0 0 0.5\n");
  write(folder, "sub/both.rad", "!xform -t 0 0 1 ball.rad\nm ring top 0 0 8 0 0 0 1 0 0 0 2\n");
  const auto read = [&](const std::string& command) {
    return io::read_radiance(
        io::Source(folder.file("scene.rad"), "void plastic m 0 0 5 1 1 1 0 0\n!" + command + "\n"));
  };
  const auto ball = [&](const std::string& command) {
    const scene::Sphere s = read(command).scene.shapes<scene::Sphere>()[0];
    return std::pair(s.centro, s.radio);
  };
  CHECK(ball("xform ball.rad") == std::pair(glm::dvec3(1, 0, 0), 0.5));
  CHECK(ball("cat ball.rad") == ball("xform ball.rad"));
  CHECK(ball("xform -t 1 2 3 -s 2 ball.rad") == std::pair(glm::dvec3(4, 4, 6), 1.0));
  CHECK(ball("xform -rz 90 -t 0 0 5 ./ball.rad") == std::pair(glm::dvec3(0, 1, 5), 0.5));
  CHECK(ball("xform -ry 90 ball.rad").first == glm::dvec3(0, 0, -1));
  CHECK(ball("xform -mx -e -I -c ball.rad").first == glm::dvec3(-1, 0, 0));
  CHECK(ball("xform -i 3 -t 1 0 0 -i 1 -s 2 ball.rad") == std::pair(glm::dvec3(8, 0, 0), 1.0));
  CHECK(ball("xform -t 1 0 0 ball.rad | xform -s 2 | xform -t 0 1 0").first == glm::dvec3(4, 1, 0));
  CHECK(ball("xform -rx 90 sub/both.rad").first == glm::dvec3(1, -1, 0));
  const io::Imported ring = read("xform -n ring -m other -t 1 0 0 -a 4 -rz 90 -i 1 -t 0 0 2 ball.rad");
  const auto balls = ring.scene.shapes<scene::Sphere>();
  REQUIRE(balls.size() == 4);
  CHECK((balls[0].centro == glm::dvec3(2, 0, 2) && balls[1].centro == glm::dvec3(0, 2, 2)));
  CHECK((balls[2].centro == glm::dvec3(-2, 0, 2) && balls[3].centro == glm::dvec3(0, -2, 2)));
  CHECK(ring.groups.table().at("ring.3.ball").elementos == scene::Names{"s4"});
  CHECK(ring.lost == Lines{"4 surfaces of no material: what its modifier names is in no text that was read"});
  const auto has_material = [](const io::Imported& made) {
    return made.scene.material(made.scene.find("s1").value()).has_value();
  };
  CHECK(has_material(read("xform -m other ball.rad | xform -m m")));
  CHECK_FALSE(has_material(read("xform -m m ball.rad | xform -m other")));
  CHECK(read("xform -a 2 -t 2 0 0 -a 3 -t 0 2 0 ball.rad").scene.shapes<scene::Sphere>().size() == 6);
  CHECK(read("xform -a 2 -t 2 0 0 ball.rad").groups.table().contains("a1.ball"));
  const auto top = read("xform -ry 90 sub/both.rad").scene.shapes<scene::Disc>()[0];
  CHECK((top.vector == glm::dvec3(0, 0, -1) && top.radio == 2));
}

TEST_CASE("Commands that would need another program are counted, and their files are not read") {
  for (const std::string command :
       {"gensky 6 21 12", "xform -f args ball.rad", "genbox m b 1 1 1 -r 0.1", "xform", "cat -n a", "xform -s 0 a",
        "xform -a 9999999 -t 1 0 0 a", "xform -t 1 2 a.rad", "xform a | rm b", "genbox m b 1 1", "xform `ls`",
        "xform $HOME", "xform a > b", "cat a; cat b", "xform -i", "xform -qx 3 a", "xform 'a", "xform a |",
        "xform -a 1000 -t 1 0 0 -a 1001 -t 0 1 0 a"}) {
    INFO(command);
    const Lines said = lost("!" + command + "\n");
    REQUIRE(said.size() == 1);
    CHECK(said[0] == fmt::format("1 command not carried out: \"{}\"", command.substr(0, command.find_first_of(" |"))));
  }
  CHECK(lost("!genrev a \\\n b c\n!genrev\n# !genrev\n") == Lines{"2 commands not carried out: \"genrev\""});
}

TEST_CASE("A material of Radiance is one of a scene, as far as it is one, and what is not is told") {
  CHECK(look_of("plastic m 0 0 5 0.5 0.25 1 0.125 0").k_ps == 0.125);
  CHECK(look_of("plastic m 0 0 5 0.5 0.25 1 0.125 0").k_d == 0.875);
  const scene::Material rough = look_of("plastic m 0 0 5 0.5 0.25 1 0.125 0.5");
  CHECK((rough.k_s == 0.125 && rough.e == 2 && rough.k_ps == 0));
  CHECK(look_of("metal m 0 0 5 0.5 0.25 1 0.5 0").M_PS == glm::dvec3(0.5, 0.25, 1));
  CHECK(look_of("mirror m 0 0 3 0.5 0.25 1").k_ps == 1);
  const scene::Material glass = look_of("glass m 0 0 3 0.5 0.25 1");
  CHECK((glass.k_t == 1 && glass.M_T == glm::dvec3(0.5, 0.25, 1) && glass.index == 1 && glass.k_d == 0));
  CHECK(look_of("dielectric m 0 0 5 1 1 1 1.5 0").index == 1.5);
  CHECK(look_of("light m 0 0 3 5 6 7").emission == glm::dvec3(5, 6, 7));
  const scene::Material pane = look_of("trans m 0 0 7 0.5 0.5 0.5 0 0 0.5 0.5");
  CHECK((pane.k_t == 0.25 && pane.k_d == 0.5));
  const std::string ball = "\nm sphere s 0 0 4 0 0 0 1";
  CHECK(lost("void light m 0 0 3 5 6 7" + ball) ==
        Lines{"1 surface that shines lights no other: it is as bright as it says"});
  CHECK(lost("void BSDF m 6 0 a.xml 0 0 1 . 0 0" + ball) ==
        Lines{"1 surface without material: BSDF is none that a scene has"});
  CHECK(lost("void plastic m 0 0 5 2 0 0 0 0" + ball) ==
        Lines{"1 surface of a material with a share of light beyond 0 to 1: cut to it"});
  CHECK(lost("void colorpict p 1 a 0 0\np plastic m 0 0 5 1 0 0 0 0" + ball) ==
        Lines{"1 surface without pattern and texture: its material's own look is kept"});
  CHECK(lost("void plastic a 0 0 5 1 0 0 0 0\nvoid mixfunc m 2 a void 0 0" + ball) ==
        Lines{"1 surface of no material: a mixture of two is none that a scene has"});
  CHECK(lost("void plastic a 0 0 5 1 0 0 0 0.5\nvoid alias m a" + ball).empty());
  CHECK(import_text("void plastic a 0 0 5 0.5 0 0 0 0\nvoid alias m a" + ball).scene.stage().materials[0].color.x ==
        0.5);
  CHECK(lost("void alias m b" + ball) ==
        Lines{"1 surface of no material: what its modifier names is in no text that was read"});
  CHECK(lost("m plastic m 0 0 5 0.5 0 0 0 0" + ball).empty());  // it stands for itself
}

TEST_CASE("A narrow source is a sun, one all around a background, and others are left out") {
  const auto stage = [](const std::string& source) {
    return import_text("void light l 0 0 3 100 200 300\nl source sun 0 0 4 " + source).scene.stage();
  };
  const auto suns = stage("0 3 4 0.5").directional_lights;
  REQUIRE(suns.size() == 1);
  CHECK(suns[0].direction == glm::dvec3(0, -3, -4));
  const double share = 2 * (1 - std::cos(0.25 * std::numbers::pi / 180));  // of π
  CHECK(suns[0].color.y == Approx(200 * share).epsilon(1e-9));
  CHECK(stage("0 0 1 360").background == glm::dvec3(100, 200, 300));
  CHECK(lost("void light l 0 0 3 1 2 3\nl source sky 0 0 4 0 0 1 180") ==
        Lines{"1 source left out: neither a sun nor one light all around"});
}

TEST_CASE("What no scene holds is left out, with its number") {
  CHECK(lost("void ring r 0 0 8 0 0 0 0 0 1 1 2") == Lines{"1 ring left out: a scene's disc has no hole"});
  CHECK(lost("void sphere s 0 0 4 0 0 0 0\nvoid cone c 0 0 8 1 1 1 1 1 1 2 1\nvoid ring r 0 0 8 0 0 0 0 0 0 0 1") ==
        Lines{"3 surfaces left out: it breaks a rule of a scene, such as a radius of 0"});
  CHECK(lost("void mesh m 1 a.rtm 0 0\nvoid instance i 1 a.oct 0 0\nvoid mesh n 1 a.rtm 0 0") ==
        Lines{"1 instance left out: it is in a file that another program has made",
              "2 meshes left out: it is in a file that another program has made"});
  CHECK(lost("void sphere a/b 0 0 4 0 0 0 1") == Lines{"1 element in no group: its identifier is no name"});
}

TEST_CASE("A malformed text of Radiance is an error with its place") {
  CHECK(error_at("void ^spehre s 0 0 4 0 0 0 1").starts_with("there is no type \"spehre\""));
  CHECK(error_at("void sphere s 0 0 4 0 0 ^x 1") == "\"x\" in sphere; expected a finite decimal number");
  CHECK(error_at("void sphere s 0 0 ^-4 0 0 0 1").starts_with("\"-4\" in the place of the number of numbers"));
  CHECK(error_at("\n^void sphere s 0 0 3 0 0 0") == "sphere of 3 numbers; expected 4");
  CHECK(error_at("^void polygon p 0 0 6 0 0 0 1 1 1").starts_with("polygon of 6 numbers"));
  CHECK(error_at("void sphere s 0 0 4 0 0^").starts_with("the text ends before sphere"));
  CHECK(error_at("void mixtext t 1 ^\"a b").starts_with("a word does not end"));
  CHECK(error_at("^void plastic m 0 0 3 1 1 1\nm sphere s 0 0 4 0 0 0 1") == "plastic has 3 numbers; expected 5");
  CHECK(error_at("^void light m 0 0 3 1 -1 1\nm sphere s 0 0 4 0 0 0 1").starts_with("a light below 0"));
  CHECK(error_at("^void dielectric m 0 0 5 1 1 1 0 0\nm sphere s 0 0 4 0 0 0 1").starts_with("an index of refraction"));
  CHECK(error_at("^!xform gone.rad")
            .starts_with("no file \"gone.rad\"; expected a file in the folder of the scene or beneath it"));
  CHECK(error_at("^!xform ../f.rad").starts_with("no file"));
}

TEST_CASE("A text that goes on for ever ends in one line") {
  const test::Folder folder;
  write(folder, "self.rad", "!xform -t 1 0 0 self.rad\n");
  write(folder, "many.rad", "!xform -a 1000 -t 1 0 0 more.rad\n");
  write(folder, "more.rad", "!xform -a 1000 -t 0 1 0 most.rad\n");
  write(folder, "most.rad", "!xform -a 1000 -t 0 0 1 none.rad\n");
  write(folder, "none.rad", "# nothing\n");
  for (int i = 0; i < 33; ++i) write(folder, fmt::format("d{}.rad", i + 1), fmt::format("!cat d{}.rad\n", i));
  write(folder, "d0.rad", "# nothing\n");
  write(folder, "long.rad", "#" + std::string(std::size_t{1} << 24U, '-'));
  write(folder, "again.rad", "!xform -a 65 -t 0 0 1 long.rad\n");
  const auto error = [&](const std::string& file) {
    try {
      io::read_radiance(io::read_source(folder.file(file)));
    } catch (const io::InputError& refused) {
      return std::string(refused.message());
    }
    return std::string();
  };
  CHECK(error("self.rad") == "commands within commands, 33 deep; expected 32 at most");
  CHECK(error("d32.rad").empty());
  CHECK(error("d33.rad") == error("self.rad"));
  CHECK(error("again.rad").starts_with("more than 1073741824 bytes of files"));
  CHECK(error("many.rad") == "more than 20000000 primitives and files; expected a text that ends sooner");
}

TEST_CASE("No damage to a text of Radiance does worse than an error") {
  CHECK(test::refused_after_damage(sample, 20000, reading) > 8000);
}
