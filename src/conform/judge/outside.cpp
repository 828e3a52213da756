#include "conform/judge/outside.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "conform/families/framed_shape.hpp"
#include "conform/judge/allowance.hpp"
#include "conform/judge/cast.hpp"
#include "durero/scene/attributes.hpp"

namespace durero::conform {
namespace {

using scene::ElementRef;

/// Whether x, a length or the largest coordinate of v or of a triangle, is a normal number of the format: a smaller one
/// is no length any more. The coordinates of a point or a unit vector need only be not too large, for each may vanish
/// beside the others.
bool is_of(double x, NumberFormat format) {
  return format == NumberFormat::binary64 || (std::abs(x) <= static_cast<double>(std::numeric_limits<float>::max()) &&
                                              std::abs(x) >= static_cast<double>(std::numeric_limits<float>::min()));
}
bool is_of(const glm::dvec3& v, NumberFormat format) { return largest(v) < 1 || is_of(largest(v), format); }
bool is_of(const scene::Corners& corners, NumberFormat format) { return is_of(largest(corners), format); }

bool is_beyond(double x, double least_allowed, double greatest_allowed) {
  return x < least_allowed || x > greatest_allowed;
}

std::string beyond(double x, std::string_view what, double least_allowed, double greatest_allowed) {
  if (x < least_allowed) return fmt::format("{} at least {}", what, least_allowed);
  if (x > greatest_allowed) return fmt::format("{} at most {}", what, greatest_allowed);
  return {};
}

/// The clause of the profile that excludes an element by its type, the format of its numbers, its sizes or its
/// coordinates; empty where none does.
template <class Shape>
std::string clause_of(const ClaimContext& trial, ElementRef element, const Shape& shape) {
  const Profile& profile = trial.profile;
  const model::Tipo tipo = trial.body(element).tipo;
  const bool is_of_grid = trial.is_grid && asks_grids(profile.tipos, profile.bodies);
  if (!is_of_grid && std::find(profile.tipos.begin(), profile.tipos.end(), tipo) == profile.tipos.end())
    return fmt::format("no {}", Shape::word);
  if (profile.caps == Caps::solid && is_axial(tipo) && !trial.is_solid(trial.body(element)))
    return fmt::format("no open {}", Shape::word);
  std::string clause;
  scene::for_each_attribute<Shape>([&](const auto& attribute) {
    if (!clause.empty()) return;
    const auto& value = shape.*attribute.field;
    constexpr bool is_size = std::is_same_v<std::decay_t<decltype(value)>, double>;
    const double least = is_size ? profile.least_size : 0;
    const double greatest = is_size ? profile.greatest_size : profile.greatest_coordinate;
    if (!is_of(value, profile.format)) {
      clause = "numbers of binary32";
    } else if (is_length(attribute.component) && is_beyond(largest(value), least, greatest)) {
      clause = beyond(largest(value), is_size ? "a size" : "a coordinate", least, greatest);
    }
  });
  return clause;
}

/// The clause of a body, whose sizes are the lengths of its sides, and its radius.
std::string clause_of_body(const Profile& profile, const AskedBody& body) {
  if (std::ranges::find(profile.bodies, body.kind) == profile.bodies.end())
    return fmt::format("no {}", word(body.kind));
  const double greatest = profile.greatest_coordinate;
  std::string clause;
  if (is_beyond(largest(body.centro), 0, greatest)) clause = beyond(largest(body.centro), "a coordinate", 0, greatest);
  std::vector<double> sizes;
  for (const glm::dvec3& side : body.sides) {
    if (!is_of(largest(side), profile.format)) return "numbers of binary32";
    sizes.push_back(length_of(side));
  }
  if (has_radius(body.kind)) {
    if (!is_of(body.radio, profile.format)) return "numbers of binary32";
    sizes.push_back(body.radio);
  }
  for (const double size : sizes) {
    if (clause.empty() && is_beyond(size, profile.least_size, profile.greatest_size))
      clause = beyond(size, "a size", profile.least_size, profile.greatest_size);
  }
  return is_of(body.centro, profile.format) ? clause : "numbers of binary32";
}

/// The clause of a surface of a text, whose type the profile must name; numbers of binary32 cannot be too large or too
/// small for it.
std::string clause_of_surface(const Profile& profile, const AskedSurface& surface) {
  if (std::ranges::find(profile.surfaces, surface.type) == profile.surfaces.end())
    return fmt::format("no {}", surface.type);
  return {};
}

/// The clause of a ball that is cast.
std::string clause_of_ball(const ClaimContext& trial) {
  const Profile& profile = trial.profile;
  const double radius = trial.range->radio;
  if (!is_of(radius, profile.format)) return "numbers of binary32";
  if (is_beyond(radius, profile.least_size, profile.greatest_size))
    return beyond(radius, "a size", profile.least_size, profile.greatest_size);
  return profile.touching == Touching::undefined && may_begin_in_touch(trial) ? "a start in touch" : "";
}

}  // namespace

std::string outside_by_scene(const ClaimContext& trial) {
  std::string clause;
  trial.scene.any_of([&](ElementRef element, const auto& shape) {
    const AskedBody* const body = trial.elements().body(element);
    const AskedSurface* const surface = trial.elements().surface(element);
    clause = body      ? clause_of_body(trial.profile, *body)
             : surface ? clause_of_surface(trial.profile, *surface)
                       : clause_of(trial, element, shape);
    return !clause.empty();
  });
  return clause;
}

std::string outside_by_ray(const ClaimContext& trial) {
  const Profile& profile = trial.profile;
  const model::Rayo& rayo = trial.ray.rayo;
  if (!is_of(rayo.p().xyz(), profile.format) || !is_of(largest(rayo.v().xyz()), profile.format))
    return "numbers of binary32";
  std::string clause = beyond(largest(rayo.p().xyz()), "a coordinate", 0, profile.greatest_coordinate);
  if (!clause.empty()) return clause;
  if (trial.question == QuestionKind::cast) clause = clause_of_ball(trial);
  if (!clause.empty()) return clause;
  if (profile.inside == Inside::undefined && !trial.solids_around_origin().empty()) return "a start inside";
  if (!trial.has_hit()) return clause;
  return beyond(number_of_truth(trial), "a distance", profile.least_t, profile.greatest_t);
}

}  // namespace durero::conform
