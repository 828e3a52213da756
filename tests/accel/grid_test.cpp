#include "durero/accel/grid.hpp"

#include <cmath>
#include <iostream>

#include "accel/both_ways.hpp"
#include "accel/counted.hpp"
#include "durero/accel/bsp.hpp"
#include "durero/accel/bvh.hpp"
#include "durero/accel/structure.hpp"
#include "durero/model/operaciones.hpp"
#include "durero/scene/stage.hpp"
#include "durero/surface/exact.hpp"
#include "support/catch.hpp"
#include "support/sanitized.hpp"
#include "support/scenes.hpp"
#include "support/shapes.hpp"

using namespace durero;
using namespace durero::test;
using accel::Cell;
using accel::Grid;
using accel::Work;

static_assert(accel::Structure<Grid>);

namespace {

constexpr auto no_limit = [] { return trace::no_limit; };

std::vector<scene::ElementRef> visited(const Grid& grid, const model::Rayo& rayo, Work& work) {
  std::vector<scene::ElementRef> elements;
  grid.any(
      trace::Ray(rayo), no_limit,
      [&](scene::ElementRef e) {
        elements.push_back(e);
        return false;
      },
      work);
  return elements;
}

scene::Scene lattice_of_balls(int half, const glm::dvec3& moved = {0, 0, 0}) {
  scene::Scene scene;
  for (int x = -half; x <= half; ++x)
    for (int y = -half; y <= half; ++y)
      for (int z = -half; z <= half; ++z) add(scene, scene::Sphere{moved + glm::dvec3(x, y, z), 0.25});
  return scene;
}

/// What the first hits of rays take in a grid of so many cubes an element.
struct Resolution {
  double cells_per_element;
  std::size_t cells, bytes;
  Work work;
  /// Cubes crossed and elements tested: what the time goes into.
  std::uint64_t steps() const { return work.cells + work.candidates; }
};

/// From 1/16 to 1024 cubes an element, each four times as many: balls at random, and rays from around them.
std::vector<Resolution> resolutions(std::size_t elements, std::size_t rays) {
  Random random(7);
  scene::Scene scene;
  const double size = 0.25 / std::cbrt(static_cast<double>(elements));
  while (scene.size() < elements) {
    const glm::dvec3 centre = random.in_cube(0.5);
    add(scene, scene::Sphere{centre, size * random.uniform(0.5, 1)});
  }
  std::vector<model::Rayo> asked;
  while (asked.size() < rays) {
    const glm::dvec3 from = random.in_cube(1.5), to = random.in_cube(0.5);
    asked.push_back(ray(from, to - from));
  }
  std::vector<Resolution> all;
  for (double cells = 1.0 / 16; cells <= 1024; cells *= 4) {
    const Grid grid(scene, {.cells_per_element = cells, .references_per_element = 1000});
    Resolution made{cells, grid.size().cells, grid.size().bytes, {}};
    for (const model::Rayo& rayo : asked) counted_first_hit(grid, rayo, made.work);
    all.push_back(made);
  }
  return all;
}

/// The finer, the more cubes are crossed and the fewer elements tested: the sum falls, and rises.
void check_u(const std::vector<Resolution>& curve) {
  const auto least = std::ranges::min_element(curve, {}, &Resolution::steps);
  for (std::size_t i = 1; i < curve.size(); ++i) {
    CAPTURE(curve[i].cells_per_element);
    CHECK(curve[i].work.cells > curve[i - 1].work.cells);
    CHECK(curve[i].work.candidates < curve[i - 1].work.candidates);
    CHECK(curve[i].bytes > curve[i - 1].bytes);
    CHECK((curve[i].steps() > curve[i - 1].steps()) == (&curve[i] > &*least));
  }
  CHECK(curve.front().steps() > 2 * least->steps());
  CHECK(curve.back().steps() > 2 * least->steps());
}

}  // namespace

TEST_CASE("what a grid takes falls and rises with its resolution") { check_u(resolutions(500, 200)); }

