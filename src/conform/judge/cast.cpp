#include "conform/judge/cast.hpp"

#include <algorithm>
#include <cmath>

#include "conform/judge/ball.hpp"
#include "conform/judge/ball_candidates.hpp"
#include "conform/judge/error_of.hpp"
#include "conform/judge/limits.hpp"
#include "conform/judge/reach_of_errors.hpp"
#include "conform/judge/robust.hpp"
#include "conform/judge/shell.hpp"

namespace durero::conform {
namespace {

using number::shifted;
using scene::ElementRef;
using surface::exact::order;
using surface::exact::Parameter;

Point<Dyadic> ball_point(const glm::dvec3& a) { return {a.x, a.y, a.z}; }

/// The errors of a ball and an element.
struct BallErrors {
  Dyadic delta, M;
  std::optional<Dyadic> reach;  ///< h·δ; nothing where errors may leave nothing of the element

  Dyadic times(int multiple) const { return Dyadic(multiple) * delta; }
};

/// The h·δ of a plane is that of the error of its distance.
template <class Shape>
std::optional<Dyadic> reach_at_ball(const Shape& shape, const Allowance& allowed) {
  if constexpr (std::is_same_v<Shape, scene::Plane>)
    return allowed.times(11);
  else
    return reach_of_errors(shape, allowed);
}

/// One ball, which is judged.
class CastTrial {
 public:
  explicit CastTrial(const ClaimContext& trial) : trial_(&trial), elements_(trial.elements()), R_(trial.range->radio) {}

  const ClaimContext& trial() const { return *trial_; }
  const model::Rayo& rayo() const { return trial_->ray.rayo; }
  const Dyadic& R() const { return R_; }
  const AskedElements& elements() const { return elements_; }

  /// The errors where the coordinates of t·v are at most `way`.
  BallErrors errors(ElementRef element, const Dyadic& way) const {
    return elements_.visit_shape(element, [&](const auto& shape) {
      const Dyadic M = std::max(magnitude(shape, rayo(), way), R_);
      const Allowance allowed(trial_->precision(), M, rayo());
      return BallErrors{allowed.delta, M, reach_at_ball(shape, allowed)};
    });
  }
  std::optional<BallTouch> first(ElementRef element, const Dyadic& rho) const {
    return first_touch(elements_, element, rayo(), rho);
  }
  bool touches(ElementRef element, const Point<Dyadic>& w, const Dyadic& rho) const {
    return is_touched(elements_, element, w, rho);
  }

 private:
  const ClaimContext* trial_;
  AskedElements elements_;
  Dyadic R_;
};

/// The zone of the first touch of all data; nothing where they do not all touch, as far as this proves it. M has room
/// for a 64th more than a touch by the data given, and then than one by those that touch latest, and so on.
std::optional<Zone> zone_of_cast(const CastTrial& of, ElementRef element) {
  const Dyadic longest(largest(of.rayo().v().xyz()));
  std::optional<BallTouch> at = of.first(element, of.R());
  for (int turn = 0; at && turn < 4; ++turn) {
    const double t = rounded_up(at->high());
    if (!std::isfinite(t)) return std::nullopt;
    const BallErrors errors = of.errors(element, Dyadic(t) * Dyadic(1 + 0x1p-6) * longest);
    if (!errors.reach) return std::nullopt;
    const Dyadic eta = *errors.reach + errors.times(5);
    at = of.first(element, of.R() - eta);
    if (!at) return std::nullopt;
    const Parameter end = at->high();
    if (order(number::linear(0, longest, end), Parameter{.x = errors.M}) > 0) continue;
    const std::optional<BallTouch> begin = of.first(element, of.R() + eta);
    return begin ? std::optional(Zone{element, begin->low(), end, errors.delta}) : std::nullopt;
  }
  return std::nullopt;
}

/// Whether the ball certainly comes to a flat element from its front: for all data it begins there and moves towards
/// it. With n the product of two sides, which are off by 2√3·δ each, v·n is off by |v|·(4δ·(|x| + |y|) + 12δ²) and, for
/// v, by 2u·|v|·|n|, and (p − a)·n by as much with |p − a| for |v|, and 2√3·δ·|n| for p − a; u is at most δ/M.
bool is_from_the_front(const CastTrial& of, ElementRef element) {
  const ClaimContext& trial = of.trial();
  if (trial.body(element) != element) return true;
  const Point<Dyadic> v = ball_point(of.rayo().v().xyz());
  const auto is_in_front = [&](const glm::dvec3& a, const Point<Dyadic>& n, const Dyadic& off_by, const Allowance& at) {
    const Point<Dyadic> from_a = from(a, ball_point(of.rayo().p().xyz()));
    const Dyadic size = length_above(n), beside = length_above(from_a);
    return dot(v, n) < -(length_above(v) * (off_by + shifted(at.u, 1) * size)) &&
           dot(from_a, n) > beside * off_by + at.times(4) * size;
  };
  return trial.scene.visit(element, [&]<class Shape>(const Shape& shape) {
    const Allowance at(trial.precision(), of.errors(element, {}).M, of.rayo());
    if constexpr (std::is_same_v<Shape, scene::Triangle>) {
      const auto& [a, b, c] = shape.vertices;
      const Point<Dyadic> x = surface::between<Dyadic>(a, b), y = surface::between<Dyadic>(a, c);
      const Dyadic off_by = at.times(4) * (length_above(x) + length_above(y)) + Dyadic(12) * square(at.delta);
      return is_in_front(a, cross(x, y), off_by, at);
    } else if constexpr (surface::Flat<Shape>) {
      return is_in_front(shape.centro, ball_point(shape.vector), shifted(at.u, 1), at);
    } else {
      return true;
    }
  });
}

/// Whether a solid may be left out because the ball begins inside it.
bool may_be_left_out(const ClaimContext& trial, const std::vector<ElementRef>& around, ElementRef element) {
  const bool is_permitted =
      trial.profile.inside == Inside::nothing || (trial.profile.inside == Inside::origin && trial.profile.least_t > 0);
  return is_permitted && std::ranges::find(around, trial.body(element)) != around.end();
}

/// The zones that no clause of the profile lets a system pass by.
class CastZones {
 public:
  explicit CastZones(const CastTrial& of) : of_(&of), around_(of.trial().solids_around_origin()) {}

