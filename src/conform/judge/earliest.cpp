#include <algorithm>

#include "conform/judge/body_space.hpp"
#include "conform/judge/zones.hpp"

namespace durero::conform {
namespace {

using surface::Quadratic;
using surface::exact::order;
using surface::exact::Parameter;
using Along = Shell<Linear<Dyadic>>;

/// The shell of an element along the whole ray, with its ends moved outwards; nothing where the allowance is no small
/// part of the element. With m the largest length and coordinate of element and origin, each coordinate of a point of
/// the moved element is at most 3m + (7 + 2k)·δ: m + δ for the centre, m + 4δ along the axis, m + (2 + 2k)·δ across it,
/// and less for the other types. For a disc that closes a solid its wall counts in m, and the last two are m + 4δ and
/// m + (2 + k + g)·δ. So t·v is at most 4m + (8 + 2k)·δ there, and M at most 5m where (8 + 2k)·δ ≤ m.
template <class Shape>
std::optional<Along> shell_along(const Shape& shape, const model::Rayo& rayo, const Precision& precision) {
  const Dyadic m = magnitude(shape, rayo, {});
  const Allowance allowed(precision, Dyadic(5) * m, rayo);
  if (allowed.times(Dyadic(8) + Dyadic(2) * Dyadic(proportion(shape))) > m) return std::nullopt;
  return shell(shape, surface::along<Dyadic>(rayo), allowed, EndShift::outwards);
}

/// The shell of a plane, which a ray may meet at any distance. M is at most m + t·L there, with L the largest
/// coordinate of v, and the walls move apart with t accordingly.
std::optional<Along> shell_along(const scene::Plane& e, const model::Rayo& rayo, const Precision& precision) {
  const Allowance allowed(precision, magnitude(e, rayo, {}), rayo);
  const Linear<Dyadic> value = potencia(e, surface::along<Dyadic>(rayo));
  const Dyadic apart = allowed.times(plane_wall), more = plane_wall * allowed.u * Dyadic(largest(rayo.v().xyz()));
  return Along{bound(Linear<Dyadic>{value.at_zero - apart, value.slope - more}),
               bound(Linear<Dyadic>{value.at_zero + apart, value.slope + more})};
}

bool may_hold_at(const Along& shell, const Parameter& t) {
  const bool is_filled = shell.filled || (shell.hollow && sign_at(*shell.hollow, t) <= 0);
  return sign_at(shell.outer, t) <= 0 && (is_filled || sign_at(shell.inner, t) >= 0) &&
         std::all_of(shell.bounds.begin(), shell.bounds.end(), [&](const auto& b) { return sign_at(b, t) >= 0; });
}

/// The parameters t ≥ from, ascending, where a condition of the shell may begin to hold: `from`, and every root ahead.
std::vector<Parameter> beginnings(const Along& shell, const Parameter& from) {
  std::vector<Parameter> all{from};
  const auto take = [&](const Quadratic<Dyadic>& f) {
    const surface::exact::Roots roots = surface::exact::roots({f.A, f.B, f.C});
    for (const Parameter& t : roots.values()) {
      if (order(t, from) > 0) all.push_back(t);
    }
  };
  take(shell.outer);
  take(shell.inner);
  if (shell.hollow) take(*shell.hollow);
  for (const Quadratic<Dyadic>& bound : shell.bounds) take(bound);
  std::sort(all.begin(), all.end(), [](const Parameter& a, const Parameter& b) { return order(a, b) < 0; });
  return all;
}

/// The first t ≥ from at which the ray of some data may meet the shape. The conditions of a shell are closed: where all
/// of them hold for some t ≥ from, the least such t is `from` or a root of one.
template <class Shape>
std::optional<Parameter> earliest_of(const Shape& shape, const model::Rayo& rayo, const Precision& precision,
                                     const Parameter& from) {
  const std::optional<Along> around = shell_along(shape, rayo, precision);
  if (!around) return from;
  const std::vector<Parameter> all = beginnings(*around, from);
  const auto first = std::find_if(all.begin(), all.end(), [&](const Parameter& t) { return may_hold_at(*around, t); });
  return first == all.end() ? std::nullopt : std::optional(*first);
}

/// The same of a body. With m its largest coordinate or the origin's, each coordinate of a point of it, moved, is at
/// most 4m + 14δ. So t·v is at most 5m + 15δ there, and M at most 6m where 15δ ≤ m.
std::optional<Parameter> earliest_of(const AskedBody& body, const model::Rayo& rayo, const Precision& precision,
                                     const Parameter& from) {
  const Dyadic m = magnitude(body, rayo, {});
  const Allowance allowed(precision, Dyadic(6) * m, rayo);
  if (allowed.times(15) > m) return from;
  const Dyadic eta = eta_of(body, allowed);
  const std::optional<BodyStretch> out = stretch_in(body, rayo, eta), in = stretch_in(body, rayo, -eta);
  if (!out || order(out->end, from) < 0) return std::nullopt;
  if (order(from, out->begin) <= 0) return out->begin;
  return in && order(in->begin, from) < 0 && order(from, in->end) < 0 ? in->end : from;
}

}  // namespace

std::optional<Parameter> earliest(const AskedElements& elements, scene::ElementRef element, const model::Rayo& rayo,
                                  const Precision& precision, const Parameter& from) {
  return elements.visit(element, [&](const auto& asked) { return earliest_of(asked, rayo, precision, from); });
}

}  // namespace durero::conform
