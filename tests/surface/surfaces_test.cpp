#include "durero/surface/surfaces.hpp"

#include "support/catch.hpp"

using namespace durero;
using surface::Surface;

namespace {

/// A shape that nobody has given a surface.
struct Bare {
  glm::dvec3 centro;
};

}  // namespace

TEST_CASE("every shape has a surface, and a list with one that has none is refused") {
  std::size_t surfaces = 0;
  scene::for_each_shape([&]<class Shape>(std::type_identity<Shape>) { surfaces += Surface<Shape>; });
  CHECK(surfaces == scene::shape_count);
  CHECK_FALSE(Surface<Bare>);
  CHECK(surface::all_are_surfaces<std::tuple<scene::Cone, scene::Sphere>>);
  CHECK_FALSE(surface::all_are_surfaces<std::tuple<scene::Sphere, Bare>>);
  CHECK_FALSE(surface::all_are_surfaces<scene::Sphere>);  // no list
}

TEST_CASE("flat are the shapes that lie in a plane") {
  using enum model::Tipo;
  for (const model::Tipo flat : {soy_plano, soy_disco, soy_triangulo}) CHECK(surface::is_flat(flat));
  for (const model::Tipo round : {soy_esfera, soy_cilindro, soy_cono, soy_tronco}) CHECK_FALSE(surface::is_flat(round));
}
