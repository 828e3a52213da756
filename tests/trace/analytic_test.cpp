#include "durero/trace/analytic.hpp"

#include "durero/surface/exact.hpp"
#include "plain/plain.hpp"
#include "support/catch.hpp"
#include "support/elements.hpp"
#include "support/property.hpp"
#include "support/shapes.hpp"
#include "support/threads.hpp"

using namespace durero;
using namespace durero::test;
using model::Resultado;

namespace {

/// Every entry point against the oracle, with and without tables.
scene::Hit check_ray(const scene::Scene& scene, const trace::Tables& tables, const model::Rayo& ray, scene::Origin en) {
  namespace exact = surface::exact;
  const scene::Hit truth = exact::first_hit(scene, ray, en);
  RC_ASSERT(trace::first_hit(tables, ray, en) == truth);
  RC_ASSERT(trace::first_hit(scene, ray, en) == truth);
  RC_ASSERT(trace::occluded(tables, ray, en) == exact::occluded(scene, ray, en));
  RC_ASSERT(trace::occluded(scene, ray, en) == exact::occluded(scene, ray, en));
  RC_ASSERT(trace::occluded_segment(tables, ray, en) == exact::occluded_segment(scene, ray, en));
  RC_ASSERT(trace::occluded_segment(scene, ray, en) == exact::occluded_segment(scene, ray, en));
  return truth;
}

bool finite(const glm::dvec3& x) { return std::isfinite(x.x) && std::isfinite(x.y) && std::isfinite(x.z); }

/// A ray, then another from its hit, which starts on the elements hit.
void check_path(const Reals& numbers) {
  const scene::Scene scene = some_of_each(numbers, 2);
  const trace::Tables tables(scene);
  for (int i = 0; i < 10; ++i) {
    const scene::Hit hit = check_ray(scene, tables, *rays(numbers), {});
    if (hit.resultado != Resultado::hit || !finite(hit.punto)) continue;
    const model::Rayo on({model::Punto(hit.punto), (*rays(numbers)).v()});
    check_ray(scene, tables, on, hit.elementos);
  }
}

/// Also of the uncertified tracer, where it has tables of all elements.
void check_many(const Reals& numbers) {
  const scene::Scene scene = some_of_each(numbers, 2);
  const trace::Tables tables(scene);
  std::vector<scene::Query> queries;
  for (int i = 0; i < 100; ++i) {
    const scene::Query query{*rays(numbers)};
    queries.push_back(query);
  }
  const auto hits = trace::first_hits(tables, queries);
  for (std::size_t i = 0; i < queries.size(); ++i) RC_ASSERT(hits[i] == trace::first_hit(tables, queries[i].rayo));
  if (!tables.extraordinary().empty()) return;
  const auto plain = trace::plain::first_hits(tables, queries);
  for (std::size_t i = 0; i < queries.size(); ++i) {
    RC_ASSERT(plain[i] == trace::plain::first_hit(tables, queries[i].rayo));
  }
}

}  // namespace

TEST_CASE("the analytic answer is the exact one, byte for byte") {
  property("ordinary scenes", [] { check_path(moderate()); });
  property("grids, where coincidences are frequent", [] { check_path(dyadicGrid()); });
  property("the whole range of binary64", [] { check_path(anyFinite()); });
}

TEST_CASE("many rays at once have the answers of each") {
  property("ordinary scenes", [] { check_many(moderate()); });
  property("grids, where coincidences are frequent", [] { check_many(dyadicGrid()); });
  property("the whole range of binary64", [] { check_many(anyFinite()); });
}

TEST_CASE("the answers to many rays do not depend on the number of threads") {
  property("1, 2 and all threads", [] {
    const scene::Scene scene = some_of_each(moderate(), 2);
    const trace::Tables tables(scene);
    std::vector<scene::Query> queries;
    for (int i = 0; i < 1000; ++i) {
      const scene::Query query{*rays(moderate())};
      queries.push_back(query);
    }
    trace::Counts one, two;
    const auto hits = on_threads(1, [&] { return trace::first_hits(tables, queries, &one); });
    RC_ASSERT(on_threads(2, [&] { return trace::first_hits(tables, queries, &two); }) == hits);
    RC_ASSERT(trace::first_hits(tables, queries) == hits);
    RC_ASSERT(one == two);
  });
}
