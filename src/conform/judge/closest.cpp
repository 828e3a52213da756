#include "conform/judge/closest.hpp"

#include <algorithm>
#include <cmath>

#include "conform/judge/error_of.hpp"
#include "conform/judge/reach_of_errors.hpp"
#include "conform/judge/shell.hpp"
#include "durero/distance/distances.hpp"

namespace durero::conform {
namespace {

using scene::ElementRef;
using Vec = Point<Dyadic>;

Vec vec(const glm::dvec3& a) { return {a.x, a.y, a.z}; }
Vec between(const Vec& a, const Vec& b) { return {b.x - a.x, b.y - a.y, b.z - a.z}; }

/// The point asked, and what the claim says of the nearest.
struct ClaimedNearest {
  glm::dvec3 asked;
  std::optional<double> distance;
  std::optional<glm::dvec3> point;
};

/// The allowance of an element where a point so far from the one asked is answered.
template <class Shape>
Allowance allowance(const ClaimContext& trial, const Shape& shape, const Dyadic& way) {
  return Allowance(trial.precision(), magnitude(shape, trial.ray.rayo, way), trial.ray.rayo);
}

/// The error of the distance from the element, where it is about `distance`; nothing where it may be any.
std::optional<Dyadic> error_of_distance(const ClaimContext& trial, ElementRef element, double distance) {
  return trial.elements().visit_shape(element, [&](const auto& shape) {
    const Allowance allowed = allowance(trial, shape, Dyadic(distance));
    std::optional<Dyadic> reach = reach_of_errors(shape, allowed);
    if (reach) *reach += allowed.times(2);
    return reach;
  });
}

/// |a − b| ≤ by
bool is_within(double a, double b, const Dyadic& by) { return absolute(Dyadic(a) - Dyadic(b)) <= by; }

Dyadic largest_coordinate(const Vec& a) { return std::max({absolute(a.x), absolute(a.y), absolute(a.z)}); }

/// The claimed point as a place, which is on no ray.
ClaimedPoint place_of_nearest(const ClaimedNearest& claimed) {
  const Vec point = vec(*claimed.point);
  return {.t = {}, .punto = point, .way = largest_coordinate(between(vec(claimed.asked), point))};
}

/// Whether the point may be so far from the one asked as the claim says. Both are off by 1.84·δ together, and the
/// distance is rounded: 2δ.
bool is_so_far(const ClaimedNearest& claimed, const Dyadic& delta) {
  if (!claimed.distance) return true;
  const Dyadic squared = squared_length(between(vec(claimed.asked), vec(*claimed.point)));
  const Dyadic most = Dyadic(*claimed.distance) + number::shifted(delta, 1);
  const Dyadic least = Dyadic(*claimed.distance) - number::shifted(delta, 1);
  return number::sign(most) >= 0 && squared <= square(most) && (number::sign(least) <= 0 || squared >= square(least));
}

/// @{ Whether the point q may be the nearest of the moved shape to p, to first order.
/// q' − c' and p' − c' have one direction on a sphere about c'. They are off by (√3 + √3/16)·δ and 2√3·δ: the product
/// across is at most 3.47·δ·|q − c| + 1.84·δ·|p − c| and, of their squares, 20·δ².
bool may_be_foot(const scene::Sphere& e, const Vec& p, const Vec& q, const Allowance& allowed) {
  const Vec a = between(vec(e.centro), q), b = between(vec(e.centro), p);
  const Dyadic most = allowed.times(4) * (length_above(a) + length_above(b)) + Dyadic(32) * square(allowed.delta);
  return squared_length(cross(a, b)) <= square(most);
}
/// p' − q' has the direction of d'. It is off by 1.84·δ, and d by √3·u, which over |p − q| ≤ √3·M is 3.1·δ.
bool may_be_foot(const scene::Plane& e, const Vec& p, const Vec& q, const Allowance& allowed) {
  return squared_length(cross(between(q, p), vec(e.vector))) <= square(allowed.times(6));
}
/// (p' − q')·(x − q') ≤ 0 for each x of a convex shape, and so for the vertices of a triangle. Both factors are off by
/// 1.84·δ or a little more (a vertex by √3·δ): 2δ·(|p − q| + |x − q|), and 12·δ² for their product.
bool may_be_foot(const scene::Triangle& e, const Vec& p, const Vec& q, const Allowance& allowed) {
  const Vec way = between(q, p);
  return std::ranges::all_of(e.vertices, [&](const glm::dvec3& vertex) {
    const Vec x = between(q, vec(vertex));
    const Dyadic most = allowed.times(2) * (length_above(way) + length_above(x)) + Dyadic(12) * square(allowed.delta);
    return dot(way, x) <= most;
  });
}
/// The same for a disc, of which the farthest along w = p − q is centro + radio·w⊥/|w⊥|, with w⊥ for w in its plane:
/// w·(centro − q) + radio·|w⊥| ≤ 0. The points of the disc are off by 4.5·δ, so that this is at most 7δ·|w| +
/// 2δ·(|centro − q| + radio) + 40·δ². |w⊥| is |w × d| up to 2⁻⁵⁰ of it; half of the allowance is kept for that.
bool may_be_foot(const scene::Disc& e, const Vec& p, const Vec& q, const Allowance& allowed) {
  const Vec w = between(q, p), to_centre = between(q, vec(e.centro));
  const Dyadic reach = length_above(w), radio(e.radio);
  const Dyadic most = allowed.times(8) * reach + allowed.times(2) * (length_above(to_centre) + radio) +
                      Dyadic(40) * square(allowed.delta) - dot(w, to_centre);
  return number::sign(most) >= 0 && square(radio) * squared_length(cross(w, vec(e.vector))) <= square(most);
}
/// Of other shapes the point and its distance are asked for alone.
template <class Shape>
bool may_be_foot(const Shape&, const Vec&, const Vec&, const Allowance&) {
  return true;
}
/// @}

/// The distances that the nearest element of the truth may have.
struct TruthDistances {
  Dyadic least, most;
};

/// Nothing where it may have any.
std::optional<TruthDistances> distances_of_truth(const ClaimContext& trial) {
  const scene::Hit& truth = trial.truth.hit;
  if (!std::isfinite(truth.t)) return std::nullopt;
  const std::optional<Dyadic> error = error_of_distance(trial, truth.elementos.front(), truth.t);
  if (!error) return std::nullopt;
  return TruthDistances{Dyadic(truth.t) - *error, Dyadic(truth.t) + *error};
}

/// Whether the nearest element may be nearer than the least distance at which the system sees something. Inside a solid
/// that it answers the point itself of it is.
bool may_be_too_near(const ClaimContext& trial, const std::optional<TruthDistances>& truth) {
  const double least = trial.profile.least_t;
  if (least == 0) return false;
  const bool is_inside = trial.profile.inside == Inside::origin && !trial.solids_around_origin().empty();
  return is_inside || !truth || truth->least < Dyadic(least);
}

/// Whether the system may see nothing: the nearest element may be beyond one of its limits.
bool may_see_nothing(const ClaimContext& trial) {
  const std::optional<TruthDistances> truth = distances_of_truth(trial);
  const double greatest = trial.profile.greatest_t;
  return may_be_too_near(trial, truth) || (std::isfinite(greatest) && (!truth || truth->most > Dyadic(greatest)));
}

/// Whether the claimed point may be the nearest of the element, whose distance is that up to an error.
bool may_be_point_of(const ClaimContext& trial, ElementRef element, const ClaimedNearest& claimed, double exact,
                     const Dyadic& error) {
  const ClaimedPoint where = place_of_nearest(claimed);
  if (!may_lie_on(trial.elements(), element, where, trial.ray.rayo, trial.precision())) return false;
  return trial.elements().visit_shape(element, [&](const auto& shape) {
    const Allowance allowed = allowance(trial, shape, where.way);
    const ClaimedNearest of_element{claimed.asked, claimed.distance.value_or(exact), claimed.point};
    return is_so_far(of_element, claimed.distance ? allowed.delta : std::max(error, allowed.delta)) &&
           may_be_foot(shape, vec(claimed.asked), where.punto, allowed);
  });
}

/// Whether the claim may be about the element: its point lies there and is a foot, and the distance is that of the
/// element. Without either the element may be as near as that of the truth.
bool may_be_nearest_of(const ClaimContext& trial, ElementRef element, const ClaimedNearest& claimed) {
  const double exact = distance::nearest_of(trial.scene, element, claimed.asked).distance;
  const std::optional<Dyadic> error = std::isfinite(exact) ? error_of_distance(trial, element, exact) : std::nullopt;
  if (!error) return true;
  if (claimed.distance && !is_within(*claimed.distance, exact, *error)) return false;
  if (claimed.point) return may_be_point_of(trial, element, claimed, exact, *error);
  if (claimed.distance) return true;
  const std::optional<TruthDistances> truth = distances_of_truth(trial);
  return !truth || may_be_too_near(trial, truth) || Dyadic(exact) - *error <= truth->most;
}

/// Whether the claim is no farther than the nearest element of the truth, up to what data move it, or that may be too
/// near to be seen.
bool is_near_enough(const ClaimContext& trial, const ClaimedNearest& claimed) {
  const std::optional<TruthDistances> truth = distances_of_truth(trial);
  if (!truth || may_be_too_near(trial, truth)) return true;
  if (claimed.distance) return Dyadic(*claimed.distance) <= truth->most;
  if (!claimed.point) return true;
  const ClaimedPoint where = place_of_nearest(claimed);
  const ElementRef nearest = trial.truth.hit.elementos.front();
  const Dyadic slack = number::shifted(delta(trial.elements(), nearest, where, trial.ray.rayo, trial.precision()), 1);
  return squared_length(between(vec(claimed.asked), where.punto)) <= square(truth->most + slack);
}

/// The elements that the claim may name, those of the truth first; an unnamed point lies on some that it is near.
std::vector<ElementRef> named(const ClaimContext& trial, const Claim& claim, const ClaimedNearest& claimed) {
  std::vector<ElementRef> all;
  if (!claim.element) all.assign(trial.truth.hit.elementos.begin(), trial.truth.hit.elementos.end());
  const std::optional<NearBox> near =
      claimed.point ? std::optional(near_box(trial, place_of_nearest(claimed))) : std::nullopt;
  trial.any_named(claim, [&](ElementRef element) {
    if (claim.element || !near || may_be_near(trial.scene, element, *near)) all.push_back(element);
    return false;
  });
  return all;
}

/// Whether the system answers the point itself inside a solid, and the claim is that.
bool is_inside(const ClaimContext& trial, const Claim& claim, const ClaimedNearest& claimed) {
  return std::ranges::any_of(answered_origins(trial, claim), [&](ElementRef element) {
    const std::optional<Dyadic> error = error_of_distance(trial, element, 0);
    if (!error) return true;
    const Dyadic most = number::shifted(*error, 1);
    if (claimed.distance && !is_within(*claimed.distance, 0, most)) return false;
    return !claimed.point || squared_length(between(vec(claimed.asked), vec(*claimed.point))) <= square(most);
  });
}

/// Whether the answer is a little off: its distance, and its point from the surface, by no more than 0.001 of the size.
bool is_a_little_off_nearest(const ClaimContext& trial, const Claim& claim, const ClaimedNearest& claimed) {
  const scene::Hit& truth = trial.truth.hit;
  const auto is_named = [&](ElementRef element) { return trial.names(claim, element); };
  if (!std::isfinite(truth.t) || std::ranges::none_of(truth.elementos, is_named)) return false;
  const glm::dvec3 p = claimed.asked;
  const double distance = claimed.distance.value_or(
      claimed.point ? std::hypot(claimed.point->x - p.x, claimed.point->y - p.y, claimed.point->z - p.z) : truth.t);
  // The place so much beyond the surface, whose error is that of the distance.
  const double apart = std::abs(distance - truth.t);
  const bool is_small = std::ranges::any_of(truth.elementos, [&](ElementRef element) {
    return trial.scene.visit(element, [&](const auto& shape) { return apart <= 0.001 * largest_length(shape); });
  });
  return is_small && (!claimed.point || std::ranges::any_of(truth.elementos, [&](ElementRef element) {
           return is_near_surface(trial, place_of_nearest(claimed), element);
         }));
}

Verdict of_wrong_nearest(const ClaimContext& trial, const Claim& claim, const ClaimedNearest& claimed) {
  if (is_a_little_off_nearest(trial, claim, claimed)) return Verdict::off;
  const auto is_named = [&](ElementRef element) { return trial.names(claim, element); };
  return std::ranges::any_of(trial.truth.hit.elementos, is_named) ? Verdict::misplaced : Verdict::wrong_element;
}

bool is_of_numbers(const glm::dvec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// Whether the claim has the exact distance, rounded once, and the first of the nearest points where it has one.
bool is_exact_nearest(const ClaimContext& trial, const Claim& claim) {
  const scene::Hit& truth = trial.truth.hit;
  const NumberFormat format = trial.profile.format;
  const auto is_named = [&](ElementRef element) { return trial.names(claim, element); };
  const glm::dvec3& q = truth.punto;
  const glm::dvec3 nearest(rounded(q.x, format), rounded(q.y, format), rounded(q.z, format));
  return std::ranges::any_of(truth.elementos, is_named) && (claim.t || claim.punto) &&
         (!claim.t || *claim.t == rounded(truth.t, format)) && (!claim.punto || *claim.punto == nearest);
}

}  // namespace

ClaimJudgement judgement_of_closest(const ClaimContext& trial, const Claim& claim) {
  if (claim.outcome == Claim::Outcome::miss)
    return {.verdict = may_see_nothing(trial) ? Verdict::right : Verdict::missed};
  if ((claim.t && !std::isfinite(*claim.t)) || (claim.punto && !is_of_numbers(*claim.punto)))
    return {.verdict = Verdict::non_finite};
  if (is_exact_nearest(trial, claim)) return {.verdict = Verdict::exact};
  const ClaimedNearest claimed{trial.ray.rayo.p().xyz(), claim.t, claim.punto};
  const auto may_be = [&](ElementRef element) { return may_be_nearest_of(trial, element, claimed); };
  ClaimJudgement is{.verdict = Verdict::right};
  if (claim.t && std::isfinite(trial.truth.hit.t))
    is.ulps = error_in_ulps(*claim.t, trial.truth.hit.t, trial.profile.format);
  if (is_inside(trial, claim, claimed)) return is;
  const std::vector<ElementRef> of = named(trial, claim, claimed);
  const bool is_right = is_near_enough(trial, claimed) && std::any_of(of.begin(), of.end(), may_be);
  if (!is_right) is.verdict = of_wrong_nearest(trial, claim, claimed);
  return is;
}

}  // namespace durero::conform
