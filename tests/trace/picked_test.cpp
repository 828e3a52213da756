#include "durero/trace/picked.hpp"

#include <vector>

#include "durero/trace/tables.hpp"
#include "support/catch.hpp"
#include "support/shapes.hpp"

using namespace durero;
using namespace durero::test;

TEST_CASE("entries are picked by an order, or as they stand where there is none") {
  std::vector<int> all{10, 11, 12, 13, 14};
  const std::vector<std::uint32_t> order{4, 2, 0, 1, 3};
  const auto by_order = trace::picked(std::span(all), order, 1, 3), standing = trace::picked(std::span(all), {}, 1, 3);
  REQUIRE(by_order.size() == 3);
  REQUIRE(standing.size() == 3);
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(by_order[i] == 10 + static_cast<int>(order[1 + i]));
    CHECK(standing[i] == 11 + static_cast<int>(i));
  }
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(by_order.place(i) == order[1 + i]);
    CHECK(standing.place(i) == i);
  }
  const std::vector<std::uint32_t> others{0, 3};
  CHECK(by_order.at_places(others).size() == 2);
  CHECK(by_order.at_places(others)[1] == 13);
  by_order[0] = 7;
  CHECK(all == std::vector{10, 11, 7, 13, 14});
}

TEST_CASE("an ordinary ray is told the one element that it starts on, where none of the scene is extraordinary") {
  for (const bool some_extraordinary : {false, true}) {
    scene::Scene scene;
    const scene::ElementRef first = add(scene, scene::Sphere{{0, 0, 0}, 1}),
                            second = add(scene, scene::Sphere{{2, 0, 0}, 1});
    if (some_extraordinary) add(scene, scene::Sphere{{0, 0, 0}, 0x1p120});
    const model::Rayo rayo = ray({1, 0, 0}, {1, 0, 0}), far = ray({1, 0, 0}, {0x1p120, 0, 0});
    std::vector<scene::Query> queries;
    for (int i = 0; i < 40; ++i)  // more than memory is asked for ahead of time
      queries.insert(queries.end(),
                     {{rayo}, {rayo, {first}}, {rayo, {second}}, {rayo, {first, second}}, {far, {first}}});
    std::vector<scene::ElementRef> told;
    const std::vector<trace::Ray> rays =
        trace::rays_of(trace::Tables(scene), trace::IndexedView<const scene::Query>(queries),
                       [&](std::size_t i, const scene::Query& query, const trace::Ray& each) {
                         CHECK(&query == &queries[i]);
                         CHECK(told.size() == i);
                         told.push_back(each.start());
                       });
    REQUIRE(rays.size() == queries.size());
    REQUIRE(told.size() == queries.size());
    for (std::size_t i = 0; i < queries.size(); ++i) {
      const auto& [asked, en] = queries[i];
      CHECK(rays[i].p == asked.p().xyz());
      CHECK(rays[i].v == asked.v().xyz());
      const bool tells = !some_extraordinary && en.size() == 1 && rays[i].ordinary;
      CHECK(rays[i].start() == (tells ? en[0] : trace::nothing));
      CHECK(told[i] == rays[i].start());
    }
  }
}
