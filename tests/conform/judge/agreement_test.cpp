// Right hits agree with the samples; an engine that errs on one ray in many is found out, by number and ray.
#include "durero/conform/judge/agreement.hpp"

#include <atomic>

#include "durero/io/json/scene_file.hpp"
#include "durero/trace/analytic.hpp"
#include "support/catch.hpp"
#include "support/scenes.hpp"

using namespace durero;
using conform::Agreement;
using oracle::sampled::SampledVerdict;

namespace {

scene::Scene some_scene() {
  test::Random random(31);
  return test::random_scene(random, 5);
}

Agreement agreement(const scene::Scene& scene, const conform::FirstHits& first_hits, std::uint64_t rays,
                    std::uint64_t seed) {
  return conform::agreement(oracle::sampled::Oracle(scene), first_hits, rays, seed);
}

conform::FirstHits analytic(const scene::Scene& scene) {
  return [&scene](std::span<const scene::Query> queries) { return trace::first_hits(trace::Tables(scene), queries); };
}

}  // namespace

TEST_CASE("the tracer's hits of many rays agree, in more than one block of rays") {
  const scene::Scene scene = some_scene();
  std::size_t blocks = 0;
  const Agreement all = agreement(
      scene,
      [&](std::span<const scene::Query> queries) {
        ++blocks;
        return trace::first_hits(trace::Tables(scene), queries);
      },
      70'000, 1);
  CHECK(all.rays() == 70'000);
  CHECK(blocks == 2);
  CHECK_FALSE(all.first);
  CHECK(all.of(SampledVerdict::incomplete) + all.of(SampledVerdict::unsound) == 0);
  CHECK(all.of(SampledVerdict::agrees) > 65'000);
}

TEST_CASE("one wrong hit is found: its number, its ray and why") {
  const scene::Scene scene = some_scene();
  const std::size_t wrong = 66'000;  // beyond the first block
  std::size_t before = 0;
  scene::Query spoiled{{{0, 0, 0}, {1, 0, 0}}, {}};
  const Agreement all = agreement(
      scene,
      [&](std::span<const scene::Query> queries) {
        std::vector<scene::Hit> hits = trace::first_hits(trace::Tables(scene), queries);
        for (std::size_t i = 0; i < hits.size(); ++i) {
          if (before + i < wrong || hits[i].resultado != model::Resultado::hit || spoiled.rayo.v().x() != 1) continue;
          hits[i].punto += glm::dvec3(100, 0, 0);
          spoiled = queries[i];
        }
        before += hits.size();
        return hits;
      },
      70'000, 1);
  REQUIRE(all.first);
  CHECK(all.first->ray >= wrong);
  CHECK(all.first->query == spoiled);
  CHECK_FALSE(agrees(all.first->verdict));
  CHECK(all.of(SampledVerdict::incomplete) + all.of(SampledVerdict::unsound) == 1);
}

TEST_CASE("every ray that is judged is told of, and none twice") {
  const scene::Scene scene = some_scene();
  // 1237 is prime, so that no part of the pairs is a whole number of rays.
  for (const std::size_t bytes : {std::size_t{0}, oracle::sampled::Oracle::usual_bytes}) {
    std::atomic<std::uint64_t> told = 0;
    conform::agreement(oracle::sampled::Oracle(scene, oracle::sampled::default_fineness, bytes), analytic(scene), 1237,
                       1, [&](std::uint64_t more) { told += more; });
    CHECK(told == 1237);
  }
}

TEST_CASE("an engine that misses everything is wrong on most of its rays") {
  const scene::Scene scene = some_scene();
  const Agreement all = agreement(
      scene, [](std::span<const scene::Query> queries) { return std::vector<scene::Hit>(queries.size()); }, 1000, 1);
  REQUIRE(all.first);
  CHECK(all.of(SampledVerdict::unsound) > 400);
}

TEST_CASE("a seed and a number name a ray, on every platform") {
  const std::vector<oracle::BallNode> balls{{{1, 2, 3}, 2, 0, 0, 0}, {{-4, 0, 0}, 1, 0, 0, 0}};
  conform::RaysTowards stream(balls, 7);
  std::vector<model::Rayo> rays;
  for (int i = 0; i < 1000; ++i) rays.push_back(stream.next());
  // The draws in their order: which ball, the three coordinates of the place, those of the way there, how far.
  conform::Random random(7);
  for (const model::Rayo& ray : rays) {
    const oracle::BallNode& ball = balls[random.bits() % 2];
    double draws[7];
    for (double& x : draws) x = static_cast<double>(random.bits() >> 11) * 0x1p-53;
    const auto in_cube = [&](int first) {
      return glm::dvec3(-1 + 2 * draws[first], -1 + 2 * draws[first + 1], -1 + 2 * draws[first + 2]);
    };
    const glm::dvec3 to = ball.center + in_cube(0) * ball.radius;
    const glm::dvec3 from = to + in_cube(3) * (ball.radius * (1 + 7 * draws[6]));
    CHECK(ray.p().xyz() == from);
    CHECK(ray.v().xyz() == to - from);
  }
  conform::RaysTowards again(balls, 7), other(balls, 8);
  CHECK(again.next() == rays[0]);
  CHECK_FALSE(other.next() == rays[0]);
}

TEST_CASE("a scene without elements has no rays") {
  const scene::Scene scene;
  const Agreement all = agreement(scene, analytic(scene), 1000, 1);
  CHECK(all.rays() == 0);
  CHECK_FALSE(all.first);
}

TEST_CASE("as JSON: how many rays had which verdict, and the first that is wrong, with the places of its elements") {
  const io::Source file("s.json", R"({"format":"durero-scene","version":1,"elementos":[
{"id":"b","tipo":"esfera","centro":[9,0,0],"radio":1},
{"id":"a","tipo":"esfera","centro":[0,0,0],"radio":1}]})");
  const scene::Scene scene = io::read_scene(file);
  const conform::AgreementCall call{file, scene, "analytic", 7};
  const std::string right = agreement_json(agreement(scene, analytic(scene), 100, 7), call);
  CHECK(right.find(R"("file":"s.json","engine":"analytic","seed":7,"rays":100,"ok":true)") != right.npos);
  CHECK(right.find(R"("incomplete":0,"unsound":0})") != right.npos);
  CHECK(right.find(R"("findings":[])") != right.npos);

  const auto moved = [&](std::span<const scene::Query> queries) {
    std::vector<scene::Hit> hits(queries.size());
    for (scene::Hit& hit : hits) hit = {model::Resultado::hit, 1, {100, 0, 0}, {*scene.find("a")}};
    return hits;
  };
  const Agreement all = agreement(scene, moved, 3, 7);
  REQUIRE(all.first);
  CHECK(all.first->claimed.punto.x == 100);
  const std::string wrong = agreement_json(all, call);
  for (const char* part :
       {R"("ok":false)", R"({"label":"incomplete","predicate":"where the ray meets)", R"("ray":0,"p":[)",
        R"("claimed":{"outcome":"hit","elementos":["a"],"t":1,"point":[100,0,0]})",
        R"("elementos":[{"id":"a","pointer":"/elementos/1","line":3,"column":1}])"})
    CHECK(wrong.find(part) != wrong.npos);
}
