#include "durero/written/surface.hpp"

#include "support/catch.hpp"

namespace durero::written {
namespace {

using algebra::Root;
using number::DyadicSurd;

const Formula x = Formula::coordinate(0), y = Formula::coordinate(1), z = Formula::coordinate(2);
constexpr Signs is_zero{false, true, false}, is_positive{false, false, true}, not_negative{false, true, true},
    not_positive{true, true, false};

model::Rayo ray(const glm::dvec3& p, const glm::dvec3& v) { return {model::Punto(p), model::Vector(v)}; }

double at(const First& first) { return algebra::rounded_linear(0, 1, std::get<Root>(first)); }
bool is_nowhere(const First& first) { return std::holds_alternative<std::monostate>(first); }
/// Of a stretch: where it begins.
double after(const First& first) {
  const auto& from = std::get<After>(first).t;
  return from ? algebra::rounded_linear(0, 1, *from) : 0;
}

/// x² + y² + z² = 1
const Condition ball = compared(x * x + y * y + z * z - Formula(1), is_zero);
/// The torus of the radii 2 and 1 about z, which rays along x through its middle meet at 1 and 3.
const Condition torus = [] {
  const Formula sum = x * x + y * y + z * z + Formula(3);
  return compared(sum * sum - Formula(16) * (x * x + y * y), is_zero);
}();
/// y = 0
const Condition plane = compared(y, is_zero);

TEST_CASE("A surface is met at the least root that its clips take") {
  const Surface whole(ball), half(both(ball, compared(x, not_negative))),
      none(both(ball, compared(x * x - Formula(2), is_positive)));
  CHECK(at(whole.first(ray({-3, 0, 0}, {1, 0, 0}), false)) == 2);
  CHECK(at(half.first(ray({-3, 0, 0}, {1, 0, 0}), false)) == 4);
  CHECK(is_nowhere(none.first(ray({-3, 0, 0}, {1, 0, 0}), false)));
  CHECK(at(whole.first(ray({0, 0, 0}, {0, 2, 0}), false)) == 0.5);
  CHECK(is_nowhere(whole.first(ray({-3, 1.0001, 0}, {1, 0, 0}), false)));
  CHECK(at(whole.first(ray({-3, 1, 0}, {1, 0, 0}), false)) == 3);  // it is touched
  CHECK(is_nowhere(whole.first(ray({3, 0, 0}, {1, 0, 0}), false)));
}

TEST_CASE("A rim belongs to a surface where the inequality says so") {
  const auto down = ray({0, 5, 0}, {1, -5, 0});  // to (1, 0, 0)
  CHECK(at(Surface(both(ball, compared(y, not_positive))).first(down, false)) == 1);
  CHECK(is_nowhere(Surface(both(ball, compared(y, {true, false, false}))).first(ray({-1, 0, 0}, {1, 0, 0}), false)));
}

TEST_CASE("A torus is met four times, and a ray that touches it meets it there") {
  const Surface surface(torus);
  CHECK(at(surface.first(ray({-5, 0, 0}, {1, 0, 0}), false)) == 2);
  CHECK(at(surface.first(ray({-2, 0, 0}, {1, 0, 0}), false)) == 1);
  CHECK(at(surface.first(ray({0, 0, 0}, {1, 0, 0}), false)) == 1);
  CHECK(at(surface.first(ray({2, 0, 0}, {1, 0, 0}), false)) == 1);
  CHECK(is_nowhere(surface.first(ray({4, 0, 0}, {1, 0, 0}), false)));
  CHECK(at(surface.first(ray({-5, 3, 0}, {1, 0, 0}), false)) == 5);  // touched at (0, 3, 0)
  CHECK(is_nowhere(surface.first(ray({-5, std::nextafter(3.0, 4.0), 0}, {1, 0, 0}), false)));
  CHECK(at(surface.first(ray({-5, 0, 1}, {1, 0, 0}), false)) == 3);  // the circle on top is touched twice
  CHECK(is_nowhere(surface.first(ray({0, 0, -5}, {0, 0, 1}), false)));
}

TEST_CASE("A ray that starts on a surface does not meet it there, and meets the rest of it") {
  const Surface surface(torus);
  CHECK(at(surface.first(ray({-3, 0, 0}, {1, 0, 0}), true)) == 2);
  const double near = std::nextafter(-3.0, -4.0);  // the rounding of a point of it, outside
  const First seen = surface.first(ray({near, 0, 0}, {1, 0, 0}), true);
  CHECK(std::abs(at(seen) - 2) < 1e-12);
  CHECK(at(surface.first(ray({near, 0, 0}, {1, 0, 0}), false)) < 1e-12);
  CHECK(is_nowhere(surface.first(ray({-3, 0, 0}, {-1, 0, 0}), true)));
}

TEST_CASE("In a ray that lies in the surface the clips decide") {
  const auto along = ray({-3, 0, 0}, {1, 0, 0});
  const auto first = [&](const Condition& clip) { return Surface(both(plane, clip)).first(along, false); };
  CHECK(after(Surface(plane).first(along, false)) == 0);
  CHECK(at(first(compared(x * x - Formula(1), not_positive))) == 2);
  CHECK(after(first(compared(x * x - Formula(1), {true, false, false}))) == 2);  // −1 < x < 1: none is first
  CHECK(after(first(compared(x * x - Formula(16), not_positive))) == 0);
  CHECK(is_nowhere(first(compared(x + Formula(3), {true, false, false}))));
  CHECK(at(first(compared(x * x * x - Formula(2), is_zero))) == Approx(3 + std::cbrt(2.0)).epsilon(1e-15));
  CHECK(at(first(both(compared(x * x * x - Formula(2), not_negative), compared(x * x - Formula(9), not_positive)))) ==
        Approx(3 + std::cbrt(2.0)).epsilon(1e-15));
  CHECK(after(first(either(compared(x - Formula(2), is_positive), compared(x - Formula(1), is_positive)))) == 4);
}

TEST_CASE("Two equations are a curve, which a ray meets in points of both") {
  const Surface circle(both(ball, plane));
  CHECK(at(circle.first(ray({-3, 0, 0}, {1, 0, 0}), false)) == 2);
  CHECK(at(circle.first(ray({1, -2, 0}, {0, 1, 0}), false)) == 2);
  CHECK(is_nowhere(circle.first(ray({0.5, -2, 0}, {0, 1, 0}), false)));
}

TEST_CASE("What no point satisfies is met nowhere, and an equation must be a conjunct") {
  CHECK(is_nowhere(Surface(always(false)).first(ray({-3, 0, 0}, {1, 0, 0}), false)));
  CHECK(Surface::pieces(always(false)) == 1);
  CHECK(Surface::pieces(both(compared(x, is_positive), ball)) == 1);
  CHECK(Surface::pieces(always(true)) == 0);
  CHECK(Surface::pieces(compared(x, not_negative)) == 0);
}

TEST_CASE("A surface hides what lies behind it before t = 1, and not at it") {
  const Surface surface(torus);
  CHECK(surface.hides(ray({-5, 0, 0}, {3, 0, 0}), false));
  CHECK_FALSE(surface.hides(ray({-5, 0, 0}, {2, 0, 0}), false));  // it is met at t = 1 first
  CHECK_FALSE(surface.hides(ray({-5, 0, 0}, {1, 0, 0}), false));
  CHECK(Surface(plane).hides(ray({-3, 0, 0}, {1, 0, 0}), false));
  CHECK_FALSE(Surface(both(plane, compared(x * x - Formula(1), {true, false, false})))
                  .hides(ray({-3, 0, 0}, {2, 0, 0}), false));  // a stretch that begins behind t = 1
}

TEST_CASE("The normal is the gradient, and null at a point without one") {
  CHECK(Surface(ball).normal({0, 0, 1}) == glm::dvec3(0, 0, 1));
  CHECK(Surface(torus).normal({3, 0, 0}) == glm::dvec3(1, 0, 0));
  CHECK(Surface(torus).normal({-1, 0, 0}) == glm::dvec3(1, 0, 0));
  CHECK(Surface(compared(x * x + y * y - z * z, is_zero)).normal({0, 0, 0}) == glm::dvec3(0));
}

/// A can about y: its wall x² + z² = 1 and its lids y = 1 and y = -1.
const Condition can = [] {
  const Formula inside = x * x + z * z - Formula(1), between = y * y - Formula(1);
  return either(both(compared(inside, is_zero), compared(between, not_positive)),
                both(compared(between, is_zero), compared(inside, not_positive)));
}();

TEST_CASE("A union is met where one of its pieces is, and at the first of these") {
  const Surface surface(can);
  CHECK(at(surface.first(ray({-3, 0, 0}, {1, 0, 0}), false)) == 2);
  CHECK(at(surface.first(ray({0.5, 4, 0}, {0, -1, 0}), false)) == 3);
  CHECK(at(surface.first(ray({0, 0, 0}, {0, -2, 0}), false)) == 0.5);  // from within, to the lid
  CHECK(at(surface.first(ray({-3, 1, 0}, {1, 0, 0}), false)) == 2);    // the rim is before the lid, in which it goes on
  CHECK(is_nowhere(surface.first(ray({-3, 1.5, 0}, {1, 0, 0}), false)));
  CHECK(after(surface.first(ray({0, 1, 0}, {1, 0, 0}), false)) == 0);  // in the lid
  CHECK(surface.hides(ray({0, 0, 0}, {0, 2, 0}), false));
  CHECK_FALSE(surface.hides(ray({0, 0, 0}, {0, 1, 0}), false));
}

TEST_CASE("A ray that starts on a union starts on the pieces that its origin may be the rounding of a point of") {
  const Surface surface(can);
  CHECK(at(surface.first(ray({0, 1, 0}, {0, -1, 0}), true)) == 2);            // from lid to lid
  CHECK(at(surface.first(ray({0, 1, 0}, {0.5, -0.5, 0}), true)) == 2);        // from lid to wall
  CHECK(at(surface.first(ray({1, 0, 0}, {-1, 1, 0}), true)) == 1);            // from wall to lid
  CHECK(is_nowhere(surface.first(ray({0.6, 0, 0.8}, {0.6, 0, 0.8}), true)));  // the rounding of a point of the wall
  CHECK(at(surface.first(ray({0.6, 0, 0.8}, {-0.6, 0, -0.8}), true)) == Approx(2));
  CHECK(is_nowhere(surface.first(ray({1, 1, 0}, {1, 1, 0}), true)));  // from the rim
  // far from all of it, it starts on none
  CHECK(at(surface.first(ray({-3, 0, 0}, {1, 0, 0}), true)) == 2);
}

TEST_CASE("What satisfies no equation on some side is no union of surfaces; the pieces of one are counted") {
  const Condition inside = compared(x, not_negative);
  CHECK(Surface::pieces(either(ball, plane)) == 2);
  CHECK(Surface::pieces(both(either(ball, plane), inside)) == 2);
  CHECK(Surface::pieces(either(ball, inside)) == 0);
  CHECK(Surface::pieces(both(inside, either(inside, plane))) == 0);
  Condition many = plane;
  for (int i = 1; i <= static_cast<int>(Surface::most_pieces); ++i) {
    CHECK(Surface::pieces(many) == static_cast<std::size_t>(i));
    many = either(std::move(many), compared(y - Formula(i), is_zero));
  }
  CHECK(Surface::pieces(many) == Surface::most_pieces + 1);
  CHECK(at(Surface(both(either(ball, plane), inside)).first(ray({-3, 0.5, 0}, {1, 0, 0}), false)) == Approx(3.8660254));
}

TEST_CASE("The normal of a union is that of the piece on which the point lies") {
  const Surface surface(can);
  CHECK(surface.normal({1, 0.5, 0}) == glm::dvec3(1, 0, 0));
  CHECK(surface.normal({0.25, 1, 0}) == glm::dvec3(0, 1, 0));
  CHECK(surface.normal({0, -1, 0.5}) == glm::dvec3(0, -1, 0));
}

}  // namespace
}  // namespace durero::written
