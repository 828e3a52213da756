// The bounds that the steps publish are no less than those derived in words beside them (closed_form-inl.hpp and what
// it includes, rounding.cpp, tables.hpp; for the sphere also proved, proofs/Flotante.v). A bound that is too small by a
// factor would hardly ever give a wrong answer, so it is computed here again, from the words: where a step publishes
// it, it must reach that; where it only compares with it, what lies within the bound must be left undecided.
#include <cmath>
#include <limits>
#include <string>

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
constexpr double infinity = std::numeric_limits<double>::infinity();

/// Published is at least derived, up to the roundings of both.
bool reaches(double published, double derived) { return published >= derived * (1 - 0x1p-35); }

double extent(const glm::dvec3& x) { return std::abs(x.x) + std::abs(x.y) + std::abs(x.z); }

/// Triage or stable, with its unit roundoff.
struct Level {
  std::string name;
  double epsilon;
};
const Level levels[] = {{"triage", u}, {"stable", 0x1p-102}};

template <class Element>
Finding find(const Level& level, const Element& element, const Beam& beam, bool on = false,
             double limit = trace::no_limit) {
  return level.epsilon == u ? triage(element, beam, on, limit) : stable(element, beam, on, limit);
}

/// The quadratic of a ray and an element, from the words, in binary64.
struct Form {
  double A, B, C;
  double kappa, E;       ///< κ, and E ≥ |q| + r or |q| + altura
  double s0, s1, reach;  ///< the advance along the axis, and |q| + altura
  double V;
};

Form form(const scene::Sphere& e, const Beam& ray) {
  const glm::dvec3 q = ray.p - e.centro;
  const double V = extent(ray.v), E = extent(q) + e.radio;
  return {dot(ray.v, ray.v), dot(q, ray.v), dot(q, q) - e.radio * e.radio, 1, E, 0, 0, E, V};
}

/// What cylinder and cone share: s0, s1, and the products of the parts across the axis.
template <class Element>
Form across(const Element& e, const Beam& ray) {
  const glm::dvec3 q = ray.p - e.centro, d = e.vector;
  const double s0 = dot(q, d), s1 = dot(ray.v, d);
  const glm::dvec3 a = ray.v - s1 * d, b = q - s0 * d;
  return {dot(a, a), dot(b, a), dot(b, b), 1, extent(q), s0, s1, extent(q) + e.altura, extent(ray.v)};
}

Form form(const scene::Cylinder& e, const Beam& ray) {
  Form f = across(e, ray);
  f.C -= e.radio * e.radio;
  f.E += e.radio;
  return f;
}

Form form(const scene::Cone& e, const Beam& ray) {
  Form f = across(e, ray);
  const double k2 = e.proporcion * e.proporcion, g = e.altura - f.s0;
  f.A -= k2 * f.s1 * f.s1;
  f.B += k2 * g * f.s1;
  f.C -= k2 * g * g;
  f.kappa = 1 + k2;
  f.E = f.reach;
  return f;
}

/// "Every coefficient is 64."
struct Errors {
  Errors(const Form& f, double epsilon)
      : A(64 * epsilon * f.kappa * f.V * f.V),
        B(64 * epsilon * f.kappa * f.V * f.E),
        C(64 * epsilon * f.kappa * f.E * f.E) {}
  double A, B, C;
};

/// "|x/y − x̂/ŷ| ≤ (x_error + |x̂/ŷ|·y_error)/(|ŷ| − y_error), and a rounding."
double quotient_error(double t, double x_error, double y, double y_error, double epsilon) {
  return 1.0000001 * (x_error + std::abs(t) * y_error) / (std::abs(y) - y_error) + 4 * epsilon * std::abs(t);
}

/// The error of √D: "≤ 3·error·H", by S + √D ≥ S, "and |S − √D| = |S² − D|/(S + √D)"; four roundings of it. H = F +
/// 2·of the line, here by H·F = D and what the caller knows of F.
double root_error(const Form& f, double H, double epsilon) {
  const double S = std::sqrt(f.B * f.B - f.A * f.C);
  return 3 * Errors(f, epsilon).B * H / S + 4 * epsilon * S;
}

