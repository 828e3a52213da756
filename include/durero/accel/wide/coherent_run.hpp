#pragma once
/// A run is a sequence of consecutive rays that are coherent enough to traverse as one bundle.

#include <algorithm>
#include <glm/common.hpp>

#include "durero/accel/slab.hpp"

namespace durero::accel {

/// The bounds of the origins and the directions of a run's rays.
class CoherentRun {
 public:
  /// A run of one ray, whose reach is measured to the box of the scene, `all`, or to the limit. `all` must outlive the
  /// run.
  CoherentRun(const trace::Ray& ray, const surface::Box& all, double limit)
      : p_low_(ray.p), p_high_(ray.p), v_low_(ray.v), v_high_(ray.v), first_(ray), all_(all), limit_(limit) {}

  /// Adds a ray to the run, if the directions have no component 0, the components along an axis have one sign, and the
  /// rays stay within `narrow` of each other along each axis, up to the reach of the first. Whether the ray was added.
  /// The reach is computed only after the origins pass, because most incoherent rays fail there.
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
  double reach_ = -1;  // negative until it is computed
};

}  // namespace durero::accel
