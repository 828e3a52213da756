#include "io/placed/placed_camera.hpp"

#include "support/catch.hpp"

using namespace durero;
using io::AffinePlacement;
using io::AngleAcross;

TEST_CASE("An angle across any side of a picture is one across its height") {
  const scene::Resolution wide{200, 100}, tall{100, 200};
  CHECK(io::vertical_angle(90, AngleAcross::height, wide) == 90);
  CHECK(io::vertical_angle(90, AngleAcross::smaller, wide) == 90);
  CHECK(io::vertical_angle(90, AngleAcross::larger, tall) == 90);
  const double half = *io::vertical_angle(90, AngleAcross::width, wide);
  CHECK(std::abs(std::tan(half * 0.008726646259971648) - 0.5) < 1e-15);
  CHECK(io::vertical_angle(90, AngleAcross::larger, wide) == half);
  CHECK(std::abs(*io::vertical_angle(half, AngleAcross::smaller, tall) - 90) < 1e-13);
  CHECK(std::abs(*io::vertical_angle(90, AngleAcross::diagonal, {300, 400}) - 77.31961650818018) < 1e-12);
  CHECK_FALSE(io::vertical_angle(0, AngleAcross::height, wide));
  CHECK_FALSE(io::vertical_angle(180, AngleAcross::width, wide));
}

TEST_CASE("A camera stands where its frame is, looks along it, and is left out where the frame is askew") {
  const AffinePlacement frame = *AffinePlacement::looking({1e6, 2, 3}, {1e6, 2, 4}, {0, 1, 0});
  const auto camera = io::placed_camera(frame, 40, false);
  REQUIRE(camera);
  CHECK((camera->eye == glm::dvec3(1e6, 2, 3) && camera->up == glm::dvec3(0, 1, 0) && camera->fov_y == 40));
  CHECK((camera->look_at.x == 1e6 && camera->look_at.y == 2 && camera->look_at.z > 1e5));
  CHECK(io::placed_camera(frame.after(AffinePlacement::scaling({2, 2, 2})), 40, false));
  CHECK_FALSE(io::placed_camera(frame.after(AffinePlacement::scaling({2, 1, 1})), 40, false));
  const AffinePlacement turned = frame.after(AffinePlacement::scaling({-1, 1, 1}));
  CHECK_FALSE((camera->mirrored || io::placed_camera(turned, 40, true)->mirrored));
  CHECK((io::placed_camera(frame, 40, true)->mirrored && io::placed_camera(turned, 40, false)->mirrored));
  CHECK_FALSE(io::placed_camera(AffinePlacement::scaling({0, 0, 0}), 40, false));
  CHECK_FALSE(
      io::placed_camera(AffinePlacement::of_matrix({1, 0, 0, 0, 0.5, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}), 40, false));
}
