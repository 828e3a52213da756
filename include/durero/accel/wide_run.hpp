#pragma once
/// Which rays that follow each other may walk the wide hierarchy as one bundle.

#include <algorithm>
#include <glm/common.hpp>

#include "durero/accel/slab.hpp"

namespace durero::accel {

/// Between which the origins and the directions of some rays lie.
class WideRun {
 public:
  /// Of one ray, as far as the box of the scene, which must outlive it, or to its limit.
  WideRun(const trace::Ray& ray, const surface::Box& all, double limit)
      : p_low_(ray.p), p_high_(ray.p), v_low_(ray.v), v_high_(ray.v), first_(ray), all_(all), limit_(limit) {}

  /// Takes another one in, if in the directions no component is 0, those along an axis are of one sign, and on the way
  /// all stay within so much of each other. Whether it did. How far they go is found out where they start together:
  /// most that find no company do not.
  bool join(const trace::Ray& ray, double narrow) {
    const glm::dvec3 p_low = glm::min(p_low_, ray.p), p_high = glm::max(p_high_, ray.p);
    const glm::dvec3 v_low = glm::min(v_low_, ray.v), v_high = glm::max(v_high_, ray.v);
    for (int i = 0; i < 3; ++i)
      if (!(p_high[i] - p_low[i] <= narrow) || !(v_low[i] > 0 || v_high[i] < 0)) return false;
    if (reach_ < 0) reach_ = std::max(stretch(all_, Beam(first_), limit_).exit, 0.0);
    for (int i = 0; i < 3; ++i)
      if (!(p_high[i] - p_low[i] + reach_ * (v_high[i] - v_low[i]) <= narrow)) return false;
    p_low_ = p_low, p_high_ = p_high, v_low_ = v_low, v_high_ = v_high;
    return true;
  }

 private:
  glm::dvec3 p_low_, p_high_, v_low_, v_high_;
  trace::Ray first_;
  const surface::Box& all_;
  double limit_;
  double reach_ = -1;  // not known yet
};

}  // namespace durero::accel
