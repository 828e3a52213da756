#include "durero/accel/hierarchy.hpp"

#include <array>
#include <tuple>
#include <vector>

#include "durero/number/rational.hpp"
#include "support/catch.hpp"

using namespace durero;
using accel::Hierarchy;
using number::Rational;

namespace {

scene::ElementRef sphere(std::uint32_t i) { return {model::Tipo::soy_esfera, i}; }

surface::Box box(const glm::dvec3& low, const glm::dvec3& size) { return {low, low + size}; }

/// Leaves in a row along the x axis within a box: the box of their parent is that box.
Hierarchy::Number group(Hierarchy& tree, const surface::Box& box, int leaves) {
  std::vector<Hierarchy::Number> children;
  const double step = (box.high.x - box.low.x) / leaves;
  for (int i = 0; i < leaves; ++i) {
    surface::Box part = box;
    part.low.x += i * step;
    part.high.x = i + 1 < leaves ? part.low.x + step : box.high.x;
    children.push_back(tree.leaf(sphere(std::uint32_t(i)), part));
  }
  return tree.join(children);
}

std::vector<Hierarchy::Number> children(const Hierarchy& tree, Hierarchy::Number node) {
  std::vector<Hierarchy::Number> all;
  tree.any_child(node, [&](Hierarchy::Number child) {
    all.push_back(child);
    return false;
  });
  return all;
}

}  // namespace

TEST_CASE("the cost of a hierarchy is that of the worked example") {
  Hierarchy tree;
  const std::array both{group(tree, box({0, 0, 0}, {2, 2, 2}), 3), group(tree, box({0, 3, 3}, {4, 1, 1}), 2)};
  const Hierarchy::Number root = tree.join(both);
  tree.set_root(root);
  CHECK(tree[root].box.high == glm::dvec3(4, 4, 4));
  CHECK(accel::area<Rational>(tree[root].box) == 96);
  CHECK(accel::weight<Rational>(tree) == 2 * 96 + 3 * 24 + 2 * 18);
  CHECK(accel::weight<Rational>(tree) / accel::area<Rational>(tree[root].box) == Rational(3125, 1000));
  CHECK(tree.inner_nodes() == 3);
  CHECK(tree.depth() == 2);
  CHECK(tree[root].leaves == 5);
}

TEST_CASE("nothing costs nothing, and a leaf neither") {
  Hierarchy tree;
  CHECK(tree.empty());
  CHECK(accel::weight<Rational>(tree) == 0);
  tree.set_root(tree.leaf(sphere(0), box({0, 0, 0}, {1, 1, 1})));
  CHECK(accel::weight<Rational>(tree) == 0);
  CHECK(tree.inner_nodes() == 0);
  CHECK(tree.depth() == 0);
  tree.take_out(tree.root());
  CHECK(tree.empty());
}

TEST_CASE("a leaf is put under a node or beside one, and boxes and numbers above follow") {
  Hierarchy tree;
  tree.set_root(group(tree, box({0, 0, 0}, {3, 1, 1}), 3));
  const Hierarchy::Number root = tree.root(), some = tree[root].child;
  tree.put_under(root, tree.leaf(sphere(3), box({0, 0, 1}, {1, 1, 1})));
  CHECK(tree[root].arity == 4);
  CHECK(tree[root].leaves == 4);
  CHECK(tree[root].box.high == glm::dvec3(3, 1, 2));
  const Hierarchy::Number added = tree.leaf(sphere(4), box({0, 0, 4}, {1, 1, 1}));
  tree.put_beside(some, added);
  const Hierarchy::Number both = tree[added].parent;
  CHECK(tree[some].parent == both);
  CHECK(tree[both].parent == root);
  CHECK(tree[both].leaves == 2);
  CHECK(tree[root].leaves == 5);
  CHECK(tree[root].arity == 4);
  CHECK(tree[root].box.high.z == 5);
  tree.put_beside(root, tree.leaf(sphere(5), box({9, 0, 0}, {1, 1, 1})));
  CHECK(tree.root() != root);
  CHECK(tree[root].parent == tree.root());
  CHECK(tree[tree.root()].parent == Hierarchy::none);
  CHECK(tree[tree.root()].leaves == 6);
  CHECK(tree[tree.root()].box.high == glm::dvec3(10, 1, 5));
}

