#include "durero/accel/cells.hpp"

#include <set>

#include "support/catch.hpp"
#include "support/scenes.hpp"
#include "support/shapes.hpp"

using namespace durero;
using namespace durero::test;
using accel::Lists;
using accel::Mailbox;

TEST_CASE("a mailbox takes each element once, however many there are") {
  Random random(1);
  for (const std::size_t count : {10, 31, 32, 33, 200, 20000}) {
    Mailbox mailbox;
    std::set<std::uint32_t> noted;
    for (std::size_t i = 0; i < count * 3; ++i) {
      const auto element = static_cast<std::uint32_t>(random.below(count) * 64);
      REQUIRE(mailbox.note(element) == noted.insert(element).second);
    }
  }
}

TEST_CASE("the elements of the cells and the cells of the elements are the same references") {
  const std::vector<accel::Reference> references{{0, 2}, {0, 3}, {1, 2}, {3, 0}, {3, 2}};
  const Lists cells = Lists::elements_of_cells(references, 5), elements = Lists::cells_of_elements(references, 4);
  CHECK(std::vector(cells[2].begin(), cells[2].end()) == std::vector<std::uint32_t>{0, 1, 3});
  CHECK(cells[1].empty());
  CHECK(cells[4].empty());
  CHECK(std::vector(elements[0].begin(), elements[0].end()) == std::vector<std::uint32_t>{2, 3});
  CHECK(elements[2].empty());
  CHECK(cells.rows() == 5);
  CHECK(cells.references() == 5);
  CHECK(cells.inverse(4) ==
        Lists::cells_of_elements(std::vector<accel::Reference>{{0, 2}, {0, 3}, {1, 2}, {3, 0}, {3, 2}}, 4));
  CHECK(cells.inverse(4).inverse(5) == cells);
}

TEST_CASE("what is not ordinary, and what has no finite box, is kept apart") {
  scene::Scene scene;
  add(scene, scene::Sphere{{1, 2, 3}, 1});
  add(scene, scene::Plane{{0, 0, 0}, {0, 0, 1}});
  add(scene, scene::Sphere{{0, 0, 0}, 1e-40});
  add(scene, scene::Sphere{{0, 0, 0}, 0.5});
  const accel::Contents contents(scene);
  CHECK(contents.elements.size() == 2);
  CHECK(contents.apart.size() == 2);
  CHECK(contents.box.low.x < -0.5);
  CHECK(contents.box.high.z > 4);
  CHECK(accel::Contents(scene::Scene()).elements.empty());
}
