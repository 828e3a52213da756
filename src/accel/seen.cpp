#include "durero/accel/seen.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace durero::accel {
namespace {

// The bound on errors of cosines. Cosines of angles between directions, and of sums and differences of angles, are made
// of fewer than ten products and sums of numbers up to 1. The directions are 1 long up to 8u each, and a difference of
// points is off by u of its length; a sine and a cosine made of each other by √((1 − x)(1 + x)) are those of one angle
// up to 4u. The sum is less than 100u, and this is 256u.
constexpr double angle_slack = 0x1p-45;

double complement(double x) { return std::sqrt(std::max(0.0, (1 - x) * (1 + x))); }

}  // namespace

// cos(α + w) ≥ cos α·(1 − w²/2) − w·sin α.
DirectionCone cone(const glm::dvec3& axis, double cosine, double more) {
  const double least = std::min(cosine, 1.0) - angle_slack;
  const double wider = std::max(0.0, least * (1 - more * more) - more * complement(least));
  return {direction(axis), wider, complement(wider)};
}

double cosine_between(const glm::dvec3& a, const glm::dvec3& b) { return glm::dot(a, b); }

glm::dvec3 direction(const glm::dvec3& vector) { return vector / std::sqrt(glm::dot(vector, vector)); }

ApparentBall seen(const surface::Ball& ball, const glm::dvec3& from) {
  const glm::dvec3 to = ball.centre - from;
  const double distance = std::sqrt(glm::dot(to, to)), slack = 0x1p-45 * (distance + ball.radius);
  const bool around = !(distance > ball.radius + slack);  // an infinite radius too
  if (around) {
    return {.around = true,
            .towards = {},
            .cosine = 0,
            .sine = 1,
            .distance = distance,
            .near = 0,
            .far = distance + ball.radius + slack};
  }
  const double sine = std::min(1.0, ball.radius / distance * (1 + 0x1p-45));
  return {.around = false,
          .towards = to / distance,
          .cosine = complement(sine),
          .sine = sine,
          .distance = distance,
          .near = distance - ball.radius - slack,
          .far = distance + ball.radius + slack};
}

// The angles of a cone and of a ball that it sees add up to the angle of the centres at least. The sum is 180° at most,
// where the cosine falls with the angle.
bool may_be_seen(const ApparentBall& ball, const DirectionCone& cone) {
  if (ball.around) return true;
  const double farthest = ball.cosine * cone.cosine - ball.sine * cone.sine;
  return cosine_between(ball.towards, cone.axis) >= farthest - angle_slack;
}

// The ball covers the cone where the angle between axis and centre and the angle of the cone add up to that of the sine
// at most.
bool is_covered(const DirectionCone& cone, const ApparentBall& ball, double sine) {
  if (ball.around || sine < cone.sine) return false;
  const double nearest = complement(sine) * cone.cosine + sine * cone.sine;
  return cosine_between(ball.towards, cone.axis) >= nearest + angle_slack;
}

}  // namespace durero::accel
