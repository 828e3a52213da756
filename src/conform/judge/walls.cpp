#include "conform/judge/walls.hpp"

#include <algorithm>

#include "conform/judge/limits.hpp"

namespace durero::conform {
namespace {

/// Whether a ray from inside a solid may pass through its surface without a hit: the profile permits it, or the system
/// answers the origin, and all hits are asked for, or the origin is nearer than least_t or than the range of the ray.
bool may_leave_unseen(const ClaimContext& trial) {
  const Profile& profile = trial.profile;
  const bool begins_behind = trial.range && trial.range->begin > 0;
  return profile.inside == Inside::nothing ||
         (profile.inside == Inside::origin && (profile.least_t > 0 || begins_behind || is_about_all(trial.question)));
}

bool is_asked(const ClaimContext& trial, const Zone& zone) {
  return is_within_limits(trial, zone) && is_within_range(trial, zone);
}

}  // namespace

std::vector<Zone> walls_of_elements(const ClaimContext& trial, double limit) {
  std::vector<Zone> all = zones(trial.elements(), trial.facts.tree(), trial.ray, trial.precision(), limit);
  std::erase_if(all, [&](const Zone& zone) { return !is_asked(trial, zone); });
  if (!may_leave_unseen(trial)) return all;
  const std::vector<scene::ElementRef> around = trial.solids_around_origin();
  std::erase_if(all, [&](const Zone& zone) {
    return std::find(around.begin(), around.end(), trial.body(zone.element)) != around.end();
  });
  return all;
}

std::optional<Zone> wall_of_mesh(const ClaimContext& trial) {
  if (!trial.profile.watertight || !trial.facts.mesh()) return std::nullopt;
  const std::optional<Zone> zone = zone_of(*trial.facts.mesh(), trial.ray.rayo, trial.precision());
  return zone && is_asked(trial, *zone) ? zone : std::nullopt;
}

std::vector<Zone> walls(const ClaimContext& trial, double limit) {
  std::vector<Zone> all = walls_of_elements(trial, limit);
  if (const auto zone = wall_of_mesh(trial)) all.push_back(*zone);
  return all;
}

}  // namespace durero::conform