// docs/figures/acceleration.py draws what this prints.
TEST_CASE("the U of the grid for its figure", "[long]") {
  const std::vector<Resolution> curve = resolutions(10'000, 1000);
  check_u(curve);
  for (const Resolution& at : curve)
    std::cout << "{\"cells_per_element\":" << at.cells_per_element << ",\"cells\":" << at.cells
              << ",\"bytes\":" << at.bytes << ",\"rays\":1000,\"crossed\":" << at.work.cells
              << ",\"tested\":" << at.work.candidates << "}\n";
}

namespace {

/// Tests of volumes and planes, cells looked through and elements tested, for first hits of rays towards small balls.
template <class S>
double steps_of(const scene::Scene& scene, std::size_t small) {
  const S structure(scene);
  Random random(13);
  Work work;
  for (int i = 0; i < 300; ++i) {
    const scene::Sphere& at = scene.shapes<scene::Sphere>()[random.below(small)];
    const glm::dvec3 from = random.in_cube(3), aside = random.in_cube(0.01);
    counted_first_hit(structure, ray(from, at.centro + aside - from), work);
  }
  return static_cast<double>(work.volumes + work.cells + work.candidates) / 300;
}

}  // namespace

// The teapot in the stadium: all that is small lies in one of the cubes.
TEST_CASE("where elements lie evenly a grid takes fewest steps, and where they lie in a heap it takes most") {
  Random random(14);
  scene::Scene even, stadium;
  for (int i = 0; i < 1000; ++i) {
    const glm::dvec3 centre = random.in_cube(0.5);
    for (scene::Scene* const scene : {&even, &stadium}) add(*scene, scene::Sphere{centre, 0.02});
  }
  for (int i = 0; i < 200; ++i) {
    const double turn = i * 0.0314159265;
    add(stadium, scene::Sphere{{150 * std::cos(turn), 100 * std::sin(turn), i % 20}, 5});
  }
  const double grid = steps_of<Grid>(even, 1000), bvh = steps_of<accel::Bvh>(even, 1000),
               bsp = steps_of<accel::Bsp>(even, 1000);
  INFO("evenly: grid " << grid << ", bvh " << bvh << ", bsp " << bsp);
  CHECK(grid < bvh);
  CHECK(grid < bsp);
  const double grid_there = steps_of<Grid>(stadium, 1000), bvh_there = steps_of<accel::Bvh>(stadium, 1000),
               bsp_there = steps_of<accel::Bsp>(stadium, 1000);
  INFO("in the stadium: grid " << grid_there << ", bvh " << bvh_there << ", bsp " << bsp_there);
  CHECK(grid_there > 5 * bvh_there);
  CHECK(grid_there > 5 * bsp_there);
}

TEST_CASE("every element that a ray meets is visited, once") {
  for (std::uint64_t seed = 1; seed <= fewer_when_sanitized(30); ++seed) {
    Random random(seed);
    const scene::Scene scene = random_scene(random, 60);
    const Grid grid(scene);
    for (int i = 0; i < 60; ++i) {
      const model::Rayo rayo = random_ray(random);
      Work work;
      std::vector<scene::ElementRef> elements = visited(grid, rayo, work);
      CHECK(elements.size() == work.candidates);
      std::ranges::sort(elements);
      REQUIRE(std::ranges::adjacent_find(elements) == elements.end());
      for (const scene::ElementRef e : grid.contents().elements)
        if (!surface::exact::reach(scene, e, rayo).empty()) REQUIRE(std::ranges::binary_search(elements, e));
    }
  }
}

TEST_CASE("a cell lists what touches it, and nothing that lies around it") {
  scene::Scene scene;
  add(scene, scene::Sphere{{0, 0, 0}, 4});
  for (int i = 0; i < 40; ++i) add(scene, scene::Sphere{{3.9, 0, 0}, 0.05});
  const Grid grid(scene, {.cells_per_element = 100, .references_per_element = 1000});
  std::size_t inside = 0;
  for (int x = 0; x < grid.lattice().count.x; ++x) {
    const Cell cell(x, grid.lattice().place(1, 0.1), grid.lattice().place(2, 0.1));
    const surface::Box box = grid.lattice().box(cell);
    if (box.low.x < -3 || 3 < box.high.x) continue;
    ++inside;
    CHECK(grid.lists()[grid.lattice().number(cell)].empty());
  }
  CHECK(inside > 5);
  check_both_ways(grid);
}

TEST_CASE("an element in many cells is tested once, and found again in the others") {
  scene::Scene scene;
  add(scene, scene::Triangle{{{{-4, -4, 0.1}, {4, -4, 0.1}, {0, 8, 0.1}}}});
  for (int x = -4; x <= 4; ++x) add(scene, scene::Sphere{{x, 0, 0.1}, 0.25});
  const Grid grid(scene, {.cells_per_element = 200, .references_per_element = 1000});
  Work work;
  const auto elements = visited(grid, ray({-9, 0, 0.1}, {1, 0, 0}), work);
  CHECK(elements.size() == 10);
  CHECK(work.candidates == 10);
  CHECK(work.repeated > 10);
}

TEST_CASE("a hit outside the current cell does not end the walk") {
  // The long triangle reaches into the first cell of the ray, and is met far behind the ball.
  scene::Scene scene;
  const scene::ElementRef wall = add(scene, scene::Triangle{{{{-8, 0.5, 0.5}, {8, -0.25, 2}, {8, -0.25, -2}}}});
  const scene::ElementRef ball = add(scene, scene::Sphere{{0, 0, 0}, 0.0625});
  for (int i = 0; i < 20; ++i) add(scene, scene::Sphere{{-7, 6, i}, 0.125});
  const Grid grid(scene, {.cells_per_element = 40});
  const model::Rayo rayo = ray({-7.9, 0.1, 0.1}, {1, -0.0125, -0.0125});
  Work work;
  CHECK(visited(grid, rayo, work) == std::vector{wall, ball});
  trace::Counts unseen;
  CHECK(surface::exact::reach(scene, wall, rayo).count == 1);
  CHECK(trace::first_hit_among(accel::CandidateSource(grid), rayo, {}, unseen).elementos == scene::ElementSet{ball});
}

TEST_CASE("cells that begin beyond the limit are passed over, and no cell before it") {
  const scene::Scene scene = lattice_of_balls(3);
  const Grid grid(scene);
  const trace::Ray along(ray({-10, 0, 0}, {1, 0, 0}));
  for (const double limit : {6.75, 8.0, 9.75, 12.0, 13.25}) {
    std::size_t met = 0;
    Work work;
    grid.any(
        along, [&] { return limit; },
        [&](scene::ElementRef) {
          ++met;
          return false;
        },
        work);
    CHECK(met >= static_cast<std::size_t>(limit - 5.75));
    CHECK(met <= static_cast<std::size_t>(limit - 5.75) + 2);
    CHECK(work.by_distance == (limit < 13 ? 1 : 0));
  }
}

TEST_CASE("what lies in a plane between cells is listed on both sides of it") {
  const accel::GridOptions fine{.cells_per_element = 256, .references_per_element = 1000};
  const auto with = [](const auto& shape) {
    scene::Scene scene;
    add(scene, scene::Sphere{{0, 0, 0}, 3.5});
    add(scene, shape);
    return scene;
  };
  const scene::Scene before = with(scene::Sphere{{0, 0, 0}, 1});
  const accel::Lattice lattice = Grid(before, fine).lattice();
  const glm::dvec3 corner = lattice.box({3, 3, 3}).low, near = corner + lattice.h / 4, far = corner + lattice.h / 2;
  const scene::Scene after =
      with(scene::Triangle{{{{near.x, near.y, corner.z}, {far.x, near.y, corner.z}, {near.x, far.y, corner.z}}}});
  const Grid grid(after, fine);
  CHECK(grid.lattice() == lattice);
  CHECK(grid.lists().inverse(2)[1].size() == 2);
}

TEST_CASE("the cubes depend on the box and the number of elements, and not on where these are") {
  const Grid grid(lattice_of_balls(3));
  const scene::Scene there = lattice_of_balls(3, {64, -128, 32});
  const Grid moved(there);
  CHECK(moved.lattice().h == grid.lattice().h);
  CHECK(moved.lattice().count == grid.lattice().count);
  scene::Scene heap;
  add(heap, scene::Sphere{{-3, -3, -3}, 0.25});
  for (int i = 0; i < 341; ++i) add(heap, scene::Sphere{{0, 0, 0}, 0.25});
  add(heap, scene::Sphere{{3, 3, 3}, 0.25});
  CHECK(Grid(heap).lattice() == grid.lattice());
}

TEST_CASE("there are as many cubes as asked for, or little more, and every element's box is within them") {
  for (const double wanted : {1.0, 10.0, 1000.0, 50000.0}) {
    for (const surface::Box& box :
         {surface::Box{{-1, -1, -1}, {1, 1, 1}}, surface::Box{{0, 0, 0}, {1000, 1, 0}},
          surface::Box{{3, 3, 3}, {3, 3, 3}}, surface::Box{{0x1p60, 0, 0}, {0x1p60 + 0x1p10, 1, 1}},
          surface::Box{{-0x1p100, -1, 0}, {0x1p100, 1, 0x1p-100}}}) {
      const accel::Lattice lattice = accel::cubes_over(box, wanted);
      CHECK(static_cast<double>(lattice.size()) <= 4 * wanted + 8);
      for (int axis = 0; axis < 3; ++axis) {
        CHECK(lattice.plane(axis, 0) <= box.low[axis]);
        CHECK(box.high[axis] < lattice.plane(axis, lattice.count[axis]));
        CHECK(lattice.place(axis, box.low[axis]) >= 0);
      }
    }
  }
  CHECK(accel::cubes_over({{-1, -1, -1}, {1, 1, 1}}, 1000).size() >= 1000);
}

TEST_CASE("references are limited: large elements make large cubes") {
  scene::Scene scene;
  for (int i = 0; i < 3000; ++i) add(scene, scene::Sphere{{0, 0, 0}, 1});
  const Grid grid(scene, {.cells_per_element = 50, .references_per_element = 10});
  CHECK(grid.lists().references() <= 10 * 3000 + 4096);
  CHECK(grid.size().references == grid.lists().references());
  CHECK(grid.size().elements == 3000);
  CHECK(grid.size().cells == grid.lattice().size());
  CHECK(Grid(scene).size() == Grid(scene).size());
  CHECK(Grid(scene::Scene()).size().references == 0);
}
