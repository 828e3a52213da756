#include "conform/judge/walls.hpp"

#include <algorithm>

#include "conform/judge/limits.hpp"
#include "conform/judge/shell.hpp"

namespace durero::conform {
namespace {

using scene::ElementRef;

/// Whether a ray from inside a solid may pass through its surface without a hit: the profile permits it, or the system
/// answers the origin, and all hits are asked for, or the origin is nearer than least_t or than the range of the ray.
bool may_leave_unseen(const ClaimContext& trial) {
  const Profile& profile = trial.profile;
  const bool begins_behind = trial.range && trial.range->begin > 0;
  return profile.inside == Inside::nothing ||
         (profile.inside == Inside::origin && (profile.least_t > 0 || begins_behind || is_about_all(trial.question)));
}

/// Whether the ray comes from the back of a flat element, which is its own body. It is certain where a zone is: the ray
/// of all data goes from one side to the other.
bool is_from_the_back(const ClaimContext& trial, ElementRef element) {
  if (trial.body(element) != element) return false;
  const surface::Point<Dyadic> v{trial.ray.rayo.v().x(), trial.ray.rayo.v().y(), trial.ray.rayo.v().z()};
  return trial.scene.visit(element, [&]<class Shape>(const Shape& shape) {
    if constexpr (std::is_same_v<Shape, scene::Triangle>) {
      const auto& [a, b, c] = shape.vertices;
      return number::sign(dot(v, cross(surface::between<Dyadic>(a, b), surface::between<Dyadic>(a, c)))) > 0;
    } else if constexpr (std::is_same_v<Shape, scene::Disc> || std::is_same_v<Shape, scene::Plane>) {
      return number::sign(dot(v, surface::Point<Dyadic>{shape.vector.x, shape.vector.y, shape.vector.z})) > 0;
    } else {
      return false;
    }
  });
}

bool is_asked(const ClaimContext& trial, const Zone& zone) {
  return is_within_limits(trial, zone) && is_within_range(trial, zone);
}

}  // namespace

std::vector<Zone> walls_of_elements(const ClaimContext& trial, double limit) {
  std::vector<Zone> all = zones(trial.elements(), trial.facts.tree(), trial.ray, trial.precision(), limit);
  const bool has_unseen = trial.profile.back_faces == BackFaces::unseen;
  std::erase_if(all, [&](const Zone& zone) {
    return !is_asked(trial, zone) || (has_unseen && is_from_the_back(trial, zone.element));
  });
  if (!may_leave_unseen(trial)) return all;
  const std::vector<ElementRef> around = trial.solids_around_origin();
  std::erase_if(all, [&](const Zone& zone) {
    return std::find(around.begin(), around.end(), trial.body(zone.element)) != around.end();
  });
  return all;
}

std::optional<Zone> wall_of_mesh(const ClaimContext& trial) {
  if (!trial.profile.watertight || !trial.facts.mesh()) return std::nullopt;
  if (trial.profile.back_faces == BackFaces::unseen) return std::nullopt;  // the origin sees backs perhaps
  const std::optional<Zone> zone = zone_of(*trial.facts.mesh(), trial.ray.rayo, trial.precision());
  return zone && is_asked(trial, *zone) ? zone : std::nullopt;
}

std::vector<Zone> walls(const ClaimContext& trial, double limit) {
  std::vector<Zone> all = walls_of_elements(trial, limit);
  if (const auto zone = wall_of_mesh(trial)) all.push_back(*zone);
  return all;
}

}  // namespace durero::conform
