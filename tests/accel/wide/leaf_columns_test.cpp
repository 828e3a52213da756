#include "durero/accel/wide/leaf_columns.hpp"

#include "durero/scene/attributes.hpp"
#include "support/catch.hpp"
#include "support/scenes.hpp"

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
