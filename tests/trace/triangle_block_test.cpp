#include "durero/trace/triangle_block.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <vector>

#include "durero/trace/packet.hpp"
#include "support/catch.hpp"
#include "support/held_block.hpp"
#include "support/scenes.hpp"
#include "support/shapes.hpp"
#include "support/targets.hpp"

using namespace durero;
using namespace durero::test;

namespace {

/// One to eight triangles whose corners are some of so many points of binary32; or three points each, where these are
/// none. Some coordinates are zeros of both signs.
std::vector<scene::Triangle> triangles_of_points(Random& random, std::size_t points) {
  const auto any = [&] {
    glm::dvec3 point(glm::vec3(random.in_cube(1)));
    if (random.uniform(0, 4) < 1) point.x = random.uniform(0, 2) < 1 ? 0.0 : -0.0;
    return point;
  };
  std::vector<glm::dvec3> all;
  while (all.size() < points) all.push_back(any());
  const auto corner = [&] {
    return all.empty() ? any() : all[static_cast<std::size_t>(random.uniform(0, static_cast<double>(points)))];
  };
  std::vector<scene::Triangle> triangles(static_cast<std::size_t>(random.uniform(1, 9)));
  for (scene::Triangle& triangle : triangles) triangle.vertices = {corner(), corner(), corner()};
  return triangles;
}

HeldBlock held_block(const std::vector<scene::Triangle>& triangles) {
  HeldBlock held;
  for (std::size_t lane = 0; lane < triangles.size(); ++lane)
    held.push_back(triangles[lane], static_cast<std::uint32_t>(7 * lane));
  return held;
}

std::array<std::uint64_t, 9> bits_of(const scene::Triangle& triangle) {
  std::array<std::uint64_t, 9> bits{};
  for (std::size_t i = 0; i < 9; ++i)
    bits[i] = std::bit_cast<std::uint64_t>(triangle.vertices[i / 3][static_cast<int>(i % 3)]);
  return bits;
}

/// Whatever points the triangles share, a block gives them back.
void check_blocks_hold_triangles() {
  Random random(1);
  std::size_t shared = 0, apart = 0;
  for (int turn = 0; turn < 400; ++turn) {
    const std::vector<scene::Triangle> triangles = triangles_of_points(random, static_cast<std::size_t>(turn) % 26);
    const HeldBlock held = held_block(triangles);
    const trace::TriangleBlock block = held.view();
    REQUIRE(block.count() == triangles.size());
    ++(block.is_shared() ? shared : apart);
    trace::TriangleBlock::Columns columns;
    trace::unpack(block, columns);
    for (std::size_t lane = 0; lane < trace::TriangleBlock::size; ++lane) {
      CHECK(block.has(lane) == (lane < triangles.size()));
      CHECK((block.lanes() >> lane & 1) == (lane < triangles.size()));
      if (block.has(lane)) {
        CHECK(bits_of(block.triangle(lane)) == bits_of(triangles[lane]));
        CHECK(block.element(lane) == 7 * lane);
      }
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const double in_lane = double{columns[i][axis][lane]};
          if (block.has(lane))
            CHECK(bits_of(block.triangle(lane))[3 * i + axis] == std::bit_cast<std::uint64_t>(in_lane));
          else
            CHECK(std::isnan(in_lane));
        }
    }
  }
  CHECK(shared > 100);
  CHECK(apart > 40);
}

}  // namespace

TEST_CASE("numbers of binary32 are told from others") {
  CHECK(trace::is_single({std::array{glm::dvec3(0.5, -0.0, 1), glm::dvec3(0, 3, 0x1p-100), glm::dvec3(1, 1, 1)}}));
  CHECK_FALSE(trace::is_single({std::array{glm::dvec3(0.5, 0, 1), glm::dvec3(0, 3, 0.1), glm::dvec3(1, 1, 1)}}));
  CHECK_FALSE(trace::is_single({std::array{glm::dvec3(0.5, 0, 1), glm::dvec3(0, 3, 1), glm::dvec3(1, 0x1p128, 1)}}));
}

