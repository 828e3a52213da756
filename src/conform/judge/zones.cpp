#include "conform/judge/zones.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "conform/judge/body_space.hpp"
#include "conform/judge/text_space.hpp"
#include "conform/judge/torus.hpp"
#include "conform/judge/torus_space.hpp"
#include "durero/trace/search.hpp"

namespace durero::conform {
namespace {

using number::shifted;
using number::sign;
using surface::Quadratic;
using surface::exact::Coefficients;
using surface::exact::order;
using surface::exact::Parameter;

/// Whether t lies between the moved ends of the element, where its walls are far apart.
bool holds_at(const Shell<Linear<Dyadic>>& shell, const Parameter& t) {
  return std::all_of(shell.bounds.begin(), shell.bounds.end(),
                     [&](const auto& bound) { return sign_at(bound, t) >= 0; }) &&
         (!shell.hollow || sign_at(*shell.hollow, t) >= 0);
}

/// A crossing of the ray with a wall of a shell.
struct Wall {
  Parameter t;
  bool is_outer;
};

/// The walls of a shell on both sides of an exact crossing: the last before it, and the first after it.
struct Walls {
  std::optional<Wall> before, after;

  void take(const Quadratic<Dyadic>& wall, bool is_outer, const Parameter& crossing) {
    const surface::exact::Roots roots = surface::exact::roots({wall.A, wall.B, wall.C});
    for (const Parameter& t : roots.values()) {
      if (order(t, crossing) < 0) {
        if (!before || order(before->t, t) < 0) before = Wall{t, is_outer};
      } else if (!after || order(t, after->t) < 0) {
        after = Wall{t, is_outer};
      }
    }
  }
  /// Whether the ray goes from one wall to the other.
  bool are_crossed() const { return before && after && before->is_outer != after->is_outer; }
};

/// Whether the zone holds a crossing also for an origin on the element. The equation without its constant,
/// t·(A·t + 2B) = 0, then changes sign between the ends of the zone, or is 0 at one.
bool is_crossed_from_it(const Coefficients& f, const Zone& zone) {
  const auto sign_of = [&](const Parameter& t) {
    return number::sign(t) * number::sign(number::linear(shifted(f.B, 1), f.A, t));
  };
  return sign_of(zone.begin) * sign_of(zone.end) <= 0;
}

/// The zone around an exact crossing, where the rays of all data cross there; nothing where the shell does not prove
/// it.
template <class Shape>
std::optional<Zone> zone_around(scene::ElementRef element, const Shape& shape, const model::Rayo& rayo,
                                const Parameter& crossing, const Precision& precision) {
  const double t = number::round_to_binary64(crossing);
  if (!std::isfinite(t)) return std::nullopt;
  // The end of the zone lies behind the crossing: M has room for a 64th more, and holds for no zone beyond that.
  const Dyadic longest(largest(rayo.v().xyz()));
  const Dyadic M = magnitude(shape, rayo, Dyadic(t) * Dyadic(1 + 0x1p-6) * longest);
  const Allowance allowed(precision, M, rayo);
  const Shell<Linear<Dyadic>> around = shell(shape, surface::along<Dyadic>(rayo), allowed, EndShift::inwards);
  if (around.filled) return std::nullopt;
  Walls walls;
  walls.take(around.outer, true, crossing);
  walls.take(around.inner, false, crossing);
  if (!walls.are_crossed()) return std::nullopt;
  Zone zone{element, walls.before->t, walls.after->t, allowed.delta};
  const bool is_ahead = number::sign(zone.begin) > 0;
  const bool is_in_reach = order(number::linear(0, longest, zone.end), Parameter{.x = M}) <= 0;
  if (!is_ahead || !is_in_reach || !holds_at(around, zone.begin) || !holds_at(around, zone.end)) return std::nullopt;
  return zone;
}

/// The allowance of a body at its crossing t, and whether a stretch that ends there lies within its M: M has room for a
/// 64th more than the crossing, and holds for no zone beyond that.
struct CrossingAllowance {
  Dyadic longest, M;
  Allowance allowed;

