#include "durero/scene/shape/truncated_cone.hpp"

#include "attributes_of.hpp"
#include "durero/scene/attributes.hpp"
#include "support/catch.hpp"
#include "support/elements.hpp"
#include "support/property.hpp"

using namespace durero;
using namespace durero::test;
using scene::TruncatedCone;

TEST_CASE("a truncated cone has a centre, a radius, a proportion, an axis and a height") {
  CHECK(TruncatedCone::word == "tronco");
  CHECK(TruncatedCone::tipo == model::Tipo::soy_tronco);
  CHECK(words<TruncatedCone>() == std::vector<std::string_view>{"centro", "radio", "proporcion", "vector", "altura"});
  const model::Agregar_Tronco in = scene::addition(model::Elemento("e"), TruncatedCone{{1, 2, 3}, 6, 4, {0, 0, -1}, 5});
  CHECK(in.centro == model::Punto(1, 2, 3));
  CHECK(in.radio == 6);
  CHECK(in.proporcion == 4);
  CHECK(in.vector == model::Vector(0, 0, -1));
  CHECK(in.altura == 5);
}

TEST_CASE("what adds a truncated cone to a scene is the cone") {
  property("any", [] { RC_ASSERT(is_what_its_addition_adds(*truncated_cones(moderate()))); });
}
