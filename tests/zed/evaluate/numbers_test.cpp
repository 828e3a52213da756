/// Numbers that no equation gives, and points of curves: found where polynomials change their sign.

#include "durero/zed/evaluate/evaluate.hpp"
#include "durero/zed/syntax/parser.hpp"
#include "support/catch.hpp"
#include "support/tree.hpp"

namespace durero::zed {
namespace {

const Evaluator& text_of_spec() {
  static const Evaluator evaluator(read_files({durero::test::source_dir() + "/spec/interseccion.tex"}).sections);
  return evaluator;
}

std::string value(const std::string& expression) { return text_of_spec().value(parse_unicode(expression)).text(); }
Truth truth_of(const std::string& predicate) { return text_of_spec().holds(parse_unicode(predicate)); }

TEST_CASE("numbers that their predicates bound are listed") {
  CHECK(value("{x : ℕ | x < 5}") == "{0, 1, 2, 3, 4}");
  CHECK(value("{x : ℕ | x < 5 • x * x}") == "{0, 1, 4, 9, 16}");
  CHECK(value("{x : ℤ | x * x ≤ 4}") == "{-2, -1, 0, 1, 2}");
  CHECK(value("{x : ℤ | 2 * x > 3 ∧ x ≤ 4}") == "{2, 3, 4}");
  CHECK(value("{x : ℝ | x * x = 2}") == "{-√2, √2}");
  CHECK(value("{x, y : ℕ | x + y = 2 ∧ x ≤ 2}") == "{0 ↦ 2, 1 ↦ 1, 2 ↦ 0}");
  CHECK(value("{x, y : ℕ | x < 2 ∧ y < 2}") == "{0 ↦ 0, 0 ↦ 1, 1 ↦ 0, 1 ↦ 1}");
  CHECK(value("# {x : ℤ | 0 ≤ x ∧ x < 1000}") == "1000");
  CHECK(value("{x : ℕ₁ | x < 3} ∪ {7}") == "{1, 2, 7}");
  CHECK(value("{x : ℕ | x < 0}") == "∅");
  CHECK(value("{x : ℕ | x < 3 ∨ x = 7}") == "{0, 1, 2, 7}");
  CHECK(value("(μ x : ℕ | 3 * x = 12)") == "4");
  CHECK(value("{x : ℕ | x > 5}") == "{ x : ℕ | x > 5 }");
  CHECK(value("{x : ℝ | 0 < x ∧ x < 1}") == "{ x : ℝ | 0 < x ∧ x < 1 }");
}

TEST_CASE("quantifiers over numbers are decided where their truth changes") {
  CHECK(truth_of("∀ x : ℕ | x < 5 • x * x < 25") == Truth::yes);
  CHECK(truth_of("∀ x : ℕ | x ≤ 5 • x * x < 25") == Truth::no);
  CHECK(truth_of("∃ x : ℤ • x * x = 49") == Truth::yes);
  CHECK(truth_of("∃ x : ℤ • x * x = 50") == Truth::no);
  CHECK(truth_of("∃ x : ℝ • x * x = 2") == Truth::yes);
  CHECK(truth_of("∃ x : ℝ • x * x = -(2)") == Truth::no);
  CHECK(truth_of("∃₁ x : ℝ | x > 0 • x * x = 2") == Truth::yes);
  CHECK(truth_of("∀ x : ℕ • x ≥ 0") == Truth::yes);
  CHECK(truth_of("∀ x : ℤ • x ≥ 0") == Truth::no);
  CHECK(truth_of("∀ x : ℝ • x * x ≥ 0") == Truth::yes);
  CHECK(truth_of("∀ x : ℝ • x * x > 0") == Truth::no);
  CHECK(truth_of("∀ x : ℤ • x * x ≥ x") == Truth::yes);
  CHECK(truth_of("∀ x : ℝ • x * x ≥ x") == Truth::no);
  CHECK(truth_of("∃ x : ℤ • 2 * x = 3") == Truth::no);
  CHECK(truth_of("∃ x : ℤ • 1 < 3 * x ∧ 3 * x < 3") == Truth::no);
  CHECK(truth_of("∃ x : ℕ • x ∈ {3, 4} ∧ x * x = 16") == Truth::yes);
  CHECK(truth_of("∀ x : ℕ | x < 1000000000000 • x ≥ 0") == Truth::yes);
  // What is no polynomial of degree two, or depends on two numbers, is left open, and never guessed; but a small number
  // that is tried may be a witness.
  CHECK(truth_of("∃ x : ℝ • x * x * x = 8") == Truth::yes);
  CHECK(truth_of("∃ x : ℝ • x < 5 ∧ x * x * x = 8") == Truth::yes);
  CHECK(truth_of("∃ x, y : ℤ • x * x * x = y + y ∧ x < 0 ∧ x * y = 8") == Truth::yes);
  CHECK(truth_of("∀ x : ℤ • x * x * x ≠ - 27") == Truth::no);
  CHECK(truth_of("∃ x : ℝ • x * x * x = 9") == Truth::open);
  CHECK(truth_of("∃ x : ℝ • x < 5 ∧ x * x * x = 9") == Truth::open);
  CHECK(truth_of("∃ x : ℝ • x * x * x = 9 ∧ x < 5") == Truth::open);
  CHECK(truth_of("∀ x, y : ℕ • x * x + y ≥ x") == Truth::open);
}

const std::string ray = "⦉p == ⦉x == 0, y == 0, z == -(5)⦊, v == ⦉x == 0, y == 0, z == 1⦊⦊";
const std::string skew = "⦉p == ⦉x == 0, y == 1, z == -(5)⦊, v == ⦉x == 0, y == 0, z == 1⦊⦊";
const std::string ball = "puntos_esfera(⦉x == 0, y == 0, z == 0⦊, 2)";

TEST_CASE("the paper's question: the nearest point of a ray on an object") {
  CHECK(value("interseccion(puntos_de_rayo(" + ray + "), " + ball + ")") ==
        "{⦉x == 0, y == 0, z == -2⦊, ⦉x == 0, y == 0, z == 2⦊}");
  CHECK(value("reduccion(interseccion(puntos_de_rayo(" + ray + "), " + ball + "), " + ray + ".p)") ==
        "⦉x == 0, y == 0, z == -2⦊");
  CHECK(value("reduccion(interseccion(" + ball + ", puntos_de_rayo(" + skew + ")), " + skew + ".p)") ==
        "⦉x == 0, y == 1, z == -√3⦊");
  const std::string away = "⦉p == ⦉x == 0, y == 0, z == 5⦊, v == ⦉x == 0, y == 0, z == 1⦊⦊";
  CHECK(value("interseccion(puntos_de_rayo(" + away + "), " + ball + ")") == "∅");
  CHECK(value("reduccion(interseccion(puntos_de_rayo(" + away + "), " + ball + "), " + away + ".p)") == "undefined");
}

TEST_CASE("the paper's question from within: of the two meetings of a line one lies behind the eye") {
  const std::string origin = "⦉x == 0, y == 0, z == 0⦊", up = "⦉x == 0, y == 0, z == 1⦊";
  const std::string rising = "⦉p == ⦉x == 0, y == 1, z == 0⦊, v == ⦉x == 1, y == 2, z == 3⦊⦊",
                    level = "⦉p == ⦉x == 0, y == 1, z == 1⦊, v == ⦉x == 1, y == 2, z == 0⦊⦊";
  const auto nearest = [](const std::string& ray_here, const std::string& set) {
    return value("reduccion(interseccion(puntos_de_rayo(" + ray_here + "), " + set + "), " + ray_here + ".p)");
  };
  CHECK(nearest(rising, ball) == "⦉x == -1/7+√(23/98), y == 5/7+2*√(23/98), z == -3/7+3*√(23/98)⦊");
  CHECK(nearest(level, ball) == "⦉x == -2/5+√(14/25), y == 1/5+2*√(14/25), z == 1⦊");
  const std::string rest_of = ", 2, " + up + ", 5)";
  CHECK(nearest(rising, "puntos_cilindro(" + origin + rest_of) ==
        "⦉x == -2/5+√(19/25), y == 1/5+2*√(19/25), z == -6/5+3*√(19/25)⦊");
  CHECK(nearest(rising, "puntos_cono(" + origin + rest_of) ==
        "⦉x == 2-√(25/31), y == 5-2*√(25/31), z == 6-3*√(25/31)⦊");
  CHECK(nearest(level, "puntos_cono(" + origin + rest_of) == "⦉x == -2/5+√(319/25), y == 1/5+2*√(319/25), z == 1⦊");
  CHECK(nearest(level, "puntos_tronco(" + origin + ", 1, 2, " + up + ", 5)") ==
        "⦉x == -2/5+√(404/25), y == 1/5+2*√(404/25), z == 1⦊");
  // out through the open end
  const std::string out = "⦉p == ⦉x == 0, y == 1, z == 4⦊, v == ⦉x == 0, y == 0, z == 1⦊⦊";
  CHECK(nearest(out, "puntos_cilindro(" + origin + rest_of) == "undefined");
}

TEST_CASE("a set of points is written without free names") {
  CHECK(value("puntos_de_rayo(" + ray + ")") ==
        "⋃ (let ray == ⦉p == ⦉x == 0, y == 0, z == -5⦊, v == ⦉x == 0, y == 0, z == 1⦊⦊ • { t : Rmas • { temp : Punto | "
        "temp.x = ray.p.x + t * ray.v.x ∧ temp.y = ray.p.y + t * ray.v.y ∧ temp.z = ray.p.z + t * ray.v.z } })");
  CHECK(value("⟨5, 7⟩") == "⟨5, 7⟩");
  CHECK(value("{1 ↦ 5, 2 ↦ 7, 3 ↦ 5}") == "{1 ↦ 5, 2 ↦ 7, 3 ↦ 5}");
  CHECK(value("{0 ↦ 5, 1 ↦ 7}") == "{0 ↦ 5, 1 ↦ 7}");
  CHECK(value("{1 ↦ 5, 1 ↦ 7}") == "{1 ↦ 5, 1 ↦ 7}");
}

}  // namespace
}  // namespace durero::zed
