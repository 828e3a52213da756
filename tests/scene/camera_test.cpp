#include "durero/scene/camera.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <stdexcept>

#include "durero/scene/stage.hpp"
#include "support/catch.hpp"

using namespace durero;

namespace {
const scene::Camera camera{{1, 2, 3}, {1, 2, 13}, {0, 1, 0}, 90};
}

TEST_CASE("every ray starts at the eye, and the middle one looks where the camera does") {
  const scene::PrimaryRays rays(camera, {101, 51});
  const model::Rayo middle = rays.ray(50, 25);
  CHECK(middle.p() == model::Punto(1, 2, 3));
  CHECK(middle.v().x() == Approx(0).margin(1e-15));
  CHECK(middle.v().y() == Approx(0).margin(1e-15));
  CHECK(middle.v().z() == Approx(1));
}

TEST_CASE("fov_y spans the height from edge to edge; pixels are square; y goes down") {
  const scene::PrimaryRays rays(camera, {40, 20});
  const glm::dvec3 top = rays.ray(0, 0).v().xyz(), bottom = rays.ray(0, 19).v().xyz(), next = rays.ray(1, 0).v().xyz();
  const double pixel = 2.0 / 20;  // the window is 2 high at distance 1 for 90 degrees
  CHECK(top.y == Approx(1 - pixel / 2));
  CHECK(bottom.y == Approx(-1 + pixel / 2));
  CHECK(glm::length(next - top) == Approx(pixel));
  CHECK(top.x > next.x);  // looking along +z with y up, the right hand points to −x
}

TEST_CASE("a mirrored camera has the rays of the other, from right to left") {
  scene::Camera turned = camera;
  turned.mirrored = true;
  const scene::PrimaryRays rays(camera, {40, 20}), back(turned, {40, 20});
  for (const auto& [x, y] : {std::pair{0U, 0U}, std::pair{39U, 0U}, std::pair{7U, 13U}}) {
    CHECK(glm::length(rays.ray(x, y).v().xyz() - back.ray(39 - x, y).v().xyz()) < 1e-15);
    CHECK(back.pixel_of(back.eye(), back.ray(x, y).v().xyz()) == scene::Pixel{x, y});
  }
}

TEST_CASE("rays go through any point of the window: at whole numbers those of pixels, halfway between them the means") {
  const scene::PrimaryRays rays(camera, {40, 20});
  CHECK(rays.ray_at(7, 3) == rays.ray(7, 3));
  const glm::dvec3 half = rays.ray_at(7.5, 3.25).v().xyz();
  const glm::dvec3 across = rays.ray(7, 3).v().xyz() + rays.ray(8, 3).v().xyz();
  const glm::dvec3 down = rays.ray(7, 4).v().xyz() - rays.ray(7, 3).v().xyz();
  CHECK(glm::length(half - (across / 2.0 + down / 4.0)) < 1e-15);
  CHECK(rays.ray_at(-0.5, -0.5).v().y() == Approx(1));  // the corner of the picture
}

TEST_CASE("a camera that sees nothing is refused in words") {
  const auto refuses = [](scene::Camera bad, scene::Resolution size = {2, 2}) {
    CHECK_THROWS_AS(scene::PrimaryRays(bad, size), std::domain_error);
  };
  refuses({{0, 0, 0}, {0, 0, 0}, {0, 1, 0}, 45});
  refuses({{0, 0, 0}, {0, 2, 0}, {0, 1, 0}, 45});
  refuses({{0, 0, 0}, {0, 0, 1}, {0, 1, 0}, 0});
  refuses({{0, 0, 0}, {0, 0, 1}, {0, 1, 0}, 180});
  refuses({{0, 0, 0}, {0, 0, 1}, {0, 1, 0}, std::nan("")});
  refuses(camera, {0, 5});
}

TEST_CASE("the pixel of a ray is the one that has it, exactly") {
  for (const scene::Camera& from : {camera, scene::Camera{{0.1, -7, 1e9}, {1, 2, 3}, {0.3, 1, 0.1}, 17}}) {
    const scene::PrimaryRays rays(from, {101, 51});
    CHECK(rays.resolution() == scene::Resolution{101, 51});
    for (std::uint32_t y = 0; y < 51; ++y)
      for (std::uint32_t x = 0; x < 101; ++x) {
        const model::Rayo ray = rays.ray(x, y);
        const glm::dvec3 p = ray.p().xyz(), v = ray.v().xyz();
        if (rays.pixel_of(p, v) != scene::Pixel{x, y}) FAIL("pixel " << x << ", " << y);
        const glm::dvec3 beside(v.x, std::nextafter(v.y, 9), v.z), behind = -v;
        if (rays.pixel_of(p, beside) || rays.pixel_of(p, behind) || rays.pixel_of(p + glm::dvec3(1, 0, 0), v))
          FAIL("not the ray of " << x << ", " << y);
      }
  }
}

TEST_CASE("rays from all over the lens pass the plane in focus where the ray of a pinhole does") {
  scene::Camera with_lens = camera;
  with_lens.aperture = 0.5;
  with_lens.focus = 4;
  const scene::PrimaryRays rays(with_lens, {40, 20}), pinhole(camera, {40, 20});
  CHECK(rays.has_lens());
  CHECK_FALSE(pinhole.has_lens());
  CHECK(rays.lens_ray_at(7.5, 3, {0, 0}) == rays.ray_at(7.5, 3));
  CHECK(pinhole.lens_ray_at(7.5, 3, {0.6, 0.8}) == pinhole.ray_at(7.5, 3));
  const model::Rayo middle = rays.ray_at(7.5, 3);
  for (const glm::dvec2 lens : {glm::dvec2(1, 0), {0, -1}, {-0.6, 0.8}}) {
    const model::Rayo ray = rays.lens_ray_at(7.5, 3, lens);
    const glm::dvec3 aside = ray.p().xyz() - middle.p().xyz();
    CHECK(glm::length(aside) == Approx(0.25));  // half the aperture
    CHECK(aside.z == Approx(0).margin(1e-15));  // across the view
    const glm::dvec3 in_focus = ray.p().xyz() + 4.0 * ray.v().xyz();
    CHECK(glm::distance(in_focus, middle.p().xyz() + 4.0 * middle.v().xyz()) < 1e-14);
    CHECK(in_focus.z == Approx(3 + 4));  // the eye is at z = 3
  }
}

TEST_CASE("without a focus the lens shows sharply what stands as far away as look_at") {
  scene::Camera with_lens = camera;
  with_lens.aperture = 1;
  const scene::PrimaryRays rays(with_lens, {40, 20});
  const model::Rayo one = rays.lens_ray_at(3, 4, {1, 0}), other = rays.lens_ray_at(3, 4, {-1, 0});
  CHECK(glm::distance(one.p().xyz() + 10.0 * one.v().xyz(), other.p().xyz() + 10.0 * other.v().xyz()) < 1e-14);
}
