// The bounds of what comes before and after the closed forms, as bounds_test.cpp has those of the forms themselves: the
// filter over balls (tables.hpp), the order of elements (search.cpp), the improved root and the rounding
// (rounding.cpp).
#include <cmath>

#include "durero/surface/surfaces.hpp"
#include "durero/trace/analytic.hpp"
#include "support/catch.hpp"
#include "support/shapes.hpp"

using namespace durero;
using namespace durero::test;
using trace::Beam;
using trace::Finding;
using trace::Verdict;

namespace {

constexpr double u = 0x1p-53;

bool reaches(double published, double derived) { return published >= derived * (1 - 0x1p-35); }

double extent(const glm::dvec3& x) { return std::abs(x.x) + std::abs(x.y) + std::abs(x.z); }

/// A hit of the triage at t, with the slope σ there, and A.
Finding hit_at(double t, double error, double slope, double slope_error, double A, double A_error) {
  return {Verdict::hit, t, 0, error, {slope, slope_error, A, A_error}};
}

const glm::dvec3 up(0, 0, 1);

}  // namespace

TEST_CASE("the bound of potencia is the derived one, 2^-95 of what it is made of") {
  // Each ray meets its element at t = 2, exactly, with slope σ and curvature A; so −f/(2σ) errs by f's error alone.
  // M = |p − centro| + |t·v| + r, or + altura.
  const Beam ray3(ray({-3, 0, 0}, {1, 0, 0}));
  const Finding of_sphere = improved(scene::Sphere{{0, 0, 0}, 1}, ray3, false, hit_at(2, 0, -1, 0, 1, 0));
  CHECK(reaches(of_sphere.error, 0x1p-95 * 36 / 2));
  const Finding of_cylinder = improved(scene::Cylinder{{0, 0, 0}, 1, up, 1}, ray3, false, hit_at(2, 0, -1, 0, 1, 0));
  CHECK(reaches(of_cylinder.error, 0x1p-95 * 36 / 2));
  const Finding of_cone = improved(scene::Cone{{0, 0, 0}, 0.5, up, 2}, ray3, false, hit_at(2, 0, -1, 0, 1, 0));
  CHECK(reaches(of_cone.error, 0x1p-95 * 1.25 * 49 / 2));
  // From the sphere itself, at t = 2 and at 0: M = 2 + 1 + 1 there, 2 here, and that counts twice.
  const Finding on =
      improved(scene::Sphere{{0, 0, 0}, 1}, Beam(ray({-1, 0, 0}, {1, 0, 0})), true, hit_at(2, 0, 1, 0, 1, 0));
  CHECK(reaches(on.error, 0x1p-95 * (16 + 2 * 4) / 2));
}

TEST_CASE("the bound of an improved root is the derived one") {
  const scene::Sphere unit{{0, 0, 0}, 1};
  const Beam beam(ray({-3, 0, 0}, {1, 0, 0}));
  const double off = 0x1p-20;  // f = −2σδ + Aδ², δ = −off
  const double error = 0x1p-19, slope_error = 0x1p-30, A_error = 0x1p-31;
  const double value = 2 * off * -1 + off * off;
  const double slope_bound = 2 * slope_error + (1 + A_error) * error;
  const Finding better = improved(unit, beam, false, hit_at(2 + off, error, -1, slope_error, 1, A_error));
  REQUIRE(better.verdict == Verdict::hit);
  const double f_error = 0x1p-95 * 36 + 0x1p-52 * std::abs(value), delta = std::abs(value) / 2;
  CHECK(reaches(better.error,
                1.0000001 * (f_error + delta * 1.0000001 * slope_bound) / (2 - slope_bound) + 4 * u * delta));
  // Without errors of slope and A the rounding of f and the quotient's own are most of it.
  const Finding sharp = improved(unit, beam, false, hit_at(2 + off, 0, -1, 0, 1, 0));
  CHECK(reaches(sharp.error, f_error / 2 + 4 * u * delta));
}

TEST_CASE("a slope less than twice its bound improves nothing") {
  const scene::Sphere unit{{0, 0, 0}, 1};
  const Beam beam(ray({-3, 0, 0}, {1, 0, 0}));
  CHECK(improved(unit, beam, false, hit_at(2, 0, -1, 0.51, 1, 0)).verdict == Verdict::undecided);
  CHECK(improved(unit, beam, false, hit_at(2, 1.01, -1, 0, 1, 0)).verdict == Verdict::undecided);
  CHECK(improved(unit, beam, false, hit_at(2, 0.51, -1, 0, 1, 1)).verdict == Verdict::undecided);
}

