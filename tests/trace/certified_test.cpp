#include "durero/trace/certified.hpp"

#include "durero/surface/exact.hpp"
#include "durero/trace/tables.hpp"
#include "support/catch.hpp"
#include "support/elements.hpp"
#include "support/property.hpp"
#include "support/sanitized.hpp"
#include "support/shapes.hpp"
#include "trace/triage.hpp"

using namespace durero;
using namespace durero::test;
using scene::ElementRef;

TEST_CASE("hits that the kernel is told of are written in their places, rounded once") {
  int hits = 0;
  property("packets of every size, of all types", [&] {
    scene::Scene scene;
    for (int i = 0; i < 3; ++i) {
      add(scene, *spheres(moderate()));
      add(scene, *cylinders(moderate()));
      add(scene, *cones(moderate()));
      add(scene, *planes(moderate()));
      add(scene, *discs(moderate()));
      add(scene, *triangles(moderate()));
      add(scene, *truncated_cones(moderate()));
    }
    std::vector<scene::Query> queries;
    const int count = *rc::gen::inRange(1, 60);
    for (int i = 0; i < count; ++i) queries.push_back({*rays(moderate()), {}});
    std::vector<scene::Hit> answers(queries.size());
    trace::Counts counts;
    trace::Certified certified(scene, queries, answers, counts);
    const trace::Tables tables(scene);
    std::vector<ElementRef> told(queries.size());
    std::vector<bool> met(queries.size());
    for (std::uint32_t i = 0; i < queries.size(); ++i) {
      const trace::Ray traced(queries[i].rayo);
      scene.any_of([&](ElementRef e, const auto& shape) {
        const trace::Finding finding = triage(shape, traced, false);
        if (finding.verdict != trace::Verdict::hit) return false;
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
  const trace::Certified::Point point{{trace::Verdict::hit, 2, 0, 0.5}};
  CHECK(point.low() == 1.5);
  CHECK(point.high() == 2.5);
}
