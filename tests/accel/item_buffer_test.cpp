#include "durero/accel/item_buffer.hpp"

#include "accel/counted.hpp"
#include "accel/item_buffer_fault.hpp"
#include "durero/scene/stage.hpp"
#include "durero/trace/analytic.hpp"
#include "support/catch.hpp"
#include "support/sanitized.hpp"
#include "support/scenes.hpp"
#include "support/shapes.hpp"

using namespace durero;
using namespace durero::test;
using accel::ItemBuffer;
using accel::Work;
using scene::ElementRef;
using scene::Scene;

namespace {

void look(Scene& scene, const glm::dvec3& eye, const glm::dvec3& at, scene::Resolution size, double fov = 60) {
  scene.stage().camera = scene::Camera{eye, at, {0.1, 1, 0}, fov};
  scene.stage().resolution = size;
}

/// The first hits of all pixels are those over all elements; the work that they took.
Work check(const Scene& scene, const ItemBuffer& buffer) {
  const trace::Tables tables(scene);
  const auto rays = accel::primary_rays(scene.stage());
  REQUIRE(rays);
  Work work;
  for (std::uint32_t y = 0; y < rays->resolution().height; ++y)
    for (std::uint32_t x = 0; x < rays->resolution().width; ++x) {
      const model::Rayo ray = rays->ray(x, y);
      if (counted_first_hit(buffer, ray, work) != trace::first_hit(tables, ray)) FAIL("pixel " << x << ", " << y);
    }
  return work;
}

}  // namespace

TEST_CASE("each pixel's ray finds its first hit in the buffer") {
  Work all;
  for (std::uint64_t seed = 1; seed <= fewer_when_sanitized(60); ++seed) {
    Random random(seed);
    Scene scene = random_scene(random, seed % 30);
    const glm::dvec3 eye = random.in_cube(seed % 3 == 0 ? 1 : 4), at = random.in_cube(0.5);
    look(scene, eye, at, {37, 21}, seed % 7 == 0 ? 175 : 50);
    const ItemBuffer buffer(scene);
    CHECK(buffer.size().cells == 37 * 21);
    all += check(scene, buffer);
    CHECK(buffer.size() == ItemBuffer(scene).size());
  }
  CHECK(all.cells == fewer_when_sanitized(60) * 37 * 21);
  CHECK(all.volumes < all.cells / 10);
}

TEST_CASE("a primary ray tests little more than the element that it hits") {
  Random random(8);
  Scene scene;
  for (int x = -8; x <= 8; ++x)
    for (int y = -8; y <= 8; ++y) add(scene, scene::Sphere{glm::dvec3(x, y, 0.3 * x), 0.7});
  look(scene, {0, 1, -12}, {0, 0, 0}, {160, 90});
  const ItemBuffer buffer(scene);
  const Work work = check(scene, buffer);
  CHECK(work.cells == 160 * 90);
  CHECK(static_cast<double>(work.candidates) <= 1.1 * 160 * 90);
  CHECK(work.volumes == 0);
  CHECK(work.untested > 160 * 90 / 10);  // pixels that see nothing, and are told so without a test
  Work others;
  for (int i = 0; i < 200; ++i) {
    const glm::dvec3 from = random.in_cube(9), towards = random.direction();
    const model::Rayo anywhere = ray(from, towards);
    CHECK(counted_first_hit(buffer, anywhere, others) == trace::first_hit(scene, anywhere));
  }
  CHECK(others.volumes + others.candidates < 200 * 289 / 4);  // of 289 balls, not each
}

TEST_CASE("a plane is kept of the pixels that see it, and tried for every other ray") {
  Scene scene;
  const ElementRef floor = add(scene, scene::Plane{{0, -1, 0}, {0, 1, 0}});
  add(scene, scene::Sphere{{0, 0, 5}, 0.5});
  add(scene, scene::Sphere{{1, 0, 5}, 0.5});
  look(scene, {0, 1, -4}, {0, 0, 2}, {16, 16});
  const ItemBuffer buffer(scene);
  CHECK(buffer.extraordinary().empty());
  CHECK(buffer.size().elements == 3);
  CHECK(static_cast<double>(check(scene, buffer).candidates) <= 1.1 * 16 * 16);
  Work work;
  CHECK(counted_first_hit(buffer, ray({9, 0, 0}, {0, -1, 0}), work).elementos == scene::ElementSet{floor});
  CHECK(work.candidates == 1);
  CHECK(work.cells == 0);
}

