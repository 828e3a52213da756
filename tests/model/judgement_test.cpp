#include "durero/model/judgement.hpp"

#include "support/catch.hpp"
#include "support/clauses.hpp"

using namespace durero;
using namespace durero::model;
using namespace durero::test;
using contract::cost;

namespace {

constexpr contract::clause first{"Test.pre.1", "x > 0"}, second{"Test.pre.2", "x < 0"};

}  // namespace

TEST_CASE("all hold where none fails") {
  CHECK(all_hold({}));
  CHECK(all_hold({{&first, true}, {&second, true}}));
  CHECK_FALSE(all_hold({{&first, true}, {&second, false}}));
}

TEST_CASE("the first judgement that fails is the violation") {
  CHECK(violated([] { check({{&first, true}}, cost::normal); }) == "none");
  CHECK(violated([] { check({{&first, true}, {&second, false}}, cost::normal); }) == "Test.pre.2");
  CHECK(violated([] { check({{&second, false}, {&first, false}}, cost::normal); }) == "Test.pre.2");
}

TEST_CASE("the values are printed for a broken clause alone, and under its own price") {
  int printed = 0;
  const auto values = [&] { return ++printed, std::string("x = 1"); };
  check({{&first, true}}, cost::normal, values);
  check({{&second, false}}, cost::audit, values);  // audit clauses are ignored until they are asked for
  CHECK(printed == 0);
  CHECK(violated([&] { check({{&second, false}}, cost::normal, values); }) == "Test.pre.2");
  CHECK(printed == 1);
}
