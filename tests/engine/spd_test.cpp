// The Standard Procedural Databases (Haines), which the literature on acceleration measures by: every engine has the
// bytes of `exact` on them, for rays of the camera, towards the lights from what those meet, from there anywhere, and
// from anywhere.
#include "support/spd.hpp"

#include <iostream>

#include "durero/accel/bvh.hpp"
#include "durero/accel/structure.hpp"
#include "durero/accel/volumes.hpp"
#include "durero/conform/families/rays_towards.hpp"
#include "durero/io/nff/nff.hpp"
#include "durero/scene/camera.hpp"
#include "durero/scene/stage.hpp"
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
    for (const scene::Light& light : scene.stage().lights) {
      const scene::Query shadow{ray(hit.punto, light.position - hit.punto), hit.elementos};
      queries.push_back(shadow);
    }
    const scene::Query anywhere{ray(hit.punto, random.direction()), hit.elementos};
    queries.push_back(anywhere);
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

namespace {

/// A hierarchy that does not know how near the nearest hit is.
struct Unpruned {
  const accel::Bvh& bvh;
  accel::Work& work;

  const scene::Scene& scene() const { return bvh.scene(); }
  std::span<const scene::ElementRef> extraordinary() const { return bvh.extraordinary(); }
  template <class Limit, class Visit>
  bool any(const trace::Ray& ray, Limit, Visit visit) const {
    return bvh.any(
        ray, [] { return trace::no_limit; }, visit, work);
  }
};

void check_pruning(const std::string& name, std::uint32_t side) {
  std::optional<scene::Scene> scene = spd(name);
  if (!scene) return;
  const accel::Bvh bvh(*scene);
  accel::Work pruned, all;
  trace::Counts unseen;
  for (const auto& [rayo, en] : primary(*scene, side))
    CHECK(trace::first_hit_among(accel::Counted(bvh, pruned), rayo, en, unseen) ==
          trace::first_hit_among(Unpruned{bvh, all}, rayo, en, unseen));
  INFO(name << ": " << pruned.volumes + pruned.candidates << " tests of " << all.volumes + all.candidates);
  CHECK(pruned.volumes + pruned.candidates < all.volumes + all.candidates);
  CHECK(pruned.candidates < all.candidates);
  CHECK(pruned.by_distance > 0);
  CHECK(all.by_distance == 0);
}

/// Of the elements whose volumes some rays meet, the share that they meet themselves, wherever on the ray.
double met_of_tried(const accel::Volumes& volumes, const Queries& queries) {
  std::uint64_t tried = 0, met = 0;
  trace::Counts unseen;
  for (const auto& [rayo, en] : queries) {
    const trace::Ray ray(rayo);
    const trace::Search search(volumes.scene(), rayo, en, unseen);
    accel::CandidateSource(volumes).any(
        ray, [] { return trace::no_limit; },
        [&](scene::ElementRef e) {
          ++tried;
          met += search.blocks(e);
          return false;
        });
  }
  return static_cast<double>(met) / static_cast<double>(tried);
}

/// Prints the shares of balls, of boxes and of what is chosen.
void check_met(const std::string& name, std::size_t rays) {
  const std::optional<scene::Scene> scene = spd(name);
  if (!scene) return;
  const Queries queries = conform::rays_towards(*scene, rays, 2);
  const double balls = met_of_tried({*scene, accel::kinds()[0]}, queries),
               boxes = met_of_tried({*scene, accel::kinds()[1]}, queries),
               chosen = met_of_tried(accel::Volumes(*scene), queries);
  std::cout << name << ", met of those whose volume is met: balls " << balls << ", boxes " << boxes << ", chosen "
            << chosen << '\n';
  for (const double share : {balls, boxes, chosen}) {
    CHECK(share > 0);
    CHECK(share <= 1);
  }
  CHECK(chosen >= 0.99 * balls);
}

}  // namespace

TEST_CASE("on the small databases a hierarchy tests less where it knows the nearest hit") {
  for (const std::string name : names) check_pruning(name + "-small", sanitized ? 8 : 32);
}

TEST_CASE("on the small databases the volumes that are chosen let through no more than balls") {
  for (const std::string name : names) check_met(name + "-small", fewer_when_sanitized(300));
}
TEST_CASE("of the elements of the databases whose volume a ray meets some are met", "[long]") {
  for (const std::string name : names) check_met(name, 1000);
}
