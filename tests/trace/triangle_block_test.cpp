#include "durero/trace/triangle_block.hpp"

#include <cmath>

#include "durero/trace/packet.hpp"
#include "support/catch.hpp"
#include "support/scenes.hpp"
#include "support/shapes.hpp"

using namespace durero;
using namespace durero::test;

namespace {

/// A triangle of binary32 near the origin.
scene::Triangle some_triangle(Random& random) {
  std::array<glm::dvec3, 3> vertices;
  for (glm::dvec3& vertex : vertices) vertex = glm::dvec3(glm::vec3(random.in_cube(1)));
  return {vertices};
}

}  // namespace

TEST_CASE("a block holds the triangles of binary32 as they are") {
  CHECK(trace::is_single({std::array{glm::dvec3(0.5, -0.0, 1), glm::dvec3(0, 3, 0x1p-100), glm::dvec3(1, 1, 1)}}));
  CHECK_FALSE(trace::is_single({std::array{glm::dvec3(0.5, 0, 1), glm::dvec3(0, 3, 0.1), glm::dvec3(1, 1, 1)}}));
  CHECK_FALSE(trace::is_single({std::array{glm::dvec3(0.5, 0, 1), glm::dvec3(0, 3, 1), glm::dvec3(1, 0x1p128, 1)}}));
  Random random(1);
  trace::TriangleBlock block;
  CHECK(block.count() == 0);
  for (const std::size_t lane : {0, 3, 7}) {
    const scene::Triangle triangle = some_triangle(random);
    block.set(lane, triangle, static_cast<std::uint32_t>(10 * lane));
    CHECK(block.has(lane));
    CHECK(block.triangle(lane).vertices == triangle.vertices);
    CHECK(block.elements[lane] == 10 * lane);
  }
  CHECK(block.count() == 3);
  CHECK_FALSE(block.has(1));
}

TEST_CASE("the triage of a block has the bits of the triage of pairs, and no finding where there is no triangle") {
  constexpr auto tipo = model::Tipo::soy_triangulo;
  Random random(2);
  std::size_t hits = 0;
  for (int turn = 0; turn < 500; ++turn) {
    const trace::Ray ray(random_ray(random));
    trace::TriangleBlock block;
    trace::Packet packet;
    const unsigned used = 1 + static_cast<unsigned>(turn) % 255;
    for (std::size_t lane = 0; lane < trace::TriangleBlock::size; ++lane) {
      scene::Triangle triangle = some_triangle(random);
      if (turn % 3 == 0) triangle.vertices[0] = glm::dvec3(glm::vec3(ray.p));
      packet.set(lane, ray, triangle);
      if ((used >> lane & 1) != 0) block.set(lane, triangle, 0);
    }
    trace::Findings of_block, of_pairs;
    trace::triage(ray, block, of_block);
    trace::triage(packet, tipo, of_pairs);
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
