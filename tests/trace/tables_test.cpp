#include "durero/trace/tables.hpp"

#include <algorithm>
#include <set>

#include "durero/surface/exact.hpp"
#include "durero/trace/finding.hpp"
#include "support/catch.hpp"
#include "support/elements.hpp"
#include "support/property.hpp"
#include "support/shapes.hpp"

using namespace durero;
using namespace durero::test;
using scene::ElementRef;

namespace {

/// Enough elements for three chunks, most of them ordinary.
scene::Scene many_elements() {
  scene::Scene scene;
  for (int i = 0; i < 600; ++i) {
    const double size = i % 50 == 7 ? 0x1p120 : 1;
    add(scene, scene::Sphere{{i % 9 * 3.0, i / 9 * 3.0, 0}, size});
  }
  return scene;
}

std::set<ElementRef> visited(const trace::Tables& tables, const trace::Ray& ray, double limit) {
  std::set<ElementRef> elements;
  tables.any(
      ray, [&] { return limit; },
      [&](ElementRef e) {
        CHECK(elements.insert(e).second);
        return false;
      });
  return elements;
}

}  // namespace

TEST_CASE("tables hold every element once, as ordinary or not") {
  const scene::Scene scene = many_elements();
  const trace::Tables tables(scene);
  CHECK(&tables.scene() == &scene);
  CHECK(tables.extraordinary().size() == 12);
  for (const ElementRef e : tables.extraordinary()) CHECK(scene.shapes<scene::Sphere>()[e.index].radio == 0x1p120);
}

TEST_CASE("tables pass over no element that a ray meets up to the limit, and over most others") {
  const scene::Scene scene = many_elements();
  const trace::Tables tables(scene);
  std::size_t visits = 0;
  for (int i = 0; i < 40; ++i) {
    const glm::dvec3 p(i * 0.7, i * 5.1, -9), centre(i % 9 * 3.0, i * 5 / 3 * 3.0, 0);
    const model::Rayo rayo = ray(p, centre - p);
    const trace::Ray traced(rayo);
    const auto all = visited(tables, traced, trace::no_limit), near = visited(tables, traced, 0.9);
    scene.for_each([&](ElementRef e, const auto& shape) {
      const auto reach = surface::exact::reach(scene, e, rayo, {});
      if (reach.empty() || !trace::ordinary(shape)) return;
      CHECK(all.contains(e));
      if (number::round_to_binary64(reach.first()) <= 0.9) CHECK(near.contains(e));
    });
    CHECK(std::includes(all.begin(), all.end(), near.begin(), near.end()));
    visits += all.size();
  }
  CHECK(visits >= 40);
  CHECK(visits < 40 * 30);
}

TEST_CASE("a visit that answers true ends the walk") {
  const scene::Scene scene = many_elements();
  const trace::Tables tables(scene);
  const trace::Ray along(ray({0, -5, 0}, {0, 1, 0}));
  int visits = 0;
  CHECK(tables.any(
      along, [] { return trace::no_limit; }, [&](ElementRef) { return ++visits == 3; }));
  CHECK(visits == 3);
}

TEST_CASE("the pairs of many rays are those of each, and a ray without a limit has none") {
  const scene::Scene scene = many_elements();
  const trace::Tables tables(scene);
  std::vector<trace::Ray> rays;
  for (int i = 0; i < 20; ++i) {
    // Those that will have no limit start inside a sphere, whose ball would pass at a limit of 0 too.
    const glm::dvec3 p = i % 3 == 0 ? glm::dvec3(0, i * 3.0, 0) : glm::dvec3(i * 1.3, i * 9.1, -9);
    rays.emplace_back(ray(p, {0.1, 0.2, 1}));
  }
  std::vector<std::set<ElementRef>> taken(rays.size());
  int flushes = 0;
  tables.pairs(
      rays, [](std::uint32_t number) { return number % 3 == 0 ? 0 : trace::no_limit; },
      [&](std::uint32_t number, ElementRef e) { CHECK(taken[number].insert(e).second); }, [&] { ++flushes; });
  CHECK(flushes == 3);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    CHECK(taken[i] == (i % 3 == 0 ? std::set<ElementRef>() : visited(tables, rays[i], trace::no_limit)));
  }
}
