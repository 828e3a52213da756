#include "durero/trace/segments.hpp"

#include <boost/container/vector.hpp>

#include "durero/trace/analytic.hpp"
#include "support/catch.hpp"
#include "support/scenes.hpp"
#include "support/shapes.hpp"

using namespace durero;
using namespace durero::test;

TEST_CASE("segments in lanes are occluded as they are one by one") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Random random(seed);
    scene::Scene scene = random_scene(random, 40);
    if (seed % 2 == 0) add(scene, scene::Sphere{{0, 0, 0}, 1e-200});
    const trace::Tables tables(scene);
    std::vector<scene::Query> queries;
    for (int i = 0; i < 300; ++i) {
      queries.push_back({random_ray(random)});
      const scene::Hit hit = trace::first_hit(tables, queries.back().rayo);
      if (hit.resultado != model::Resultado::hit) continue;
      const glm::dvec3 p = queries.back().rayo.p().xyz();
      queries.push_back({ray(p, hit.punto - p)});  // ends about where it meets the first
      queries.push_back({ray(hit.punto, p - hit.punto), hit.elementos});
      queries.push_back({ray(hit.punto, 2.0 * (hit.punto - p)), hit.elementos});  // may meet the element again
      queries.push_back({ray(p, (hit.punto - p) * 0x1p-200)});
    }
    boost::container::vector<bool> alone(queries.size()), in_lanes(queries.size());
    trace::occluded_segments(tables, queries, {alone.data(), alone.size()});
    trace::occluded_segments_in_lanes(tables, queries, {in_lanes.data(), in_lanes.size()});
    CHECK(in_lanes == alone);
  }
}
