#include "nearest.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>

namespace durero::oracle::sampled {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

class NearestCandidate {
 public:
  NearestCandidate(const Cover& cover, const ScaledRay& line) : cover_(cover), line_(line) { visit(0); }

  std::optional<SampledCandidate> candidate() const {
    if (foot_ == infinity) return std::nullopt;
    return SampledCandidate{foot_, cover_.samples[which_]};
  }

 private:
  void visit(std::uint32_t index) {
    const BallNode& ball = cover_.balls[index];
    if (!may_hold_candidate(ball, cover_.delta, line_, foot_)) return;
    if (ball.right == 0) return look(ball.first, ball.last);
    visit(index + 1);
    visit(ball.right);
  }

  void look(std::uint32_t first, std::uint32_t last) {
    const double limit = cover_.delta * cover_.delta;
    for (std::uint32_t i = first; i < last; ++i) {
      const glm::dvec3 q = cover_.samples[i] - line_.p;
      const double foot = std::max(0.0, glm::dot(q, line_.direction));
      const glm::dvec3 apart = q - line_.direction * foot;
      if (foot >= foot_ || glm::dot(apart, apart) > limit) continue;
      foot_ = foot;
      which_ = i;
    }
  }

  const Cover& cover_;
  const ScaledRay& line_;
  double foot_ = infinity;
  std::uint32_t which_ = 0;
};

}  // namespace

bool may_hold_candidate(const BallNode& ball, double delta, const ScaledRay& line, double foot) {
  const glm::dvec3 to_center = ball.center - line.p;
  const double along = glm::dot(to_center, line.direction);
  const glm::dvec3 apart = to_center - line.direction * std::max(0.0, along);
  const double reach = (ball.radius + delta) * (1 + 0x1p-40) + 0x1p-40 * glm::length(to_center);
  return glm::dot(apart, apart) <= reach * reach && along - reach < foot;
}

std::optional<SampledCandidate> nearest(const Cover& cover, const ScaledRay& line) {
  return NearestCandidate(cover, line).candidate();
}

bool near_sample(const Cover& cover, const glm::dvec3& point, double slack, std::uint32_t index) {
  const BallNode& ball = cover.balls[index];
  const double limit = cover.delta + slack;
  if (glm::length(ball.center - point) > ball.radius + limit) return false;
  if (ball.right != 0)
    return near_sample(cover, point, slack, index + 1) || near_sample(cover, point, slack, ball.right);
  return std::any_of(cover.samples.begin() + ball.first, cover.samples.begin() + ball.last,
                     [&](const glm::dvec3& sample) { return glm::length(sample - point) <= limit; });
}

}  // namespace durero::oracle::sampled
