#include "conform/limits.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "conform/shell.hpp"
#include "durero/surface/exact.hpp"

namespace durero::conform {
namespace {

using surface::exact::Parameter;

/// How far the distance of t, which is t or t·|v| by the profile's measure, is less (−1) or more (1) than limit +
/// by/|v| or limit + by. Precondition: t ≥ 0. Where the number is negative t is more.
///
/// By squares: (t·|v|)² is one number with the root of t. Of the parameter limit·|v| is one whose sum with `by` has no
/// such square, and longest, the largest coordinate of v, stands for |v| in by/|v|, which is larger by that.
int compared(const Trial& trial, const Parameter& t, double limit, const Dyadic& by) {
  const glm::dvec3& v = trial.ray.rayo.v().xyz();
  if (trial.profile.measure != Measure::length) {
    const Dyadic longest(largest(v));
    return sign_at({{}, number::shifted(longest, -1), -(Dyadic(limit) * longest + by)}, t);
  }
  const Dyadic length = Dyadic(limit) + by;
  if (number::sign(length) < 0) return 1;
  return sign_at({squared_length(Point<Dyadic>{v.x, v.y, v.z}), {}, -square(length)}, t);
}

}  // namespace

bool is_truth_beyond_limits(const Trial& trial) {
  if (!trial.has_hit()) return false;
  const double number = number_of_truth(trial);
  return number < trial.profile.least_t || number > trial.profile.greatest_t;
}

bool is_all_beyond_limits(const Trial& trial) {
  const auto is_beyond = [&](const surface::exact::Crossing& crossing) {
    const auto& [begin, end] = crossing.segment;
    if (!begin || !end || *begin != *end) return false;
    const auto& [least, greatest] = std::pair(trial.profile.least_t, trial.profile.greatest_t);
    return compared(trial, *begin, least, {}) < 0 ||
           (std::isfinite(greatest) && compared(trial, *begin, greatest, {}) > 0);
  };
  const auto crossings = surface::exact::all_hits(trial.scene, trial.ray.rayo, trial.ray.en);
  return std::all_of(crossings.begin(), crossings.end(), is_beyond);
}

Profile without_limits(Profile profile) {
  profile.least_t = 0;
  profile.greatest_t = std::numeric_limits<double>::infinity();
  return profile;
}

bool is_within_limits(const Trial& trial, const Zone& zone) {
  const auto& [least, greatest] = std::pair(trial.profile.least_t, trial.profile.greatest_t);
  const Dyadic apart = number::shifted(zone.delta, 1);
  const bool is_behind_least = least == 0 || compared(trial, zone.begin, least, apart) >= 0;
  return is_behind_least && (!std::isfinite(greatest) || compared(trial, zone.end, greatest, -apart) <= 0);
}

}  // namespace durero::conform
