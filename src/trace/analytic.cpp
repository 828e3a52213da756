#include "durero/trace/analytic.hpp"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include "durero/trace/plain.hpp"

namespace durero::trace {

scene::Hit first_hit(const scene::Scene& scene, const model::Rayo& rayo, Origin en) {
  return plain::first_hit(scene, rayo, en);
}

bool occluded(const scene::Scene& scene, const model::Rayo& rayo, Origin en) {
  return plain::first_hit(scene, rayo, en).resultado != model::Resultado::miss;
}

bool occluded_segment(const scene::Scene& scene, const model::Rayo& rayo, Origin en) {
  const scene::Hit hit = plain::first_hit(scene, rayo, en);
  return hit.resultado != model::Resultado::miss && hit.t < 1;
}

std::vector<scene::Hit> first_hits(const scene::Scene& scene, std::span<const Query> queries, unsigned threads) {
  std::vector<scene::Hit> hits(queries.size());
  const auto answer = [&](const oneapi::tbb::blocked_range<std::size_t>& range) {
    for (std::size_t i = range.begin(); i != range.end(); ++i) {
      const Query& query = queries[i];
      hits[i] = first_hit(scene, query.rayo, {query.en.data(), query.en.size()});
    }
  };
  const int workers = threads == 0 ? oneapi::tbb::task_arena::automatic : static_cast<int>(threads);
  oneapi::tbb::task_arena arena(workers);
  arena.execute(
      [&] { oneapi::tbb::parallel_for(oneapi::tbb::blocked_range<std::size_t>(0, queries.size(), 64), answer); });
  return hits;
}

}  // namespace durero::trace
