#include "io/placed/placement.hpp"

#include <glm/geometric.hpp>

#include "support/catch.hpp"

using namespace durero;
using io::AffinePlacement;

namespace {
glm::dvec3 put(const AffinePlacement& by, const glm::dvec3& p) { return by.map.point(p, 1); }
}  // namespace

TEST_CASE(
    "A placement is made of translations, scales and turns, the inner first, and its scale is that of all lengths") {
  const AffinePlacement t = AffinePlacement::translation({1, 2, 3}), s = AffinePlacement::scaling({2, 2, 2}),
                        r = *AffinePlacement::rotation({0, 0, 5}, 90);
  CHECK(put(t.after(s), {1, 1, 1}) == glm::dvec3(3, 4, 5));
  CHECK(put(s.after(t), {1, 1, 1}) == glm::dvec3(4, 6, 8));
  CHECK(put(r, {1, 2, 3}) == glm::dvec3(-2, 1, 3));
  CHECK(t.after(s).after(r).scale == 2);
  CHECK_FALSE(s.after(AffinePlacement::scaling({1, 2, 1})).scale);
  CHECK(AffinePlacement::scaling({-3, 3, 3}).scale == 3);
  CHECK_FALSE(AffinePlacement::rotation({0, 0, 0}, 90));
  const auto turn = *AffinePlacement::rotation({1, 1, 1}, 120);
  CHECK(glm::distance(put(turn, {1, 2, 3}), {3, 1, 2}) < 1e-15);
  CHECK((t.steps == 0 && r.steps == 1 && t.after(r).after(s).steps == 2));
}

TEST_CASE("A matrix is a similarity where it exchanges and reverses axes alone, over its last number") {
  CHECK(AffinePlacement::of_matrix({0, 2, 0, 0, -2, 0, 0, 0, 0, 0, 2, 0, 1, 1, 1, 1}).scale == 2);
  CHECK(AffinePlacement::of_matrix({0, 2, 0, 0, -2, 0, 0, 0, 0, 0, 2, 0, 1, 1, 1, 4}).scale == 0.5);
  CHECK(put(AffinePlacement::of_matrix({0, 2, 0, 0, -2, 0, 0, 0, 0, 0, 2, 0, 1, 1, 1, 4}), {1, 0, 0}) ==
        glm::dvec3(0.25, 0.75, 0.25));
  CHECK_FALSE(AffinePlacement::of_matrix({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 2, 0, 0, 0, 0, 1}).scale);
  CHECK_FALSE(AffinePlacement::of_matrix({0.6, 0.8, 0, 0, -0.8, 0.6, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}).scale);
  CHECK_FALSE(AffinePlacement::of_matrix({1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}).scale);
  CHECK_FALSE(AffinePlacement::of_matrix({1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}).scale);
}

TEST_CASE("A placement has its way back, and says the same to a scene") {
  const AffinePlacement by = AffinePlacement::translation({1, 0, 0}).after(
      AffinePlacement::of_matrix({1, 2, 3, 0, 0, 1, 4, 0, 5, 6, 0, 0, 7, 8, 9, 2}));
  const AffinePlacement back = *by.inverse();
  for (const glm::dvec3 p : {glm::dvec3(1, 2, 3), glm::dvec3(-0.1, 1e9, 0.3)}) {
    CHECK(back.after(by).map.is_identity());
    CHECK(put(back.after(by), p) == p);
    const model::ExactPoint image =
        model::puesto(by.mapa(), {number::exact(p.x), number::exact(p.y), number::exact(p.z)});
    CHECK(image.x == number::Surd(number::exact(p.x) / 2 + number::exact(p.z) * 5 / 2 + number::Rational(9, 2)));
  }
  CHECK_FALSE(AffinePlacement::scaling({1, 0, 1}).inverse());
  CHECK_FALSE(by.map.keeps_axes());
  CHECK(AffinePlacement::scaling({1, 2, 3}).map.keeps_axes());
}

TEST_CASE("A frame looks along +z, with +x to the left of whoever looks") {
  const AffinePlacement frame = *AffinePlacement::looking({0, 0, -5}, {0, 0, 1}, {0, 2, 0});
  CHECK(put(frame, {0, 0, 1}) == glm::dvec3(0, 0, -4));
  CHECK(put(frame, {1, 0, 0}) == glm::dvec3(1, 0, -5));
  CHECK(put(frame, {0, 1, 0}) == glm::dvec3(0, 1, -5));
  CHECK_FALSE(AffinePlacement::looking({1, 1, 1}, {1, 1, 1}, {0, 1, 0}));
  CHECK_FALSE(AffinePlacement::looking({0, 0, 0}, {0, 2, 0}, {0, 1, 0}));
}
