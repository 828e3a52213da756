#include "durero/scene/any_shape.hpp"

#include "support/catch.hpp"

using namespace durero;

TEST_CASE("any shape is one of all, in the order of Tipo") {
  STATIC_REQUIRE(std::variant_size_v<scene::AnyShape> == scene::shape_count);
  std::size_t count = 0;
  scene::for_each_shape([&]<class Shape>(std::type_identity<Shape>) {
    const scene::AnyShape any{std::in_place_type<Shape>};
    CHECK(any.index() == static_cast<std::size_t>(Shape::tipo));
    CHECK(std::holds_alternative<Shape>(any));
    ++count;
  });
  CHECK(count == scene::shape_count);
}
