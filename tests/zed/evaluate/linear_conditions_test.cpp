// Linear conditions on whole numbers, against all points of a window.
#include "zed/evaluate/linear_conditions.hpp"

#include "support/catch.hpp"
#include "support/property.hpp"

namespace durero::zed {
namespace {

constexpr int window = 4;  // each variable of a random question is from −4 to 4

IntegerForm form(const std::vector<int>& coefficients, int constant) {
  IntegerForm form;
  form.constant = constant;
  for (unsigned i = 0; i < coefficients.size(); ++i)
    if (coefficients[i] != 0) form.coefficients[i] = coefficients[i];
  return form;
}

bool holds(const LinearConditions& conditions, const IntegerPoint& point) {
  return std::all_of(conditions.begin(), conditions.end(), [&](const IntegerForm& each) {
    Integer sum = each.constant;
    for (const auto& [variable, coefficient] : each.coefficients) {
      const auto at = point.find(variable);
      sum += coefficient * (at == point.end() ? Integer(0) : at->second);
    }
    return sum <= 0;
  });
}

/// Calls `visit` for each point of the window in so many variables, until it returns true. Says whether it did.
bool some_point(unsigned variables, const std::function<bool(IntegerPoint&)>& visit, IntegerPoint point = {}) {
  if (point.size() == variables) return visit(point);
  const auto at = static_cast<unsigned>(point.size());
  for (int number = -window; number <= window; ++number) {
    point[at] = number;
    if (some_point(variables, visit, point)) return true;
  }
  return false;
}

void add_window(LinearConditions& conditions, unsigned variables) {
  for (unsigned i = 0; i < variables; ++i)
    for (const int side : {1, -1}) {
      conditions.push_back({});
      conditions.back().constant = -window;
      conditions.back().coefficients[i] = side;
    }
}

LinearConditions any_conditions(unsigned variables, int greatest) {
  LinearConditions conditions;
  const int count = *rc::gen::inRange(1, 6);
  for (int i = 0; i < count; ++i) {
    std::vector<int> coefficients;
    for (unsigned j = 0; j < variables; ++j) coefficients.push_back(*rc::gen::inRange(-greatest, greatest + 1));
    conditions.push_back(form(coefficients, *rc::gen::inRange(-9, 10)));
  }
  return conditions;
}

TEST_CASE("conditions of which no whole numbers satisfy all are contradictory, and others have a point") {
  Steps steps;
  const auto impossible = [&](const LinearConditions& conditions) { return solved(conditions, steps).is_impossible; };
  CHECK(impossible({form({}, 1)}));
  CHECK_FALSE(impossible({form({}, 0)}));
  CHECK(impossible({form({1}, -2), form({-1}, 3)}));                                // 3 ≤ x ≤ 2
  CHECK_FALSE(impossible({form({1}, -3), form({-1}, 3)}));                          // 3 ≤ x ≤ 3
  CHECK(impossible({form({3}, -8), form({-3}, 7)}));                                // 7 ≤ 3x ≤ 8
  CHECK(impossible({form({2, -2}, -1), form({-2, 2}, 1)}));                         // 2x = 2y + 1
  CHECK(impossible({form({1, -1}, 1), form({0, 1, -1}, 1), form({-1, 0, 1}, 0)}));  // x < y < z ≤ x
  const auto point = solved({form({7, 11}, -100), form({-7, -11}, 100)}, steps).point;
  REQUIRE(point);
  CHECK(point->at(0) * 7 + point->at(1) * 11 == 100);
  const auto free = solved({form({1, -1}, 0)}, steps).point;  // x ≤ y
  REQUIRE(free);
  CHECK(free->at(0) <= free->at(1));
}

TEST_CASE("the steps of an elimination are counted") {
  Steps few(3);
  CHECK_THROWS_AS(solved({form({1, -1}, 0), form({-1, 2}, 0), form({1, 3}, 1), form({-2, 1}, 5)}, few), StepsSpent);
}

TEST_CASE("an elimination says of random conditions what the points of a window say") {
  int asked = 0, known = 0;
  durero::test::property("random conditions", [&] {
    const auto variables = static_cast<unsigned>(*rc::gen::inRange(1, 4));
    LinearConditions conditions = any_conditions(variables, 3);
    add_window(conditions, variables);
    Steps steps;
    const LinearAnswer answer = solved(conditions, steps);
    const bool some = some_point(variables, [&](IntegerPoint& point) { return holds(conditions, point); });
    if (answer.is_impossible) RC_ASSERT(!some);
    if (answer.point) RC_ASSERT(holds(conditions, *answer.point));
    RC_ASSERT(!(answer.is_impossible && answer.point));
    ++asked;
    known += answer.is_impossible || answer.point ? 1 : 0;
  });
  INFO(known << " of " << asked << " were decided");
  CHECK(known * 10 >= asked * 9);
}

TEST_CASE("a projection holds of the numbers to which some others can be found, and of no others") {
  int asked = 0, known = 0;
  durero::test::property("random conditions", [&] {
    LinearConditions conditions = any_conditions(3, 2);
    add_window(conditions, 3);
    Steps steps;
    const auto rest = projected(conditions, {2}, steps);
    ++asked;
    if (!rest) return;
    ++known;
    some_point(2, [&](IntegerPoint& point) {
      bool some = false;
      for (int number = -window; number <= window; ++number) {
        IntegerPoint whole = point;
        whole[2] = number;
        some = some || holds(conditions, whole);
      }
      RC_ASSERT(holds(*rest, point) == some);
      return false;
    });
  });
  INFO(known << " of " << asked << " were projected");
  CHECK(known * 2 >= asked);
}

TEST_CASE("a projection that may leave out numbers between two others is none") {
  Steps steps;
  CHECK_FALSE(projected({form({-1, 2}, 0), form({1, -2}, 0)}, {1}, steps));  // x = 2y holds of even x alone
  const auto rest = projected({form({-1, 2}, 0), form({1, -2}, -1)}, {0}, steps);
  REQUIRE(rest);
  CHECK(rest->empty());
}

}  // namespace
}  // namespace durero::zed