  /// Whether the condition holds for a zone of an element that the ball may touch up to the limit.
  template <class Holds>
  bool any_of(double limit, Holds holds) const {
    const ClaimContext& trial = of_->trial();
    const bool has_unseen = trial.profile.back_faces == BackFaces::unseen;
    const BallWay way(trial.scene, of_->rayo(), trial.range->radio);
    return way.any_of([&] { return limit; },
                      [&](ElementRef element) {
                        if (may_be_left_out(trial, around_, element)) return false;
                        if (has_unseen && !is_from_the_front(*of_, element)) return false;
                        const std::optional<Zone> zone = zone_of_cast(*of_, element);
                        return zone && is_within_limits(trial, *zone) && holds(*zone);
                      });
  }

 private:
  const CastTrial* of_;
  std::vector<ElementRef> around_;
};

/// A claimed touch with its place on the ray.
struct ClaimedTouch {
  ClaimedPoint middle;  ///< of the ball, on the ray
  std::optional<glm::dvec3> contact;
};

/// Whether a place of contact may be on the element.
bool may_be_on(const CastTrial& of, ElementRef element, const glm::dvec3& contact, const BallErrors& errors) {
  return of.touches(element, ball_point(contact), *errors.reach + errors.delta);
}

/// Whether the ball around the middle, whose place is off besides, may touch the element, at the contact if the claim
/// has one.
bool may_touch_at(const CastTrial& of, ElementRef element, const ClaimedTouch& claimed) {
  const auto& [middle, contact] = claimed;
  const BallErrors errors = of.errors(element, middle.way);
  if (!errors.reach) return true;
  const Point<Dyadic> p = ball_point(of.rayo().p().xyz());
  const Dyadic eta = *errors.reach + errors.times(5 + middle.deviation);
  const bool is_before =
      number::sign(middle.t) < 0 && squared_length(from(of.rayo().p().xyz(), middle.punto)) > square(errors.times(4));
  if (is_before || !of.touches(element, middle.punto, of.R() + eta)) return false;
  if (!contact) return true;
  const Dyadic apart = squared_length(from(*contact, middle.punto)), off_by = errors.times(5 + middle.deviation);
  const Dyadic least = of.R() - off_by;
  return may_be_on(of, element, *contact, errors) && apart <= square(of.R() + off_by) &&
         (number::sign(least) <= 0 || apart >= square(least) || of.touches(element, p, of.R() + eta));
}

/// Whether some zone certainly ends before the touch of the element at the middle.
bool is_passed(const CastTrial& of, const CastZones& zones, ElementRef element, const ClaimedPoint& middle) {
  const Dyadic own = Dyadic(middle.deviation) * of.errors(element, middle.way).delta;
  return zones.any_of(rounded_up(middle.t), [&](const Zone& zone) { return is_behind(middle, own, zone, of.rayo()); });
}

/// The elements that the claim may name, and that may be near the place.
std::vector<ElementRef> named_near(const CastTrial& of, const Claim& claim, const ClaimedPoint& place) {
  const ClaimContext& trial = of.trial();
  const Dyadic longest = std::max(Dyadic(std::max(trial.facts.largest_length(), largest(of.rayo().p().xyz()))), of.R());
  const Allowance allowed(trial.precision(), std::max(longest, place.way), of.rayo());
  const auto& [x, y, z] = place.punto;
  // A triangle is off by 2δ, and its ball by 5δ and the deviation of t, 4δ at most; 5δ are for roundings of the filter.
  const NearBox near{{number::round_to_binary64(x), number::round_to_binary64(y), number::round_to_binary64(z)},
                     bound_above(of.R() + allowed.times(16))};
  std::vector<ElementRef> all;
  trial.any_named(claim, [&](ElementRef element) {
    if (may_be_near(trial.scene, element, near)) all.push_back(element);
    return false;
  });
  return all;
}

/// Whether the system answers that the ball touches at once inside a solid, and the claim is that.
bool is_inside_at_once(const CastTrial& of, const Claim& claim, const ClaimedPoint& middle) {
  return std::ranges::any_of(answered_origins(of.trial(), claim), [&](ElementRef element) {
    return squared_length(from(of.rayo().p().xyz(), middle.punto)) <= square(of.errors(element, middle.way).times(4));
  });
}

/// The middle of a ball that touches the claimed contact first: of a claim that has no t. The contact is off by its own
/// rounding and, as a place on the element, the middle by its errors: R is taken with 5δ less and more.
std::optional<ClaimedPoint> middle_at(const CastTrial& of, ElementRef element, const glm::dvec3& contact) {
  const Point<Dyadic> p = ball_point(of.rayo().p().xyz()), v = ball_point(of.rayo().v().xyz()), q = from(contact, p);
  const Dyadic way = std::max({absolute(q.x), absolute(q.y), absolute(q.z)}) + of.R();
  const Dyadic rho = of.R() + of.errors(element, way).times(5);
  const Dyadic A = squared_length(v), B = dot(q, v), C = squared_length(q) - square(rho);
  if (number::sign(C) <= 0) return ClaimedPoint{.t = {}, .punto = p, .way = {}, .deviation = 4};
  const surface::exact::Roots roots = surface::exact::roots({A, B, C});
  for (const Parameter& t : roots.values()) {
    if (number::sign(t) > 0) return ClaimedPoint{.t = t, .punto = {}, .way = way, .deviation = 4};
  }
  return std::nullopt;
}

bool is_right_contact(const CastTrial& of, const CastZones& zones, ElementRef element, const glm::dvec3& contact) {
  const std::optional<ClaimedPoint> middle = middle_at(of, element, contact);
  if (!middle) return false;
  const BallErrors errors = of.errors(element, middle->way);
  if (!errors.reach) return true;
  return may_be_on(of, element, contact, errors) && !is_passed(of, zones, element, *middle);
}

/// A lower bound on the first touch of a plane by the ball of any data. At t the errors are η at the origin, and at
/// most 16u·t times the largest coordinate of v besides, for M is not more than the sum of what it is there and of t·v.
std::optional<Parameter> earliest_touch(const CastTrial& of, ElementRef element, const scene::Plane& plane) {
  const BallErrors errors = of.errors(element, {});
  const Allowance at(of.trial().precision(), errors.M, of.rayo());
  const Point<Dyadic> d = ball_point(plane.vector);
  const Dyadic size = length_above(d), away = dot(from(plane.centro, ball_point(of.rayo().p().xyz())), d);
  const Dyadic apart = absolute(away) - (of.R() + *errors.reach + errors.times(5)) * size;
  if (number::sign(apart) <= 0) return Parameter{};
  const Dyadic along = dot(ball_point(of.rayo().v().xyz()), d);
  const Dyadic off_by = shifted(at.u, 4) * Dyadic(largest(of.rayo().v().xyz()));
  const Dyadic towards = (number::sign(away) > 0 ? -along : along) + off_by * size;
  return number::sign(towards) > 0 ? std::optional(Parameter{.x = apart, .w = towards}) : std::nullopt;
}
/// The earliest touch of a bounded element. A ball that touches it is within 3·M and R of the origin of coordinates, by
/// each coordinate.
template <class Shape>
std::optional<Parameter> earliest_touch(const CastTrial& of, ElementRef element, const Shape& shape) {
  const Dyadic length = magnitude(shape, of.rayo(), Dyadic(0));
  const BallErrors errors = of.errors(element, shifted(length + of.R(), 2));
  if (!errors.reach) return Parameter{};
  const std::optional<BallTouch> first = of.first(element, of.R() + *errors.reach + errors.times(5));
  return first ? std::optional(first->low()) : std::nullopt;
}

/// Whether the element may be touched first: the lower bound on its first touch is behind no zone's end.
bool may_be_touched_first(const CastTrial& of, const CastZones& zones, ElementRef element) {
  const std::optional<Parameter> first =
      of.elements().visit_shape(element, [&](const auto& shape) { return earliest_touch(of, element, shape); });
  if (!first) return false;
  const ClaimedPoint middle{.t = *first, .punto = {}, .way = {}, .deviation = 2};
  return !is_passed(of, zones, element, middle);
}

bool names_touched(const ClaimContext& trial, const Claim& claim) {
  return std::ranges::any_of(trial.truth.hit.elementos, [&](ElementRef e) { return trial.names(claim, e); });
}

/// The verdict on a hit that is not right.
Verdict of_wrong_touch(const CastTrial& of, const Claim& claim, const std::optional<ClaimedTouch>& claimed) {
  const ClaimContext& trial = of.trial();
  if (!trial.has_hit()) return Verdict::phantom;
  const bool is_named = names_touched(trial, claim);
  if (!claimed) return is_named ? Verdict::misplaced : Verdict::wrong_element;
  if (is_named && !is_far(trial, claimed->middle)) return Verdict::off;
  const std::vector<ElementRef> near = named_near(of, claim, claimed->middle);
  const bool touches =
      std::ranges::any_of(near, [&](ElementRef element) { return may_touch_at(of, element, *claimed); });
  if (!is_named) return Verdict::wrong_element;
  return touches ? Verdict::far_root : Verdict::misplaced;
}

bool is_a_point(const glm::dvec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// The verdict on a hit with t or a length, and perhaps a contact.
Verdict of_touch_at(const CastTrial& of, const Claim& claim, const ClaimedTouch& claimed) {
  if (is_inside_at_once(of, claim, claimed.middle)) return Verdict::right;
  const CastZones zones(of);
  const auto may_be = [&](ElementRef element) {
    return may_touch_at(of, element, claimed) && !is_passed(of, zones, element, claimed.middle);
  };
  const std::vector<ElementRef> near = named_near(of, claim, claimed.middle);
  const bool is_right = std::ranges::any_of(near, may_be);
  if (!is_right) return of_wrong_touch(of, claim, claimed);
  return is_the_truth(of.trial(), claim) ? Verdict::exact : Verdict::right;
}

/// The verdict on a hit with a contact alone, or an element alone.
Verdict of_touch_without_t(const CastTrial& of, const Claim& claim) {
  const bool may_be_inside = !answered_origins(of.trial(), claim).empty();
  if (may_be_inside || (!claim.punto && names_touched(of.trial(), claim))) return Verdict::right;
  const CastZones zones(of);
  const bool is_right = of.trial().any_named(claim, [&](ElementRef element) {
    return claim.punto ? is_right_contact(of, zones, element, *claim.punto) : may_be_touched_first(of, zones, element);
  });
  return is_right ? Verdict::right : of_wrong_touch(of, claim, std::nullopt);
}

}  // namespace

ClaimJudgement judgement_of_cast(const ClaimContext& trial, const Claim& claim) {
  const CastTrial of(trial);
  if (claim.outcome == Claim::Outcome::miss) {
    if (!trial.has_hit()) return {.verdict = Verdict::exact};
    const bool is_touched_by_all = CastZones(of).any_of(trace::no_limit, [](const Zone&) { return true; });
    return {.verdict = is_touched_by_all ? Verdict::missed : Verdict::right};
  }
  const bool has_t = claim.t && trial.profile.measure != Measure::point;
  if ((has_t && !std::isfinite(*claim.t)) || (claim.punto && !is_a_point(*claim.punto)))
    return {.verdict = Verdict::non_finite};
  if (!has_t) return {.verdict = of_touch_without_t(of, claim)};
  Claim without_contact = claim;
  without_contact.punto.reset();
  const ClaimedTouch claimed{*place(trial, without_contact), claim.punto};
  return {.verdict = of_touch_at(of, claim, claimed),
          .ulps = trial.has_hit() ? error_in_ulps(*claim.t, number_of_truth(trial), trial.profile.format) : 0};
}

bool may_begin_in_touch(const ClaimContext& trial) {
  const CastTrial of(trial);
  const glm::dvec3& p = of.rayo().p().xyz();
  const std::vector<ElementRef> near = named_near(of, {}, {.t = {}, .punto = ball_point(p), .way = {}});
  return std::ranges::any_of(near, [&](ElementRef element) {
    const BallErrors errors = of.errors(element, {});
    return !errors.reach || of.touches(element, ball_point(p), of.R() + *errors.reach + errors.times(5));
  });
}

}  // namespace durero::conform
