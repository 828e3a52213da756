#include "pov_bounds.hpp"

#include <algorithm>
#include <array>

namespace durero::io {

using number::Rational;

namespace {

using ExactPoint = std::array<Rational, 3>;

ExactPoint exact_point(const glm::dvec3& p) { return {number::exact(p.x), number::exact(p.y), number::exact(p.z)}; }

/// The place where transformations put a point, one after another, each without rounding.
ExactPoint put(ExactPoint p, const std::vector<const PovTransform*>& all) {
  for (const PovTransform* const by : all) {
    ExactPoint q = exact_point(by->shift);
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 3; ++column)
        q.at(static_cast<std::size_t>(row)) +=
            number::exact(by->linear[column][row]) * p.at(static_cast<std::size_t>(column));
    p = q;
  }
  return p;
}

Rational squared(const ExactPoint& v) { return v[0] * v[0] + v[1] * v[1] + v[2] * v[2]; }

/// A ball, or a point where its radius is 0.
struct ExactBall {
  ExactPoint center;
  Rational radius = 0;
};

bool is_in_sphere(const ExactBall& ball, const scene::Sphere& sphere, const glm::dvec3& shift) {
  const ExactPoint center = exact_point(sphere.centro), way = exact_point(shift);
  ExactPoint apart;
  for (std::size_t i = 0; i < 3; ++i) apart.at(i) = ball.center.at(i) - center.at(i) - way.at(i);
  const Rational beyond = number::exact(sphere.radio) - ball.radius;
  return beyond >= 0 && squared(apart) <= beyond * beyond;
}

bool is_in_box(const ExactBall& ball, const std::array<glm::dvec3, 2>& box, const glm::dvec3& shift) {
  const ExactPoint a = exact_point(box[0]), b = exact_point(box[1]), way = exact_point(shift);
  for (std::size_t i = 0; i < 3; ++i) {
    const Rational at = ball.center.at(i) - way.at(i);
    if (at - ball.radius < std::min(a.at(i), b.at(i)) || at + ball.radius > std::max(a.at(i), b.at(i))) return false;
  }
  return true;
}

/// n·w − d is at most −r·|n| at the centre: its square is then r²·n·n or more.
bool is_behind(const ExactBall& ball, const PovShape& plane, const glm::dvec3& shift) {
  const ExactPoint n = exact_point(std::get<scene::Plane>(plane.surface).vector), way = exact_point(shift);
  Rational depth = number::exact(plane.distance.value_or(0));
  for (std::size_t i = 0; i < 3; ++i) depth -= n.at(i) * (ball.center.at(i) - way.at(i));
  return depth >= 0 && depth * depth >= ball.radius * ball.radius * squared(n);
}

/// Whether a bound holds a ball.
bool holds(const PovObject& bound, const ExactBall& ball) {
  if (bound.is_left_out || bound.is_inverse || bound.is_clipped() || !bound.moved.is_shift()) return false;
  const glm::dvec3& shift = bound.moved.shift;
  if (bound.word == "object") return bound.moved.is_identity() && holds(bound.parts.front(), ball);
  if (bound.box) return is_in_box(ball, *bound.box, shift);
  if (!bound.shape) return false;
  if (const auto* const sphere = std::get_if<scene::Sphere>(&bound.shape->surface); sphere && !bound.shape->ends)
    return is_in_sphere(ball, *sphere, shift);
  return std::holds_alternative<scene::Plane>(bound.shape->surface) && is_behind(ball, *bound.shape, shift);
}

/// Balls whose convex hull a shape lies in; none of what has no end.
std::vector<ExactBall> balls_around(const PovObject& object) {
  const auto at = [](const glm::dvec3& p, double radius) {
    return ExactBall{exact_point(p), abs(number::exact(radius))};
  };
  std::vector<ExactBall> all;
  if (object.box) {
    for (int corner = 0; corner < 8; ++corner) {
      glm::dvec3 p;
      for (int i = 0; i < 3; ++i) p[i] = (*object.box)[static_cast<std::size_t>(corner >> i & 1)][i];
      all.push_back(at(p, 0));
    }
  } else if (object.patch) {
    for (const auto& row : object.patch->points)
      for (const glm::dvec3& point : row) all.push_back(at(point, 0));
  } else if (object.surface && object.surface->torus) {
    const auto& [major, minor] = *object.surface->torus;
    all.push_back({ExactPoint{}, abs(number::exact(major)) + abs(number::exact(minor))});
  } else if (object.shape && object.shape->ends) {
    for (const RoundEnd& end : *object.shape->ends) all.push_back(at(end.at, end.radius));
  } else if (object.shape) {
    if (const auto* const sphere = std::get_if<scene::Sphere>(&object.shape->surface))
      all.push_back(at(sphere->centro, sphere->radio));
    if (const auto* const disc = std::get_if<scene::Disc>(&object.shape->surface))
      all.push_back(at(disc->centro, disc->radio));
    if (const auto* const triangle = std::get_if<scene::Triangle>(&object.shape->surface))
      for (const glm::dvec3& vertex : triangle->vertices) all.push_back(at(vertex, 0));
  }
  return all;
}

/// Whether a bound holds an object, which these transformations move after its own. A ball stays one where they are
/// shifts, and a hull of points is one of points.
bool holds(const PovObject& bound, const PovObject& object, std::vector<const PovTransform*> by) {
  if (object.light) return true;
  if (object.is_left_out || object.is_inverse) return false;
  by.insert(by.begin(), &object.moved);
  const auto is_held = [&](const PovObject& part) { return holds(bound, part, by); };
  if (!object.parts.empty() && object.word == "intersection") return std::ranges::any_of(object.parts, is_held);
  if (!object.parts.empty() && object.word == "difference") return is_held(object.parts.front());
  if (!object.parts.empty()) return std::ranges::all_of(object.parts, is_held);
  const std::vector<ExactBall> balls = balls_around(object);
  const bool is_shift = std::ranges::all_of(by, &PovTransform::is_shift);
  return !balls.empty() && std::ranges::all_of(balls, [&](const ExactBall& ball) {
    return (is_shift || ball.radius == 0) && holds(bound, {put(ball.center, by), ball.radius});
  });
}

}  // namespace

bool surely_hold(const std::vector<PovObject>& bounds, const PovObject& object) {
  return !bounds.empty() &&
         std::ranges::all_of(bounds, [&](const PovObject& bound) { return holds(bound, object, {}); });
}

}  // namespace durero::io
