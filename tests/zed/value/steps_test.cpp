#include "durero/zed/value/steps.hpp"

#include "durero/zed/evaluate/evaluate.hpp"
#include "durero/zed/syntax/parser.hpp"
#include "support/catch.hpp"

namespace durero::zed {
namespace {

std::uint64_t steps_of(const std::string& expression, std::uint64_t most = Steps::unbounded) {
  Steps steps(most);
  const Evaluator evaluator({}, {}, &steps);
  evaluator.value(parse_unicode(expression));
  return steps.taken();
}

std::uint64_t steps_to_decide(const std::string& predicate, std::uint64_t most = Steps::unbounded) {
  Steps steps(most);
  const Evaluator evaluator({}, {}, &steps);
  const Truth truth = evaluator.holds(parse_unicode(predicate));  // Catch would swallow what it throws
  CHECK(truth == Truth::yes);
  return steps.taken();
}

}  // namespace

TEST_CASE("as many steps may be taken as are allowed, and none more") {
  Steps steps(3);
  steps.take();
  steps.take(2);
  CHECK(steps.taken() == 3);
  CHECK_THROWS_AS(steps.take(), StepsSpent);
  CHECK_THROWS_AS(Steps(7).take(8), StepsSpent);
}

TEST_CASE("a search takes a step for each member that it visits, and a relation one") {
  CHECK(steps_to_decide("1 < 2") == 1);
  const std::uint64_t hundred = steps_to_decide("∀ x : 1‥100 • x ≤ 100");
  CHECK(hundred >= 200);
  CHECK(hundred <= 400);
  CHECK(steps_to_decide("∀ x, y : 1‥100 • x ≤ 100") >= 100 * 100 * 2);
}

TEST_CASE("work on a large set takes steps in proportion, whoever asks for it") {
  CHECK(steps_of("(ℙ (1‥12)) ∪ ∅") >= (1 << 12) / 8);
  CHECK(steps_of("(1‥4000) ∪ (2‥5000)") >= 9000 / 8);
  CHECK(steps_of("⋃ {x : 1‥100 • 1‥x}") >= 100 * 100 / 2 / 8);
  CHECK(steps_of("(λ x : 1‥1000 • x) ⨾ (λ x : 1‥1000 • x)") >= 1000 * 1000 / 8);
  CHECK(steps_of("{x : 1‥1000 | x ∈ 1‥100000}") <= 10000);  // membership is asked without going through the set
  CHECK(steps_to_decide("{x : 1‥1000 | x > 0} = {y : 1‥1000 | y > 0}") >= 2 * 1000 + 2 * 1000 / 8);
}

TEST_CASE("work on a large number takes steps in proportion") {
  std::string power = "3";
  for (int i = 0; i < 14; ++i) power = "let a == " + power + " • a * a";  // 3^(2^14) has some 400 words
  const std::uint64_t steps = steps_of(power);
  CHECK(steps >= 14 + 8 * 400);
  CHECK(steps <= 14 + 8 * 4 * 400);
}

TEST_CASE("what takes too many steps is stopped, also within a definition that is listed when first asked for") {
  CHECK_THROWS_AS(steps_to_decide("∀ x, y, z : 1‥1000 • x ≤ 1000", 100'000), StepsSpent);
  CHECK_THROWS_AS(steps_of("# (λ x, y, z : 1‥100 • x + y)", 100'000), StepsSpent);
  CHECK_THROWS_AS(steps_of("{x : 1‥100 • ⋃ {y : 1‥1000 • x‥y}}", 100'000), StepsSpent);
}

TEST_CASE("an evaluator counts for itself where nothing is given to count in") {
  CHECK(Evaluator({}).value(parse_unicode("1 + 1")).text() == "2");
}

}  // namespace durero::zed