/// The error of the nearer root, C/q or q/A with q = −(B + σS).
double nearer_root_error(const Form& f, double H, double epsilon) {
  const Errors error(f, epsilon);
  const double S = std::sqrt(f.B * f.B - f.A * f.C), sigma = f.B >= 0 ? 1 : -1, q = -(f.B + sigma * S);
  const double q_error = error.B + root_error(f, H, epsilon) + 2 * epsilon * std::abs(q);
  const double of_A = q / f.A, of_C = f.C / q;
  const double by_A = quotient_error(of_A, q_error, f.A, error.A, epsilon);
  const double by_C = quotient_error(of_C, error.C, q, q_error, epsilon);
  return of_A > 0 && (of_C <= 0 || of_A < of_C) ? by_A : by_C;
}

/// H = (distance of the surface) + (distance of the line), as the table of quantities has them.
double H_of(const scene::Sphere& e, const Beam& ray) {
  const glm::dvec3 q = ray.p - e.centro;
  return e.radio * length(ray.v) + length(cross(q, ray.v));
}
double H_of(const scene::Cylinder& e, const Beam& ray) {
  const glm::dvec3 q = ray.p - e.centro, d = e.vector;
  const glm::dvec3 a = ray.v - dot(ray.v, d) * d, b = q - dot(q, d) * d;
  return e.radio * length(a) + length(cross(b, a));
}
double H_of(const scene::Cone& e, const Beam& ray) {
  const glm::dvec3 q = ray.p - e.centro, d = e.vector;
  const double s0 = dot(q, d), s1 = dot(ray.v, d);
  const glm::dvec3 a = ray.v - s1 * d, b = q - s0 * d;
  return e.proporcion * length((e.altura - s0) * a + s1 * b) + length(cross(b, a));
}

const glm::dvec3 slanted(0.6, 0, 0.8);
const scene::Sphere sphere{{0.5, -0.25, 1}, 1.5};
const scene::Cylinder cylinder{{0.5, -0.25, 1}, 1.5, slanted, 4};
const scene::Cone cone{{0.5, -0.25, 1}, 0.75, slanted, 4};

/// From far and from inside: the nearer root is C/q, then q/A.
const Beam rays_at[] = {Beam(ray({-7, 2, 3}, {3.25, -0.875, -0.5})), Beam(ray({1, -0.25, 2}, {-0.75, 0.25, 0.5})),
                        Beam(ray({1, -0.25, 2}, {0.75, -0.5, -0.625}))};

/// check(level, element, beam) for both levels, every element and ray.
template <class Check>
void for_each(Check check) {
  for (const Level& level : levels) {
    for (const Beam& beam : rays_at) {
      INFO(level.name << " from " << beam.p.x);
      check(level, sphere, beam);
      check(level, cylinder, beam);
      check(level, cone, beam);
    }
  }
}

}  // namespace

TEST_CASE("the bounds of the coefficients and of the discriminant's root are the derived ones") {
  for_each([](const Level& level, const auto& element, const Beam& beam) {
    const Form f = form(element, beam);
    const Errors error(f, level.epsilon);
    const Finding hit = find(level, element, beam);
    REQUIRE(hit.verdict == Verdict::hit);
    CHECK(reaches(hit.slope.A_error, error.A));
    CHECK(reaches(hit.slope.at_root_error, root_error(f, H_of(element, beam), level.epsilon)));
    CHECK(reaches(hit.error, nearer_root_error(f, H_of(element, beam), level.epsilon)));
  });
}

TEST_CASE("the bounds for a ray that starts on the element are the derived ones") {
  int hits = 0;
  for_each([&](const Level& level, const auto& element, const Beam& beam) {
    const Form f = form(element, beam);
    const Errors error(f, level.epsilon);
    const Finding hit = find(level, element, beam, true);
    if (hit.verdict != Verdict::hit) return;
    ++hits;
    CHECK(reaches(hit.slope.at_root_error, error.B));
    CHECK(reaches(hit.error, quotient_error(-2 * f.B / f.A, 2 * error.B, f.A, error.A, level.epsilon)));
  });
  CHECK(hits >= 6);
}

// Below, p − centro is exact and small numbers survive in it: the element lies next to the origin of the numbers.

