#include "durero/accel/wide/coherent_run.hpp"

#include "support/catch.hpp"
#include "support/shapes.hpp"

using namespace durero;
using namespace durero::test;

TEST_CASE("rays of a run stay within its width as far as they go, and turn into no other octant") {
  const surface::Box all{{-10, -10, -10}, {10, 10, 10}};
  const auto joins = [&](const glm::dvec3& p, const glm::dvec3& v, double limit) {
    accel::CoherentRun run(trace::Ray(ray({0, 0, 0}, {1, 1, 1})), all, limit);
    return run.join(trace::Ray(ray(p, v)), 1);
  };
  CHECK(joins({0, 0, 0}, {1, 1, 1}, 1));
  CHECK(joins({1, 0, 0}, {1, 1, 1}, 1));
  CHECK_FALSE(joins({1.1, 0, 0}, {1, 1, 1}, 1));
  CHECK_FALSE(joins({0, 0, -1.1}, {1, 1, 1}, 1));
  CHECK_FALSE(joins({0, 0, 0}, {1, -1, 1}, 1));
  CHECK_FALSE(joins({0, 0, 0}, {1, 0, 1}, 1));
  CHECK(joins({0.5, 0, 0}, {1, 1.5, 1}, 1));
  CHECK(joins({0, 0.5, 0}, {1, 1.5, 1}, 1));
  CHECK_FALSE(joins({0, 0.5, 0}, {1, 1.6, 1}, 1));
  CHECK_FALSE(joins({0, 0, 0}, {1, 1.2, 1}, 100));  // to where the box ends
  CHECK(joins({0, 0, 0}, {1, 1.05, 1}, 100));
  accel::CoherentRun run(trace::Ray(ray({0, 0, 0}, {1, 1, 1})), all, 1);  // what did not join does not count
  CHECK_FALSE(run.join(trace::Ray(ray({5, 0, 0}, {1, 1, 1})), 1));
  CHECK(run.join(trace::Ray(ray({-0.5, 0, 0}, {1, 1, 1})), 1));
  CHECK_FALSE(run.join(trace::Ray(ray({0.75, 0, 0}, {1, 1, 1})), 1));
}
