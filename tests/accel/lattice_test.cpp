#include "durero/accel/lattice.hpp"

#include <glm/common.hpp>

#include "accel/rational_walk.hpp"
#include "durero/conform/random.hpp"
#include "support/catch.hpp"
#include "support/sanitized.hpp"

using namespace durero;
using namespace durero::test;
using accel::Cell;
using accel::Lattice;
using accel::PlaneCrossing;

namespace {

struct Walked {
  std::vector<Cell> cells;
  std::vector<PlaneCrossing> events;
};

Walked walked(const model::Rayo& rayo, const Lattice& lattice) {
  Walked result;
  walk(accel::AxisRay(trace::Ray(rayo)), lattice, [&](const Cell& cell, const PlaneCrossing& event) {
    result.cells.push_back(cell);
    result.events.push_back(event);
    return false;
  });
  return result;
}

const Lattice sixths{{-3, -2, 0}, 0.75, {6, 5, 4}};

/// Towards a corner, an edge or a face of the lattice, from inside or outside; or anywhere.
model::Rayo drawn(conform::Random& random, const Lattice& lattice) {
  glm::dvec3 through;
  for (int axis = 0; axis < 3; ++axis) {
    const int place = random.integer(-1, lattice.count[axis] + 1);
    through[axis] = random.chance(3, 4) ? lattice.plane(axis, place) : random.uniform(-4, 4);
  }
  const glm::dvec3 way = random.chance(2, 3) ? random.lattice_vector(2) : random.direction();
  const double from = random.chance(1, 4) ? 0 : 0.75 * random.integer(-8, 8);
  return ray(through - from * way, random.any_of(std::array{1.0, 0.75, 3.0, 0.1}) * way);
}

}  // namespace

TEST_CASE("the walk visits exactly the cells that hold points of the ray, each once, in its order") {
  conform::Random random(1);
  std::size_t visited = 0, missed = 0, at_once = 0;
  for (std::size_t i = 0; i < fewer_when_sanitized(6000); ++i) {
    const model::Rayo rayo = drawn(random, sixths);
    const std::vector<Cell> expected = rational_walk(rayo, sixths);
    const Walked subject = walked(rayo, sixths);
    INFO("ray " << i);
    REQUIRE(subject.cells == expected);
    visited += expected.size();
    missed += expected.empty() ? 1 : 0;
    for (std::size_t k = 1; k < expected.size(); ++k) {
      const Cell step = glm::abs(expected[k] - expected[k - 1]);
      at_once += step.x + step.y + step.z > 1 ? 1 : 0;
    }
  }
  CHECK(visited > fewer_when_sanitized(6000));
  CHECK(missed > fewer_when_sanitized(200));
  CHECK(at_once > fewer_when_sanitized(500));
}

TEST_CASE("the walk is that of the exact line, at length", "[long]") {
  conform::Random random(2);
  for (std::size_t i = 0; i < 1'000'000; ++i) {
    const Lattice lattice{{random.integer(-4, 0) * 0.75, random.integer(-4, 0) * 0.75, -1.5},
                          0.75,
                          {random.integer(1, 7), random.integer(1, 7), random.integer(1, 7)}};
    const model::Rayo rayo = drawn(random, lattice);
    REQUIRE(walked(rayo, lattice).cells == rational_walk(rayo, lattice));
  }
}

TEST_CASE("rays from far away, of extreme directions, and along planes that are no short numbers") {
  conform::Random random(3);
  const Lattice odd{{0x1p40 + 0.1875 * 5, -0.1875 * 7, 0.1875 * 1024}, 0.1875, {4, 5, 3}};
  for (std::size_t i = 0; i < fewer_when_sanitized(600); ++i) {
    glm::dvec3 through;
    for (int axis = 0; axis < 3; ++axis)
      through[axis] = random.chance(1, 2) ? odd.plane(axis, random.integer(0, odd.count[axis]))
                                          : random.uniform(odd.plane(axis, 0), odd.plane(axis, odd.count[axis]));
    glm::dvec3 way;
    for (int axis = 0; axis < 3; ++axis) way[axis] = random.number(-40, 40);
    if (random.chance(1, 3)) way[random.integer(0, 2)] = 0;
    const model::Rayo rayo = ray(through - random.any_of(std::array{0.0, 1.0, 0x1p20}) * way, way);
    REQUIRE(walked(rayo, odd).cells == rational_walk(rayo, odd));
  }
}

TEST_CASE("steps are no more than there are planes to cross, and cells are entered in order") {
  conform::Random random(4);
  for (int i = 0; i < 500; ++i) {
    const model::Rayo rayo = drawn(random, sixths);
    const Walked subject = walked(rayo, sixths);
    const accel::AxisRay line{trace::Ray(rayo)};
    CHECK(subject.cells.size() <= 6 + 5 + 4);
    for (std::size_t k = 1; k < subject.events.size(); ++k)
      REQUIRE(line.order(subject.events[k - 1], subject.events[k]) < 0);
  }
}

TEST_CASE("a point on a face belongs to the cell above it") {
  for (int i = 0; i <= 6; ++i) {
    const double plane = sixths.plane(0, i);
    CHECK(sixths.place(0, plane) == i);
    CHECK(sixths.place(0, std::nextafter(plane, -10)) == i - 1);
  }
  CHECK(sixths.place(0, -1e300) == -1);
  CHECK(sixths.place(0, 1e300) == 6);
  CHECK(sixths.number({5, 4, 3}) == sixths.size() - 1);
  CHECK(sixths.box({0, 0, 1}).low == glm::dvec3(-3, -2, 0.75));
}
