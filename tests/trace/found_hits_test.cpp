#include "durero/trace/found_hits.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <vector>

#include "durero/surface/exact.hpp"
#include "support/catch.hpp"
#include "support/held_block.hpp"
#include "support/scenes.hpp"
#include "support/shapes.hpp"

using namespace durero;
using namespace durero::test;
using scene::ElementRef;
using trace::SingleRays;

namespace {

constexpr std::uint32_t first_name = 1u << 31;  // of the source's triangles

glm::dvec3 single(const glm::dvec3& x) {
  const auto of = [](double a) { return static_cast<double>(static_cast<float>(a)); };
  return {of(x.x), of(x.y), of(x.z)};
}

/// Triangles in blocks, and a query for each.
struct Aimed {
  scene::Scene scene{};
  std::vector<HeldBlock> blocks{};
  std::vector<scene::Query> queries{};

  trace::TriangleBlock block(std::uint32_t name) const { return blocks[(name - first_name) / 8].view(); }

  void put(const std::array<glm::dvec3, 3>& vertices, const glm::dvec3& p, const glm::dvec3& v) {
    const auto number = static_cast<std::uint32_t>(queries.size());
    if (number % 8 == 0) blocks.emplace_back();
    blocks.back().push_back({vertices}, number);
    add(scene, scene::Triangle{vertices});
    queries.push_back({ray(p, v)});
  }
};

/// The hits of all queries on their triangles, and misses for others, by bundles that are told what is met.
std::vector<scene::Hit> written(const Aimed& aimed, const std::vector<bool>& met, scene::Hit before) {
  std::vector<scene::Hit> hits(aimed.queries.size(), before);
  trace::FoundHits found(aimed.scene, aimed.queries, hits);
  for (std::size_t first = 0; first < hits.size(); first += SingleRays::size) {
    SingleRays rays;
    for (std::size_t i = first; i < std::min(first + SingleRays::size, hits.size()); ++i)
      rays.push(aimed.queries[i].rayo.p().xyz(), aimed.queries[i].rayo.v().xyz(), SingleRays::none);
    REQUIRE(round_to_single(rays));
    const std::uint64_t all = rays.open;
    for (std::size_t place = 0; place < rays.count; ++place) {
      rays.nearest[place] = first_name + static_cast<std::uint32_t>(first + place);
      if (met[first + place]) rays.low[place] = 0;
    }
    found.answer(static_cast<std::uint32_t>(first), rays, all, aimed);
  }
  return hits;
}

void check_rounded(const Aimed& aimed, const std::vector<bool>& met, const scene::Hit& before) {
  const std::vector<scene::Hit> hits = written(aimed, met, before);
  for (std::uint32_t i = 0; i < hits.size(); ++i) {
    CAPTURE(i);
    const ElementRef e{model::Tipo::soy_triangulo, i};
    if (!met[i]) {
      CHECK(hits[i] == scene::Hit{});
      continue;
    }
    const auto t = surface::exact::reach(aimed.scene, e, aimed.queries[i].rayo, {}).first();
    CHECK(hits[i] == surface::exact::rounded_hit(aimed.queries[i].rayo, t, {e}));
  }
}

/// Triangles with rays at them, a fifth at a vertex, where binary64 leaves open whether they hit; then rays whose t is
/// halfway between two numbers of binary64, which only exact arithmetic tells; then origins beside 0 that are not
/// ordinary.
Aimed aimed_at_random() {
  Random random(7);
  Aimed aimed;
  for (int i = 0; i < 135; ++i) {
    const std::array vertices{single(random.in_cube(1)), single(random.in_cube(1)), single(random.in_cube(1))};
    const glm::dvec3 p = random.in_cube(3);
    const glm::dvec3 at = i % 5 == 0 ? vertices[1] : (vertices[0] + vertices[1] + vertices[2]) / 3.0;
    aimed.put(vertices, p, at - p);
  }
  for (const double k : {1.0, 3.0, 5.0, 7.0}) {
    const double half = 0x1p-53 * std::exp2(std::floor(std::log2(k)));
    aimed.put({glm::dvec3(-9, -9, 3 * k), {9, -9, 3 * k}, {0, 9, 3 * k}}, {0.1, 0.2, -3 * half}, {0.125, 0.25, 3});
  }
  for (const double tiny : {0x1p-900, 0x1p-1074, -0x1p-1060, 0.0}) {
    const std::array across{glm::dvec3(-1, 0, 0), glm::dvec3(1, 0, 0), glm::dvec3(0, 0x1p-90, 0x1p-90)};
    aimed.put(across, {tiny, 0x1p-92, 0.25}, {tiny, 0, -1});
    aimed.put({glm::dvec3(-1, -1, 0), {1, -1, 0}, {0, 1, 0x1p-95}}, {tiny, tiny, -tiny}, {0x1p-20, 0, 0x1p-29});
  }
  for (scene::Query& query : aimed.queries)
    if (query.rayo.v().x() != 0 && std::abs(query.rayo.v().x()) < 1 / SingleRays::range)
      query.rayo = ray(query.rayo.p().xyz(), {0, 0, -1});
  return aimed;
}

}  // namespace

TEST_CASE("hits whose triangles are known are rounded once, those that lanes cannot decide as well") {
  const Aimed aimed = aimed_at_random();
  std::vector<bool> met;
  for (std::uint32_t i = 0; i < aimed.queries.size(); ++i)
    met.push_back(
        !surface::exact::reach(aimed.scene, {model::Tipo::soy_triangulo, i}, aimed.queries[i].rayo, {}).empty());
  CHECK(std::ranges::count(met, true) > 110);
  check_rounded(aimed, met, {});
  // What stood in the places is written over, whatever it was.
  const scene::Hit before{model::Resultado::no_minimum, 5, {1, 2, 3}, {{model::Tipo::soy_cono, 1}, {}, {}}};
  std::vector<bool> some = met;
  for (std::size_t i = 0; i < some.size(); i += 3) some[i] = false;
  check_rounded(aimed, some, before);
}

TEST_CASE("most hits of ordinary rays are certain in lanes") {
  const Aimed aimed = aimed_at_random();
  SingleRays rays;
  trace::HitTriangles triangles;
  trace::RoundedRays rounded;
  std::uint64_t inner = 0;
  for (std::size_t place = 0; place < SingleRays::size; ++place) {
    rays.push(aimed.queries[place].rayo.p().xyz(), aimed.queries[place].rayo.v().xyz(), SingleRays::none);
    triangles.set(place, aimed.blocks[place / 8].view(), place % 8);
    if (place % 5 != 0) inner |= SingleRays::bit(place);
  }
  REQUIRE(round_to_single(rays));
  round_hits(rays, triangles, inner, rounded);
  CHECK(std::popcount(rounded.certain) + 2 > std::popcount(inner));
  CHECK((rounded.certain & ~inner) == 0);
}

TEST_CASE("a hit from an origin that is not ordinary is not certain in lanes") {
  SingleRays rays;
  trace::HitTriangles triangles;
  trace::RoundedRays rounded;
  HeldBlock block;
  block.push_back({{glm::dvec3(-1, -1, 0), {1, -1, 0}, {0, 1, 0}}}, 0);
  for (const double x : {0.0, 0x1p-100, 0x1p-101, -0x1p-900}) {
    triangles.set(rays.count, block.view(), 0);
    rays.push({x, 0, 0.25}, {0, 0, -1}, SingleRays::none);
  }
  REQUIRE(round_to_single(rays));
  round_hits(rays, triangles, rays.open, rounded);
  CHECK(rounded.certain == 0b0011);
}
