#include "durero/accel/wide/packet_eights.hpp"

#include <algorithm>
#include <limits>

#include "support/catch.hpp"
#include "support/scenes.hpp"
#include "support/shapes.hpp"

using namespace durero;
using namespace durero::test;
using accel::WideNode;
using accel::WidePacket;
using accel::WidePacketEights;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

WideNode random_node(Random& random) {
  WideNode node;
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (std::size_t place = 0; place < WideNode::width; ++place) {
      const double low = random.uniform(-10, 10);
      node.planes[axis][place] = static_cast<float>(low);
      node.planes[axis + 3][place] = static_cast<float>(low + random.uniform(0, 4));
    }
  return node;
}

/// Rays about one in eights that lie apart, some of which reach less far, and some no way at all.
void fill(WidePacket& bundle, std::size_t count, Random& random) {
  const glm::dvec3 p = random.in_cube(12), v = random.in_cube(1);
  glm::dvec3 about{};
  for (std::size_t place = 0; place < count; ++place) {
    if (place % 8 == 0) about = random.in_cube(1);
    const double limit = place % 3 == 0 ? 9 : place % 7 == 0 || place / 8 == 2 ? -1 : place % 5 == 0 ? infinity : 6;
    const glm::dvec3 from = p + about + random.in_cube(0.1), along = v + random.in_cube(0.1);
    bundle.set(place, trace::Ray(ray(from, along)), limit);
  }
  invert(bundle, count);
}

std::uint64_t met_by_rays(const WideNode& node, std::size_t child, const WidePacket& bundle) {
  accel::WideMeetings met{};
  met_by(node, 1u << child, bundle, met);
  return met[child];
}

double greatest_limit(const WidePacket& bundle, std::size_t eight) {
  return *std::max_element(&bundle.limit[8 * eight], &bundle.limit[8 * eight] + 8);
}

}  // namespace

TEST_CASE("by eights the rays of a bundle meet the boxes that each of them meets, also once their limits have fallen") {
  Random random(16);
  std::size_t gathered = 0, met = 0;
  for (std::size_t turn = 0; turn < 2000; ++turn) {
    WidePacket bundle;
    const std::size_t count = 8 * (1 + turn % 8);
    fill(bundle, count, random);
    if (!gather(bundle, 0, count)) continue;
    ++gathered;
    WidePacketEights eights;
    gather(eights, bundle);
    const WideNode node = random_node(random);
    for (int falls = 0; falls < 4; ++falls) {
      for (std::size_t child = 0; child < WideNode::width; ++child) {
        const std::uint64_t expected = met_by_rays(node, child, bundle);
        met += expected != 0;
        CHECK(met_by(node, child, bundle, eights) == expected);
      }
      std::uint64_t which = 0;
      for (std::size_t place = 0; place < count; ++place)
        if (random.integer(0, 2) == 0) {
          bundle.limit[place] = std::min(bundle.limit[place], random.uniform(-3, 8));
          which |= std::uint64_t{1} << place;
        }
      CHECK(bring_up_to_date(eights, bundle, which) == accel::farthest(bundle));
      for (std::size_t eight = 0; eight < count / 8; ++eight)
        CHECK(eights.limit[eight] == greatest_limit(bundle, eight));
    }
  }
  CHECK(gathered > 300);
  CHECK(met > 300);
}

TEST_CASE("an eight lies between the ends of its own rays, and those that do not walk take no part") {
  Random random(17);
  WidePacket bundle;
  do fill(bundle, 40, random);
  while (!gather(bundle, 0, 40));
  WidePacketEights eights;
  gather(eights, bundle);
  for (std::size_t eight = 0; eight < WidePacketEights::most; ++eight) {
    if (eight >= 5) {
      CHECK(eights.limit[eight] < 0);
      continue;
    }
    CHECK(eights.limit[eight] == greatest_limit(bundle, eight));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto [low, high] =
          std::minmax_element(&bundle.rays.p[axis][8 * eight], &bundle.rays.p[axis][8 * eight] + 8);
      CHECK(eights.p_low[axis][eight] == *low);
      CHECK(eights.p_high[axis][eight] == *high);
      const auto [least, most] =
          std::minmax_element(&bundle.inverse[axis][8 * eight], &bundle.inverse[axis][8 * eight] + 8);
      CHECK(eights.inverse_low[axis][eight] == *least);
      CHECK(eights.inverse_high[axis][eight] == *most);
    }
  }
}
