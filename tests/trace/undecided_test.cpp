// What lies within the bound that a step states is left undecided, and what lies well beyond it is decided. Rays are
// laid so that a quantity is the given part of its bound.
#include <cmath>

#include "support/catch.hpp"
#include "support/shapes.hpp"
#include "trace/closed_form-inl.hpp"
#include "trace/steps.hpp"
#include "trace/triage.hpp"

using namespace durero;
using namespace durero::test;
namespace steps = trace::HWY_NAMESPACE;
using steps::DoubleDouble;
using trace::Decision;

namespace {

const scene::Cylinder upright{{0, 0, 0}, 1, {0, 0, 1}, 1};

/// What the closed form over T says of the ray, and the quantities that it says it from.
template <class T, class Shape>
struct Answer {
  Answer(const Shape& shape, const glm::dvec3& p, const glm::dvec3& v, bool on = false)
      : traced(ray(p, v)),
        f(steps::quadratic<T>(shape, traced)),
        verdict(steps::closed_form<T>(shape, traced, on, trace::no_limit).verdict) {}
  trace::Ray traced;
  steps::BoundedQuadratic<T> f;
  Decision verdict;
};

/// Numbers are small next to the origin of the numbers, and survive there: p is chosen so that a quantity is the given
/// part of its bound.
constexpr double parts[] = {-3, -0.99, 0, 0.99, 3};

bool within(double part) { return std::abs(part) < 1; }

}  // namespace

TEMPLATE_TEST_CASE("a discriminant within its bound has no sign", "", double, DoubleDouble) {
  const scene::Sphere below{{0, -1, 0}, 1};  // |q × v| = 1 + y, r|v| = 1
  const double bound = Answer<TestType, scene::Sphere>(below, {-8, 0, 0}, {1, 0, 0}).f.B_error;
  for (const double part : parts) {
    const Answer<TestType, scene::Sphere> answer(below, {-8, -part * bound, 0}, {1, 0, 0});
    INFO(part);
    CHECK((answer.verdict == Decision::undecided) >= within(part));
    CHECK((answer.verdict == Decision::miss) == (part < -1));
  }
}

TEMPLATE_TEST_CASE("a root within its bound of the origin is neither ahead nor behind", "", double, DoubleDouble) {
  const scene::Sphere unit{{1, 0, 0}, 1};
  const Answer<TestType, scene::Sphere> at(unit, {0, 0, 0}, {1, 0, 0});
  const auto q = stable_sum(at.f, root_of_discriminant(at.f)).q;
  const double bound = steps::quotient(at.f.C, at.f.C_error, q.value, q.error).error;
  for (const double part : parts) {
    const Answer<TestType, scene::Sphere> answer(unit, {-part * bound, 0, 0}, {1, 0, 0});
    INFO(part);
    CHECK((answer.verdict == Decision::undecided) == within(part));
  }
}

TEMPLATE_TEST_CASE("an advance within its bound of the base is neither inside nor outside", "", double, DoubleDouble) {
  for (const double slope : {0.0, 8.0}) {
    const glm::dvec3 v(1, 0, slope);
    const Answer<TestType, scene::Cylinder> at(upright, {-2, 0, -slope}, v);
    const auto q = stable_sum(at.f, root_of_discriminant(at.f)).q;
    const double bound = advance(at.f, steps::quotient(at.f.C, at.f.C_error, q.value, q.error)).error;
    for (const double part : parts) {
      // Where −slope + part·bound is rounded to nothing of the bound, the part is what is left: none.
      if (slope != 0 && steps::Numbers<TestType>::roundoff < 0x1p-60) continue;
      const Answer<TestType, scene::Cylinder> answer(upright, {-2, 0, -slope + part * bound}, v);
      INFO(slope << " " << part);
      CHECK((answer.verdict == Decision::undecided) == within(part));
    }
  }
}

TEST_CASE("an advance within its bound of the other rim is neither inside nor outside") {
  const Answer<double, scene::Cylinder> at(upright, {-2, 0, 1}, {1, 0, 0});
  const auto q = stable_sum(at.f, root_of_discriminant(at.f)).q;
  const double bound = advance(at.f, steps::quotient(at.f.C, at.f.C_error, q.value, q.error)).error;
  for (const double part : parts) {
    INFO(part);
    const Answer<double, scene::Cylinder> answer(upright, {-2, 0, 1 + part * bound}, {1, 0, 0});
    CHECK((answer.verdict == Decision::undecided) == within(part));
  }
}

TEST_CASE("a root within its bound of the limit is not beyond it") {
  const scene::Sphere unit{{0, 0, 0}, 1};
  const trace::Ray traced(ray({-3, 0, 0}, {1, 0, 0}));
  const double bound = triage(unit, traced, false).error;
  for (const double part : parts) {
    INFO(part);
    const Decision verdict = triage(unit, traced, false, 2 + part * bound).verdict;
    CHECK(verdict == (part < -1 ? Decision::miss : Decision::hit));
  }
}

TEMPLATE_TEST_CASE("nothing is divided by a number that may be 0", "", double, DoubleDouble) {
  // Nearly along the axis A = a² + …; from the axis itself B is small too. The bounds of A hardly change with a.
  const scene::Cylinder tube{{0, 0, 0}, 1, {0, 0, 1}, 0x1p60};
  const double bound = Answer<TestType, scene::Cylinder>(tube, {0.5, 0, 0.5}, {0, 0, 1}).f.A_error;
  for (const double part : {0.0, 0.5, 0.99}) {
    const glm::dvec3 along(std::sqrt(part * bound), 0, 1);
    INFO(part);
    CHECK((Answer<TestType, scene::Cylinder>(tube, {0.5, 0, 0.5}, along).verdict == Decision::undecided));
    CHECK((Answer<TestType, scene::Cylinder>(tube, {0.5, 0, 0.5}, along, true).verdict == Decision::undecided));
  }
  // At the middle of a short chord B = 0 and the root of D is all of the sum; the chord lies below the base, so that
  // only the sum can be in doubt.
  const scene::Cylinder above{{0, -1, 0}, 1, {0, 0, 1}, 1};
  const double of_F = Answer<TestType, scene::Cylinder>(above, {0, 0, -1}, {1, 0, 0}).f.B_error;
  bool doubtful = false;
  for (double part = 1.25; part < 8; part += 0.25) {
    const Answer<TestType, scene::Cylinder> answer(above, {0, -part * of_F, -1}, {1, 0, 0});
    const auto q = stable_sum(answer.f, root_of_discriminant(answer.f)).q;
    if (steps::magnitude(q.value) > q.error) continue;
    INFO(part);
    doubtful = true;
    CHECK(answer.verdict == Decision::undecided);
  }
  CHECK(doubtful);
}

TEST_CASE("a slope that may be 0 improves nothing") {
  const scene::Sphere unit{{0, 0, 0}, 1};
  const trace::Ray traced(ray({-3, 0, 0}, {1, 0, 0}));
  const auto improves = [&](double error, double slope_error, double A_error) {
    return improved(unit, traced, false, {Decision::hit, 2, 0, error, {-1, slope_error, 1, A_error}}).verdict ==
           Decision::hit;
  };
  CHECK(improves(0x1p-20, 0x1p-20, 0));
  CHECK_FALSE(improves(0, 1.01, 0));
  CHECK_FALSE(improves(2.01, 0, 0));
  CHECK_FALSE(improves(1.01, 0, 1));
}
