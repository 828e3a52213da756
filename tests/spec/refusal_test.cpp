#include "durero/spec/refusal.hpp"

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
}

}  // namespace
}  // namespace durero::spec
