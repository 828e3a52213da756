#include "durero/scene/remainder.hpp"

#include "support/catch.hpp"

namespace durero::scene {
namespace {

GroupedScene balls_and_a_plane() {
  GroupedScene whole;
  for (const char* const name : {"a", "b", "c", "d"}) whole.scene.add(model::Elemento{name}, Sphere{{}, 1});
  whole.scene.add(model::Elemento{"wall"}, Plane{{0, 0, 0}, {1, 0, 0}});
  return whole;
}

TEST_CASE("What is left of a scene has the other elements, and says where they stand in the whole") {
  const GroupedScene whole = balls_and_a_plane();
  const auto at = [&](const char* name) { return whole.scene.find(name).value(); };
  const Remainder rest(whole, [&](ElementRef e) { return e == at("a") || e == at("c"); });
  const Scene& left = rest.scene().scene;
  CHECK(left.size() == 3);
  CHECK(whole.scene.size() == 5);
  CHECK_FALSE(left.find("a").has_value());
  for (const char* const name : {"b", "d", "wall"}) CHECK(rest.element(left.find(name).value()) == at(name));
  const ElementSet all{left.find("b").value(), left.find("d").value(), left.find("wall").value()};
  const ElementSet there = rest.elements(all);
  CHECK(std::is_sorted(there.begin(), there.end()));
  CHECK(there.size() == 3);
}

TEST_CASE("A ray starts on what is left of the elements that it starts on, in their order") {
  const GroupedScene whole = balls_and_a_plane();
  const auto at = [&](const char* name) { return whole.scene.find(name).value(); };
  const Remainder rest(whole, [&](ElementRef e) { return e == at("a"); });
  Query query{{model::Punto(0, 0, 0), model::Vector(1, 0, 0)}, {at("a"), at("b"), at("d"), at("wall")}};
  std::sort(query.en.begin(), query.en.end());
  const auto queries = rest.queries(std::vector{query});
  REQUIRE(queries.size() == 1);
  CHECK(queries[0].rayo == query.rayo);
  ElementSet expected;
  for (const char* const name : {"b", "d", "wall"}) expected.push_back(rest.scene().scene.find(name).value());
  std::sort(expected.begin(), expected.end());
  CHECK(queries[0].en == expected);
}

}  // namespace
}  // namespace durero::scene
