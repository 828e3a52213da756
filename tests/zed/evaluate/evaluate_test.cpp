#include "durero/zed/evaluate/evaluate.hpp"

#include "durero/zed/syntax/parser.hpp"
#include "support/catch.hpp"
#include "support/tree.hpp"

namespace durero::zed {
namespace {

std::vector<Section> specification() {
  const std::string folder = durero::test::source_dir() + "/spec/";
  const auto read = read_files({folder + "tipos.tex", folder + "escena.tex", folder + "operaciones.tex",
                                folder + "puntos.tex", folder + "interseccion.tex", folder + "iluminacion.tex",
                                folder + "luz.tex", folder + "distribuida.tex"});
  REQUIRE(read.ok());
  return read.sections;
}

const Evaluator& evaluator() {
  static const Evaluator evaluator(specification());
  return evaluator;
}

std::string value(const std::string& expression) { return evaluator().value(parse_unicode(expression)).text(); }
bool holds(const std::string& predicate) {
  const Truth truth = evaluator().holds(parse_unicode(predicate));
  REQUIRE(truth != Truth::open);
  return truth == Truth::yes;
}

/// Returns why an evaluator on this text does not decide a predicate, or nothing where it is true.
std::string undecided(const std::string& text, const std::string& predicate) {
  const Specification read = read_text(text, "s.tex");
  REQUIRE(read.ok());
  try {
    return Evaluator(read.sections).holds(parse_unicode(predicate)) == Truth::yes ? "" : "false";
  } catch (const EvaluationError& error) {
    return error.what();
  }
}

TEST_CASE("a name that two sections declare is not decided, nor a text that declares a name of the toolkit") {
  const auto section = [](const std::string& name, const std::string& parents, const std::string& definition) {
    return "\\begin{zsection} \\SECTION " + name + " \\parents " + parents + " \\end{zsection}\n\\begin{zed} " +
           definition + " \\end{zed}\n";
  };
  const std::string two = section("a", "prelude", "n == 1 \\\\ m == 1") + section("b", "prelude", "n == 2 \\\\ k == 2");
  CHECK(undecided(two, "n = 2") == "n is declared in a and in b, and what is evaluated has one meaning of it");
  CHECK(undecided(two, "m + k = 3").empty());
  const std::string own = section("a", "prelude", "dom == \\lambda x : \\nat @ x + 1 \\\\ n == dom~1");
  for (const char* asked : {"dom 1 = 2", "n = 2", "∀ f : ℕ ⇸ ℕ • dom f = ∅"})
    CHECK(undecided(own, asked) ==
          "dom is declared in a and in relation_toolkit, and what is evaluated has one meaning of it");
}

TEST_CASE("numbers, tuples and bindings") {
  CHECK(value("1 + 2 * 3") == "7");
  CHECK(value("(μ r : ℝ | r * 2 = 1)") == "1/2");
  CHECK(value("(1, 2).2") == "2");
  CHECK(value("⦉x == 1, y == 2, z == 3⦊.y") == "2");
  CHECK(value("7 div 2") == "3");
  CHECK(value("(- 7) mod 2") == "1");
  CHECK(value("if 1 < 2 ≤ 2 then 5 else 6") == "5");
  CHECK(value("let x == 2; y == 3 • x * y") == "6");
  CHECK(value("tolerancia_unidad * 1125899906842624") == "1");
  CHECK(value("raizcuadrada(4)") == "2");
  CHECK(value("raizcuadrada(8)") == "√8");
  CHECK(value("raizcuadrada(raizcuadrada(2)) * raizcuadrada(raizcuadrada(2))") == "√2");
  CHECK(value("cuadrado(raizcuadrada(2))") == "2");
  CHECK(holds("raizcuadrada(1 + raizcuadrada(2)) < raizcuadrada(3)"));
}

// elevado.def.1, elevado.def.2, elevado.def.3: known by its laws, at whole exponents and at their halves.
TEST_CASE("a power is evaluated by its laws") {
  CHECK(value("elevado(3, 4)") == "81");
  CHECK(value("elevado(raizcuadrada(2), 5)") == "4*√2");
  CHECK(value("elevado(0, 0)") == "1");
  CHECK(value("elevado(0, 3)") == "0");
  CHECK(value("20 * elevado(2, 10)") == "20480");
  CHECK(holds("∃ h : ℝ | 2 * h = 1 • elevado(9, h) = 3 ∧ elevado(4, 1 + h) = 8 ∧ elevado(h, 5) * 32 = 1"));
  CHECK(holds("∃ h : ℝ | 3 * h = 1 • elevado(1, h) = 1"));
  CHECK(value("elevado(- 1, 2)") == "undefined");
  CHECK(value("elevado(2, - 1)") == "undefined");
  CHECK_THROWS_AS(holds("∃ h : ℝ | 3 * h = 1 • elevado(2, h) = 3"), EvaluationError);
  CHECK_THROWS_AS(value("elevado(2, 1048577)"), EvaluationError);
}

TEST_CASE("sets and functions") {
  CHECK(value("{1, 2, 3} ∪ {3, 4}") == "{1, 2, 3, 4}");
  CHECK(value("{x : 1‥5 | x * x > 5 • x + 1}") == "{4, 5, 6}");
  CHECK(value("dom {1 ↦ 2, 3 ↦ 4}") == "{1, 3}");
  CHECK(value("{1 ↦ 2, 3 ↦ 4} ∼") == "{2 ↦ 1, 4 ↦ 3}");
  CHECK(value("{1 ↦ 2, 3 ↦ 4}⦇{3}⦈") == "{4}");
  CHECK(value("{1} ⩤ {1 ↦ 2, 3 ↦ 4}") == "{3 ↦ 4}");
  CHECK(value("{1 ↦ 2} ⊕ {1 ↦ 5, 3 ↦ 4}") == "{1 ↦ 5, 3 ↦ 4}");
  CHECK(value("{1 ↦ 2, 3 ↦ 4}(3)") == "4");
  CHECK(value("{1 ↦ 2, 3 ↦ 4}(2)") == "undefined");
  CHECK(value("# (ℙ (1‥4))") == "16");
  CHECK(value("⋃ {{1}, {2, 3}}") == "{1, 2, 3}");
  CHECK(value("min {3, 1, 2}") == "1");
  CHECK(value("Tipo") == "{soy_esfera, soy_cilindro, soy_cono, soy_tronco, soy_plano, soy_disco, soy_triangulo}");
  CHECK(value("(λ x : 1‥3 • x * x)(2)") == "4");
  CHECK(value("dom (λ x : 1‥3 • x * x)") == "{1, 2, 3}");
}

TEST_CASE("predicates") {
  CHECK(holds("∀ x : 1‥4 • x < 5"));
  CHECK(holds("∃ x : ℝ • x * 3 = 1"));
  CHECK_FALSE(holds("∃ x : ℝ | x < 0 • x * 3 = 1"));
  CHECK(holds("∃₁ x : 1‥4 • x * x = 9"));
  CHECK_FALSE(holds("∃₁ x : 1‥4 • x > 2"));
  CHECK(holds("1 ∈ Rmas"));
  CHECK_FALSE(holds("0 ∈ Rmas"));
  CHECK(holds("⦉x == 1, y == 0, z == 0⦊ ∈ Unitario"));
  CHECK_FALSE(holds("⦉x == 1, y == 1, z == 0⦊ ∈ Unitario"));
  CHECK(holds("{1 ↦ 2, 2 ↦ 2} ∈ ℕ ⇸ ℕ"));
  CHECK_FALSE(holds("{1 ↦ 2, 1 ↦ 3} ∈ ℕ ⇸ ℕ"));
  CHECK_FALSE(holds("{1 ↦ 2, 2 ↦ 2} ∈ ℕ ⤔ ℕ"));
}

TEST_CASE("the set of a variable has variables of its own") {
  CHECK(holds("∃ z : {n : {3, 4, 5}} • z = 3"));
  CHECK(holds("∃ z : {n : 3 ‥ 5 | n > 3} • z = 4"));
  CHECK_FALSE(holds("∃ z : {n : 3 ‥ 5 | n > 3} • z = 3"));
  CHECK(holds("∃ z : {n : {3, 4}; m : {5, 6}} • z = (3, 5)"));
  CHECK(holds("∃ x, z : {n : {3, 4, 5}} • z = 3 ∧ x = 4"));
  CHECK(holds("∃ z : {n : {3, 4}; m : {5, 6} • n}; y : {n : {7, 8, 9}} • z = 3 ∧ y = 8"));
  CHECK(holds("∃ z : {n : {3, 4}}; w == # {n : {5, 6}} • z = 3 ∧ w = 2"));
  CHECK(holds("∃₁ z : {n : {3, 4, 5}} • z = 3"));
  CHECK_FALSE(holds("∀ z : {n : {3, 4, 5}} • z ≠ 3"));
  CHECK(value("{z : {n : {3, 4, 5}} | z = 3}") == "{3}");
  CHECK(value("(μ z : {n : {3, 4, 5}} | z = 3)") == "3");
  CHECK(holds("∃ z : {s : {∅, {1}} | s ≠ {2}} × {n : {3, 4}} • z = (∅, 3)"));
}

TEST_CASE("points by the one-point rule") {
  const std::string ray = "⦉p == ⦉x == 0, y == 0, z == 0⦊, v == ⦉x == 1, y == 2, z == 0⦊⦊";
  CHECK(holds("⦉x == 3, y == 6, z == 0⦊ ∈ puntos_de_rayo(" + ray + ")"));
  CHECK_FALSE(holds("⦉x == 3, y == 7, z == 0⦊ ∈ puntos_de_rayo(" + ray + ")"));
  CHECK_FALSE(holds("⦉x == 0, y == 0, z == 0⦊ ∈ puntos_de_rayo(" + ray + ")"));
  CHECK_FALSE(holds("⦉x == - 3, y == - 6, z == 0⦊ ∈ puntos_de_rayo(" + ray + ")"));
  CHECK(holds("⦉x == raizcuadrada(2), y == 2 * raizcuadrada(2), z == 0⦊ ∈ puntos_de_rayo(" + ray + ")"));
  const std::string center = "⦉x == 0, y == 0, z == 0⦊";
  CHECK(holds("⦉x == 0, y == raizcuadrada(2), z == 0⦊ ∈ puntos_esfera(" + center + ", raizcuadrada(2))"));
  CHECK(holds("⦉x == 1, y == 0, z == 2⦊ ∈ puntos_cilindro(" + center + ", 1, ⦉x == 0, y == 0, z == 1⦊, 2)"));
  CHECK_FALSE(holds("⦉x == 1, y == 0, z == 3⦊ ∈ puntos_cilindro(" + center + ", 1, ⦉x == 0, y == 0, z == 1⦊, 2)"));
  CHECK(holds("⦉x == 0, y == 0, z == 2⦊ ∈ puntos_cono(" + center + ", 1, ⦉x == 0, y == 0, z == 1⦊, 2)"));
  CHECK(value("reduccion({⦉x == 0, y == 0, z == 2⦊, ⦉x == 0, y == 1, z == 1⦊}, " + center + ")") ==
        "⦉x == 0, y == 1, z == 1⦊");
  CHECK(value("reduccion(∅, " + center + ")") == "undefined");
}

}  // namespace
}  // namespace durero::zed
