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

TEST_CASE("of several elements that a segment starts on, each is met at its other point") {
  scene::Scene scene;
  for (const double x : {0.0, 2.0}) add(scene, scene::Sphere{{x, 0, 0}, 1});
  const scene::ElementSet both{{model::Tipo::soy_esfera, 0}, {model::Tipo::soy_esfera, 1}};
  const trace::Tables tables(scene);
  std::vector<scene::Query> queries;
  for (const double way : {4.0, -4.0, 0.5, -0.5}) queries.push_back({ray({1, 0, 0}, {way, 0, 0}), both});
  queries.push_back({ray({-1.5, 0.01, 0}, {1, 0, 0}), both});  // as starts at t = 3 and 7; if it lay on neither, at 0.5
  boost::container::vector<bool> occluded(queries.size());
  trace::occluded_segments_in_lanes(tables, queries, {occluded.data(), occluded.size()});
  CHECK(occluded == boost::container::vector<bool>{true, true, false, false, false});
}

TEST_CASE("of rays that follow each other from one element, each is tested against it, however many they are") {
  scene::Scene scene;
  for (const double x : {0.0, 8.0}) add(scene, scene::Sphere{{x, 0, 0}, 1});
  add(scene, scene::Cylinder{{16, 0, 0}, 1, {0, 0, 1}, 1});
  const trace::Tables tables(scene);
  for (const int run : {1, 2, 3, 7, 8, 9, 30}) {
    std::vector<scene::Query> queries;
    boost::container::vector<bool> through;
    for (int i = 0; i < 100; ++i) {
      const int which = i / run % 3;
      const double x = which * 8 + 1, way = i % 5 == 2 || i % 5 == 3 ? -4 : 4;
      queries.push_back({ray({x, 0, 0.5}, {way, 0, 0}), {{}}});
      queries.back().en[0] = which == 2 ? scene::ElementRef{model::Tipo::soy_cilindro, 0}
                                        : scene::ElementRef{model::Tipo::soy_esfera, static_cast<std::uint32_t>(which)};
      through.push_back(way < 0);
    }
    boost::container::vector<bool> occluded(queries.size());
    trace::occluded_segments_in_lanes(tables, queries, {occluded.data(), occluded.size()});
    CHECK(occluded == through);
  }
}
