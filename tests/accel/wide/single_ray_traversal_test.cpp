#include "durero/accel/wide/single_ray_traversal.hpp"

#include <algorithm>
#include <vector>

#include "durero/conform/random.hpp"
#include "durero/trace/finding.hpp"
#include "support/catch.hpp"
#include "support/shapes.hpp"

using namespace durero;
using namespace durero::test;
using accel::SingleRayTraversal;
using accel::WideChild;
using accel::WideNode;
using Next = SingleRayTraversal::Next;

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

std::vector<std::uint32_t> walked(const glm::dvec3& v, double limit, const glm::dvec3& p = {0, 0, 0}) {
  const std::vector<WideNode> nodes = two_nodes();
  SingleRayTraversal walker{trace::Ray(ray(p, v))};
  std::vector<std::uint32_t> elements;
  while (walker.advance(nodes.data(), trace::TriangleBlocks({}), limit) != Next::end)
    elements.push_back(walker.element.index);
  return elements;
}

}  // namespace

TEST_CASE("the nearest box comes first, and none beyond the limit") {
  CHECK(walked({1, 0, 0}, trace::no_limit) == std::vector<std::uint32_t>{1, 2, 0});
  CHECK(walked({1, 0, 0}, 8) == std::vector<std::uint32_t>{1, 2, 0});
  CHECK(walked({1, 0, 0}, 7.5) == std::vector<std::uint32_t>{1, 2});
  CHECK(walked({2, 0, 0}, 1) == std::vector<std::uint32_t>{1});
  CHECK(walked({-1, 0, 0}, trace::no_limit).empty());
  CHECK(walked({-1, 0, 0}, trace::no_limit, {20, 0, 0}) == std::vector<std::uint32_t>{0, 2, 1});
  CHECK(walked({1, 1, 0}, trace::no_limit).empty());
  CHECK(walked({2, 1, 0}, trace::no_limit) == std::vector<std::uint32_t>{1});
}

TEST_CASE("walkers that open their nodes side by side go on as each alone") {
  const std::vector<WideNode> nodes = two_nodes();
  std::vector<SingleRayTraversal> walkers;
  const std::vector<glm::dvec3> from{{0, 0, 0}, {4, 0, 0}, {0, 5, 0}, {1, 0, 0}, {2.25, 0, 0}, {9.5, 0, 0}};
  const auto v = [&](std::size_t i) { return glm::dvec3(i + 1 < from.size() ? 1 : -1, 0, 0); };
  for (std::size_t i = 0; i < from.size(); ++i) walkers.emplace_back(trace::Ray(ray(from[i], v(i))));
  std::vector<std::vector<std::uint32_t>> elements(walkers.size());
  const double limit = 7;
  std::vector<SingleRayTraversal*> at_nodes{&walkers[0]};  // which is one node ahead of the others
  CHECK(walkers[0].next(limit) == Next::node);
  open(nodes.data(), at_nodes);
  do {
    at_nodes.clear();
    for (std::size_t i = 0; i < walkers.size(); ++i) {
      Next next = walkers[i].next(limit);
      for (; next == Next::element; next = walkers[i].next(limit)) elements[i].push_back(walkers[i].element.index);
      if (next == Next::node) at_nodes.push_back(&walkers[i]);
    }
    open(nodes.data(), at_nodes);
  } while (!at_nodes.empty());
  for (std::size_t i = 0; i < walkers.size(); ++i) CHECK(elements[i] == walked(v(i), limit, from[i]));
  CHECK(elements[0] == std::vector<std::uint32_t>{1, 2});
  CHECK(elements[1] == std::vector<std::uint32_t>{0});
  CHECK(elements[2].empty());
  CHECK(elements[5] == std::vector<std::uint32_t>{0, 2, 1});
}

TEST_CASE("a ray in the plane of a face, or along an edge, meets the box") {
  const std::vector<std::uint32_t> all{1, 2, 0};
  for (const double zero : {0.0, -0.0})
    for (const glm::dvec3 p : {glm::dvec3(0, 1, 0), glm::dvec3(0, -1, 0), glm::dvec3(0, 0, 1), glm::dvec3(0, 0, -1),
                               glm::dvec3(0, 1, -1), glm::dvec3(0, -1, 1)})
      CHECK(walked({1, zero, zero}, trace::no_limit, p) == all);
}

TEST_CASE("a walker comes to the children whose boxes the test of one box passes, and to no others") {
  conform::Random random(7);
  const auto corner = [&] {
    const int x = random.integer(-3, 3), y = random.integer(-3, 3), z = random.integer(-3, 3);
    return glm::dvec3(x, y, z);
  };
  for (int turn = 0; turn < 3000; ++turn) {
    std::vector<WideNode> nodes(1);
    std::vector<surface::Box> boxes;
    for (std::uint32_t place = 0; place < WideNode::width; ++place) {
      const glm::dvec3 low = corner(), size = random.chance(1, 2) ? glm::dvec3(1, 0, 2) : glm::dvec3(1.5, 2, 0.25);
      boxes.push_back({low, low + size});
      for (std::size_t axis = 0; axis < 3; ++axis) {
        nodes[0].planes[axis][place] = static_cast<float>(boxes[place].low[static_cast<int>(axis)]);
        nodes[0].planes[axis + 3][place] = static_cast<float>(boxes[place].high[static_cast<int>(axis)]);
      }
      nodes[0].children[place] = {place, {}, WideChild::Kind::element};
    }
    const glm::dvec3 v = random.lattice_vector(2), p = random.chance(1, 2) ? corner() : random.in_cube(4);
    const trace::Ray traced(ray(p, random.chance(1, 2) ? v : -v));  // with zeros of either sign
    for (const double limit : {0.0, 0.5, 1.0, 2.5, trace::no_limit}) {
      std::vector<std::uint32_t> one_by_one, walked;
      for (std::uint32_t place = 0; place < WideNode::width; ++place)
        if (stretch(boxes[place], accel::Beam(traced), limit).meets()) one_by_one.push_back(place);
      SingleRayTraversal walker(traced);
      while (walker.advance(nodes.data(), trace::TriangleBlocks({}), limit) != Next::end)
        walked.push_back(walker.element.index);
      std::ranges::sort(walked);
      INFO("turn " << turn << ", up to " << limit);
      CHECK(walked == one_by_one);
    }
  }
}

TEST_CASE("a walker counts, and starts again") {
  const std::vector<WideNode> nodes = two_nodes();
  SingleRayTraversal walker{trace::Ray(ray({0, 0, 0}, {1, 0, 0}))};
  while (walker.advance(nodes.data(), trace::TriangleBlocks({}), trace::no_limit) != Next::end) continue;
  CHECK(walker.nodes == 2);
  CHECK(walker.met == 4);
  walker.restart(trace::Ray(ray({20, 0, 0}, {-1, 0, 0})));
  CHECK(walker.advance(nodes.data(), trace::TriangleBlocks({}), trace::no_limit) == Next::element);
  CHECK(walker.element.index == 0);
  CHECK(walker.advance(nodes.data(), trace::TriangleBlocks({}), 12) == Next::end);
  CHECK(walker.late == 1);
}
