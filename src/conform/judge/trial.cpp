#include "conform/judge/trial.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "conform/families/solids.hpp"
#include "conform/judge/allowance.hpp"

namespace durero::conform {
namespace {

using surface::Point;

Dyadic dot(const Point<Dyadic>& a, const Point<Dyadic>& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Point<Dyadic> dyadic_point(const glm::dvec3& a) { return {a.x, a.y, a.z}; }

/// The parameter length/|v|, rounded once; a quotient beyond the range of binary64 becomes the largest finite number.
/// times_length() is the way back, t·|v|, rounded once.
double over_length(double length, const glm::dvec3& v) {
  const Dyadic squared = surface::squared_length(dyadic_point(v));
  if (squared == Dyadic(1)) return length;
  const double t = number::round_to_binary64(number::DyadicSurd{.y = length, .delta = squared, .w = squared});
  constexpr double most = std::numeric_limits<double>::max();
  return std::clamp(t, -most, most);
}
double times_length(double t, const glm::dvec3& v) {
  const Dyadic squared = surface::squared_length(dyadic_point(v));
  if (squared == Dyadic(1) || !std::isfinite(t)) return t;
  return number::round_to_binary64(number::DyadicSurd{.y = t, .delta = squared});
}

bool gives_point(const ClaimContext& trial, const Claim& claim) {
  return trial.profile.measure == Measure::point || !claim.t;
}

ClaimedPoint place_at(const model::Rayo& rayo, double t, int deviation) {
  const glm::dvec3 &p = rayo.p().xyz(), &v = rayo.v().xyz();
  const auto coordinate = [&](double from, double step) { return Dyadic(from) + Dyadic(t) * Dyadic(step); };
  return {{.x = t},
          {coordinate(p.x, v.x), coordinate(p.y, v.y), coordinate(p.z, v.z)},
          Dyadic(std::abs(t)) * Dyadic(largest(v)),
          deviation,
          t};
}

/// The place of a claimed point. Its t is that of the foot of the perpendicular from the point to the ray's line.
ClaimedPoint place_of(const model::Rayo& rayo, const glm::dvec3& punto) {
  const Point<Dyadic> v = dyadic_point(rayo.v().xyz()), from_p = from(rayo.p().xyz(), dyadic_point(punto));
  const Dyadic way = std::max({absolute(from_p.x), absolute(from_p.y), absolute(from_p.z)});
  return {{.x = dot(from_p, v), .w = dot(v, v)}, dyadic_point(punto), way, 4, std::nullopt};
}

/// The square of 4δ, with δ of the element at the place.
Dyadic squared_deviation(const ClaimContext& trial, scene::ElementRef element, const ClaimedPoint& place) {
  return square(Dyadic(4) * delta(trial.elements(), element, place, trial.ray.rayo, trial.precision()));
}

}  // namespace

scene::ElementRef ClaimContext::body(scene::ElementRef element) const {
  if (profile.caps == Caps::open) return element;
  const Solid* solid = solid_closed_by(solids, element);
  return solid == nullptr ? element : solid->wall;
}

bool ClaimContext::is_solid(scene::ElementRef element) const {
  if (others.surface(element)) return false;
  if (element.tipo == model::Tipo::soy_esfera) return true;
  if (element.tipo == model::Tipo::soy_plano) return profile.half_spaces;
  return profile.caps == Caps::solid &&
         std::any_of(solids.begin(), solids.end(), [&](const Solid& solid) { return solid.wall == element; });
}

bool ClaimContext::may_start_inside(scene::ElementRef element) const {
  const glm::dvec3& p = ray.rayo.p().xyz();
  const ClaimedPoint origin{.t = {}, .punto = {p.x, p.y, p.z}, .way = {}};
  return may_lie_inside(elements(), element, origin, ray.rayo, precision());
}

std::vector<scene::ElementRef> ClaimContext::solids_around_origin() const {
  std::vector<scene::ElementRef> around;
  const auto add = [&](scene::ElementRef element) {
    if (may_start_inside(element)) around.push_back(element);
  };
  // A body stands among the spheres.
  for (std::uint32_t i = 0; i < scene.shapes<scene::Sphere>().size(); ++i) add({scene::Sphere::tipo, i});
  for (std::uint32_t i = 0; profile.half_spaces && i < scene.shapes<scene::Plane>().size(); ++i)
    add({scene::Plane::tipo, i});
  if (profile.caps == Caps::open) return around;
  for (const Solid& solid : solids) add(solid.wall);
  return around;
}

double rounded(double x, NumberFormat format) {
  return format == NumberFormat::binary32 ? static_cast<double>(static_cast<float>(x)) : x;
}

double number_of(const ClaimContext& trial, const scene::Hit& hit) {
  return trial.profile.measure == Measure::length ? times_length(hit.t, trial.ray.rayo.v().xyz()) : hit.t;
}

double number_of_truth(const ClaimContext& trial) { return number_of(trial, trial.truth.hit); }

bool is_exactly(const ClaimContext& trial, const Claim& claim, const scene::Hit& hit) {
  const auto is_named = [&](scene::ElementRef e) { return trial.names(claim, e); };
  if (std::none_of(hit.elementos.begin(), hit.elementos.end(), is_named)) return false;
  const NumberFormat format = trial.profile.format;
  if (!gives_point(trial, claim)) return claim.t == rounded(number_of(trial, hit), format);
  const glm::dvec3& p = hit.punto;
  return claim.punto == glm::dvec3(rounded(p.x, format), rounded(p.y, format), rounded(p.z, format));
}

bool is_the_truth(const ClaimContext& trial, const Claim& claim) {
  return trial.has_hit() && is_exactly(trial, claim, trial.truth.hit);
}

std::optional<ClaimedPoint> place(const ClaimContext& trial, const Claim& claim) {
  const model::Rayo& rayo = trial.ray.rayo;
  if (gives_point(trial, claim)) {
    const glm::dvec3 p = claim.punto.value_or(glm::dvec3(std::numeric_limits<double>::quiet_NaN()));
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) return std::nullopt;
    return place_of(rayo, p);
  }
  if (!std::isfinite(*claim.t)) return std::nullopt;
  const bool is_length = trial.profile.measure == Measure::length;
  return is_length ? place_at(rayo, over_length(*claim.t, rayo.v().xyz()), 2) : place_at(rayo, *claim.t, 0);
}

bool may_lie_on_ray(const ClaimContext& trial, scene::ElementRef element, const ClaimedPoint& place) {
  const Point<Dyadic> v = dyadic_point(trial.ray.rayo.v().xyz()), q = from(trial.ray.rayo.p().xyz(), place.punto);
  const Dyadic beside = squared_deviation(trial, element, place), x = dot(q, v), vv = dot(v, v);
  const bool is_before = number::sign(x) < 0 && square(x) > beside * vv;
  return !is_before && dot(q, q) * vv - square(x) <= beside * vv;
}

std::vector<scene::ElementRef> elements_at(const ClaimContext& trial, const Claim& claim, const ClaimedPoint& place) {
  std::vector<scene::ElementRef> at;
  const NearBox near = near_box(trial, place);
  trial.any_named(claim, [&](scene::ElementRef element) {
    const bool may_be = may_be_near(trial.scene, element, near) &&
                        may_lie_on(trial.elements(), element, place, trial.ray.rayo, trial.precision()) &&
                        may_lie_on_ray(trial, element, place);
    if (may_be) at.push_back(element);
    return false;
  });
  return at;
}

std::vector<scene::ElementRef> answered_origins(const ClaimContext& trial, const Claim& claim) {
  if (trial.profile.inside != Inside::origin) return {};
  std::vector<scene::ElementRef> around = trial.solids_around_origin();
  std::erase_if(around, [&](scene::ElementRef element) { return !trial.names(claim, element); });
  return around;
}

NearBox near_box(const ClaimContext& trial, const ClaimedPoint& place) {
  const auto& [x, y, z] = place.punto;
  const double longest = std::max(trial.facts.largest_length(), largest(trial.ray.rayo.p().xyz()));
  const Allowance allowed(trial.precision(), std::max(Dyadic(longest), place.way), trial.ray.rayo);
  return {{number::round_to_binary64(x), number::round_to_binary64(y), number::round_to_binary64(z)},
          bound_above(allowed.times(8))};
}

bool may_be_near(const scene::Scene& scene, scene::ElementRef element, const NearBox& near) {
  return element.tipo != scene::Triangle::tipo ||
         near.may_be_of(surface::box(scene.shapes<scene::Triangle>()[element.index]));
}

bool may_be_origin(const ClaimContext& trial, scene::ElementRef element, const ClaimedPoint& place) {
  const Point<Dyadic> q = from(trial.ray.rayo.p().xyz(), place.punto);
  return dot(q, q) <= squared_deviation(trial, element, place);
}

}  // namespace durero::conform
