#include "durero/accel/linear.hpp"

#include "support/catch.hpp"
#include "support/shapes.hpp"

using namespace durero;
using namespace durero::test;

TEST_CASE("without a structure every ball is tried, and what a ray may meet is handed over") {
  scene::Scene scene;
  for (int z = 5; z < 15; z += 3) add(scene, scene::Sphere{{0, 0, double(z)}, 1});
  add(scene, scene::Sphere{{9, 0, 5}, 1});
  add(scene, scene::Sphere{{0, 0, 0}, 1e300});
  const accel::LinearList linear(scene);
  CHECK(linear.size() == accel::Size{.elements = 5, .apart = 1, .bytes = 5 * 40 + 8});
  accel::Work work;
  std::size_t seen = 0;
  const auto visit = [&](scene::ElementRef) { return ++seen == 0; };
  const trace::Ray forwards(ray({0, 0, 0}, {0, 0, 1}));
  CHECK_FALSE(linear.any(
      forwards, [] { return trace::no_limit; }, visit, work));
  CHECK(seen == 4);
  CHECK(work == accel::Work{.volumes = 5, .candidates = 4});
  CHECK(linear.any(
      forwards, [] { return 6.0; }, [](scene::ElementRef) { return true; }, work));
}
