#include "durero/accel/wide/wide_node.hpp"

#include <algorithm>
#include <limits>
#include <vector>

#include "support/catch.hpp"
#include "support/sanitized.hpp"
#include "support/scenes.hpp"
#include "support/shapes.hpp"

using namespace durero;
using namespace durero::test;
using accel::WideNode;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

surface::Box box_at(const WideNode& node, std::size_t place) {
  surface::Box box{};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto axis = static_cast<int>(i);
    box.low[axis] = static_cast<double>(node.planes[i][place]);
    box.high[axis] = static_cast<double>(node.planes[i + 3][place]);
  }
  return box;
}

/// Eight boxes, of which the last holds nothing.
WideNode random_node(Random& random) {
  WideNode node;
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (std::size_t place = 0; place < WideNode::width; ++place) {
      const double low = random.uniform(-10, 10);
      const double size = random.uniform(0, 4);
      node.planes[axis][place] = static_cast<float>(place == 7 ? infinity : low);
      node.planes[axis + 3][place] = static_cast<float>(place == 7 ? -infinity : low + size);
    }
  return node;
}

}  // namespace

namespace {

/// The first eights of a bundle filled with rays about one, in whose directions no component is 0.
void fill(accel::WidePacket& bundle, std::size_t count, Random& random) {
  const glm::dvec3 p = random.in_cube(12), v = random.in_cube(1);
  for (std::size_t place = 0; place < count; ++place) {
    const glm::dvec3 from = p + random.in_cube(0.3);
    bundle.set(place, trace::Ray(ray(from, v + random.in_cube(0.1))),
               place % 3 == 0   ? 5
               : place % 7 == 0 ? -1
                                : infinity);
  }
  invert(bundle, count);
}

accel::Beam beam_at(const accel::WidePacket& bundle, std::size_t place) {
  const auto of = [&](const auto& columns) {
    return glm::dvec3(columns[0][place], columns[1][place], columns[2][place]);
  };
  return accel::Beam(trace::Ray(ray(of(bundle.rays.p), of(bundle.rays.v))));
}

}  // namespace

TEST_CASE("a bundle tests as its rays do, or passes more") {
  Random random(6);
  std::vector<WideNode> nodes(20);
  for (WideNode& node : nodes) node = random_node(random);
  std::size_t gathered = 0;
  for (std::size_t turn = 0; turn < fewer_when_sanitized(300); ++turn) {
    accel::WidePacket bundle;
    fill(bundle, accel::WidePacket::size, random);
    const std::size_t begin = 8 * (turn % 4), end = begin + 8 * (1 + turn % 5);
    if (!gather(bundle, begin, std::min(end, accel::WidePacket::size))) continue;
    ++gathered;
    double farthest = 0;
    for (std::size_t place = bundle.begin; place < bundle.end; ++place)
      farthest = std::max(farthest, bundle.limit[place]);
    CHECK(accel::farthest(bundle) == farthest);
    for (const WideNode& node : nodes) {
      WideNode::Entries entries{};
      const unsigned met = accel::met(node, bundle, infinity, entries);
      accel::WideMeetings together{};
      met_by(node, 0b11101111, bundle, together);
      for (std::size_t child = 0; child < WideNode::width; ++child) {
        std::uint64_t of_each = 0;
        for (std::size_t place = bundle.begin; place < bundle.end; ++place) {
          const double limit = bundle.limit[place];
          const accel::BoxInterval own = stretch(box_at(node, child), beam_at(bundle, place), std::max(limit, 0.0));
          if (limit < 0 || !own.meets()) continue;
          of_each |= std::uint64_t{1} << place;
          CHECK(entries[child] <= own.entry);
        }
        accel::WideMeetings alone{};
        met_by(node, 1u << child, bundle, alone);
        CHECK(alone[child] == of_each);
        if (child != 4) CHECK(together[child] == of_each);
        if (of_each != 0) CHECK((met >> child & 1) != 0);
      }
    }
  }
  CHECK(gathered > fewer_when_sanitized(50));
}

TEST_CASE("a ray of a bundle that moves to another place is tested there as it was") {
  Random random(7);
  const WideNode node = random_node(random);
  accel::WidePacket bundle;
  std::size_t moved = 0;
  for (std::size_t turn = 0; turn < fewer_when_sanitized(3000); ++turn) {
    fill(bundle, 16, random);
    if (!gather(bundle, 0, 16)) continue;
    accel::WideMeetings before{}, after{};
    met_by(node, 0xff, bundle, before);
    const double speed = bundle.rays.speed[13];
    const std::uint64_t start = bundle.rays.start[13] = turn;
    bundle.limit[2] = -1;  // what stood there took part no more
    bundle.move(13, 2);
    CHECK(bundle.rays.speed[2] == speed);
    CHECK(bundle.rays.start[2] == start);
    invert(bundle, 16);
    REQUIRE(gather(bundle, 0, 16));
    met_by(node, 0xff, bundle, after);
    for (std::size_t child = 0; child < WideNode::width; ++child) {
      CHECK((after[child] >> 2 & 1) == (before[child] >> 13 & 1));
      moved += before[child] >> 13 & 1;
    }
  }
  CHECK(moved > fewer_when_sanitized(10));
}

TEST_CASE("rays of other signs, or along a plane of the axes, walk in no bundle") {
  const auto together = [](const glm::dvec3& one, const glm::dvec3& other) {
    accel::WidePacket bundle;
    for (std::size_t place = 0; place < 8; ++place)
      bundle.set(place, trace::Ray(ray({0, 0, 0}, place == 5 ? other : one)), infinity);
    invert(bundle, 8);
    return gather(bundle, 0, 8);
  };
  CHECK_FALSE(together({1, 0, 1}, {1, 0, 1}));
  CHECK_FALSE(together({1, 1, 1}, {1, 1, 0}));
  CHECK_FALSE(together({-0.0, 1, 1}, {-0.0, 1, 1}));
  CHECK(together({1, -1, 1}, {2, -3, 4}));
  CHECK_FALSE(together({1, -1, 1}, {1, 1, 1}));
  CHECK_FALSE(together({1, -1, 1}, {1, -1, -1}));
}
