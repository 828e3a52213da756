#include "durero/spec/animation_text.hpp"

#include "durero/zed/syntax/reader.hpp"
#include "support/catch.hpp"

namespace durero::spec {
namespace {

using Catch::Matchers::Contains;

/// A counter from 0 to 2.
const Machine& counter() {
  static const Machine made(
      zed::read_text("\\begin{schema}{S}\n n : \\nat\n\\where\n n \\leq 2 % S.inv.1\n\\end{schema}\n"
                     "\\begin{schema}{Init}\n S~'\n\\where\n n' = 0\n\\end{schema}\n"
                     "\\begin{schema}{Up}\n \\Delta S \\\\ by? : \\nat \\\\ old! : \\nat\n\\where\n"
                     " by? \\geq 1 \\\\ n' = n + by? \\\\ old! = n\n\\end{schema}\n"
                     "\\begin{zed}\n \\vdash? \\forall S @ n \\leq 1\n\\end{zed}\n",
                     "counter.tex"),
      {});
  return made;
}

Transition begun() { return counter().initial(1).transitions.at(0); }
Transition gone_up() {
  const zed::Name by{"by", "?"};
  return counter().steps(begun().after, *counter().find("Up"), {{by, counter().typed("2", by)}}, 9).transitions.at(0);
}

TEST_CASE("a step stands on one line with its inputs and outputs, a state in a table beside the one before") {
  CHECK(step_line(counter(), begun()) == "Init");
  CHECK(step_line(counter(), gone_up()) == "Up  by? = 2; old! = 0");
  CHECK(state_table(counter(), nullptr, begun().after) == "    n == 0\n");
  const zed::Valuation before = begun().after;
  CHECK(state_table(counter(), &before, gone_up().after) == "  * n == 0  →  2\n");
  CHECK(way_story(counter(), {begun(), gone_up()}) ==
        "0. Init\n    n == 0\n1. Up  by? = 2; old! = 0\n  * n == 0  →  2\n");
}

TEST_CASE("predicates stand with their truth and label, and the outlook names what refuses an operation") {
  CHECK_THAT(findings_list(counter().invariant(begun().after)), Contains("true   n ≤ 2  % S.inv.1\n"));
  CHECK(outlook(counter(), begun().after) == "  invariant: 2 of 2 conjuncts hold\n  may go on: Up\n");
  CHECK_THAT(operations_list(counter(), begun().after), Contains("yes  Up  by? = 1; old! = 0"));
  CHECK_THAT(operations_list(counter(), gone_up().after), Contains("no   Up"));
}

TEST_CASE("a conjecture stands with its place, and is said to be of the state") {
  const zed::Valuation before = begun().after;
  const auto tried = counter().conjectures(before, gone_up());
  REQUIRE(tried.size() == 1);
  CHECK(claim_line(tried[0]) == "  false  counter.tex:17: ∀ S • n ≤ 1  (here)\n");
}

}  // namespace
}  // namespace durero::spec
