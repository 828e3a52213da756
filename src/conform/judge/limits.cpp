#include "conform/judge/limits.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "conform/judge/shell.hpp"
#include "durero/surface/exact.hpp"

namespace durero::conform {
namespace {

using surface::exact::Parameter;

/// The sign of the comparison of a distance with a limit: −1, 0 or 1 where the distance of t is less than, equal to or
/// more than the limit moved by `by`. Where the profile measures lengths, the distance is t·|v| and the limit is
/// limit + by; otherwise they are t and limit + by/|v|. Where limit + by is negative, a length is more. Precondition:
/// t ≥ 0.
///
/// Lengths are compared by their squares: (t·|v|)² is one number with the root of t. For the parameter,
/// (limit·|v| + by)² would need a second root; the largest coordinate of v stands for |v| in by/|v|, whose magnitude is
/// larger by that.
int compared(const ClaimContext& trial, Measure measure, const Parameter& t, double limit, const Dyadic& by) {
  const glm::dvec3& v = trial.ray.rayo.v().xyz();
  if (measure != Measure::length) {
    const Dyadic longest(largest(v));
    return sign_at({{}, number::shifted(longest, -1), -(Dyadic(limit) * longest + by)}, t);
  }
  const Dyadic length = Dyadic(limit) + by;
  if (number::sign(length) < 0) return 1;
  return sign_at({squared_length(Point<Dyadic>{v.x, v.y, v.z}), {}, -square(length)}, t);
}

/// The place of the ray at t.
ClaimedPoint place_of_t(const model::Rayo& rayo, double t) {
  const glm::dvec3 &p = rayo.p().xyz(), &v = rayo.v().xyz();
  const auto coordinate = [&](double from, double step) { return Dyadic(from) + Dyadic(t) * Dyadic(step); };
  return {.t = {.x = t},
          .punto = {coordinate(p.x, v.x), coordinate(p.y, v.y), coordinate(p.z, v.z)},
          .way = Dyadic(t) * Dyadic(largest(v))};
}

Dyadic delta_at(const ClaimContext& trial, scene::ElementRef element, const ClaimedPoint& place) {
  return delta(trial.elements(), element, place, trial.ray.rayo, trial.precision());
}

/// The comparison by what the profile measures.
int compared(const ClaimContext& trial, const Parameter& t, double limit, const Dyadic& by) {
  return compared(trial, trial.profile.measure, t, limit, by);
}

}  // namespace

bool is_within_range(const ClaimContext& trial, const Zone& zone) {
  if (!trial.range) return true;
  const auto& [begin, end, radio] = *trial.range;
  const Dyadic apart(number::shifted(zone.delta, 1));
  return (begin == 0 || compared(trial, Measure::parameter, zone.begin, begin, apart) >= 0) &&
         (std::isinf(end) || compared(trial, Measure::parameter, zone.end, end, -apart) <= 0);
}

bool may_be_within_range(const ClaimContext& trial, scene::ElementRef element, const ClaimedPoint& place) {
  if (!trial.range) return true;
  const auto& [begin, end, radio] = *trial.range;
  const Dyadic apart = Dyadic(2 + place.deviation) * delta_at(trial, element, place);
  return compared(trial, Measure::parameter, place.t, begin, -apart) >= 0 &&
         (std::isinf(end) || compared(trial, Measure::parameter, place.t, end, apart) <= 0);
}

std::optional<Parameter> earliest_asked(const ClaimContext& trial, scene::ElementRef element) {
  const auto first_from = [&](const Parameter& from) {
    return earliest(trial.elements(), element, trial.ray.rayo, trial.precision(), from);
  };
  if (!trial.range) return first_from({});
  const auto& [begin, end, radio] = *trial.range;
  const auto apart = [&](double t) {
    return number::shifted(delta_at(trial, element, place_of_t(trial.ray.rayo, t)), 1);
  };
  const Dyadic longest(largest(trial.ray.rayo.v().xyz()));
  const Dyadic from = begin > 0 ? Dyadic(begin) * longest - apart(begin) : Dyadic(0);
  const auto t = first_from(number::sign(from) > 0 ? Parameter{.x = from, .w = longest} : Parameter{});
  if (!t || std::isinf(end)) return t;
  return compared(trial, Measure::parameter, *t, end, apart(end)) <= 0 ? t : std::nullopt;
}

bool is_truth_beyond_limits(const ClaimContext& trial) {
  if (!trial.has_hit()) return false;
  const double number = number_of_truth(trial);
  return number < trial.profile.least_t || number > trial.profile.greatest_t;
}

bool is_all_beyond_limits(const ClaimContext& trial) {
  const auto is_beyond = [&](const surface::exact::Crossing& crossing) {
    const auto& [begin, end] = crossing.segment;
    if (!begin || !end || *begin != *end) return false;
    const auto& [least, greatest] = std::pair(trial.profile.least_t, trial.profile.greatest_t);
    return compared(trial, *begin, least, {}) < 0 ||
           (std::isfinite(greatest) && compared(trial, *begin, greatest, {}) > 0);
  };
  const auto crossings = all_crossings(trial.scene, trial.ray, trial.others);
  return std::all_of(crossings.begin(), crossings.end(), is_beyond);
}

Profile without_limits(Profile profile) {
  profile.least_t = 0;
  profile.greatest_t = std::numeric_limits<double>::infinity();
  return profile;
}

bool is_within_limits(const ClaimContext& trial, const Zone& zone) {
  const auto& [least, greatest] = std::pair(trial.profile.least_t, trial.profile.greatest_t);
  const Dyadic apart = number::shifted(zone.delta, 1);
  const bool is_behind_least = least == 0 || compared(trial, zone.begin, least, apart) >= 0;
  return is_behind_least && (!std::isfinite(greatest) || compared(trial, zone.end, greatest, -apart) <= 0);
}

}  // namespace durero::conform
