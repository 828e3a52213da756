#include "turn.hpp"

#include "durero/number/ball.hpp"
#include "durero/number/dyadic.hpp"

namespace durero::io {
namespace {

/// The vector from one point to another.
template <class Number>
struct PlaneStep {
  PlaneStep(const glm::dvec2& from, const glm::dvec2& to)
      : u(Number(to.x) - Number(from.x)), v(Number(to.y) - Number(from.y)) {}
  Number u, v;
};

template <class Number>
Number cross(const PlaneStep<Number>& a, const PlaneStep<Number>& b) {
  return a.u * b.v - a.v * b.u;
}

template <class Number>
Number length_squared(const PlaneStep<Number>& a) {
  return a.u * a.u + a.v * a.v;
}

/// Twice the area of the triangle.
template <class Number>
struct TurnForm {
  static Number of(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
    return cross(PlaneStep<Number>(a, b), PlaneStep<Number>(a, c));
  }
};

/// The determinant of the three points lifted to the paraboloid, seen from d.
template <class Number>
struct CircleForm {
  static Number of(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c, const glm::dvec2& d) {
    const PlaneStep<Number> to_a(d, a), to_b(d, b), to_c(d, c);
    return length_squared(to_a) * cross(to_b, to_c) + length_squared(to_b) * cross(to_c, to_a) +
           length_squared(to_c) * cross(to_a, to_b);
  }
};

/// The sign of a form: by enclosures where they decide, otherwise by exact numbers.
template <template <class> class Form, class... Points>
int sign_of(const Points&... points) {
  if (const int decided = Form<number::RealBall>::of(points...).decided_sign(); decided != 0) return decided;
  return sign(Form<number::Dyadic>::of(points...));
}

}  // namespace

int turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) { return sign_of<TurnForm>(a, b, c); }

int circle_side(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c, const glm::dvec2& d) {
  return sign_of<CircleForm>(a, b, c, d);
}

}  // namespace durero::io
