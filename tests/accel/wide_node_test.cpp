#include "durero/accel/wide_node.hpp"

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

TEST_CASE("a bundle tests as its rays do, or passes more") {
  Random random(6);
  std::vector<WideNode> nodes(20);
  for (WideNode& node : nodes) node = random_node(random);
  for (std::size_t turn = 0; turn < fewer_when_sanitized(200); ++turn) {
    accel::WideBundle bundle;
    const glm::dvec3 p = random.in_cube(12), v = random.in_cube(1);
    while (bundle.count < 1 + turn % accel::WideBundle::size) {
      const glm::dvec3 from = p + random.in_cube(0.3);
      const accel::Beam beam{trace::Ray(ray(from, v + random.in_cube(0.1)))};
      if (!bundle.takes(beam)) continue;
      bundle.limit[bundle.count] = bundle.count % 3 == 0 ? 5 : infinity;
      bundle.push(beam);
    }
    for (const WideNode& node : nodes) {
      WideNode::Entries entries{};
      const unsigned met = accel::met(node, bundle, infinity, entries);
      for (std::size_t place = 0; place < WideNode::width; ++place) {
        std::uint64_t of_each = 0;
        for (std::size_t i = 0; i < bundle.count; ++i) {
          accel::Beam beam{trace::Ray(ray({0, 0, 0}, {1, 1, 1}))};
          beam.p = {bundle.p[0][i], bundle.p[1][i], bundle.p[2][i]};
          beam.inverse = {bundle.inverse[0][i], bundle.inverse[1][i], bundle.inverse[2][i]};
          const accel::Stretch own = stretch(box_at(node, place), beam, bundle.limit[i]);
          if (!own.meets()) continue;
          of_each |= std::uint64_t{1} << i;
          CHECK(entries[place] <= own.entry);
        }
        CHECK(met_by(node, place, bundle) == of_each);
        if (of_each != 0) CHECK((met >> place & 1) != 0);
      }
    }
  }
}

TEST_CASE("rays of other signs, or along a plane of the axes, are in no bundle") {
  const auto beam = [](const glm::dvec3& v) { return accel::Beam(trace::Ray(ray({0, 0, 0}, v))); };
  accel::WideBundle bundle;
  CHECK_FALSE(bundle.takes(beam({1, 0, 1})));
  CHECK_FALSE(bundle.takes(beam({-0.0, 1, 1})));
  bundle.push(beam({1, -1, 1}));
  CHECK(bundle.takes(beam({2, -3, 4})));
  CHECK_FALSE(bundle.takes(beam({1, 1, 1})));
  CHECK_FALSE(bundle.takes(beam({1, -1, -1})));
}