TEST_CASE("a block holds its triangles bit by bit, with points that are shared or not, under every instruction set") {
  for (const std::int64_t target : machine_targets()) {
    const Only_Target only(target);
    check_blocks_hold_triangles();
  }
}

TEST_CASE("blocks stand behind each other, and take the less the more points they share") {
  Random random(3);
  std::vector<trace::TriangleBlock::Unit> units;
  std::vector<std::size_t> counts, begins;
  for (const std::size_t points : {3, 10, 0, 5, 0}) {
    trace::BlockBuilder builder;
    const std::vector<scene::Triangle> triangles = triangles_of_points(random, points);
    for (const scene::Triangle& triangle : triangles) builder.push_back(triangle, 0);
    counts.push_back(triangles.size());
    begins.push_back(units.size());
    builder.append_to(units);
  }
  units.resize(units.size() + trace::TriangleBlock::room);
  std::vector<std::size_t> found_counts, found;
  const trace::TriangleBlocks blocks(units);
  blocks.for_each([&](std::uint32_t index, const trace::TriangleBlock& block) {
    found.push_back(index);
    found_counts.push_back(block.count());
    CHECK(blocks[index].points() == block.points());
  });
  CHECK(found == begins);
  CHECK(found_counts == counts);
  CHECK_FALSE(blocks.empty());
  CHECK(trace::TriangleBlocks({}).empty());
  const auto units_of = [&](std::size_t points) {
    std::vector<scene::Triangle> triangles;
    while (triangles.size() < 8) triangles = triangles_of_points(random, points);
    return held_block(triangles).view().units();
  };
  CHECK(units_of(0) == 21);  // 4 + 8·4 + 24·12 bytes
  CHECK(units_of(5) == 8);   // 4 + 24 + 8·4 + 5·12 bytes
}

TEST_CASE("the triage of a block has the bits of the triage of pairs, and no finding where there is no triangle") {
  constexpr auto tipo = model::Tipo::soy_triangulo;
  Random random(2);
  std::size_t hits = 0;
  for (int turn = 0; turn < 500; ++turn) {
    const trace::Ray ray(random_ray(random));
    std::vector<scene::Triangle> triangles = triangles_of_points(random, static_cast<std::size_t>(turn) % 2 * 7);
    if (turn % 3 == 0)
      for (scene::Triangle& triangle : triangles) triangle.vertices[0] = glm::dvec3(glm::vec3(ray.p));
    const HeldBlock block = held_block(triangles);
    trace::Packet packet;
    for (std::size_t lane = 0; lane < trace::TriangleBlock::size; ++lane)
      packet.set(lane, ray, triangles[std::min(lane, triangles.size() - 1)]);
    trace::Findings of_block, of_pairs;
    trace::triage(ray, block.view(), of_block);
    trace::triage(packet, tipo, of_pairs);
    const unsigned used = block.view().lanes();
    CHECK(of_block.hit == (of_pairs.hit & used));
    CHECK(of_block.undecided == (of_pairs.undecided & used));
    for (std::size_t lane = 0; lane < trace::TriangleBlock::size; ++lane) {
      if ((of_block.hit >> lane & 1) == 0) continue;
      ++hits;
      CHECK(of_block.t[lane] == of_pairs.t[lane]);
      CHECK(of_block.error[lane] == of_pairs.error[lane]);
    }
  }
  CHECK(hits > 100);
}

TEST_CASE("a name among eight has a lane") {
  const scene::ElementRef first{model::Tipo::soy_triangulo, 16};
  CHECK(trace::lane_of({model::Tipo::soy_triangulo, 16}, first) == 1);
  CHECK(trace::lane_of({model::Tipo::soy_triangulo, 23}, first) == 128);
  CHECK(trace::lane_of({model::Tipo::soy_triangulo, 24}, first) == 0);
  CHECK(trace::lane_of({model::Tipo::soy_triangulo, 15}, first) == 0);
  CHECK(trace::lane_of({model::Tipo::soy_esfera, 16}, first) == 0);
}
