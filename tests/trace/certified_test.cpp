#include "durero/trace/certified.hpp"

#include "durero/surface/exact.hpp"
#include "durero/trace/tables.hpp"
#include "support/catch.hpp"
#include "support/elements.hpp"
#include "support/property.hpp"
#include "support/sanitized.hpp"
#include "support/scenes.hpp"
#include "support/shapes.hpp"
#include "trace/triage.hpp"

using namespace durero;
using namespace durero::test;
using scene::ElementRef;

TEST_CASE("hits that the kernel is told of are written in their places, rounded once") {
  int hits = 0;
  property("packets of every size, of all types", [&] {
    const scene::Scene scene = some_of_each(moderate(), 3);
    std::vector<scene::Query> queries;
    const int count = *rc::gen::inRange(1, 60);
    for (int i = 0; i < count; ++i) queries.push_back({*rays(moderate()), {}});
    std::vector<scene::Hit> answers(queries.size());
    trace::Counts counts;
    trace::Certified certified(scene, queries, answers, counts, true);
    const trace::Tables tables(scene);
    std::vector<ElementRef> told(queries.size());
    std::vector<bool> met(queries.size());
    for (std::uint32_t i = 0; i < queries.size(); ++i) {
      const trace::Ray traced(queries[i].rayo);
      scene.any_of([&](ElementRef e, const auto& shape) {
        const trace::RootEstimate finding = triage(shape, traced, false);
        if (finding.verdict != trace::Decision::hit) return false;
        certified.hit(i, traced, tables, told[i] = e, {finding});
        met[i] = true;
        return true;
      });
    }
    certified.finish();
    std::uint64_t rounded = 0;
    for (std::size_t i = 0; i < queries.size(); ++i) {
      if (!met[i]) {
        RC_ASSERT(answers[i] == scene::Hit{});
        continue;
      }
      ++rounded;
      const auto t = surface::exact::reach(scene, told[i], queries[i].rayo, {}).first();
      RC_ASSERT(answers[i] == surface::exact::rounded_hit(queries[i].rayo, t, {told[i]}));
    }
    RC_ASSERT(counts.order[0] == rounded);
    RC_ASSERT(counts.rounding[0] + counts.rounding[1] + counts.rounding[2] == rounded);
    hits += static_cast<int>(rounded);
  });
  CHECK(hits > (sanitized ? 0 : 300));
}

TEST_CASE("a point of the kernel holds the parameter between its ends, and nothing is nearer than none") {
  CHECK(trace::Certified::Point{}.low() == trace::no_limit);
  const trace::Certified::Point point{{trace::Decision::hit, 2, 0, 0.5}};
  CHECK(point.low() == 1.5);
  CHECK(point.high() == 2.5);
}

TEST_CASE("points of a plane across an axis are rounded without exact arithmetic, each type and axis") {
  scene::Scene scene;
  const auto turned = [](int axis, const glm::dvec3& x) {
    return axis == 0 ? x : axis == 1 ? glm::dvec3(x.z, x.x, x.y) : glm::dvec3(x.y, x.z, x.x);
  };
  std::vector<ElementRef> elements;
  for (int axis = 0; axis < 3; ++axis) {
    const auto at = [&](double x, double y, double z) { return turned(axis, {x, y, z}); };
    elements.push_back(add(scene, scene::Plane{at(0, 3, 1), at(1, 0, 0)}));
    elements.push_back(add(scene, scene::Disc{at(-0.0, 1, 2), 100, at(-1, 0, 0)}));
    elements.push_back(add(scene, scene::Triangle{{at(0, -100, -100), at(0, 100, -100), at(0, 3, 100)}}));
    elements.push_back(add(scene, scene::Triangle{{at(1, -100, -100), at(1, 100, -100), at(7, 3, 100)}}));
  }
  for (std::size_t k = 0; k < elements.size(); ++k) {
    CAPTURE(k);
    std::vector<scene::Query> queries;
    for (int i = 1; i < 60; ++i)
      queries.push_back({ray({0.1 * i + 3, 5 - 0.03 * i, 4 + 0.07 * i}, {-1 - 0.01 * i, -0.9, -1.1 + 0.001 * i}), {}});
    std::vector<scene::Hit> answers(queries.size());
    trace::Counts counts;
    trace::Certified certified(scene, queries, answers, counts, true);
    const trace::Tables tables(scene);
    for (std::uint32_t i = 0; i < queries.size(); ++i) {
      const trace::Ray traced(queries[i].rayo);
      const trace::RootEstimate finding =
          scene.visit(elements[k], [&](const auto& shape) { return triage(shape, traced, false); });
      if (finding.verdict == trace::Decision::hit) certified.hit(i, traced, tables, elements[k], {finding});
    }
    certified.finish();
    for (std::size_t i = 0; i < queries.size(); ++i) {
      if (answers[i] == scene::Hit{}) continue;
      const auto t = surface::exact::reach(scene, elements[k], queries[i].rayo, {}).first();
      CHECK(answers[i] == surface::exact::rounded_hit(queries[i].rayo, t, {elements[k]}));
      for (int axis = 0; axis < 3; ++axis)
        CHECK(!std::signbit(answers[i].punto[axis] == 0 ? answers[i].punto[axis] : 1));
    }
    CHECK(counts.rounding[0] > 20);
    CHECK(counts.rounding[2] == 0);
  }
}

TEST_CASE("hits of the element that a ray starts on are rounded once, in lanes") {
  scene::Scene scene;
  const std::vector<ElementRef> elements{add(scene, scene::Sphere{{0.1, 0.2, 0.3}, 1}),
                                         add(scene, scene::Cylinder{{0.1, -0.7, 0.3}, 1, {0, 1, 0}, 4}),
                                         add(scene, scene::TruncatedCone{{0.2, -0.5, 0.1}, 0.6, 0.25, {0, 0, 1}, 3})};
  for (const ElementRef e : elements) {
    std::vector<scene::Query> queries;
    for (int i = 0; i < 45; ++i) {
      const auto in = ray({3, 0.01 * i - 0.2, 0.3 + 0.005 * i}, {-1, -0.002 * i, 0.001 * i});
      const auto reach = surface::exact::reach(scene, e, in);
      REQUIRE(!reach.empty());
      const glm::dvec3 on = surface::exact::rounded_hit(in, reach.first(), {e}).punto;
      queries.push_back({ray(on, {-1.0 / (i + 1), 0.002, 0.0012}), {e}});
    }
    std::vector<scene::Hit> answers(queries.size());
    trace::Counts counts;
    trace::Certified certified(scene, queries, answers, counts, true);
    for (std::uint32_t i = 0; i < queries.size(); ++i) {
      const trace::Ray traced(queries[i].rayo);
      const trace::RootEstimate finding =
          scene.visit(e, [&](const auto& shape) { return triage(shape, traced, true); });
      REQUIRE(finding.verdict == trace::Decision::hit);
      certified.hit_own(i, traced, e, {finding});
    }
    certified.finish();
    for (std::size_t i = 0; i < queries.size(); ++i) {
      const auto t = surface::exact::reach(scene, e, queries[i].rayo, {e}).first();
      CHECK(answers[i] == surface::exact::rounded_hit(queries[i].rayo, t, {e}));
    }
    CHECK(counts.rounding[0] > 40);
  }
}
