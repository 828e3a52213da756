// What the text on acceleration (Ramos, Tema VI) claims of the time that a picture takes: the share of it that goes
// into intersections (A §1.1), and what a hierarchy, an item buffer and adaptive depth make of it (A §1.5). Measured by
// the processor's time on one thread; docs/acceleration-reference.md has what is printed here.
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <iostream>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "durero/accel/bvh.hpp"
#include "durero/accel/item_buffer.hpp"
#include "durero/accel/volumes.hpp"
#include "durero/io/json/scene_file.hpp"
#include "durero/io/nff/nff.hpp"
#include "durero/render/render.hpp"
#include "durero/scene/stage.hpp"
#include "engine/structured.hpp"
#include "support/catch.hpp"
#include "support/scenes.hpp"
#include "support/shapes.hpp"
#include "support/spd.hpp"

using namespace durero;
using namespace durero::test;
using scene::Query;
using scene::Scene;

namespace {

/// Algorithm II.2: every element is intersected with every ray.
class Every {
 public:
  explicit Every(const Scene& scene) : scene_(&scene) {
    scene.for_each([&](scene::ElementRef e, const auto&) { all_.push_back(e); });
  }
  const Scene& scene() const noexcept { return *scene_; }
  std::span<const scene::ElementRef> extraordinary() const noexcept { return {}; }
  accel::Size size() const { return {.elements = all_.size()}; }
  template <class Limit, class Visit>
  bool any(const trace::Ray&, Limit, Visit visit, accel::Work& work) const {
    work.candidates += all_.size();
    return std::ranges::any_of(all_, visit);
  }

 private:
  const Scene* scene_;
  std::vector<scene::ElementRef> all_;
};
static_assert(accel::Structure<Every>);

double processor_seconds() { return double(std::clock()) / CLOCKS_PER_SEC; }

/// An engine that is asked by the clock.
class Timed final : public engine::Engine {
 public:
  explicit Timed(const engine::Engine& of) : of_(of) {}
  void first_hits(std::span<const Query> queries, std::span<scene::Hit> hits) const override {
    timed([&] { of_.first_hits(queries, hits); });
  }
  void first_elements(std::span<const Query> queries, std::span<trace::FirstElement> elements) const override {
    timed([&] { of_.first_elements(queries, elements); });
  }
  void occluded_segments(std::span<const Query> queries, std::span<bool> occluded) const override {
    timed([&] { of_.occluded_segments(queries, occluded); });
  }
  glm::dvec3 normal(const Scene& scene, scene::ElementRef element, const glm::dvec3& point) const override {
    return of_.normal(scene, element, point);
  }
  double seconds() const { return seconds_; }

 private:
  template <class Ask>
  void timed(Ask ask) const {
    const double before = processor_seconds();
    ask();
    seconds_ += processor_seconds() - before;
  }
  const engine::Engine& of_;
  mutable double seconds_ = 0;
};

/// Balls at random in the unit cube, less large where they are more, in front of a camera, with a light.
Scene balls(std::size_t count) {
  Random random(1);
  Scene scene;
  while (scene.size() < count) {
    const glm::dvec3 centre = (random.in_cube(1) + 1.0) / 2.0;
    add(scene, scene::Sphere{centre, 0.25 / std::cbrt(double(count)) * random.uniform(0.5, 1)});
  }
  scene.stage().camera = scene::Camera{{0.5, 0.5, -1.5}, {0.5, 0.5, 0.5}, {0, 1, 0}, 40};
  scene.stage().resolution = scene::Resolution{200, 200};
  scene.stage().lights.push_back({{3, 5, -4}, {1, 1, 1}});
  return scene;
}

/// Of the time that a picture takes, the share that the engine takes: the middle one of some goes.
double share_of_intersections(const Scene& scene, const engine::Engine& engine) {
  std::vector<double> shares;
  for (int go = 0; go < 5; ++go) {
    const Timed timed(engine);
    const double before = processor_seconds();
    render::render(scene, timed);
    shares.push_back(timed.seconds() / (processor_seconds() - before));
  }
  std::ranges::sort(shares);
  return shares[2];
}

}  // namespace

