#include "durero/composed/side_tree.hpp"

#include <array>

#include "support/catch.hpp"

using durero::composed::SideTree;
using durero::composed::SolidPlace;

namespace {

using Sides = std::vector<std::int8_t>;

const SideTree a = SideTree::face(0, false), b = SideTree::face(1, false), turned = SideTree::face(0, true);

}  // namespace

TEST_CASE("a face: inside where the value is negative, its surface where it is 0") {
  CHECK(a.place(Sides{-1}) == SolidPlace::inside);
  CHECK(a.place(Sides{0}) == SolidPlace::surface);
  CHECK(a.place(Sides{1}) == SolidPlace::outside);
  CHECK(turned.place(Sides{-1}) == SolidPlace::outside);
  CHECK(turned.place(Sides{0}) == SolidPlace::surface);
  CHECK(turned.place(Sides{1}) == SolidPlace::inside);
}

TEST_CASE("unions and intersections off the faces are those of sets") {
  for (const std::int8_t p : {std::int8_t{-1}, std::int8_t{1}}) {
    for (const std::int8_t q : {std::int8_t{-1}, std::int8_t{1}}) {
      CHECK((SideTree::all({a, b}).place(Sides{p, q}) == SolidPlace::inside) == (p < 0 && q < 0));
      CHECK((SideTree::any({a, b}).place(Sides{p, q}) == SolidPlace::inside) == (p < 0 || q < 0));
    }
  }
}

TEST_CASE("one face on both sides: a union is whole there, an intersection empty") {
  CHECK(SideTree::any({a, turned}).place(Sides{0}) == SolidPlace::inside);
  CHECK(SideTree::all({a, turned}).place(Sides{0}) == SolidPlace::outside);
  CHECK(SideTree::all({a, a}).place(Sides{0}) == SolidPlace::surface);
  CHECK(SideTree::all({a, a.complement()}).place(Sides{0}) == SolidPlace::outside);
}

TEST_CASE("on several faces: the surface where some sides are in and others out") {
  const SideTree both = SideTree::all({a, b}), either = SideTree::any({a, b});
  CHECK(both.place(Sides{0, 0}) == SolidPlace::surface);
  CHECK(both.place(Sides{0, -1}) == SolidPlace::surface);
  CHECK(both.place(Sides{0, 1}) == SolidPlace::outside);
  CHECK(either.place(Sides{0, 0}) == SolidPlace::surface);
  CHECK(either.place(Sides{0, -1}) == SolidPlace::inside);
  // Four quarters about an edge are all of it.
  const SideTree quarters =
      SideTree::any({SideTree::all({a, b}), SideTree::all({a, b.complement()}), SideTree::all({a.complement(), b}),
                     SideTree::all({a.complement(), b.complement()})});
  CHECK(quarters.place(Sides{0, 0}) == SolidPlace::inside);
  CHECK(quarters.complement().place(Sides{0, 0}) == SolidPlace::outside);
}

TEST_CASE("the rest of space has the same surface") {
  const SideTree solid = SideTree::all({a, SideTree::any({b, turned})});
  for (const std::int8_t p : {std::int8_t{-1}, std::int8_t{0}, std::int8_t{1}}) {
    for (const std::int8_t q : {std::int8_t{-1}, std::int8_t{0}, std::int8_t{1}}) {
      const auto of = static_cast<int>(solid.place(Sides{p, q}));
      CHECK(static_cast<int>(solid.complement().place(Sides{p, q})) == -of);
    }
  }
}
