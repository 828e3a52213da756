#include "durero/accel/wide/leaf_columns.hpp"

#include <cmath>

#include "durero/scene/attributes.hpp"
#include "support/catch.hpp"
#include "support/scenes.hpp"
#include "support/shapes.hpp"

using namespace durero;
using namespace durero::test;
using scene::ElementRef;

TEST_CASE("each leaf is its element, whatever the order in which they came") {
  Random random(1);
  const scene::Scene scene = random_scene(random, 100);
  std::vector<ElementRef> elements;
  scene.for_each([&](ElementRef e, const auto&) { elements.push_back(e); });
  std::reverse(elements.begin(), elements.end());
  accel::LeafColumns leaves;
  leaves.reserve(scene);
  const std::size_t bytes = leaves.bytes();
  for (const ElementRef e : elements) {
    const ElementRef leaf = leaves.push_back(scene, e);
    CHECK(leaf.tipo == e.tipo);
    CHECK(leaves.leaf(e) == leaf);
    CHECK(leaves.element(leaf) == e);
    leaves.visit(leaf, [&]<class Shape>(const Shape& shape) {
      const std::span<const std::byte> row = std::as_bytes(std::span(&shape, 1));
      CHECK(leaves.rows().ends(leaf) == std::pair(&row.front(), &row.back()));
      const Shape& own = scene.shapes<Shape>()[e.index];
      scene::for_each_attribute<Shape>(
          [&](const auto& attribute) { CHECK(shape.*attribute.field == own.*attribute.field); });
    });
  }
  for (const ElementRef e : elements) CHECK(leaves.element(leaves.leaf(e)) == e);
  CHECK(leaves.bytes() == bytes);
  CHECK(bytes >= 100 * (sizeof(scene::Sphere) + 2 * sizeof(std::uint32_t)));
}

TEST_CASE("a triangle of a block has a name, its row and its geometry; an unpacked block is the node over it") {
  scene::Scene scene;
  for (int i = 0; i < 5; ++i)
    add(scene, scene::Triangle{std::array{glm::dvec3(i, 0, -i), glm::dvec3(i + 0.5, 1, 0.25), glm::dvec3(i, 2, 3)}});
  accel::LeafColumns leaves;
  const std::array<std::uint32_t, 3> rows{4, 0, 2};
  accel::LargeVector<accel::LeafColumns::BlockUnit> units;
  trace::BlockBuilder builder;
  builder.push_back(scene.shapes<scene::Triangle>()[1], 1);
  builder.append_to(units);
  const auto block = static_cast<std::uint32_t>(units.size());
  builder = {};
  for (const std::uint32_t row : rows) builder.push_back(scene.shapes<scene::Triangle>()[row], row);
  builder.append_to(units);
  units.resize(units.size() + trace::TriangleBlock::room);
  leaves.reserve(scene, std::move(units));
  const std::size_t bytes = leaves.bytes();
  const ElementRef first = accel::LeafColumns::first_of(block);
  leaves.push_back(scene, ElementRef{model::Tipo::soy_triangulo, 3});
  CHECK(leaves.bytes() == bytes);
  scene.for_each([&](ElementRef e, const auto&) { CHECK(leaves.element(leaves.leaf(e)) == e); });
  accel::WideNode node;
  accel::unpack(leaves.blocks(), block, node);
  CHECK(leaves.blocks()[block].count() == 3);
  for (std::uint32_t lane = 0; lane < 8; ++lane) {
    if (lane >= rows.size()) {
      CHECK(node.children[lane].kind == accel::WideChild::Kind::none);
      CHECK(node.planes[0][lane] == HUGE_VALF);
      CHECK(node.planes[3][lane] == -HUGE_VALF);
      continue;
    }
    const ElementRef leaf{first.tipo, first.index + lane};
    CHECK(leaves.leaf({first.tipo, rows[lane]}) == leaf);
    CHECK(node.children[lane].element() == leaf);
    const auto i = static_cast<float>(rows[lane]);
    CHECK(node.planes[0][lane] == i);
    CHECK(node.planes[2][lane] == -i);
    CHECK(node.planes[3][lane] == i + 0.5F);
    CHECK(node.planes[4][lane] == 2);
    leaves.visit(leaf, [&]<class Shape>(const Shape& shape) {
      if constexpr (std::is_same_v<Shape, scene::Triangle>)
        CHECK(shape.vertices == scene.shapes<scene::Triangle>()[rows[lane]].vertices);
    });
  }
}
