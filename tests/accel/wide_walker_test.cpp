#include "durero/accel/wide_walker.hpp"

#include <vector>

#include "durero/trace/finding.hpp"
#include "support/catch.hpp"
#include "support/shapes.hpp"

using namespace durero;
using namespace durero::test;
using accel::WideChild;
using accel::WideNode;
using accel::WideWalker;
using Next = WideWalker::Next;

namespace {

void set(WideNode& node, std::size_t place, float low, WideChild child) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    node.planes[axis][place] = axis == 0 ? low : -1;
    node.planes[axis + 3][place] = axis == 0 ? low + 1 : 1;
  }
  node.children[place] = child;
}

/// A root of the element 0 at x = 8 … 9, and of a node at 2 … 3 with the elements 1 and 2 there.
std::vector<WideNode> two_nodes() {
  std::vector<WideNode> nodes(2);
  for (WideNode& node : nodes)
    for (std::size_t plane = 0; plane < 6; ++plane)
      node.planes[plane].fill(static_cast<float>(plane < 3 ? trace::no_limit : -trace::no_limit));
  set(nodes[0], 0, 8, {0, {}, WideChild::Kind::element});
  set(nodes[0], 1, 2, {1, {}, WideChild::Kind::node});
  set(nodes[1], 0, 2.5, {2, {}, WideChild::Kind::element});
  set(nodes[1], 1, 2, {1, {}, WideChild::Kind::element});
  return nodes;
}

std::vector<std::uint32_t> walked(const glm::dvec3& v, double limit, WideWalker::Pace pace,
                                  const glm::dvec3& p = {0, 0, 0}) {
  const std::vector<WideNode> nodes = two_nodes();
  WideWalker walker{trace::Ray(ray(p, v))};
  std::vector<std::uint32_t> elements;
  for (;;) {
    const Next next = walker.advance(nodes.data(), limit, pace);
    if (next == Next::end) return elements;
    if (next == Next::element) elements.push_back(walker.element.index);
  }
}

}  // namespace

TEST_CASE("the nearest box comes first, and none beyond the limit, at either pace") {
  for (const auto pace : {WideWalker::Pace::steady, WideWalker::Pace::by_nodes}) {
    CHECK(walked({1, 0, 0}, trace::no_limit, pace) == std::vector<std::uint32_t>{1, 2, 0});
    CHECK(walked({1, 0, 0}, 8, pace) == std::vector<std::uint32_t>{1, 2, 0});
    CHECK(walked({1, 0, 0}, 7.5, pace) == std::vector<std::uint32_t>{1, 2});
    CHECK(walked({2, 0, 0}, 1, pace) == std::vector<std::uint32_t>{1});
    CHECK(walked({-1, 0, 0}, trace::no_limit, pace).empty());
    CHECK(walked({1, 1, 0}, trace::no_limit, pace).empty());
    CHECK(walked({2, 1, 0}, trace::no_limit, pace) == std::vector<std::uint32_t>{1});
  }
}

TEST_CASE("a ray in the plane of a face, or along an edge, meets the box") {
  const std::vector<std::uint32_t> all{1, 2, 0};
  for (const double zero : {0.0, -0.0})
    for (const glm::dvec3 p : {glm::dvec3(0, 1, 0), glm::dvec3(0, -1, 0), glm::dvec3(0, 0, 1), glm::dvec3(0, 0, -1),
                               glm::dvec3(0, 1, -1), glm::dvec3(0, -1, 1)})
      CHECK(walked({1, zero, zero}, trace::no_limit, WideWalker::Pace::steady, p) == all);
}

TEST_CASE("a walker counts, and starts again") {
  const std::vector<WideNode> nodes = two_nodes();
  WideWalker walker{trace::Ray(ray({0, 0, 0}, {1, 0, 0}))};
  while (walker.advance(nodes.data(), trace::no_limit, WideWalker::Pace::steady) != Next::end) continue;
  CHECK(walker.nodes == 2);
  CHECK(walker.met == 4);
  walker.restart(trace::Ray(ray({20, 0, 0}, {-1, 0, 0})));
  CHECK(walker.advance(nodes.data(), trace::no_limit, WideWalker::Pace::steady) == Next::element);
  CHECK(walker.element.index == 0);
  CHECK(walker.advance(nodes.data(), 12, WideWalker::Pace::steady) == Next::end);
  CHECK(walker.late == 1);
}