TEST_CASE("most of the time of a simple tracer goes into intersections, and less of it with a hierarchy", "[long]") {
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  for (const auto& [elements, least] : {std::pair(10, 0.0), {100, 0.75}, {1000, 0.95}}) {
    const Scene scene = balls(static_cast<std::size_t>(elements));
    const double every = share_of_intersections(scene, engine::Structured<Every>(scene)),
                 bvh = share_of_intersections(scene, engine::Structured<accel::Bvh>(scene)),
                 fast = share_of_intersections(scene, *engine::find("fast")->prepare(scene));
    std::cout << elements << " elements, share of intersections: every element " << every << ", bvh " << bvh
              << ", fast " << fast << '\n';
    CHECK(every >= least);
    CHECK(bvh < every);
    CHECK(fast < every);
  }
}

namespace {

/// One way to draw a picture, and what it took.
struct Way {
  const char* name;
  double min_weight;
  std::unique_ptr<const engine::Engine> (*make)(const Scene& scene);
  double seconds = 0;      ///< the least of some goes, to prepare and to draw
  double greatest = 0;     ///< the greatest
  std::uint64_t rays = 0;  ///< that were followed
};

std::unique_ptr<const engine::Engine> with_balls(const Scene& scene) {
  return std::make_unique<const engine::Structured<accel::Volumes>>(scene, accel::kinds()[0]);
}
template <class S>
std::unique_ptr<const engine::Engine> with(const Scene& scene) {
  return std::make_unique<const engine::Structured<S>>(scene);
}

/// Rays that count for less than this of each colour of their pixel are not followed.
constexpr double least_weight = 0.05;

std::vector<Way> drawn(const Scene& scene, std::uint32_t depth, int goes) {
  std::vector<Way> ways{{"balls", 0, with_balls},
                        {"hierarchy", 0, with<accel::Bvh>},
                        {"balls, adaptive depth", least_weight, with_balls},
                        {"hierarchy, item buffer", 0, with<accel::ItemBuffer>},
                        {"hierarchy, item buffer, adaptive depth", least_weight, with<accel::ItemBuffer>}};
  for (int go = 0; go < goes; ++go)
    for (Way& way : ways) {
      render::PathStatistics reach;
      const double before = processor_seconds();
      const auto engine = way.make(scene);
      render::render(scene, *engine, {}, {.max_depth = depth, .min_weight = way.min_weight}, &reach);
      const double took = processor_seconds() - before;
      way.seconds = go == 0 ? took : std::min(way.seconds, took);
      way.greatest = std::max(way.greatest, took);
      way.rays = reach.rays;
    }
  return ways;
}

void check_ways(const std::string& name, Scene scene, std::uint32_t side, int goes) {
  scene.stage().resolution = scene::Resolution{side, side};
  const std::vector<Way> ways = drawn(scene, 5, goes);
  std::cout << name << ", " << scene.size() << " elements:";
  for (const Way& way : ways)
    std::cout << ' ' << way.name << ' ' << way.seconds / ways[0].seconds << " (" << way.seconds << "–" << way.greatest
              << " s, " << way.rays << " rays);";
  std::cout << '\n';
  CHECK(ways[4].rays <= ways[0].rays);
  CHECK(ways[3].rays == ways[0].rays);
  CHECK(ways[4].seconds < (scene.size() < 50 ? 0.95 : 0.65) * ways[0].seconds);  // a few elements need no hierarchy
}

}  // namespace

TEST_CASE(
    "the ways that are compared follow as many rays, and no more where those that count for little are left out") {
  Scene scene = balls(30);
  scene.stage().materials.push_back({.name = "mirror", .color = glm::dvec3(0.5), .k_ps = 0.2});
  scene.for_each([&](scene::ElementRef e, const auto&) { scene.set_material(e, 0); });
  scene.stage().resolution = scene::Resolution{24, 24};
  const std::vector<Way> ways = drawn(scene, 5, 1);
  CHECK(ways[0].rays > 24 * 24);
  CHECK(ways[1].rays == ways[0].rays);
  CHECK(ways[3].rays == ways[0].rays);
  CHECK(ways[2].rays < ways[0].rays);
  CHECK(ways[4].rays == ways[2].rays);
}

// The text has about one half for all three together, on scenes of its time.
TEST_CASE("with a hierarchy, an item buffer and adaptive depth a picture takes about half the time, or less",
          "[long]") {
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const std::string whitted = source_dir() + "/demo/gallery/whitted.json";
  check_ways("whitted", io::read_scene(io::read_source(whitted)), 200, 5);
  for (const std::string name : {"balls", "rings", "lattice", "jacks", "tree"})
    for (const bool small : {true, false})
      if (const auto path = spd_path(name + (small ? "-small" : "")))
        check_ways(name + (small ? ", small" : ""), io::read_nff(io::read_source(*path)).scene, small ? 128 : 32,
                   small ? 3 : 1);
}
