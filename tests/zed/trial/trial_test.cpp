#include "durero/zed/trial/trial.hpp"

#include "support/catch.hpp"

namespace durero::zed {
namespace {

using Catch::Matchers::Contains;

const std::string before =
    "\\begin{zed} [Cosa] \\end{zed}\n\\begin{zed} Color ::= rojo | verde \\end{zed}\n"
    "\\begin{schema}{S} cosas : \\finset Cosa \\\\ n : \\nat \\where n = \\# cosas \\end{schema}\n"
    "\\begin{schema}{Entra} \\Delta S \\\\ c? : Cosa \\where c? \\notin cosas \\also cosas' = cosas \\cup \\{c?\\} "
    "\\end{schema}\n"
    "\\begin{schema}{Primero} S~' \\where cosas' = \\emptyset \\end{schema}\n";

std::vector<Trial> trials(const std::string& claims, const TrialBounds& bounds = {}) {
  const Specification read = read_text(before + "\\begin{zed} " + claims + "\n\\end{zed}\n", "here.tex");
  const Typing typing = check(read);
  REQUIRE(read.ok());
  REQUIRE(typing.ok());
  return try_conjectures(read, typing, {}, bounds);
}

Trial trial(const std::string& claim, const TrialBounds& bounds = {}) {
  return trials("\\vdash? " + claim, bounds).at(0);
}

}  // namespace

TEST_CASE("a conjecture is tried on states that satisfy what its quantifier asks") {
  const Trial found = trial("\\forall S; k : \\nat @ n \\leq 3 % S.conj.1", {.states = 8, .draws = 256});
  CHECK(found.counterexample.empty());
  CHECK(found.why_not.empty());
  CHECK(found.tried >= TrialBounds{}.states);
  CHECK_FALSE(found.is_evaluated);
  CHECK(found.label == "S.conj.1");
  CHECK(found.file == "here.tex");
  CHECK(found.place.line == 6);
  CHECK(trial("\\forall S | n = 2 @ n < 3").is_evaluated);
  CHECK(trial("\\forall S @ n \\leq 3", {.states = 8, .draws = 0}).tried == 0);
}

TEST_CASE("a false conjecture is refuted by a state, which is told with every name that it declares") {
  for (const char* claim : {"\\forall S @ n = 0", "\\forall S; c : Color @ c = rojo \\land n \\geq 0"}) {
    const Trial found = trial(claim);
    CHECK_THAT(found.counterexample, Contains("  cosas = ") && Contains("  n = "));
  }
  CHECK_THAT(trial("\\forall c : Color @ c = rojo").counterexample, Contains("  c = verde\n"));
  CHECK(trial("1 = 2").counterexample == "  it has no variables\n");
  CHECK(trial("1 = 1").is_evaluated);
  CHECK(trial("1 = 1").tried == 1);
}

TEST_CASE("a precondition is asked of states") {
  CHECK(trial("\\forall S; c? : Cosa @ \\pre Entra \\iff c? \\notin cosas").tried >= TrialBounds{}.states);
  CHECK_THAT(trial("\\forall S; c? : Cosa @ \\pre Entra").counterexample, Contains("  c? = Cosa_"));
}

TEST_CASE("of what exists a witness is looked for, and that none was met refutes nothing") {
  const Trial found = trial("\\exists S~' @ Primero");
  CHECK(found.tried >= 1);
  CHECK(found.why_not.empty());
  const Trial none = trial("\\exists S @ n = 4");
  CHECK(none.counterexample.empty());
  CHECK(none.tried == 0);
  CHECK_THAT(none.why_not, Contains("is a witness"));
  CHECK(trial("\\exists k : \\nat @ k * k = 50").counterexample == "  there is no witness\n");
}

TEST_CASE("of an initial state equations give the witness, where none is drawn") {
  const std::string state =
      "State == [~ f, g, h, k : Cosa \\pfun \\nat | \\dom f = \\dom g \\land h = k ~] "
      "\\end{zed}\n\\begin{zed} ";
  const Trial found = trials(state + "\\vdash? \\exists State~' @ f' = \\emptyset \\land h' = \\emptyset").at(0);
  CHECK(found.tried >= 1);
  CHECK(found.why_not.empty());
}

TEST_CASE("what the evaluation decides is true, or shows a state where it is not") {
  CHECK(trial("\\forall y : 5 \\upto 7 @ y > 4").is_evaluated);
  CHECK(trial("\\forall y : 5 \\upto 7 @ y > 6").counterexample == "  y = 5\n");
  CHECK(trial("\\forall x : \\nat @ x + 1 > x").is_evaluated);
  CHECK(trial("\\forall s, t : \\seq \\nat @ s \\cat t = t \\cat s").counterexample == "  s = ⟨0⟩\n  t = ⟨1⟩\n");
  CHECK(trial("\\forall | false @ false").is_evaluated);
  CHECK(trial("\\exists x : \\nat @ x \\mod 7 = 3").is_evaluated);
  CHECK(trial("\\exists x : \\nat @ x < 0").counterexample == "  there is no witness\n");
}

TEST_CASE("small values are gone through before others are drawn") {
  const TrialBounds one{.states = 1, .draws = 16};
  CHECK_THAT(trial("\\forall c, d : Cosa; s : \\power Cosa | c \\in s @ d \\in s", one).counterexample,
             Contains("  d = Cosa_"));
  CHECK_THAT(trial("\\forall f : Cosa \\pfun \\nat; c : Cosa | c \\in \\dom f @ f~c = 0", one).counterexample,
             Contains(" ↦ 1"));
  CHECK_FALSE(trial("\\forall f : Cosa \\pfun \\nat; c : Cosa | c \\in \\dom f @ f~c \\geq 0", one).is_evaluated);
}

TEST_CASE("what cannot be tried says why") {
  CHECK(trial("\\forall S | n = 9 @ n = 0").why_not == "none of the values drawn are a state");
  const Trial open = trial("\\forall S @ (\\forall k : \\nat | k > n @ k * k * k > n)");
  CHECK(open.tried == 0);
  CHECK_FALSE(open.why_not.empty());
  CHECK_THAT(trial("\\forall S @ n \\leq 3", {.states = 8, .draws = 64, .steps = 1}).why_not, Contains("steps"));
}

TEST_CASE("what conjuncts make of other values is looked for where no values drawn satisfy them") {
  CHECK(trial("\\forall a, b, c, d : \\num | c = 100 * a + b \\land d = c * c + 70 @ d \\geq 70").tried >=
        TrialBounds{}.states);
  // a state that is made of several draws counts once
  CHECK(trial("\\forall cosas : \\finset Cosa; n : \\nat | n = \\# cosas @ n \\leq 3", {.states = 64, .draws = 512})
            .tried == 8);
  CHECK_THAT(trial("\\forall a, b : \\num | b = a + 1000 @ b < 1000").counterexample, Contains("  b = 100"));
  CHECK(trial("\\forall p, q : \\num \\cross \\num | (p.1 + q.1, q.2) = (50, p.2) @ q.2 = p.2").tried >= 1);
  // no number is made so, and what is looked for that way is not found
  CHECK(trial("\\forall a, b : \\num | b * b = 0 - 1 - a * a @ a = b").why_not ==
        "none of the values drawn are a state");
}

TEST_CASE("samples stand for what they are named after, and the states are the same at every call") {
  const Specification read =
      read_text(before + "\\begin{zed} \\vdash? \\forall c : Cosa; k : \\nat @ k = 7 \\end{zed}\n", "here");
  const Typing typing = check(read);
  const Samples samples = {{"Cosa", {Value::atom("Cosa", "mesa")}}, {"ℕ", {Real(7)}}};
  const Trial found = try_conjectures(read, typing, samples).at(0);
  CHECK(found.tried == 1);  // there is one state, however often it is drawn
  CHECK(trial("\\forall c : Color @ c \\in Color").is_evaluated);
  CHECK(trial("\\forall S @ n \\leq 3", {.states = 64, .draws = 512}).tried == 8);  // so many sets of three names
  CHECK(trial("\\forall c : Cosa; k : \\nat | k = 1 @ k > 0").is_evaluated);
  CHECK(trial("\\forall S @ n = 0").counterexample == trial("\\forall S @ n = 0").counterexample);
}

TEST_CASE("members of a free type are nested, and none is what its constructor does not take") {
  const std::string tree =
      "[X] \\\\ T ::= tip | fork \\ldata \\nat \\cross T \\cross T \\rdata \\end{zed}\n\\begin{zed} ";
  const Trial found = trials(tree + "\\vdash? \\forall t : T @ t = tip").at(0);
  CHECK_THAT(found.counterexample, Contains("fork("));
  const std::string loop = "L ::= more \\ldata L \\rdata \\end{zed}\n\\begin{zed} ";
  CHECK(trials(loop + "\\vdash? \\forall l : L @ \\exists k : L @ more~k = l").at(0).is_evaluated);  // L has none
  const std::string none = "N ::= of \\ldata \\{~ n : \\nat | n > 90 ~\\} \\rdata \\end{zed}\n\\begin{zed} ";
  CHECK(trials(none + "\\vdash? \\forall n : N @ \\exists k : \\nat @ of~k = n").at(0).why_not ==
        "no member of N is found to try it on");
}

TEST_CASE("what conjuncts do not make is drawn, where it cannot be said what they make") {
  CHECK(trial("\\forall a, b : \\num; s : \\power Cosa | a = b + 70 \\land "
              "(a, s) \\in \\{~ k : \\num; t : \\power Cosa | \\# t \\leq 9 ~\\} @ a \\geq 60")
            .tried >= TrialBounds{}.states);
}

TEST_CASE("a sample that is no member, or is not taken whole, is no state") {
  const Specification read = read_text(before +
                                           "\\begin{zed} T == [~ n : \\nat | n = 7 ~] \\end{zed}\n"
                                           "\\begin{zed} \\vdash? \\forall k : \\nat @ k \\geq 0 \\end{zed}\n"
                                           "\\begin{zed} \\vdash? \\forall S; T @ n = 7 \\end{zed}\n",
                                       "here");
  const Typing typing = check(read);
  REQUIRE(typing.ok());
  const Value thing = Value::atom("Cosa", "mesa");
  const Samples samples = {
      {"ℕ", {Real(-7)}},
      {"S", {Value::binding(signature({{"cosas", ""}, {"n", ""}}), {Value::set({thing}), Real(1)})}},
      {"T", {Value::binding(signature({{"n", ""}}), {Real(7)})}},
  };
  for (const Trial& found : try_conjectures(read, typing, samples)) {
    CHECK(found.counterexample.empty());
    CHECK(found.why_not == "none of the values drawn are a state");
  }
}

}  // namespace durero::zed
