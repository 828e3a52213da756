#include "durero/conform/ask/claim.hpp"

#include "support/catch.hpp"

using durero::conform::Claim;

TEST_CASE("what says nothing is no answer") {
  const Claim silent;
  CHECK(silent.outcome == Claim::Outcome::unanswered);
  CHECK_FALSE((silent.element || silent.t || silent.punto));
  CHECK(silent.why.empty());
}

TEST_CASE("claims are equal when they say the same") {
  const Claim hit{.outcome = Claim::Outcome::hit, .t = 4.0};
  CHECK(hit == Claim{.outcome = Claim::Outcome::hit, .t = 4.0});
  CHECK_FALSE(hit == Claim{.outcome = Claim::Outcome::hit, .t = 5.0});
  CHECK_FALSE(hit == Claim{.outcome = Claim::Outcome::hit, .punto = glm::dvec3(0, 0, 4)});
  CHECK_FALSE(Claim{.outcome = Claim::Outcome::crashed, .why = "signal 6"} ==
              Claim{.outcome = Claim::Outcome::crashed, .why = "signal 11"});
}
