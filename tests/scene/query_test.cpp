#include "durero/scene/query.hpp"

#include "support/catch.hpp"

using namespace durero;
using model::Tipo;
using scene::ElementRef;
using scene::Origin;
using scene::Query;

namespace {

constexpr ElementRef sphere{Tipo::soy_esfera, 3}, cone{Tipo::soy_cono, 0};

}  // namespace

TEST_CASE("an origin holds the elements that it was made of, however they were given") {
  const auto is = [](const Origin& origin, const std::vector<ElementRef>& elements) {
    for (const ElementRef e : elements)
      if (!origin.contains(e)) return false;
    return std::equal(origin.begin(), origin.end(), elements.begin(), elements.end()) &&
           origin.empty() == elements.empty();
  };
  const std::vector<ElementRef> both{sphere, cone}, none;
  const scene::ElementSet set{sphere, cone};
  CHECK(is(Origin(), none));
  CHECK(is(Origin(none), none));
  CHECK(is(Origin(sphere), {sphere}));
  CHECK(is(Origin(both), both));
  CHECK(is(Origin(set), both));
  CHECK(is(Origin(std::span(both).last(1)), {cone}));
}

TEST_CASE("an element is of an origin by its type and its place") {
  const Origin origin(sphere);
  CHECK(origin.contains({Tipo::soy_esfera, 3}));
  CHECK_FALSE(origin.contains({Tipo::soy_esfera, 0}));
  CHECK_FALSE(origin.contains({Tipo::soy_cono, 3}));
  CHECK_FALSE(Origin().contains(sphere));
}

TEST_CASE("an origin of many elements holds these and no other, ascending or not") {
  for (const std::uint32_t size : {1u, 7u, 8u, 9u, 10u, 33u, 1000u}) {
    scene::ElementSet set;
    for (std::uint32_t i = 0; i < size; ++i)
      set.push_back({i < size / 2 ? Tipo::soy_esfera : Tipo::soy_cono, 2 * i + 1});
    const std::vector<ElementRef> backwards(set.rbegin(), set.rend());
    for (const Origin& origin : {Origin(set), Origin(backwards)}) {
      for (const ElementRef e : set) {
        CHECK(origin.contains(e));
        CHECK_FALSE(origin.contains({e.tipo, e.index - 1}));
        CHECK_FALSE(origin.contains({e.tipo, e.index + 1}));
        CHECK_FALSE(origin.contains({Tipo::soy_cilindro, e.index}));
      }
    }
  }
}

TEST_CASE("an origin refers to the elements, and sees what becomes of them") {
  std::vector<ElementRef> elements{sphere};
  const Origin origin(elements);
  elements[0] = cone;
  CHECK(origin.contains(cone));
  CHECK_FALSE(origin.contains(sphere));
}

TEST_CASE("queries are equal where ray and elements are") {
  const Query query{{model::Punto(0, 0, 0), model::Vector(0, 0, 1)}, {sphere}};
  Query other = query;
  CHECK(other == query);
  other.en = {sphere, cone};
  CHECK_FALSE(other == query);
  CHECK_FALSE(Query{query.rayo} == query);
  CHECK_FALSE(Query{{model::Punto(0, 0, 0), model::Vector(0, 0, 2)}, {sphere}} == query);
}
