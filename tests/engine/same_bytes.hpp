#pragma once
/// Every engine that promises the bytes of `exact` is held against `analytic`, which its own tests hold against
/// `exact`.

#include <algorithm>
#include <boost/container/vector.hpp>
#include <string>
#include <vector>

#include "durero/engine/engine.hpp"
#include "support/catch.hpp"

namespace durero::test {

using Queries = std::vector<scene::Query>;

inline boost::container::vector<bool> occluded(const engine::Engine& engine, const Queries& queries) {
  boost::container::vector<bool> answers(queries.size());
  engine.occluded_segments(queries, {answers.data(), answers.size()});
  return answers;
}

/// The points that stand before a light, where all elements pass it and where one of each five does not.
inline void check_same_between(const scene::Scene& scene, const engine::Engine& engine, const engine::Engine& other,
                               const Queries& queries, const std::string& replay) {
  using surface::exact::RayStretch;
  constexpr std::size_t some = 40;
  const surface::exact::Passes most = [](scene::ElementRef e) { return e.index % 5 != 4; },
                               all = [](scene::ElementRef) { return true; };
  for (std::size_t i = 0; i < std::min(some, queries.size()); ++i)
    for (const RayStretch stretch : {RayStretch::segment, RayStretch::whole})
      for (const surface::exact::Passes& passes : {most, all}) {
        const auto own = engine.points_between(scene, queries[i], stretch, passes);
        if (own == other.points_between(scene, queries[i], stretch, passes)) continue;
        INFO(replay << ", points of ray " << i);
        CHECK(own == other.points_between(scene, queries[i], stretch, passes));
        return;
      }
}

inline void check_same(const scene::Scene& scene, const Queries& queries, const std::string& replay) {
  const auto analytic = engine::find("analytic")->prepare(scene);
  const std::vector<scene::Hit> hits = engine::first_hits(*analytic, queries);
  const auto blocked = occluded(*analytic, queries);
  for (const engine::EngineRow& row : engine::engines()) {
    if (!row.exact_bytes || row.name == "exact" || row.name == "analytic") continue;
    const auto engine = row.prepare(scene);
    const std::vector<scene::Hit> own = engine::first_hits(*engine, queries);
    const auto own_blocked = occluded(*engine, queries);
    std::vector<trace::FirstElement> elements(queries.size());
    engine->first_elements(queries, elements);
    for (std::size_t i = 0; i < queries.size(); ++i) {
      const trace::FirstElement first = trace::first_element(hits[i]);
      if (own[i] == hits[i] && own_blocked[i] == blocked[i] && elements[i] == first) continue;
      INFO(row.name << ", " << replay << ", ray " << i);
      CHECK(own[i] == hits[i]);
      CHECK(own_blocked[i] == blocked[i]);
      CHECK(elements[i] == first);
      break;
    }
    if (!queries.empty()) CHECK(engine::first_hit(*engine, queries.back()) == hits.back());
    check_same_between(scene, *engine, *analytic, queries, std::string(row.name) + ", " + replay);
  }
}

}  // namespace durero::test
