#include "durero/written/text.hpp"

#include <fstream>
#include <sstream>

#include "durero/io/pov/algebraic.hpp"
#include "durero/io/source.hpp"
#include "support/catch.hpp"
#include "support/folder.hpp"
#include "support/tree.hpp"

namespace durero::written {
namespace {

using io::WrittenKind;
using io::WrittenValue;

const std::string surfaces = test::source_dir() + "/demo/surfaces/";

/// A section `mia` with that text in it, in Unicode or LaTeX.
class Written {
 public:
  explicit Written(const std::string& text) {
    std::ofstream(file()) << "\\begin{zsection}\n  \\SECTION mia \\parents puntos\n\\end{zsection}\n" << text;
  }
  std::string file() const { return folder_.file("mia.tex"); }
  Text text() const { return Text(file()); }

 private:
  test::Folder folder_;
};

/// puntos_cosa(centro, radio) is the set of the w with that predicate.
std::string cosa(const std::string& predicate) {
  return "\\begin{axdef}\n  puntos\\_cosa : Punto \\cross Rmas \\fun \\power Punto\n\\where\n"
         "  \\forall centro : Punto; radio : Rmas @ puntos\\_cosa(centro, radio) = \\{~ w : Punto |\n" +
         predicate + " ~\\}\n\\end{axdef}\n";
}

/// What is said of the text, behind its file: `LINE:COLUMN: …`.
template <class Do>
std::string error_of(const Written& written, Do&& what) {
  try {
    what();
  } catch (const io::InputError& error) {
    const std::string line = error.what();
    if (!line.starts_with(written.file() + ":")) return line;
    return line.substr(written.file().size() + 1);
  }
  return "no error";
}

std::string error_of_cosa(const std::string& predicate) {
  const Written written(cosa(predicate));
  return error_of(written, [&] { written.text().surface("cosa", {glm::dvec3(1, 0, 0), 2.0}); });
}

model::Rayo along_x() { return {model::Punto(glm::dvec3(-9, 0, 0)), model::Vector(glm::dvec3(1, 0, 0))}; }

/// The x at which the axis meets puntos_cosa((1, 0, 0), 2).
double met(const std::string& predicate) {
  const Written written(cosa(predicate));
  const First first = written.text().surface("cosa", {glm::dvec3(1, 0, 0), 2.0}).first(along_x(), false);
  return algebra::rounded_linear(-9, 1, std::get<algebra::Root>(first));
}

TEST_CASE("The attributes of a type are the parameters of its function, or the components of their schema") {
  const Text torus(surfaces + "torus.tex");
  REQUIRE(torus.types().size() == 1);
  CHECK(torus.types()[0].word == "toro");
  REQUIRE(torus.types()[0].attributes.size() == 3);
  CHECK(torus.types()[0].attributes[0].word == "centro");
  CHECK(torus.types()[0].attributes[0].kind == WrittenKind::triple);
  CHECK(torus.types()[0].attributes[2].word == "menor");
  CHECK(torus.types()[0].attributes[2].kind == WrittenKind::number);
  const Text ellipsoid(surfaces + "ellipsoid.tex");
  REQUIRE(ellipsoid.types().size() == 1);
  CHECK(ellipsoid.types()[0].attributes[3].word == "hondo");
  const Written lambda("\\begin{zed}\n  puntos\\_cara == \\lambda v : Vertices @ puntos\\_triangulo(v)\n\\end{zed}\n");
  REQUIRE(lambda.text().types().size() == 1);
  CHECK(lambda.text().types()[0].attributes[0].kind == WrittenKind::three_points);
}

TEST_CASE("What the program has shapes for is no type of the text's own, and has its points by it all the same") {
  const Text text(test::source_dir() + "/spec/puntos.tex");
  for (const io::WrittenType& type : text.types()) CHECK(type.word != "esfera");
  const First first = text.surface("esfera", {glm::dvec3(0), 4.0}).first(along_x(), false);
  CHECK(algebra::rounded_linear(0, 1, std::get<algebra::Root>(first)) == 5);
}

TEST_CASE("A predicate may be written in many ways") {
  for (const char* predicate : {"(w.x - centro.x) * (w.x - centro.x) + w.y * w.y + w.z * w.z = radio * radio",
                                "potencia\\_esfera(w, centro, radio) = 0", "w \\in puntos\\_esfera(centro, radio)",
                                "\\lnot w \\notin puntos\\_esfera(centro, radio)",
                                "(\\LET p == potencia\\_esfera(w, centro, radio) @ 0 \\leq p \\land p = 0)",
                                "w \\in puntos\\_esfera(centro, radio) \\cap puntos\\_esfera(centro, radio)",
                                "w \\in puntos\\_esfera(centro, radio) \\setminus \\{~ u : Punto | u.x > 100 ~\\}",
                                "w \\in \\{~ u : Punto | potencia\\_esfera(u, centro, radio) = 0 ~\\}",
                                "(\\lambda u : Punto @ potencia\\_esfera(u, centro, radio))(w) = 0",
                                "(\\IF radio > 1 \\THEN potencia\\_esfera(w, centro, radio) \\ELSE w.x) = 0",
                                "potencia\\_esfera(\\lblot x == w.x, y == w.y, z == w.z \\rblot, centro, radio) = 0",
                                "(w, potencia\\_esfera(w, centro, radio)).2 = 0 \\land (w.x < 100 \\implies w.x < 50)",
                                "potencia\\_esfera(w, centro, radio) * 2251799813685248 * tolerancia\\_unidad = 0"}) {
    CAPTURE(predicate);
    CHECK(met(predicate) == -1);
  }
  CHECK(met("potencia\\_esfera(w, centro, radio) = 0 \\land w.x \\geq centro.x") == 3);
  CHECK(met("potencia\\_esfera(w, centro, radio) = 0 \\land (w.x > 2 \\lor w.x < \\negate 4)") == 3);
  CHECK(met("potencia\\_esfera(w, centro, radio) = 0 \\land (w.x < 2 \\iff w.x < \\negate 4)") == 3);
  CHECK(met("w = centro") == 1);
}

TEST_CASE("What is no algebraic surface is refused at its place") {
  CHECK(error_of_cosa("distancia(w, centro) = radio") == "8:1: distancia is not declared; expected a declared name");
  CHECK(error_of_cosa("raizcuadrada(w.x) = radio").starts_with("8:1: raizcuadrada is defined by no equation that "));
  CHECK(error_of_cosa("w.x \\div 2 = 0").starts_with("8:1: "));
  CHECK(error_of_cosa("\\exists t : \\real @ w.x = t * t").ends_with("joined by ∧, ∨, ¬, ⇒ and ⇔"));
  CHECK(
      error_of_cosa("0 \\leq w.x") ==
      "7:72: not all points of puntos_cosa satisfy an equation; expected p = q ∧ clips, where p and q are polynomials, "
      "or a union of such");
  CHECK(error_of_cosa("(\\IF w.x > 0 \\THEN w.y \\ELSE w.z) = 0")
            .find("which of the two it is depends on the point; expected one polynomial") != std::string::npos);
  CHECK(error_of_cosa("potencia\\_esfera(w, centro, w.x) = 0") ==
        "8:1: potencia_esfera may be applied outside its domain; expected radio ∈ Rmas");
  CHECK(error_of_cosa("w \\in puntos\\_de\\_rayo(\\lblot p == centro, v == centro \\rblot)").find("; expected ") !=
        std::string::npos);
}

TEST_CASE(
    "A union is a surface at the top, under a clip and of sets; one with a solid in it is refused, or of too many") {
  CHECK(met("w.x = 5 \\lor w.x = 3") == 3);
  CHECK(met("w.x = 5 \\lor w.x = 3 \\land w.y > 0 \\lor w.x = 4") == 4);
  CHECK(met("(w.x = 5 \\lor w.x = 3) \\land w.x > 4") == 5);
  CHECK(met("(w.y > 0 \\lor w.z > 0 \\lor w.y = 0) \\land (w.x = 5 \\lor w.x = 4)") == 4);
  CHECK(met("\\lnot (w.x \\neq 5 \\land w.x \\neq 3)") == 3);
  CHECK(met("w \\in puntos\\_esfera(centro, radio) \\cup \\{~ u : Punto | u.x = \\negate 2 ~\\}") == -2);
  CHECK(met("w.x = 5 \\lor false") == 5);
  const std::string solid = "7:72: not all points of puntos_cosa satisfy an equation; ";
  for (const char* predicate :
       {"w.x = 0 \\lor w.y > 0", "w.x = 0 \\lor true", "\\lnot w.x = 0", "w.x = 0 \\implies w.y = 0",
        "w.x = 0 \\iff w.y = 0", "(w.x = 0 \\lor w.y = 0) \\land w.z > 0 \\lor w.z < 0",
        "(w.x = 0 \\lor w.y > 0) \\land (w.x = 1 \\lor w.z > 0)", "w.x = w.x",
        "w \\in puntos\\_esfera(centro, radio) \\cup \\{~ u : Punto | u.x > 0 ~\\}",
        "w \\notin puntos\\_esfera(centro, radio)"}) {
    CAPTURE(predicate);
    CHECK(error_of_cosa(predicate).starts_with(solid));
  }
  std::string many = "w.x = 0";
  for (int i = 1; i < 64; ++i) many += " \\lor w.x = " + std::to_string(i);
  CHECK(met(many) == 0);
  CHECK(error_of_cosa(many + " \\lor w.x = 64") == "7:72: puntos_cosa is a union of 65 pieces; expected 64 at most");
}

TEST_CASE("A degree that is too high ends in one line, and so do too many steps") {
  std::string power = "w.x";
  for (int i = 0; i < 5; ++i) power = "cuadrado(" + power + ")";
  CHECK(error_of_cosa(power + " = 1").find("is a polynomial of too high a degree; expected a degree of 24 at most") !=
        std::string::npos);
  std::string twice =
      "\\begin{zed}\n  f0 == \\lambda r : \\real @ r + r\n\\end{zed}\n";  // each applies that before it twice
  for (int i = 1; i <= 20; ++i) {
    const std::string f = "f" + std::to_string(i), before = "f" + std::to_string(i - 1);
    twice += "\\begin{zed}\n  " + f + " == \\lambda r : \\real @ " + before + "(r) + " + before + "(r)\n\\end{zed}\n";
  }
  const Written many(twice + cosa("f20(w.x) = 1")), few(twice + cosa("f9(w.x) = 1"));
  CHECK(error_of(many, [&] {
          many.text().surface("cosa", {glm::dvec3(0), 1.0});
        }).ends_with("puntos_cosa takes more steps than it may; expected a shorter text"));
  const Text many_elements = few.text();  // each element has its steps
  for (int i = 0; i < 800; ++i) CHECK_NOTHROW(many_elements.surface("cosa", {glm::dvec3(0), 1.0}));
  const Written endless(
      "\\begin{axdef}\n  sin : \\real \\fun \\real\n\\where\n  \\forall r : \\real @ sin(r) = sin(r) + r\n"
      "\\end{axdef}\n" +
      cosa("sin(w.x) = 1"));
  CHECK(error_of(endless, [&] {
          endless.text().surface("cosa", {glm::dvec3(0), 1.0});
        }).ends_with("definitions are nested too deeply; expected fewer"));
}

TEST_CASE("Attributes outside the domain of the function are refused by name") {
  const Text torus(surfaces + "torus.tex");
  const auto refused = [&](double mayor, double menor) -> std::pair<std::string, std::string> {
    try {
      torus.surface("toro", {glm::dvec3(0), mayor, menor});
    } catch (const NotInDomain& not_in_domain) {
      return {not_in_domain.attribute, not_in_domain.expected};
    }
    return {"", ""};
  };
  CHECK(refused(2, 1) == std::pair<std::string, std::string>{"", ""});
  CHECK(refused(1, 2).second == "menor < mayor");
  CHECK(refused(2, -1) == std::pair<std::string, std::string>{"menor", "menor ∈ Rmas"});
  CHECK(refused(-2, 1) == std::pair<std::string, std::string>{"mayor", "mayor ∈ Rmas"});
}

TEST_CASE("A text without points of a type is refused, and so is one that is wrong") {
  const Written none("\\begin{zed}\n  uno == 1\n\\end{zed}\n");
  CHECK(error_of(none, [&] { none.text(); }) ==
        "1:1: no section of it declares points of a type of elements; expected a function such as puntos_toro, to ℙ "
        "Punto");
  const Written wrong("\\begin{zed}\n  uno == dos\n\\end{zed}\n");
  CHECK(error_of(wrong, [&] { wrong.text(); }).starts_with("5:10: dos is not declared; "));
  CHECK_THROWS_AS(Text("no/such/file.tex"), io::FileError);
  CHECK_THROWS_AS(Text(io::Source("t", "nothing")), io::InputError);
  const Written key(
      "\\begin{axdef}\n  puntos\\_x : Punto \\fun \\power Punto\n\\where\n"
      "  \\forall material : Punto @ puntos\\_x(material) = \\{~ w : Punto | w = material ~\\}\n\\end{axdef}\n");
  CHECK(
      error_of(key, [&] { key.text(); })
          .ends_with(
              "a parameter of puntos_x is called material; expected another name: every element has that of its own"));
  const Written points(cosa("w = centro"));
  CHECK(error_of(points, [&] { points.text().surface("nada", {}); }).starts_with("1:1: no equation gives puntos_nada"));
  CHECK(error_of(points, [&] {
          points.text().surface("cosa", {1.0});
        }).ends_with("puntos_cosa takes 2 arguments; expected 1, the attributes of cosa"));
}

TEST_CASE("A text in memory is read as its file is, and finds its parents in the program's own text alone") {
  std::ostringstream torus;
  torus << std::ifstream(surfaces + "torus.tex").rdbuf();
  const Text held(io::Source("a name", torus.str()));
  CHECK(held.file() == "a name");
  CHECK(held.types() == Text(surfaces + "torus.tex").types());
  CHECK_FALSE(held.declares_shapes());
  const std::string beside = surfaces + "new.tex";
  const std::string child = "\\begin{zsection}\n  \\SECTION nuevo \\parents toro\n\\end{zsection}\n";
  try {
    const Text refused(io::Source(beside, child));
    FAIL("a text in memory has found its parent in a folder");
  } catch (const io::InputError& error) {
    CHECK(error.message() == "unknown parent toro; expected a section, or a file toro.tex");
  }
}

TEST_CASE("A text declares shapes where it gives their points, or has a section in the place of the program's own") {
  const auto declares = [](std::initializer_list<std::string> files) {
    const test::Folder folder;
    const std::string all = folder.file("all.tex");
    {
      std::ofstream out(all);
      for (const std::string& file : files) out << std::ifstream(test::source_dir() + "/" + file).rdbuf() << '\n';
    }
    return Text(all).declares_shapes();
  };
  const std::string torus = "demo/surfaces/torus.tex";
  CHECK_FALSE(declares({torus}));
  CHECK(declares({"demo/surfaces/instances.tex"}));  // a section instancias
  CHECK(declares({"spec/puntos.tex"}));
  CHECK(declares({"spec/tipos.tex", torus}));
  CHECK(declares({"spec/impresa/dibujo/superficies.tex"}));
}

TEST_CASE("The types of POV-Ray's surfaces are those that their text declares") {
  const Text text(surfaces + "algebraic.tex");
  const std::span<const io::WrittenType> types = io::algebraic_types();
  CHECK((std::vector(types.begin(), types.end()) == text.types()));
}

TEST_CASE("Numbers of an element, numerals and the point are off where points are asked that may be moved") {
  using number::Rational;
  const Written written(cosa("w.x - centro.x = radio + 3"));
  const Text text = written.text();
  const auto met = [&](const Rational& x, const AttributeErrors& errors, const Rational& off) {
    const MovedPoint at{{x, 0, 0}, {1, 0, 0}, off, 0};
    return text.moved_points("cosa", {glm::dvec3(1, 0, 0), 2.0}, errors, at).may_be_within({0, 0});
  };
  const AttributeErrors none{0, 0}, part{Rational(1, 8), 0}, least{0, Rational(1, 16)};
  CHECK(met(6, none, 0));
  CHECK_FALSE(met(Rational(25, 4), none, 0));
  // 1/8 of 1, 2 and 3 together are 3/4.
  CHECK(met(Rational(53, 8), part, 0));
  CHECK_FALSE(met(Rational(55, 8), part, 0));
  CHECK(met(Rational(49, 8) - Rational(1, 64), least, 0));
  CHECK_FALSE(met(Rational(49, 8) + Rational(1, 64), least, 0));
  CHECK(met(Rational(25, 4), none, Rational(1, 4)));
  CHECK_FALSE(met(Rational(25, 4), none, Rational(1, 8)));
}

TEST_CASE("A text that asks which polynomial it is of numbers that are off is an error") {
  const Written written(cosa("(\\IF radio = 2 \\THEN w.x \\ELSE w.y) = 0"));
  const Text text = written.text();
  const MovedPoint at{{0, 0, 0}, {1, 0, 0}, 0, 0};
  CHECK_THROWS_AS(text.moved_points("cosa", {glm::dvec3(1, 0, 0), 2.0}, {number::Rational(1, 8), 0}, at),
                  io::InputError);
  CHECK_NOTHROW(text.moved_points("cosa", {glm::dvec3(1, 0, 0), 5.0}, {number::Rational(1, 8), 0}, at));
}

}  // namespace
}  // namespace durero::written