TEST_CASE("an identity that is wrong costs time and no answer") {
  for (std::uint64_t seed = 1; seed <= fewer_when_sanitized(20); ++seed) {
    Random random(seed);
    Scene scene = random_scene(random, 12);
    look(scene, random.in_cube(4), {0, 0, 0}, {32, 20});
    ItemBuffer buffer(scene);
    std::vector<ElementRef> elements;
    scene.for_each([&](ElementRef e, const auto&) { elements.push_back(e); });
    for (std::uint32_t pixel = 0; pixel < 32 * 20; ++pixel)
      accel::ItemBufferFault::plant(buffer, pixel, random.any_of(elements));
    const Work work = check(scene, buffer);
    CHECK(work.volumes > 0);
  }
}

TEST_CASE("rays that are none of the camera's, and those that start on elements, go through the hierarchy") {
  Scene scene;
  const ElementRef near = add(scene, scene::Sphere{{0, 0, 5}, 1});
  add(scene, scene::Sphere{{0, 0, 9}, 1});
  look(scene, {0, 0, 0}, {0, 0, 1}, {5, 5}, 20);
  const ItemBuffer buffer(scene);
  const trace::Tables tables(scene);
  const model::Rayo middle = accel::primary_rays(scene.stage())->ray(2, 2);
  const auto cells = [&](const model::Rayo& rayo, scene::Origin en = {}) {
    Work work;
    CHECK(counted_first_hit(buffer, rayo, work, en) == trace::first_hit(tables, rayo, en));
    CHECK(work.cells <= 1);
    return work.volumes == 0 && work.cells == 1;
  };
  CHECK(cells(middle));
  CHECK_FALSE(cells(middle, near));
  CHECK_FALSE(cells({middle.p(), model::Vector(middle.v().xyz() * 2.0)}));
  CHECK_FALSE(cells({model::Punto(0, 0, 0x1p-60), middle.v()}));
  std::vector<ElementRef> met;
  const auto visit = [&](ElementRef e) { return met.push_back(e), false; };
  accel::CandidateSource(buffer).any(
      trace::Ray(middle), [] { return trace::no_limit; }, visit);
  CHECK(met == std::vector{near, ElementRef{near.tipo, 1}});  // once each, where the limit does not fall
  Work work;
  buffer.any(
      trace::Ray(middle), [] { return 1.0; }, [](ElementRef) { return false; }, work);
  CHECK(work.cells == 0);
}

TEST_CASE("a buffer holds for no camera, for one that sees nothing, and for many elements in one place") {
  Scene scene;
  CHECK(ItemBuffer(scene).size() == accel::Size{});
  scene.stage().camera = scene::Camera{{0, 0, 0}, {0, 0, 0}, {0, 1, 0}, 45};
  CHECK(ItemBuffer(scene).size().cells == 0);
  look(scene, {0, 0, 0}, {0, 0, 1}, {65535, 65535});
  CHECK(ItemBuffer(scene).size().cells == 0);
  look(scene, {1e200, 0, 0}, {0, 0, 1}, {5, 5});
  CHECK(ItemBuffer(scene).size().cells == 0);
  for (int i = 0; i < 300; ++i) add(scene, scene::Sphere{{0, 0, 5}, 1});
  look(scene, {0, 0, 0}, {0, 0, 1}, {9, 9}, 40);
  const ItemBuffer same(scene);
  CHECK(same.size().references == 0);
  check(scene, same);
  look(scene, {0, 0, 5.5}, {0, 0, 9}, {9, 9});
  check(scene, ItemBuffer(scene));
}
