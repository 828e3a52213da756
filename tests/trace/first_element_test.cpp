#include "durero/trace/first_element.hpp"

#include "durero/trace/analytic.hpp"
#include "support/catch.hpp"
#include "support/scenes.hpp"
#include "support/shapes.hpp"

using namespace durero;
using namespace durero::test;
using model::Resultado;
using trace::FirstElement;

namespace {

std::vector<FirstElement> elements_of(const trace::Tables& tables, const std::vector<scene::Query>& queries) {
  std::vector<FirstElement> elements(queries.size(), {Resultado::no_minimum, 7, {}});
  trace::first_elements_among(tables, queries, elements);
  return elements;
}

}  // namespace

TEST_CASE("what is first met is what the whole answer says") {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Random random(seed);
    scene::Scene scene = random_scene(random, 40);
    if (seed % 3 == 0) add(scene, scene::Sphere{{0, 0, 0}, 1e-200});
    const trace::Tables tables(scene);
    std::vector<scene::Query> queries;
    for (int i = 0; i < 600; ++i) {
      queries.push_back({random_ray(random)});
      const scene::Hit hit = trace::first_hit(tables, queries.back().rayo);
      if (hit.resultado == Resultado::hit)
        queries.push_back({{model::Punto(hit.punto), model::Vector(random.direction())}, hit.elementos});
    }
    const std::vector<FirstElement> elements = elements_of(tables, queries);
    const std::vector<scene::Hit> hits = trace::first_hits(tables, queries);
    for (std::size_t i = 0; i < queries.size(); ++i) CHECK(elements[i] == trace::first_element(hits[i]));
  }
}

TEST_CASE("of several elements at one point the least is told, and how many there are") {
  scene::Scene scene;
  const scene::ElementRef first = add(scene, scene::Sphere{{0, 0, 5}, 1});
  add(scene, scene::Sphere{{0, 0, 6}, 2});
  const scene::ElementRef cylinder = add(scene, scene::Cylinder{{9, 0, 0}, 1, model::Vector(0, 0, 1).xyz(), 4});
  const trace::Tables tables(scene);
  const std::vector<FirstElement> elements =
      elements_of(tables, {{ray({0, 0, 0}, {0, 0, 1})}, {ray({0, 0, 0}, {0, 1, 0})}, {ray({10, 0, 1}, {0, 0, 1})}});
  CHECK(elements[0] == FirstElement{Resultado::hit, 2, first});
  CHECK(elements[1] == FirstElement{});
  CHECK(elements[2] == FirstElement{Resultado::no_minimum, 1, cylinder});
}