TEST_CASE("boxes shrink when a leaf is taken out or has another box, and an only child takes its parent's place") {
  Hierarchy tree;
  const Hierarchy::Number pair = group(tree, box({0, 0, 0}, {2, 1, 1}), 2),
                          far = tree.leaf(sphere(2), box({5, 0, 0}, {1, 1, 1}));
  tree.set_root(tree.join(std::array{pair, far}));
  const Hierarchy::Number root = tree.root();
  tree.refit(far, box({3, 0, 0}, {1, 1, 1}));
  CHECK(tree[root].box.high.x == 4);
  const std::vector<Hierarchy::Number> both = children(tree, pair);
  tree.take_out(both[0]);
  CHECK(tree[both[1]].parent == root);
  CHECK(tree[root].arity == 2);
  CHECK(tree[root].leaves == 2);
  CHECK(tree.inner_nodes() == 1);
  tree.take_out(far);
  CHECK(tree.root() == both[1]);
  CHECK(tree[both[1]].parent == Hierarchy::none);
  CHECK(tree.leaf(sphere(7), box({0, 0, 0}, {1, 1, 1})) < 6);  // a number that is free again
}

TEST_CASE("boxes shrink when one leaf of three is taken out") {
  Hierarchy tree;
  const Hierarchy::Number three = group(tree, box({0, 0, 0}, {3, 1, 1}), 3);
  tree.set_root(tree.join(std::array{three, tree.leaf(sphere(3), box({0, 0, 0}, {1, 1, 1}))}));
  tree.any_child(three, [&](Hierarchy::Number leaf) {
    const bool last = tree[leaf].box.high.x == 3;
    if (last) tree.take_out(leaf);
    return last;
  });
  CHECK(tree[three].box.high.x == 2);
  CHECK(tree[three].leaves == 2);
  CHECK(tree[tree.root()].box.high.x == 2);
  CHECK(tree[tree.root()].leaves == 3);
}

TEST_CASE("children of a node that gives way are its parent's") {
  Hierarchy tree;
  const Hierarchy::Number pair = group(tree, box({0, 0, 0}, {2, 1, 1}), 2),
                          far = tree.leaf(sphere(2), box({5, 0, 0}, {1, 1, 1}));
  tree.set_root(tree.join(std::array{pair, far}));
  const std::vector<Hierarchy::Number> both = children(tree, pair);
  tree.dissolve(pair);
  CHECK(tree[tree.root()].arity == 3);
  CHECK(tree[tree.root()].leaves == 3);
  for (const Hierarchy::Number leaf : both) CHECK(tree[leaf].parent == tree.root());
  CHECK(tree.depth() == 1);
}

TEST_CASE("arranged, it is the same tree, without gaps, and the children of a node stand together") {
  Hierarchy tree;
  std::vector<Hierarchy::Number> all;
  for (int i = 0; i < 4; ++i) all.push_back(group(tree, box({0, 3.0 * i, 0}, {2, 2, 2}), 2 + i));
  tree.set_root(tree.join(all));
  tree.dissolve(all[1]);
  tree.take_out(tree[all[3]].child);
  // Of each node, in the order of the tree: its box, and what it is.
  const auto described = [&] {
    std::vector<std::tuple<double, double, std::uint32_t, std::uint32_t, std::uint32_t>> nodes;
    tree.for_each([&](const Hierarchy::Node& node) {
      nodes.emplace_back(node.box.low.x, node.box.high.y, node.arity, node.leaves, node.element.index);
    });
    return nodes;
  };
  const auto before = described();
  tree.arrange();
  CHECK(described() == before);
  CHECK(tree.numbers() == before.size());
  CHECK(tree.inner_nodes() == 4);
  CHECK(tree[tree.root()].parent == Hierarchy::none);
  for (Hierarchy::Number node = 0; node < tree.numbers(); ++node) {
    const std::vector<Hierarchy::Number> family = children(tree, node);
    CHECK(family.size() == tree[node].arity);
    for (std::size_t i = 0; i < family.size(); ++i) {
      CHECK(family[i] == family[0] + i);
      CHECK(tree[family[i]].parent == node);
    }
  }
  // Edits go on.
  tree.put_under(tree.root(), tree.leaf(sphere(9), box({0, 0, 5}, {1, 1, 1})));
  CHECK(tree[tree.root()].box.high.z == 6);
  Hierarchy none;
  none.arrange();
  CHECK(none.empty());
}
