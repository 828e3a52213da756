// The search orders elements by the errors that the steps state, and leaves what lies within them to the next step.
#include "durero/trace/search.hpp"

#include <cmath>

#include "durero/trace/analytic.hpp"
#include "support/catch.hpp"
#include "support/shapes.hpp"
#include "trace/steps.hpp"

using namespace durero;
using namespace durero::test;

TEST_CASE("parameters closer than the sum of their errors are ordered exactly") {
  // Two unit spheres, the second off the ray by y, so that it is met y²/2 later.
  const model::Rayo along_x = ray({0, 0, 0}, {1, 0, 0});
  const scene::Sphere first{{2, 0, 0}, 1};
  const double error = stable(first, trace::Ray(along_x), false).error;
  const auto ordered_by = [&](double apart) {
    scene::Scene scene;
    add(scene, first);
    add(scene, scene::Sphere{{2, std::sqrt(2 * apart), 0}, 1});
    trace::Counts counts;
    first_hit(trace::Tables(scene), along_x, {}, &counts);
    return counts.order;
  };
  CHECK(ordered_by(2 * error * 0.99)[2] == 1);
  CHECK(ordered_by(2 * error * 0.6)[2] == 1);
  CHECK(ordered_by(2 * error * 4)[2] == 0);
}

TEST_CASE("what no step in floating point is certain of is rounded from the exact parameter") {
  // A sphere met at 1 + 2⁻⁵³ and at 1 + 3·2⁻⁵³, each halfway between two binary64: the even one is told. Both are met
  // at 1 along the axis, which is rounded of p + t·v and not of p and the rounded t.
  const auto first = [](double centre, double p) {
    scene::Scene scene;
    add(scene, scene::Sphere{{centre, 0, 0}, 1});
    trace::Counts counts;
    const scene::Hit hit = first_hit(trace::Tables(scene), ray({p, 0, 0}, {1, 0, 0}), {}, &counts);
    CHECK(counts.rounding[2] == 1);
    return hit;
  };
  CHECK(first(2, -0x1p-53).t == 1);
  CHECK(first(2, -0x1p-53).punto == glm::dvec3(1, 0, 0));
  CHECK(first(2, -0x1.8p-52).t == 1 + 0x1p-51);
  CHECK(first(2, -0x1.8p-52).punto == glm::dvec3(1, 0, 0));
}