TEST_CASE("a discriminant within its bound has no sign") {
  for (const Level& level : levels) {
    // |q × v| = 1 + δ against r|v| = 1; E = |q| + r = 10 + δ, V = 1.
    const double bound = 64 * level.epsilon * 10;
    for (const double part : {-0.9, 0.9}) {
      const scene::Sphere unit{{0, -1, 0}, 1};
      CHECK(find(level, unit, Beam(ray({-8, part * bound, 0}, {1, 0, 0}))).verdict == Verdict::undecided);
    }
  }
}

TEST_CASE("a root within its bound of the origin is neither ahead nor behind") {
  for (const Level& level : levels) {
    for (const double side : {-0.9, 0.9}) {
      const scene::Sphere unit{{1, 0, 0}, 1};
      const Beam at(ray({0, 0, 0}, {1, 0, 0}));
      const double bound = quotient_error(0, Errors(form(unit, at), level.epsilon).C, 2, 0, level.epsilon);
      CHECK(find(level, unit, Beam(ray({side * bound, 0, 0}, {1, 0, 0}))).verdict == Verdict::undecided);
    }
  }
}

TEST_CASE("an advance within its bound of a rim is neither inside nor outside") {
  for (const Level& level : levels) {
    const scene::Cylinder upright{{0, 0, 0}, 1, {0, 0, 1}, 1};
    for (const double part : {-0.9, 0.9}) {
      // Across the axis: s1 = 0, t = 1, |q| + altura + |t|V = 2 + 1 + 1.
      const double of_sum = 16 * level.epsilon * 4 * part;
      CHECK(find(level, upright, Beam(ray({-2, 0, of_sum}, {1, 0, 0}))).verdict == Verdict::undecided);
      if (level.epsilon == u) {
        CHECK(find(level, upright, Beam(ray({-2, 0, 1 + of_sum}, {1, 0, 0}))).verdict == Verdict::undecided);
      }
      // Along it: s1 = 8, and the root's error by as much. The ray comes to z = 0 at t = 1.
      const Beam steep(ray({-2, 0, -8}, {1, 0, 8}));
      const double root = nearer_root_error(form(upright, steep), H_of(upright, steep), level.epsilon);
      const double bound = 16 * level.epsilon * (11 + 9) + 8 * root;
      if (level.epsilon == u) {
        CHECK(find(level, upright, Beam(ray({-2, 0, -8 + part * bound}, {1, 0, 8}))).verdict == Verdict::undecided);
      }
    }
  }
}

TEST_CASE("an A that may be 0 is not divided by") {
  for (const Level& level : levels) {
    // Nearly along the axis: A = a², its error 64ε(a + 1)².
    const double a = std::sqrt(64 * level.epsilon * 0.9);
    const scene::Cylinder tube{{0, 0, 0}, 1, {0, 0, 1}, 0x1p60};
    const Beam along(ray({0.5, 0, 0.5}, {a, 0, 1}));
    CHECK(find(level, tube, along).verdict == Verdict::undecided);
    CHECK(find(level, tube, along, true).verdict == Verdict::undecided);
  }
}

TEST_CASE("a sum of B and the discriminant's root that is within twice its bound is not divided by") {
  for (const Level& level : levels) {
    // At the middle of a chord B = 0 and S² = F·H, so the bound of S is 3·error·H/S = S·3·error/F. The chord lies below
    // the base, so that nothing else is in doubt: where there is a sum to divide by, the ray misses.
    const scene::Cylinder above{{0, -1, 0}, 1, {0, 0, 1}, 1};
    const double error = 64 * level.epsilon * 3;
    CHECK(find(level, above, Beam(ray({0, -4.5 * error, -1}, {1, 0, 0}))).verdict == Verdict::undecided);
    CHECK(find(level, above, Beam(ray({0, -9 * error, -1}, {1, 0, 0}))).verdict == Verdict::miss);
  }
}

TEST_CASE("a root within its bound of the limit is not beyond it") {
  const scene::Sphere unit{{0, 0, 0}, 1};
  const Beam beam(ray({-3, 0, 0}, {1, 0, 0}));
  const double bound = nearer_root_error(form(unit, beam), H_of(unit, beam), u);
  CHECK(find(levels[0], unit, beam, false, 2 - 0.9 * bound).verdict == Verdict::hit);
  CHECK(find(levels[0], unit, beam, false, 2 - 1.1 * bound).verdict == Verdict::miss);
}
