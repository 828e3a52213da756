#include "durero/scene/hit.hpp"

#include <cmath>

#include "support/catch.hpp"

using namespace durero;
using model::Resultado;
using model::Tipo;
using scene::Hit;

TEST_CASE("a hit that says nothing is a miss, of no element, at 0") {
  const Hit hit;
  CHECK(hit.resultado == Resultado::miss);
  CHECK(hit.t == 0);
  CHECK(hit.punto == glm::dvec3(0));
  CHECK(hit.elementos.empty());
}

TEST_CASE("hits are equal where every part is, as numbers are") {
  const Hit hit{Resultado::hit, 2, {1, 0, 3}, {{Tipo::soy_cono, 1}}};
  Hit other = hit;
  CHECK(other == hit);
  other.punto.y = -0.0;
  CHECK(other == hit);
  CHECK(std::signbit(other.punto.y));
  other.elementos.push_back({Tipo::soy_cono, 2});
  CHECK_FALSE(other == hit);
  const auto differs = [&](auto change) {
    Hit changed = hit;
    change(changed);
    return !(changed == hit);
  };
  CHECK(differs([](Hit& h) { h.resultado = Resultado::no_minimum; }));
  CHECK(differs([](Hit& h) { h.t = std::nextafter(h.t, 3.0); }));
  CHECK(differs([](Hit& h) { h.punto.x = 0; }));
  CHECK(differs([](Hit& h) { h.elementos.front().index = 0; }));
  CHECK(differs([](Hit& h) { h.elementos.clear(); }));
}
