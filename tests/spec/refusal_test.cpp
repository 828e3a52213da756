#include "durero/spec/refusal.hpp"

#include <set>

#include "durero/spec/calculator.hpp"
#include "durero/zed/syntax/reader.hpp"
#include "durero/zed/value/undecided.hpp"
#include "support/catch.hpp"

namespace durero::spec {
namespace {

std::string said(const zed::EvaluationError& error) {
  const auto [wrong, expected] = refusal_of(error);
  return wrong + "; " + expected;
}

TEST_CASE("each error of an evaluation has its own message") {
  CHECK(said(zed::Undetermined("N")) ==
        "this is not decided: no equation gives N a value; expected one, or --let N=VALUE");
  CHECK(said(zed::Unsatisfied("nothing fits")) ==
        "the text cannot be so: nothing fits; expected a text that some values satisfy, or another --let");
  CHECK(said(zed::TooManyMembers("ℙ S")) ==
        "this is not decided: ℙ S has more members than can be listed; expected a smaller set, whatever --steps and "
        "--memory are");
  CHECK(said(zed::EvaluationError("x is open")) ==
        "this is not decided: x is open; expected finite sets, or equations, for what is quantified");
  CHECK(said(OpenVariables("x is open", "expected a bound for x")) ==
        "this is not decided: x is open; expected a bound for x");
}

TEST_CASE("each lack of an evaluation has an expectation of its own") {
  std::set<std::string> expectations;
  for (const zed::Lack lack : {zed::Lack::members, zed::Lack::equation, zed::Lack::end, zed::Lack::number,
                               zed::Lack::degree, zed::Lack::instance, zed::Lack::ground})
    expectations.insert(said(zed::LackingEvaluation(lack, "f 3")));
  CHECK(expectations.size() == 7);
  CHECK(said(zed::LackingEvaluation(zed::Lack::equation, "no equation gives f a value at 3")) ==
        "this is not decided: no equation gives f a value at 3; expected an equation for this argument, or another "
        "argument");
}

/// What is said of a term that is typed after a text.
std::string said_of(const std::string& typed, const std::vector<std::string>& scope = {}) {
  Calculator text(
      zed::read_text("\\begin{zed} [NAME] \\\\ T ::= leaf | node \\ldata T \\rdata \\end{zed}\n"
                     "\\begin{schema}{Book} known : \\power NAME; n : \\nat \\end{schema}\n"
                     "\\begin{axdef} few : \\nat \\fun \\nat \\where few(0) = 1 \\end{axdef}\n",
                     "t.tex"));
  text.scope(scope);
  try {
    return text.evaluate(typed).text;
  } catch (const zed::EvaluationError& error) {
    return said(error);
  }
}

TEST_CASE("the expectation fits what is not decided") {
  CHECK(said_of("∀ x : ℤ • x * x * x ≠ 2 * x + 7") ==
        "this is not decided: x ranges over ℤ, of which there is no end, and no equation gives its value; expected a "
        "bound for x, as x : 0‥9");
  CHECK(said_of("∀ x : 0‥9 • x * x * x ≠ 2 * x + 7") == "true");
  CHECK(said_of("∃ f : 1‥20 → 1‥20 • f (f 1 + f 20) = 21") ==
        "this is not decided: f ranges over 1 ‥ 20 → 1 ‥ 20, which has too many members, and no equation gives its "
        "value; expected a smaller set for f");
  CHECK(said_of("∀ n, m : NAME • n = m") ==
        "this is not decided: one of n, m ranges over a set that is not finite, and no equation gives its value; "
        "expected members of NAME, as by --scope NAME=3");
  CHECK(said_of("∀ n, m : NAME • n = m", {"NAME=3"}) == "false");
  CHECK(said_of("∀ t : T • ∀ i : 1‥3 • t ≠ node t ∨ i = 4") ==
        "this is not decided: t ranges over T, of which there is no end, and no equation gives its value; expected a "
        "finite set for t");
  CHECK(said_of("∀ Book • # known ≤ n") ==
        "this is not decided: Book ranges over its states, of which there is no end, and no equation gives its value; "
        "expected a finite set for Book, and members of NAME, as by --scope NAME=3");
  CHECK(said_of("few 2") ==
        "this is not decided: no equation gives few a value at 2; expected an equation for this argument, or another "
        "argument");
  CHECK(said_of("# {x : ℤ | x mod 2 = 0}") ==
        "this is not decided: the size of { x : ℤ | x mod 2 = 0 }: its members cannot be enumerated; expected sets "
        "that can be listed, as {x : 0‥9 | P}; --scope gives a given set members");
}

}  // namespace
}  // namespace durero::spec
