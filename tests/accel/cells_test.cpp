#include "durero/accel/cells.hpp"

#include <set>
#include <string>

#include "accel/both_ways.hpp"
#include "durero/accel/bsp.hpp"
#include "durero/accel/grid.hpp"
#include "durero/accel/octree.hpp"
#include "durero/model/operaciones.hpp"
#include "support/catch.hpp"
#include "support/sanitized.hpp"
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

namespace {

/// One element more or less at random, a dozen of them at most.
void edit(scene::Scene& scene, std::vector<std::string>& names, std::size_t number, Random& random) {
  if (names.size() > 12 || (!names.empty() && random.chance(1, 3))) {
    const std::size_t at = random.below(names.size());
    const scene::ElementRef e = *scene.find(names[at]);
    scene::with_shape(e.tipo, [&]<class Shape>(std::type_identity<Shape>) {
      scene.apply(typename Shape::Removal{model::Elemento(names[at])});
    });
    names.erase(names.begin() + static_cast<std::ptrdiff_t>(at));
  } else {
    names.push_back("n" + std::to_string(number));
    scene.apply(random_addition(random, names.back()));
  }
}

/// These structures are made anew of the edited scene.
void check_after_edits(std::size_t edits) {
  Random random(7);
  scene::Scene scene;
  std::vector<std::string> names;
  for (std::size_t number = 0; number < edits; ++number) {
    edit(scene, names, number, random);
    check_both_ways(accel::Grid(scene));
    check_both_ways(accel::Octree(scene));
    check_both_ways(accel::Bsp(scene));
    check_both_ways(accel::BspMedian(scene));
  }
}

}  // namespace

TEST_CASE("after every edit of a scene the cells of the elements and the elements of the cells agree") {
  check_after_edits(fewer_when_sanitized(500));
}
TEST_CASE("after each of ten thousand edits the cells of the elements and the elements of the cells agree", "[long]") {
  check_after_edits(10'000);
}