  CrossingAllowance(const AskedBody& body, const model::Rayo& rayo, double t, const Precision& precision)
      : longest(largest(rayo.v().xyz())),
        M(magnitude(body, rayo, Dyadic(t) * Dyadic(1 + 0x1p-6) * longest)),
        allowed(precision, M, rayo) {}
  bool has_room_for(const Zone& zone) const {
    return number::sign(zone.begin) > 0 && order(number::linear(0, longest, zone.end), Parameter{.x = M}) <= 0;
  }
};

/// Adds the zones of a torus: from one of the tubes around its surface to the other, around each crossing.
void add_torus_zones(std::vector<Zone>& all, scene::ElementRef element, const AskedBody& body, const model::Rayo& rayo,
                     const Precision& precision) {
  const Torus torus(body);
  for (const TubeRoot& crossing : tube_roots(torus.along(rayo, torus.radio()))) {
    const double t = number::round_to_binary64(crossing.high);
    if (!std::isfinite(t)) continue;
    const CrossingAllowance at(body, rayo, t, precision);
    const std::optional<BodyStretch> found = torus_zone(body, rayo, crossing.root, eta_of(body, at.allowed));
    if (!found) continue;
    const Zone zone{element, found->begin, found->end, at.allowed.delta};
    if (at.has_room_for(zone)) all.push_back(zone);
  }
}

/// Adds the zones of a convex body: from where the ray enters it moved out to where it enters it moved in, and likewise
/// where it leaves it.
void add_zones(std::vector<Zone>& all, scene::ElementRef element, const AskedBody& body, const model::Rayo& rayo,
               const Precision& precision) {
  const std::optional<BodyStretch> given = stretch_in(body, rayo, {});
  if (!given) return;
  for (const bool enters : {true, false}) {
    const double t = number::round_to_binary64(enters ? given->begin : given->end);
    if (!(t > 0) || !std::isfinite(t)) continue;
    const CrossingAllowance at(body, rayo, t, precision);
    const Dyadic eta = eta_of(body, at.allowed);
    const std::optional<BodyStretch> in = stretch_in(body, rayo, -eta), out = stretch_in(body, rayo, eta);
    if (!in || !out) continue;
    const Zone zone{element, enters ? out->begin : in->end, enters ? in->begin : out->end, at.allowed.delta};
    if (at.has_room_for(zone)) all.push_back(zone);
  }
}

/// The shell of the shape at the place, with its ends moved outwards.
template <class Shape>
Shell<Dyadic> shell_at(const Shape& shape, const ClaimedPoint& place, const model::Rayo& rayo,
                       const Precision& precision) {
  return shell(shape, place.punto, Allowance(precision, magnitude(shape, rayo, place.way), rayo), EndShift::outwards);
}

template <class Shape>
bool is_on(const Shape& shape, const ClaimedPoint& place, const model::Rayo& rayo, const Precision& precision) {
  return may_hold(shell_at(shape, place, rayo, precision));
}
bool is_on(const AskedBody& body, const ClaimedPoint& place, const model::Rayo& rayo, const Precision& precision) {
  const Dyadic eta = eta_of(body, Allowance(precision, magnitude(body, rayo, place.way), rayo));
  return place_in(body, place.punto, eta) != BodyPlace::outside &&
         place_in(body, place.punto, -eta) != BodyPlace::inside;
}

bool is_on(const AskedSurface& surface, const ClaimedPoint& place, const model::Rayo& rayo,
           const Precision& precision) {
  return may_lie_on(surface, place, rayo, precision);
}

template <class Shape>
bool is_within(const Shape& shape, const ClaimedPoint& place, const model::Rayo& rayo, const Precision& precision) {
  return may_hold_inside(shell_at(shape, place, rayo, precision));
}
bool is_within(const AskedBody& body, const ClaimedPoint& place, const model::Rayo& rayo, const Precision& precision) {
  const Dyadic eta = eta_of(body, Allowance(precision, magnitude(body, rayo, place.way), rayo));
  return place_in(body, place.punto, eta) != BodyPlace::outside;
}

/// A surface of a text is no solid: it has no inside.
bool is_within(const AskedSurface&, const ClaimedPoint&, const model::Rayo&, const Precision&) { return false; }

}  // namespace

std::vector<Zone> zones(const AskedElements& elements, const SceneTree& tree, const scene::Query& ray,
                        const Precision& precision, double limit) {
  std::vector<Zone> all;
  trace::Counts counts;
  const scene::Scene& scene = elements.scene();
  const trace::Search search(scene, ray.rayo, ray.en, counts);
  const auto add = [&](scene::ElementRef element) {
    const bool starts_on_it = scene::Origin(ray.en).contains(element);
    if (const AskedBody* const body = elements.body(element)) {
      if (starts_on_it) return;
      const auto add_all = body->kind == BodyKind::toro ? add_torus_zones : add_zones;
      return add_all(all, element, *body, ray.rayo, precision);
    }
    if (const AskedSurface* const surface = elements.surface(element)) {
      const std::vector<Zone> of_surface = zones_of(element, *surface, ray.rayo, precision);
      all.insert(all.end(), of_surface.begin(), of_surface.end());
      return;
    }
    const std::optional<trace::Meeting> met = search.certified_meeting(element, limit);
    if (met && met->kind == trace::Meeting::Kind::none) return;
    const Coefficients f =
        scene.visit(element, [&](const auto& shape) { return surface::exact::coefficients(shape, ray.rayo); });
    const surface::exact::Roots crossings = surface::exact::roots(f);
    for (const Parameter& t : crossings.values()) {
      if (number::sign(t) <= 0) continue;
      const std::optional<Zone> zone = elements.visit_shape(
          element, [&](const auto& shape) { return zone_around(element, shape, ray.rayo, t, precision); });
      if (zone && (!starts_on_it || is_crossed_from_it(f, *zone))) all.push_back(*zone);
    }
  };
  tree.along(
      search.ray(), ray.en, [&] { return limit; }, add);
  return all;
}

Dyadic delta(const AskedElements& elements, scene::ElementRef element, const ClaimedPoint& place,
             const model::Rayo& rayo, const Precision& precision) {
  return elements.visit(
      element, [&](const auto& shape) { return Allowance(precision, magnitude(shape, rayo, place.way), rayo).delta; });
}

Parameter moved_by(const Parameter& t, const Dyadic& by, const model::Rayo& rayo) {
  const Dyadic longest(largest(rayo.v().xyz()));
  const auto& [x, y, radicand, w] = t;
  return {x * longest + by * w, y * longest, radicand, w * longest};
}

bool is_behind(const ClaimedPoint& place, const Dyadic& own, const Zone& zone, const model::Rayo& rayo) {
  return order(zone.end, moved_by(place.t, -(own + shifted(zone.delta, 1)), rayo)) < 0;
}

bool is_before(const ClaimedPoint& place, const Dyadic& own, const Zone& zone, const model::Rayo& rayo) {
  return order(moved_by(place.t, own + shifted(zone.delta, 1), rayo), zone.begin) < 0;
}

bool may_lie_on(const AskedElements& elements, scene::ElementRef element, const ClaimedPoint& place,
                const model::Rayo& rayo, const Precision& precision) {
  return elements.visit(element, [&](const auto& asked) { return is_on(asked, place, rayo, precision); });
}

bool may_lie_inside(const AskedElements& elements, scene::ElementRef element, const ClaimedPoint& place,
                    const model::Rayo& rayo, const Precision& precision) {
  return elements.visit(element, [&](const auto& asked) { return is_within(asked, place, rayo, precision); });
}

}  // namespace durero::conform
