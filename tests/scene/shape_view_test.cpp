#include "durero/scene/shape_view.hpp"

#include "support/catch.hpp"

using namespace durero;

TEST_CASE("a view of a shape visits that very shape, with its type") {
  scene::for_each_shape([]<class Shape>(std::type_identity<Shape>) {
    const Shape shape{};
    const scene::ShapeView view(shape);
    const void* const visited = view.visit([]<class Visited>(const Visited& other) -> const void* {
      CHECK(Visited::tipo == Shape::tipo);
      return &other;
    });
    CHECK(visited == &shape);
  });
}

static_assert(!std::is_constructible_v<scene::ShapeView, double>);
static_assert(std::is_constructible_v<scene::ShapeView, scene::Sphere>);
