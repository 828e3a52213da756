// POV-Ray's language as a program: expressions, names, loops, macros, files, and what ends it.
#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include "durero/io/json/scene_file.hpp"
#include "durero/io/pov/pov.hpp"
#include "durero/scene/stage.hpp"
#include "io/malformed.hpp"
#include "support/catch.hpp"

using namespace durero;

namespace {

io::Imported import_text(const std::string& text) { return io::read_pov(io::Source("f", text + "\n#version 3.7;")); }
/// The middles and radii of the balls of a text.
std::vector<glm::dvec4> balls(const std::string& text) {
  std::vector<glm::dvec4> all;
  const io::Imported read = import_text(text);
  for (const scene::Sphere& ball : read.scene.shapes<scene::Sphere>()) all.emplace_back(ball.centro, ball.radio);
  return all;
}
/// The value of an expression, of which a ball is so far from the origin.
glm::dvec3 value(const std::string& expression) { return glm::dvec3(balls("sphere { " + expression + ", 1 }").at(0)); }
std::string error_at(const std::string& with_mark) {
  return test::error_at_mark(with_mark, [](const io::Source& s) { return io::read_pov(s); });
}
using Balls = std::vector<glm::dvec4>;

/// A folder that is removed with what is in it.
class Folder {
 public:
  Folder() : path_(std::filesystem::temp_directory_path() / fmt::format("durero_pov_{}", getpid())) {
    std::filesystem::create_directories(path_ / "parts" / "x");
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  void write(const std::string& name, const std::string& text) const { std::ofstream(path_ / name) << text; }
  std::string path(const std::string& name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

}  // namespace

TEST_CASE("Expressions have the values that POV-Ray gives them") {
  for (const auto& [expression, expected] : std::vector<std::pair<std::string, glm::dvec3>>{
           {"<1, 2, 3>*2 - x", {1, 4, 6}},
           {"<1 2 3>", {1, 2, 3}},
           {"<2 -1, (3), 4/8>", {1, 3, 0.5}},
           {"2", {2, 2, 2}},
           {"<2-3*-2, -2*-3, 10-4-3>", {8, 6, 3}},
           {"<mod(-7, 3), int(-2.5), div(-7, 2)>", {-1, -2, -3}},
           {"<(1 < 2) + 0, ((1 < 2) & (3 != 3) | 1), (0 ? 5 : 6)>", {1, 1, 6}},
           {"<select(-1, 1, 2), select(0, 1, 2, 3), !0>", {1, 2, 1}},
           {"<max(1, 5, 3), min(4, 2), abs(-3)>", {5, 2, 3}},
           {"vcross(x, y) + vnormalize(<0, 3, 4>)*5", {0, 3, 5}},
           {"<vdot(<1, 2, 3>, <2, 3, 4>), vlength(<3, 4, 0>), <7, 8>.v>", {20, 5, 8}},
           {"<strlen(\"four\"), asc(\"A\"), val(\"2.5\")>", {4, 65, 2.5}},
           {"<strcmp(\"a\", \"b\"), strlen(concat(\"ab\", str(1.5, 6, 2))), strlen(substr(\"hello\", 2, 3))>",
            {-1, 8, 3}},
           {"<rgb <0.25, 0.5, 1>.red, (rgbt <0, 0, 0, 0.5>).transmit, <1, 1, 1>.gray>", {0.25, 0.5, 1}}}) {
    CAPTURE(expression);
    CHECK(glm::distance(value(expression), expected) < 1e-14);
  }
  CHECK(value("<image_width, image_height, 0>") == glm::dvec3(640, 480, 0));
  CHECK(balls("// +W32 +H18\nsphere { <image_width, image_height, clock>, 1 }") == Balls{{32, 18, 0, 1}});
  CHECK(value("<rand(seed(1)), 0, 0>").x == 1812445598.0 / 4294967295.0);
}

TEST_CASE("Names stand for numbers, texts, arrays, objects and looks") {
  CHECK(balls("#declare R = 2; #local At = <1, 2, 3>; sphere { At*R, R }") == Balls{{2, 4, 6, 2}});
  CHECK(balls("#declare R = -2; sphere { <1 R 3>, 1 } sphere { <4-R, 1, 0>, 1 }") ==
        Balls{{1, -2, 3, 1}, {6, 1, 0, 1}});
  CHECK(balls("#declare R = 5 #declare Q = R*2 sphere { 0, Q }") == Balls{{0, 0, 0, 10}});
  CHECK(balls("#declare Ball = sphere { x, 1 } object { Ball } object { Ball translate y }") ==
        Balls{{1, 0, 0, 1}, {1, 1, 0, 1}});
  CHECK(balls("#declare A = array[2][2] { {1, 2}, {3, 4} } #declare A[1][0] = 7;\n"
              "sphere { <A[0][1], A[1][0], dimension_size(A, 2)>, A[1][1] }") == Balls{{2, 7, 2, 4}});
  CHECK(
      balls(
          "#declare A = array[2] #declare A[0] = sphere { x, 1 } #ifdef (A[1]) sphere { 0, 9 } #end object { A[0] }") ==
      Balls{{1, 0, 0, 1}});
  CHECK(balls("#declare S = 1; #macro M() #local S = 2; sphere { S*x, 1 } #end M() sphere { S*y, 1 }\n"
              "#undef S #ifndef (S) sphere { 3*z, 1 } #end") == Balls{{2, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 3, 1}});
  CHECK(balls("#declare F = function(a, b) { a*a + b } #declare G = function { x + 2*y } sphere { <F(3, 1), G(1, 2, "
              "0), 0>, 1 }") == Balls{{10, 5, 0, 1}});
  const io::Imported looks = import_text(
      "#declare White = rgb 1; #declare F = finish { ambient 0 diffuse 0.5 } #declare T = texture { pigment { "
      "White*0.5 } finish "
      "{ F } }\nsphere { 0, 1 texture { T } } sphere { x, 1 pigment { color White filter 0.25 } finish { F diffuse 1 } "
      "}");
  REQUIRE(looks.scene.stage().materials.size() == 2);
  CHECK(looks.scene.stage().materials[0] == scene::Material{.name = "f1", .color = glm::dvec3(0.5), .k_d = 0.5});
  CHECK(looks.scene.stage().materials[1].k_t == 0.25);
  CHECK(looks.lost == std::vector<std::string>{"1 object that light goes through: its shadow is that of a stone"});
}

TEST_CASE("Conditions, choices and loops are carried out") {
  CHECK(balls("#declare I = 0; #while (I < 3) sphere { I*x, 1 } #declare I = I + 1; #end").size() == 3);
  CHECK(balls("#for (I, 0, 1, 0.1) sphere { I*x, 1 } #end").size() == 11);
  CHECK(balls("#for (I, 5, 1, -2) sphere { I*x, 1 } #end") == Balls{{5, 0, 0, 1}, {3, 0, 0, 1}, {1, 0, 0, 1}});
  CHECK(balls("#for (I, 0, 9) #if (I = 2) #break #end sphere { I*x, 1 } #end").size() == 2);
  for (const auto& [chosen, radius] : {std::pair(1, 1.0), {2, 2.0}, {6, 3.0}, {9, 4.0}}) {
    const std::string text = fmt::format(
        "#switch ({}) #case (1) sphere {{ 0, 1 }} #break #case (2) sphere {{ 0, 2 }} #break #range (5, 7) sphere {{ 0, "
        "3 }} "
        "#break #else sphere {{ 0, 4 }} #end",
        chosen);
    CHECK(balls(text) == Balls{{0, 0, 0, radius}});
  }
  CHECK(balls("#switch (1) #case (1) sphere { 0, 1 } #case (2) sphere { 0, 2 } #end").size() == 2);  // it goes on
  CHECK(balls("#if (0) torus { #else sphere { 0, 1 #end }") == Balls{{0, 0, 0, 1}});
  CHECK(balls("#if (0) #if (1) #else #end nothing #elseif (1) sphere { 0, 1 } #else nothing #end").size() == 1);
  CHECK(balls("#declare S = \"a\"; #if (S = \"a\") sphere { 0, 1 } #end #if (\"a\" != S) nothing #end").size() == 1);
  CHECK(balls("#declare A = #if (1) 2; #else 3; #end sphere { 0, A }") == Balls{{0, 0, 0, 2}});
}

TEST_CASE("Macros are given values, names and objects, and call themselves") {
  CHECK(balls("#macro Row(N, At) #if (N > 0) sphere { At, N } Row(N - 1, At + x) #end #end Row(3, 0)") ==
        Balls{{0, 0, 0, 3}, {1, 0, 0, 2}, {2, 0, 0, 1}});
  CHECK(balls("#macro Twice(A) 2*A #end sphere { 0, Twice(3) + 1 }") == Balls{{0, 0, 0, 7}});
  CHECK(balls("#macro Next(A) #declare A = A + 1; #end #declare N = 1; Next(N) Next(N) sphere { 0, N }") ==
        Balls{{0, 0, 0, 3}});
  CHECK(balls("#macro Both(O) object { O } object { O translate x } #end Both(sphere { 0, 1 })") ==
        Balls{{0, 0, 0, 1}, {1, 0, 0, 1}});
  CHECK(balls("#macro M(A) sphere { 0, A } #end M(#undef M #macro M(A) sphere { 0, 9 } #end 2)") ==
        Balls{{0, 0, 0, 2}});
}

TEST_CASE("Files are included from the folder of the text and below it, and from nowhere else") {
  const Folder folder;
  folder.write("parts/ball.inc", "#local Secret = 3; #declare Radius = 2; #macro Ball(At) sphere { At, Radius } #end");
  folder.write("main.pov", "#include \"parts/ball.inc\" Ball(x) #ifdef (Secret) sphere { 0, 9 } #end #version 3.7;");
  const io::Imported read = io::read_pov(io::read_source(folder.path("main.pov")));
  REQUIRE(read.scene.shapes<scene::Sphere>().size() == 1);
  CHECK(read.scene.shapes<scene::Sphere>()[0].radio == 2);
  folder.write("parts/wrong.inc", "sphere {\n  0 }");
  folder.write("main.pov", "#include \"parts/wrong.inc\"");
  try {
    io::read_pov(io::read_source(folder.path("main.pov")));
    FAIL("it is read");
  } catch (const io::InputError& error) {
    CHECK(std::string(error.what()) ==
          folder.path("parts/wrong.inc") + ":2:5: \"}\" in sphere; expected a finite number");
  }
  folder.write("empty.inc", "");
  folder.write("main.pov", "#if (file_exists(\"empty.inc\") & !file_exists(\"no.inc\")) sphere { 0, 1 } #end");
  CHECK(io::read_pov(io::read_source(folder.path("main.pov"))).scene.size() == 1);
  for (const std::string& outside : {folder.path("empty.inc"), std::string("../empty.inc"),
                                     std::string("x/../../empty.inc"), std::string(), std::string(".")}) {
    folder.write("parts/inner.pov", fmt::format("#include \"{}\"", outside));
    CHECK_THROWS_AS(io::read_pov(io::read_source(folder.path("parts/inner.pov"))), io::InputError);
  }
}

TEST_CASE("A program that does not end, or is wrong, is one line at its place") {
  using Case = std::pair<std::string, std::string>;
  for (const auto& [text, expected] : {
           Case{"#macro M() ^M() #end M()",
                "macros, files and names within each other, deeper than 10,000; expected 10,000 at most"},
           {"#declare F = function(a) { ^F(a) } sphere { 0, F(1) }",
            "functions within each other, deeper than 300; expected 300 at most"},
           {"#include ^", "the text ends; expected a text behind #include"},
           {"^#include \"no.inc\"",
            "no file \"no.inc\"; expected a file in the folder of the scene or beneath it, or one of POV-Ray's own "
            "where it is "
            "installed"},
           {"^#includ \"a\"", "#includ is not carried out; expected another directive"},
           {"#if (1) sphere { 0, 1 } ^", "the text ends; expected #end for each #if, #while, #for and #switch"},
           {"#if (0) ^", "the text ends; expected #end for each #if, #while, #for, #switch and #macro"},
           {"^#end", "#end without a beginning; expected #if, #while, #for or #switch before it"},
           {"^#else", "#else without #if; expected one before it"},
           {"^#break", "#break outside of a loop or a #switch; expected one around it"},
           {"#for (I, 0, 1, 0^) #end", "\")\" stands here; expected a step other than 0 in #for"},
           {"#declare ^= 1;", "\"=\" stands here; expected a name behind #declare"},
           {"#declare A = array[2]; #declare A[2^] = 1;",
            "\"]\" stands here; expected the number of an element, 0 to 1"},
           {"#declare A = array[2]; sphere { 0, ^A[0] }", "an element of \"A\" has no value here; expected one"},
           {"#macro M(A) #end ^M()", "M is given 0 values; expected 1"},
           {"sphere { 0, 1/0 ^}", "an expression without a finite value; expected one"},
           {"sphere { 0, ^sqrt(-1) }", "an expression without a finite value; expected one"},
           {"sphere { 0, ^pow(2) }", "pow of 1 values; expected 2"},
           {"sphere { 0, (^>) }", "\">\" stands here; expected a finite number"},
           {"sphere { 0, <1, 2, 3>.^a }", "\"a\" stands here; expected a component, such as x or red"},
           {"sphere { 0, ^min_extent(Ball) }", "min_extent is not carried out; expected a value that asks no object"},
           {"^#error \"no way\"", "the text ends itself: \"no way\"; expected no #error"},
           {"^#read (F, A)", "#read is not carried out; expected numbers in the text, or in a file that it includes"},
       }) {
    INFO(text);
    CHECK(error_at(text) == expected);
  }
  CHECK_THROWS_WITH(import_text("sphere { 0, " + std::string(400, '(')),
                    Catch::Contains("expected expressions within each other, 300 at most"));
}

TEST_CASE("A program without an end, and one that leaves too much, are refused", "[long]") {
  CHECK(error_at("#while ^(1) #end") == "a program of more than 200,000,000 steps; expected one that ends before");
  std::string bomb = "#declare A0 = sphere { 0, 1 }\n";
  for (int i = 1; i < 40; ++i)
    bomb += fmt::format("#declare A{0} = union {{ object {{ A{1} }} object {{ A{1} }} }}\n", i, i - 1);
  CHECK_THROWS_WITH(import_text(bomb), Catch::Contains("leaves more than 16,000,000 words"));
}

TEST_CASE("No damage to a POV-Ray program does worse than an error") {
  const std::string program = R"(#version 3.7; #declare R = 1; #declare A = array[2] { 1, <2, 3, 4> }
#macro Ball(At, Of) #for (I, 1, Of) sphere { At + I*x, R scale 2 rotate 30*y } #end #end
#declare F = function(a, b) { a*b + 1 } #for (K, 0, 2) Ball(K*y, F(1, K)) #end
#if (defined(R) & (A[0] = 1)) difference { box { -1, A[1] } cylinder { -2*y, 2*y, 0.5 } matrix <1, 0, 0, 0, 1, 0, 0.5, 0, 1, 0, 0, 0> } #else torus { 1, 0.5 } #end
#switch (R) #case (1) mesh2 { vertex_vectors { 3, 0, x, y } face_indices { 1, <0, 1, 2> } } #break #end
#default { finish { ambient 0 } } plane { y, -1 pigment { checker rgb 1 rgb 0 } } light_source { <1, 2, 3>, rgb 1 fade_power 2 }
)";
  CHECK(import_text(program).scene.size() == 9);
  CHECK(test::refused_after_damage(program, 2000, [](const io::Source& s) { return io::read_pov(s); }) > 300);
}
