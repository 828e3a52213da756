// Splines of POV-Ray's language. The expected values are POV-Ray 3.7's own, as `#debug` prints them.
#include <fmt/format.h>

#include <string>
#include <vector>

#include "durero/io/pov/pov.hpp"
#include "durero/scene/scene.hpp"
#include "io/malformed.hpp"
#include "support/catch.hpp"

using namespace durero;

namespace {

const std::string points = "0,<0,1,2> 1,<1,5,-1>, 2.5,<4,0,3> 4,<2,2,2> 7,<9,1,0>";

/// The value of an expression behind declarations: of it a ball is so far from the origin.
glm::dvec3 value(const std::string& declarations, const std::string& expression) {
  const std::string text = declarations + "\nsphere { " + expression + ", 1 }\n#version 3.7;";
  return io::read_pov(io::Source("f", text)).scene.shapes<scene::Sphere>()[0].centro;
}

void check_near(const glm::dvec3& value, const glm::dvec3& expected, double margin = 1e-11) {
  for (int i = 0; i < 3; ++i) CHECK(value[i] == Approx(expected[i]).epsilon(0).margin(margin));
}

struct Asked {
  const char* kind;
  double at;
  glm::dvec3 expected;
};

std::string error_at(const std::string& with_mark) {
  return test::error_at_mark(with_mark, [](const io::Source& s) { return io::read_pov(s); });
}

}  // namespace

TEST_CASE("A spline has the values of its kind that POV-Ray gives it") {
  for (const auto& [kind, at, expected] :
       std::vector<Asked>{{"linear", -1, {0, 1, 2}},
                          {"linear", 1.75, {2.5, 2.5, 1}},
                          {"linear", 8, {9, 1, 0}},
                          {"quadratic", -1, {0, 1, 2}},
                          {"quadratic", 1.5, {1.8, 4.8, -0.8}},
                          {"quadratic", 3, {3.888888888889, -0.111111111111, 3.222222222222}},
                          {"quadratic", 6.5, {6.814814814815, 1.629629629630, 0.333333333333}},
                          {"cubic", 0.5, {1, 5, -1}},
                          {"cubic", 1.5, {2.074074074074, 3.888888888889, -0.111111111111}},
                          {"cubic", 2, {3.314814814815, 1.555555555556, 1.722222222222}},
                          {"cubic", 3.5, {2.444444444444, 1.259259259259, 2.518518518519}},
                          {"cubic", 6.5, {2, 2, 2}},
                          {"natural", 1.5, {2.167016072676, 3.993885394829, -0.215408805031}},
                          {"natural", 3, {3.640111809923, -0.183438155136, 3.352550663871}},
                          {"natural", 6.5, {7.044549266247, 1.764369322152, 0.102506988120}},
                          {"natural", 7.5, {9, 1, 0}}}) {
    INFO(kind << " at " << at);
    const std::string declared = fmt::format("#declare S = spline {{ {}_spline {} }}", kind, points);
    check_near(value(declared, fmt::format("S({})", at)), expected);
    check_near(value("#declare S = spline { " + points + " }", fmt::format("S({}, {}_spline)", at, kind)), expected);
  }
}

TEST_CASE("A spline is linear without a kind, in the order of its numbers, and of two vectors or of one") {
  const std::string mixed = "#declare S = spline { 4,<2,2,2> 0,<0,1,2> 1,<1,5,-1> 1,<3,3,3> }";
  check_near(value(mixed, "S(0.5)"), {1.5, 2, 2.5});
  check_near(value(mixed, "S(2)"), {2.666666666667, 2.666666666667, 2.666666666667});
  for (const char* kind : {"quadratic", "natural", "linear"})
    check_near(value(fmt::format("#declare S = spline {{ {}_spline 3,<2,2,2> 4,<0,0,0> }}", kind), "S(3.5)"),
               {1, 1, 1});
  const std::string two = "#declare S = spline { cubic_spline 3,<2,2,2> 4,<0,0,0> }";
  check_near(value(two, "S(0)"), {1, 1, 1});
  check_near(value(two, "S(3.2)"), {1, 1, 1});
  check_near(value("#declare S = spline { cubic_spline 3,<2,2,2> 4,<0,5,0> 6,<3,1,0> }", "S(5)"), {0, 5, 0});
  check_near(value("#declare S = spline { cubic_spline 3,<2,1,2> }", "S(9)"), {2, 1, 2});
}

TEST_CASE("A spline goes on from another, is passed on, and stands in a function") {
  const std::string natural = fmt::format("#declare S = spline {{ natural_spline {} }}", points);
  check_near(value(natural + "#declare M = spline { S 9,<1,1,1> }", "M(1.5)"), {2.201947, 3.987023, -0.218446}, 1e-6);
  check_near(value(natural + "#declare M = S;", "M(1.5)"), {2.167016072676, 3.993885394829, -0.215408805031});
  check_near(value("#declare F = function { spline { linear_spline 0,<0,1,2> 1,<1,5,-1> } }", "F(0.5)"), {0.5, 3, 0.5});
  check_near(value("#declare S = spline { 0, 1 1, 5 }", "<S(0.5).x, S(0.5).y, 0>"), {3, 3, 0});
  check_near(value("#macro P(S, X) S(X) #end #declare A = spline { 0,<0,0,0> 1,<2,4,6> }", "P(A, 0.5)"), {1, 2, 3});
}

TEST_CASE("What is wrong with a spline is said at its place") {
  CHECK(error_at("#declare S = spline { ^}").ends_with("expected a vector at least in a spline"));
  CHECK(error_at("#declare S = spline { 1 ^<1,2,3> }").ends_with("between a number of a spline and its vector"));
  CHECK(error_at("#declare S = spline { 1,<1,2,3> } sphere { S(1, ^bent_spline), 1 }")
            .ends_with("expected linear_spline, quadratic_spline, cubic_spline or natural_spline"));
}