TEST_CASE("a parameter is certain only where its whole bound rounds the same") {
  const Beam still(ray({0.5, 0, 0}, {0x1p-90, 0, 0}));  // the point is certain
  const auto certain = [&](double hi, double lo, double error) {
    return rounded(still, Finding{Verdict::hit, hi, lo, error}).certain;
  };
  const double odd = 1 + 2 * u;  // the halfway above rounds up
  CHECK(certain(odd, u / 2, 0));
  CHECK_FALSE(certain(odd, u * (1 - 2 * u), 0));         // 2⁻⁵²|lo| for the rounding of lo ± error
  CHECK_FALSE(certain(odd, u / 2, u / 2));               // the error itself
  CHECK_FALSE(certain(odd, u / 2, u / 2 * 0.99999995));  // and its own roundings, 10⁻⁷ of it
  CHECK(certain(odd, u / 2, u / 4));
}

TEST_CASE("a coordinate is certain only where its whole bound rounds the same") {
  // x = 1 + t is below the halfway above 1 by 0.9·2⁻¹⁰²(|t·v| + |p|).
  const double t = u - 0.875 * 0x1p-102;
  CHECK_FALSE(rounded(Beam(ray({1, 0, 0}, {1, 0, 0})), Finding{Verdict::hit, t, 0, 0}).certain);
  CHECK(rounded(Beam(ray({1, 0, 0}, {1, 0, 0})), Finding{Verdict::hit, u / 2, 0, 0}).certain);
  // p + 4t, t = 1 + 2⁻⁵⁶ ± e: below the halfway above 4 by 3.75e.
  const double e = 0x1p-70, p = 0x1p-51 - 0x1p-54 - 3.75 * e;
  const Finding found{Verdict::hit, 1, 0x1p-56, e};
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 origin(0.5), v(0);
    origin[axis] = p;
    v[axis] = 4;
    CHECK_FALSE(rounded(Beam(ray(origin, v)), found).certain);
    origin[axis] = 0;
    CHECK(rounded(Beam(ray(origin, v)), found).certain);
  }
}

TEST_CASE("parameters closer than the sum of their bounds are ordered exactly") {
  // Two unit spheres, the second off the ray by y, so that it is met y²/2 later.
  const Beam beam(ray({0, 0, 0}, {1, 0, 0}));
  const scene::Sphere first{{2, 0, 0}, 1};
  const double error = stable(first, beam, false).error;
  const auto ordered_by = [&](double apart) {
    scene::Scene scene;
    add(scene, first);
    add(scene, scene::Sphere{{2, std::sqrt(2 * apart), 0}, 1});
    trace::Counts counts;
    first_hit(trace::Tables(scene), ray({0, 0, 0}, {1, 0, 0}), {}, &counts);
    return counts.order;
  };
  CHECK(ordered_by(2 * error * 0.99)[2] == 1);
  CHECK(ordered_by(2 * error * 0.6)[2] == 1);
  CHECK(ordered_by(2 * error * 4)[2] == 0);
}

TEST_CASE("where the stable step decides the parameter's ends are wider than the error") {
  // Within the triage's bound of a tangent, and beyond the stable step's.
  scene::Scene scene;
  const scene::ElementRef e = add(scene, scene::Sphere{{0, 0, 0}, 1});
  const model::Rayo ray3 = ray({-3, 1 - 0x1p-52, 0}, {1, 0, 0});
  trace::Counts counts;
  const trace::Meeting met = trace::Search(scene, ray3, {}, counts).meeting(e, trace::no_limit);
  REQUIRE(met.step == trace::Step::stable);
  CHECK(met.finding.hi + met.finding.error + 0x1p-51 * met.finding.hi <= met.high);
  CHECK(met.low <= met.finding.hi - met.finding.error - 0x1p-51 * met.finding.hi);
  CHECK(met.finding.error < 0x1p-60);  // so the last term is most of it
}

TEST_CASE("the filter's allowances are the derived ones") {
  const Beam beam(ray({100, -20, 7}, {3, -5, 0.25}));
  CHECK(reaches(beam.allowance, 16 * u * extent(beam.p)));
  const double square = dot(beam.v, beam.v);
  CHECK(beam.length_squared >= square * (1 + 60 * u));
  CHECK(beam.length >= std::sqrt(square) * (1 + 30 * u));
  trace::Balls balls;
  balls.push_back({{100, -20, 7}, 0});
  CHECK(reaches(balls.radius[0], 16 * u * 127));
}

TEST_CASE("the balls' allowances are the derived ones") {
  // 2⁻⁴⁰ of the radius; and 4u(|centro| + height) in each component, for the rounded centre, with as much again.
  const double r = surface::ball(scene::Cylinder{{0, 0, 0}, 3, up, 8}).radius;
  CHECK(r - 5 >= 5 * 0x1p-40 * 0.999);
  CHECK(reaches(surface::ball(scene::Cylinder{{0x1p60, 0, 0}, 3, up, 8}).radius, 0x1p12 + 5));
  CHECK(reaches(surface::ball(scene::Cone{{0, 0x1p60, 0}, 0.5, up, 8}).radius, 0x1p12 + 5));
}
