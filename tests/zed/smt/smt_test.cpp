/// A solver's answer counts where the text says so. The solvers here are made up: honest ones, and ones that lie.
#include "durero/zed/smt/smt.hpp"

#include "durero/zed/syntax/parser.hpp"
#include "durero/zed/types/typecheck.hpp"
#include "support/catch.hpp"

namespace durero::zed {
namespace {

using Catch::Matchers::Contains;

const std::string text =
    "\\begin{zed} [NAME] \\end{zed}\n\\begin{zed} Color ::= red | green | blue \\end{zed}\n"
    "\\begin{zed} Cell == \\{x : \\nat | x > 2\\} \\end{zed}\n"
    "\\begin{schema}{Point} a : \\num \\\\ b : \\nat \\where a < b \\end{schema}\n"
    "\\begin{axdef} twice : \\num \\fun \\num \\where \\forall n : \\num @ twice(n) = n + n \\end{axdef}\n"
    "\\begin{axdef} step : \\nat \\fun \\nat \\where step(0) = 7 \\\\ \\forall n : \\nat | n > 0 @ step(n) = n - 1 "
    "\\end{axdef}\n"
    "\\begin{axdef} fact : \\nat \\fun \\nat \\where fact(0) = 1 \\\\ \\forall n : \\nat @ fact(n + 1) = (n + 1) * "
    "fact(n) \\end{axdef}\n";

/// A question, with what the solver was told.
struct AskedQuestion {
  SmtFinding found;
  std::vector<std::string> scripts{};
};

AskedQuestion asked(const std::string& predicate, const SmtReply& reply, const KnownMembers& members = {}) {
  static const Specification read = read_text(text, "here.tex");
  REQUIRE(read.ok());
  REQUIRE(check(read).ok());
  const Evaluator evaluator(read.sections);
  AskedQuestion made;
  const SmtProgram program{"z3", [&](const std::string& script) {
                             made.scripts.push_back(script);
                             return reply;
                           }};
  made.found = ask_program(program, parse_unicode(predicate), read.sections, evaluator, {}, members);
  return made;
}

/// The facts of the only script, one a line.
std::string facts(const std::string& predicate, const KnownMembers& members = {}) {
  const AskedQuestion made = asked(predicate, {"unsat\n"}, members);
  INFO(predicate << ": " << made.found.said);
  REQUIRE(made.scripts.size() == 1);
  std::string lines;
  for (std::size_t at = 0; at < made.scripts[0].size();) {
    const std::size_t end = made.scripts[0].find('\n', at);
    const std::string line = made.scripts[0].substr(at, end - at);
    if (line.starts_with("(declare") || line.starts_with("(assert")) lines += line + "\n";
    at = end + 1;
  }
  return lines;
}

std::string said(const std::string& predicate, const std::string& output) {
  return asked(predicate, {output}).found.said;
}

}  // namespace

TEST_CASE("a script asks for values of the variables of an ∃") {
  CHECK(asked("∃ x : ℕ; y : ℤ | x > y • x * y = 6", {"unsat\n"}).scripts ==
        std::vector<std::string>{"(set-option :produce-models true)\n"
                                 "(set-logic ALL)\n"
                                 "(declare-fun v0 () Int)\n"
                                 "(declare-fun v1 () Int)\n"
                                 "(assert (>= v0 0))\n"
                                 "(assert (> v0 v1))\n"
                                 "(assert (= (* v0 v1) 6))\n"
                                 "(check-sat)\n"
                                 "(get-value (v0 v1))\n"
                                 "(exit)\n"});
}

TEST_CASE("of a ∀ the negation is asked, of ∃₁ two values, of a comparison with ∅ a member") {
  CHECK(facts("∀ x : ℕ₁ • x < 9") == "(declare-fun v0 () Int)\n(assert (>= v0 1))\n(assert (not (< v0 9)))\n");
  CHECK(facts("∃₁ x : ℤ • x > 9") ==
        "(declare-fun v0 () Int)\n(declare-fun v1 () Int)\n(assert (> v0 9))\n(assert (> v1 9))\n"
        "(assert (not (= v0 v1)))\n");
  CHECK(facts("{x : ℤ | x > 9} = ∅") == "(declare-fun v0 () Int)\n(assert (> v0 9))\n");
  CHECK(facts("∅ ≠ {x : ℤ | x > 9 • 6 div x}") ==
        "(declare-fun v0 () Int)\n(assert (> v0 9))\n(assert (not (= v0 0)))\n");
}

TEST_CASE("div and mod are those of the toolkit, and undefined where the divisor is 0") {
  CHECK(facts("∃ x, y : ℤ • x div y = 2") ==
        "(declare-fun v0 () Int)\n(declare-fun v1 () Int)\n(assert (and (not (= v1 0)) "
        "(= (ite (> v1 0) (div v0 v1) (div (- v0) (- v1))) 2)))\n");
  CHECK(facts("∃ x : ℤ • 6 div x ≠ 2") ==
        "(declare-fun v0 () Int)\n(assert (and (not (= v0 0)) "
        "(not (= (ite (> v0 0) (div 6 v0) (div (- 6) (- v0))) 2))))\n");
  CHECK(facts("∃ x : ℤ • x mod 3 ≠ 2") == "(declare-fun v0 () Int)\n(assert (not (= (mod v0 3) 2)))\n");
}

TEST_CASE("the successor of a number that is none of ℕ is undefined") {
  CHECK(facts("∀ x : ℤ • succ x = x + 1") == "(declare-fun v0 () Int)\n(assert (not (<= 0 v0)))\n");
  CHECK(facts("∃ x : ℤ • succ (succ x) ≠ 5") ==
        "(declare-fun v0 () Int)\n"
        "(assert (and (and (<= 0 v0) (<= 0 (+ v0 1))) (not (= (+ (+ v0 1) 1) 5))))\n");
  CHECK(facts("∃ x : 𝔸 • succ x = 2") ==
        "(declare-fun v0 () Real)\n"
        "(assert (and (and (is_int v0) (<= 0 (to_int v0))) (= (+ (to_int v0) 1) 2)))\n");
}

TEST_CASE("variables have the conditions of their sets") {
  CHECK(facts("∃ x : 3 ‥ 5 • x ≠ 4") ==
        "(declare-fun v0 () Int)\n(assert (and (<= 3 v0) (<= v0 5)))\n(assert (not (= v0 4)))\n");
  CHECK(facts("∃ x : ℤ₁ • x < 1") == "(declare-fun v0 () Int)\n(assert (not (= v0 0)))\n(assert (< v0 1))\n");
  CHECK(facts("∃ x : 𝔸 • x * x = 2") == "(declare-fun v0 () Real)\n(assert (= (* v0 v0) 2.0))\n");
  CHECK(facts("∃ x : 𝔸 • x ∈ ℕ") == "(declare-fun v0 () Real)\n(assert (and (is_int v0) (>= (to_int v0) 0)))\n");
  CHECK(facts("∃ x : {1, 4} ∪ {9} • x > 3") ==
        "(declare-fun v0 () Int)\n(assert (or (or (= v0 1) (= v0 4)) (= v0 9)))\n(assert (> v0 3))\n");
  CHECK(facts("∃ x : Cell • x < 5") ==
        "(declare-fun v0 () Int)\n(assert (and (>= v0 0) (> v0 2)))\n(assert (< v0 5))\n");
  CHECK(facts("∃ c : Color • c ≠ green") ==
        "(declare-fun v0 () Int)\n(assert (and (<= 0 v0) (< v0 3)))\n(assert (not (= v0 1)))\n");
  CHECK(facts("∃ n, m : NAME • n ≠ m",
              [](const Name&) {
                return std::optional(std::vector{Value::atom("NAME", "ann"), Value::atom("NAME", "bob")});
              }) ==
        "(declare-fun v0 () Int)\n(declare-fun v1 () Int)\n(assert (and (<= 0 v0) (< v0 2)))\n"
        "(assert (and (<= 0 v1) (< v1 2)))\n(assert (not (= v0 v1)))\n");
}

TEST_CASE("tuples and bindings are translated part by part, and a schema by its text") {
  CHECK(facts("∃ p : ℤ × ℕ • p = (1, 2) ∧ p.1 < p.2") ==
        "(declare-fun v0 () Int)\n(declare-fun v1 () Int)\n(assert (>= v1 0))\n"
        "(assert (and (and (= v0 1) (= v1 2)) (< v0 v1)))\n");
  const std::string point = "(declare-fun v0 () Int)\n(declare-fun v1 () Int)\n";
  CHECK(facts("∃ p : Point • p.a = 4") == point + "(assert (and (>= v1 0) (< v0 v1)))\n(assert (= v0 4))\n");
  CHECK(facts("∃ Point • a = 4") ==
        point + "(assert (>= v1 0))\n(assert (and (>= v1 0) (< v0 v1)))\n(assert (= v0 4))\n");
}

TEST_CASE("functions are expanded, and quantifiers nested") {
  CHECK(facts("∃ x : ℤ • twice(x) = 8") == "(declare-fun v0 () Int)\n(assert (= (+ v0 v0) 8))\n");
  CHECK(facts("∃ x : ℤ • (λ y : ℕ • y * x) x = 8") ==
        "(declare-fun v0 () Int)\n(assert (and (>= v0 0) (= (* v0 v0) 8)))\n");
  CHECK(facts("∃ x : ℤ • let y == x + 1 • y * y = 9") ==
        "(declare-fun v0 () Int)\n(assert (= (* (+ v0 1) (+ v0 1)) 9))\n");
  CHECK(facts("∃ x : ℕ • {1 ↦ 5, 2 ↦ 6} x = 6") ==
        "(declare-fun v0 () Int)\n(assert (>= v0 0))\n"
        "(assert (and (or (= v0 1) (= v0 2)) (= (ite (= v0 1) 5 6) 6)))\n");
  CHECK_THAT(facts("∃ x : ℕ • step(x) = 6"), Contains("(ite (= v0 0) 7 "));
  CHECK(facts("∃ x : ℤ • ∀ y : ℕ • y ≥ x") ==
        "(declare-fun v0 () Int)\n(assert (forall ((v1 Int)) (or (not (>= v1 0)) (>= v1 v0))))\n");
  CHECK(facts("∃ x : ℤ • x = (if x < 3 then 3 else x)") ==
        "(declare-fun v0 () Int)\n(assert (= v0 (ite (< v0 3) 3 v0)))\n");
}

TEST_CASE("values of the solver are a witness where the text says so") {
  const AskedQuestion right = asked("∃ x, y : ℤ • x * x + y = 3 ∧ x < - 1", {"sat\n((v0 (- 2))\n (v1 (- 1)))\n"});
  CHECK(right.found.truth == Truth::yes);
  CHECK(right.found.said == "z3 finds the witness x == -2, y == -1, which holds by the text");
  REQUIRE(right.found.values.size() == 2);
  CHECK(right.found.values[1].second.text() == "-1");
  const AskedQuestion against = asked("∀ x : ℕ • x < 100 ∨ x mod 7 ≠ 3", {"sat\n((v0 101))\n"});
  CHECK(against.found.truth == Truth::no);
  CHECK(against.found.said == "z3 finds the counter-example x == 101, which holds by the text");
  CHECK(asked("∃₁ x : ℤ • x > 9", {"sat\n((v0 10) (v1 11))\n"}).found.truth == Truth::no);
  CHECK(asked("{x : ℕ | x * x = 16} = ∅", {"sat\n((v0 4))\n"}).found.truth == Truth::no);
  CHECK(asked("{x : ℕ | x * x = 16} ≠ ∅", {"sat\n((v0 4))\n"}).found.truth == Truth::yes);
  CHECK(asked("¬ (∃ c : Color • c = blue)", {"sat\n((v0 2))\n"}).found.truth == Truth::no);
  CHECK(asked("∃ x : 𝔸 • x * x = 2", {"sat\n((v0 (root-obj (+ (^ x 2) (- 2)) 1)))\n"}).found.said ==
        "z3 finds the witness x == -√2, which holds by the text");
  CHECK(asked("∃ x : 𝔸 • 3 * x = - 1", {"sat\n((v0 (- (/ 1.0 3.0))))\n"}).found.truth == Truth::yes);
  CHECK(asked("∃ x == 3; y : ℤ • y > x", {"sat\n((v0 4))\n"}).found.truth == Truth::yes);
  CHECK(asked("∃ x : ℤ • x > 4", {"unknown\n((v0 5))\n"}).found.truth == Truth::yes);
}

TEST_CASE("an answer that does not hold by the text is not told as true") {
  for (const char* output : {"sat\n((v0 5))\n", "unsat\n", "unknown\n", "unknown\n((v0 5))\n", "sat\n", "maybe\n", "",
                             "sat\n((v0 6.5))\n", "sat\n((w 6))\n", "sat\n((v0 (f 6)))\n", "sat (((((", "sat ))",
                             "(error \"line 1\")\n", "sat\n((v0 (/ 6.0 0.0)))\n", "sat\n((v0 \"6\"))\n"}) {
    INFO(output);
    const AskedQuestion made = asked("∃ x : ℤ • x * x = 36 ∧ x > 0", {output});
    CHECK(made.found.truth == Truth::open);
    CHECK(made.found.values.empty());
    CHECK(made.found.said.starts_with("z3"));
  }
  CHECK(said("∃ x : ℤ • x * x = 36", "sat\n((v0 5))\n") == "z3's answer x == 5 does not hold by the text");
  CHECK(said("∃ x : ℤ • x * x = 36", "unsat\n") == "z3 finds no witness");
  CHECK(said("∀ x : ℤ • x * x = 36", "unsat\n") == "z3 finds no counter-example");
  CHECK(said("∃₁ x : ℤ • x * x = 36", "unsat\n") == "z3 finds no two witnesses");
  CHECK(said("∃₁ x : ℤ • x * x = 36", "sat\n((v0 6) (v1 6))\n") ==
        "z3's answer x == 6 and x == 6 does not hold by the text");
  CHECK(said("∃ x : ℤ • x * x = 36", "unknown\n") == "z3 does not decide it either");
  CHECK(said("∃ x : ℤ • x * x = 36", "Killed\x1b\n") == "z3's answer is not understood: Killed?");
  CHECK(said("∃ x : ℤ • x * x = 36", "sat\n") == "z3's answer has no values that are understood");
  CHECK(said("∃ x : ℕ • x * x = 36", "sat\n((v0 (- 6)))\n") == "z3's answer x == -6 does not hold by the text");
  CHECK(asked("∃ x : ℤ • x > 3", {"", "gives no answer within 10 s"}).found.said == "z3 gives no answer within 10 s");
}

TEST_CASE("a predicate without translation is not asked, and the reason is told") {
  const auto is_not_asked = [](const char* predicate, const char* why) {
    const AskedQuestion made = asked(predicate, {"sat\n"});
    INFO(predicate);
    CHECK(made.scripts.empty());
    CHECK(made.found.said == std::string("z3 is not asked: ") + why);
  };
  is_not_asked("∃ r : ℤ ↔ ℤ • r ⁺ ≠ r", "r ⁺ is not translated");
  is_not_asked("∃ f : ℕ → ℕ • f 0 = 7", "ℕ has too many members to be written out");
  is_not_asked("∃ n : NAME • n = n", "the members of NAME are not known to be few names");
  is_not_asked("∃ x : ℕ • fact(x) = 5", "fact is recursive");
  is_not_asked("∃ x : ℕ • # {y : ℕ | y < x} = 5", "{ y : ℕ | y < x } has no few members that are known");
  is_not_asked("1 = 2", "1 = 2 is no quantified predicate");
  is_not_asked("∃ x == 3 • x = 4", "no variable is sought");
}

TEST_CASE("of a disjunction each side is asked, and each is told") {
  const AskedQuestion made =
      asked("(∃ x : ℤ • x * x * x = 1030301000000) ∨ (∀ y : ℕ • y * y * y < 8)", {"sat\n((v0 10100))\n"});
  CHECK(made.found.truth == Truth::yes);
  CHECK_THAT(made.found.said, Contains("x == 10100"));
  CHECK(asked("(∀ y : ℕ • y * y * y < 1000000) ⇔ (1 = 2)", {"sat\n((v0 300))\n"}).found.truth == Truth::yes);
}

}  // namespace durero::zed
