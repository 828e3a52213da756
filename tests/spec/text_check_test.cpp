#include "durero/spec/text_check.hpp"

#include "durero/spec/constants.hpp"
#include "durero/zed/types/typecheck.hpp"
#include "support/catch.hpp"

namespace durero::spec {
namespace {

/// A text with its types, which a check refers to.
struct Read {
  zed::Specification text;
  zed::Typing typing;
};
Read read(const std::string& body) {
  Read made{zed::read_texts({{"t.tex", body}}), {}};
  made.typing = zed::check(made.text);
  return made;
}

TextCheck checked(const Read& of, const TextCheckSetup& setup = {}, const std::string& labels = "") {
  return check_text(of.text, of.typing, {"t.tex"}, setup, LabelIndex(labels));
}

TEST_CASE("a text without a defect is told by its sections and its conjectures") {
  const Read of = read("\\begin{zed}\n N == 1 \\\\\n \\vdash? N = 1 % N.conj.1\n\\end{zed}\n");
  const TextCheck check = checked(of);
  CHECK(check.is_read());
  CHECK_FALSE(check.is_refuted());
  CHECK(check.lines() == "t.tex: section Specification ok, 2 paragraphs\nt.tex:3:2: conjecture N.conj.1 is true\n");
  CHECK(checked(of, {}, "N.conj.1\ttheorem\tproofs/N.v:1\tN_is_one\n").conjectures.at(0).text() ==
        "t.tex:3:2: conjecture N.conj.1 proved as N_is_one; is true\n");
  CHECK(check.untried() == 0);
  CHECK(checked(of, {.states = 0}).untried() == 1);
  CHECK(checked(of, {.states = 0}).lines() ==
        "t.tex: section Specification ok, 2 paragraphs\nt.tex:3:2: conjecture N.conj.1 not tried: no state is asked "
        "for\n");
}

TEST_CASE("a false conjecture is refuted by a state, whatever theorem is named") {
  const Read of = read("\\begin{zed}\n \\vdash? \\forall n : 1 \\upto 2 @ n = 1 % N.conj.1\n\\end{zed}\n");
  const TextCheck check = checked(of, {}, "N.conj.1\ttheorem\tproofs/N.v:1\tN_is_one\n");
  CHECK(check.is_read());
  CHECK(check.is_refuted());
  CHECK(check.conjectures.at(0).text() == "t.tex:2:2: conjecture N.conj.1 is false, as in this state:\n  n = 2\n");
}

TEST_CASE("an error keeps conjectures from being tried, and an opinion is one where it is asked for") {
  const TextCheck wrong = checked(read("\\begin{zed}\n N == M \\\\\n \\vdash? 1 = 1\n\\end{zed}\n"));
  CHECK_FALSE(wrong.is_read());
  CHECK(wrong.conjectures.empty());
  CHECK(wrong.lines() == "t.tex:2:7: M is not declared; expected a declared name\n");
  const Read loose =
      read("\\begin{schema}{S}\n n : \\nat\n\\end{schema}\n\\begin{schema}{Op}\n \\Delta S\n\\end{schema}\n");
  CHECK(checked(loose).is_read());
  CHECK_FALSE(checked(loose, {.strict = true}).is_read());
}

TEST_CASE("a file without a paragraph was meant to hold one") {
  const TextCheck check = checked(read("Nothing.\n"));
  CHECK_FALSE(check.is_read());
  CHECK(check.lines() ==
        "t.tex:1:1: no Z paragraph; expected \\begin{zed}, axdef, schema, gendef or zsection, or a box of Unicode\n");
}

TEST_CASE("a constant has the value that the setup gives it, or the setup is wrong") {
  const Read of = read("\\begin{axdef}\n N : \\nat\n\\end{axdef}\n\\begin{zed}\n \\vdash? N = 7\n\\end{zed}\n");
  CHECK_FALSE(checked(of, {.let = {"N=7"}}).is_refuted());
  CHECK(checked(of, {.let = {"N=8"}}).is_refuted());
  CHECK_THROWS_AS(checked(of, {.let = {"M=8"}}), ConstantError);
}

TEST_CASE("within a scope a conjecture about a given set is decided, and the answer says within which") {
  const Read of = read(
      "\\begin{zed}\n [X, Y]\n\\end{zed}\n\\begin{axdef}\n c : X; n : \\nat\n\\end{axdef}\n\\begin{zed}\n"
      " \\vdash? \\forall x, y, z : X @ x = y \\lor y = z \\lor x = z\n\\end{zed}\n");
  CHECK(checked(of).is_refuted());
  const TextCheck two = checked(of, {.scope = {"X=2"}});
  CHECK_FALSE(two.is_refuted());
  CHECK(two.conjectures.at(0).trial.is_evaluated);
  CHECK(two.conjectures.at(0).text() == "t.tex:8:2: conjecture is true within X = {X1, X2}\n");
  const TextCheck three = checked(of, {.let = {"n=4"}, .scope = {"X=ann,bob,eve", "Y=1", "c=bob"}});
  CHECK_THAT(
      three.conjectures.at(0).text(),
      Catch::Matchers::StartsWith("t.tex:8:2: conjecture is false within X = {ann, bob, eve} and Y = {Y1}, as in"));
  CHECK_THROWS_AS(checked(of, {.scope = {"Z=2"}}), ScopeError);
  CHECK_THROWS_AS(checked(of, {.scope = {"X=0"}}), ScopeError);
  CHECK_THROWS_AS(checked(of, {.scope = {"X=2", "X=3"}}), ScopeError);
}

TEST_CASE("a scope bounds what is tried, too") {
  const Read of = read(
      "\\begin{zed}\n [X]\n\\end{zed}\n\\begin{zed}\n"
      " \\vdash? \\forall s : \\seq X @ \\# (\\ran s) \\leq 2\n\\end{zed}\n");
  CHECK(checked(of).is_refuted());
  const TextCheck two = checked(of, {.scope = {"X=ann,bob"}});
  CHECK_FALSE(two.is_refuted());
  CHECK_FALSE(two.conjectures.at(0).trial.is_evaluated);
  CHECK(two.conjectures.at(0).trial.tried > 0);
  CHECK_THAT(two.conjectures.at(0).text(), Catch::Matchers::EndsWith(" states within X = {ann, bob}\n"));
}

TEST_CASE("numbers are tried within bounds, and the answer says which") {
  const Read of = read(
      "\\begin{axdef}\n f : \\num \\fun \\num\n\\where\n \\forall n : \\num @ f(n) = n * n * n - 20 * n * n\n"
      "\\end{axdef}\n\\begin{zed}\n \\vdash? \\forall n : \\num @ f(n) \\leq 0\n\\end{zed}\n");
  const TextCheck few = checked(of, {.numbers = std::pair{0, 19}});
  CHECK(few.conjectures.at(0).text() == "t.tex:7:2: conjecture tried on 20 states, with numbers from 0 to 19\n");
  CHECK(checked(of, {.numbers = std::pair{15, 30}}).is_refuted());
}

}  // namespace
}  // namespace durero::spec
