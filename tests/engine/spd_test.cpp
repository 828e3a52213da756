// The Standard Procedural Databases (Haines), which the literature on acceleration measures by: every engine has the
// bytes of `exact` on them, for rays of the camera, towards the lights from what those meet, from there anywhere, and
// from anywhere.
#include "support/spd.hpp"

#include "durero/conform/rays_towards.hpp"
#include "durero/io/nff.hpp"
#include "durero/scene/camera.hpp"
#include "engine/same_bytes.hpp"
#include "support/catch.hpp"
#include "support/sanitized.hpp"
#include "support/scenes.hpp"
#include "support/shapes.hpp"

using namespace durero;
using namespace durero::test;

namespace {

constexpr std::array names{"balls", "rings", "lattice", "jacks", "tree"};

/// Nothing where the file is absent.
std::optional<scene::Scene> spd(const std::string& name) {
  const auto path = spd_path(name);
  if (!path) return std::nullopt;
  return std::move(io::read_nff(io::read_source(*path)).scene);
}

Queries primary(scene::Scene& scene, std::uint32_t side) {
  scene.stage().resolution = scene::Resolution{side, side};
  const scene::PrimaryRays rays(*scene.stage().camera, *scene.stage().resolution);
  Queries queries;
  for (std::uint32_t pixel = 0; pixel < side * side; ++pixel) {
    const scene::Query query{rays.ray(pixel % side, pixel / side)};
    queries.push_back(query);
  }
  return queries;
}

/// From where the rays meet something first: to each light, and into a direction at random.
Queries secondary(const scene::Scene& scene, const Queries& from, std::uint64_t seed) {
  Random random(seed);
  Queries queries;
  for (const scene::Hit& hit : engine::first_hits(*engine::find("analytic")->prepare(scene), from)) {
    if (hit.resultado != model::Resultado::hit) continue;
    for (const scene::Light& light : scene.stage().lights)
      queries.push_back({ray(hit.punto, light.position - hit.punto), hit.elementos});
    queries.push_back({ray(hit.punto, random.direction()), hit.elementos});
  }
  return queries;
}

/// Each of the four kinds, `side`² of the camera. Of all of them every `nth` is asked of `exact` too.
void check_database(const std::string& name, std::uint32_t side, std::size_t nth) {
  std::optional<scene::Scene> scene = spd(name);
  if (!scene) return;
  Queries queries = primary(*scene, side);
  const Queries further = secondary(*scene, queries, 1), at_random = conform::rays_towards(*scene, side * side, 1);
  CHECK(further.size() > side);
  queries.insert(queries.end(), further.begin(), further.end());
  queries.insert(queries.end(), at_random.begin(), at_random.end());
  check_same(*scene, queries, name);
  Queries some;
  for (std::size_t i = 0; i < queries.size(); i += nth) some.push_back(queries[i]);
  const auto exact = engine::find("exact")->prepare(*scene), analytic = engine::find("analytic")->prepare(*scene);
  CHECK(engine::first_hits(*exact, some) == engine::first_hits(*analytic, some));
  CHECK(occluded(*exact, some) == occluded(*analytic, some));
}

}  // namespace

TEST_CASE("on the small databases") {
  for (const std::string name : names) check_database(name + "-small", sanitized ? 8 : 24, 1);
}

TEST_CASE("on the databases as they are", "[long]") {
  for (const std::string name : names) check_database(name, 128, 500);
}
