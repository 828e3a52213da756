#include <algorithm>

#include "conform/judge/body_space.hpp"
#include "conform/judge/text_space.hpp"
#include "conform/judge/torus_space.hpp"
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

/// The parameters t ≥ from, ascending and without repetition, where a condition of the shell may begin to hold: `from`,
/// and every root ahead.
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
  const auto is_same = [](const Parameter& a, const Parameter& b) { return order(a, b) == 0; };
  all.erase(std::unique(all.begin(), all.end(), is_same), all.end());
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

/// The allowance of a body along the whole ray; nothing where the data may be off by too much. With m the body's
/// largest number or the origin's, each coordinate of a point of it, moved, is at most 5m + 15δ: those of its middle,
/// three sides and a radius. So t·v is at most 6m + 16δ there, and M at most 7m where 16δ ≤ m.
std::optional<Allowance> allowance_along(const AskedBody& body, const model::Rayo& rayo, const Precision& precision) {
  const Dyadic m = magnitude(body, rayo, {});
  const Allowance allowed(precision, Dyadic(7) * m, rayo);
  return allowed.times(16) > m ? std::nullopt : std::optional(allowed);
}

/// The stretches of a torus; nothing where it may be met anywhere.
std::optional<std::vector<ShellStretch>> stretches_of_torus(const AskedBody& body, const model::Rayo& rayo,
                                                            const Precision& precision) {
  const std::optional<Allowance> allowed = allowance_along(body, rayo, precision);
  return allowed ? torus_stretches(body, rayo, eta_of(body, *allowed)) : std::nullopt;
}

/// The first t of a torus, which is not before the first of its stretches that ends behind `from`.
std::optional<Parameter> earliest_of_torus(const AskedBody& body, const model::Rayo& rayo, const Precision& precision,
                                           const Parameter& from) {
  const auto all = stretches_of_torus(body, rayo, precision);
  if (!all) return from;
  for (const auto& [begin, end, most] : *all) {
    if (!end || order(*end, from) >= 0) return order(begin, from) > 0 ? begin : from;
  }
  return std::nullopt;
}

/// Stretches of the ray in a convex body that is moved out, and in one that is moved in, as far as its data may be off.
struct BodyStretches {
  std::optional<BodyStretch> out, in;
};

/// Nothing where the data may be off by too much.
std::optional<BodyStretches> stretches_in(const AskedBody& body, const model::Rayo& rayo, const Precision& precision) {
  const std::optional<Allowance> allowed = allowance_along(body, rayo, precision);
  if (!allowed) return std::nullopt;
  const Dyadic eta = eta_of(body, *allowed);
  return BodyStretches{stretch_in(body, rayo, eta), stretch_in(body, rayo, -eta)};
}

/// The first such t of a body.
std::optional<Parameter> earliest_of(const AskedBody& body, const model::Rayo& rayo, const Precision& precision,
                                     const Parameter& from) {
  if (body.kind == BodyKind::toro) return earliest_of_torus(body, rayo, precision, from);
  const std::optional<BodyStretches> both = stretches_in(body, rayo, precision);
  if (!both) return from;
  const auto& [out, in] = *both;
  if (!out || order(out->end, from) < 0) return std::nullopt;
  if (order(from, out->begin) <= 0) return out->begin;
  return in && order(in->begin, from) < 0 && order(from, in->end) < 0 ? in->end : from;
}

/// The sign of f between two neighbours of its roots, a and b, or behind a where there is no b: f has no root there.
int sign_between(const Quadratic<Dyadic>& f, const Parameter& a, const Parameter* b) {
  const int at_a = sign_at(f, a), at_b = b == nullptr ? 0 : sign_at(f, *b);
  if (at_a != 0 || at_b != 0) return at_a != 0 ? at_a : at_b;
  const int bend = number::sign(f.A);
  if (b != nullptr) return -bend;  // both are its roots
  return bend != 0 ? bend : number::sign(f.B);
}

/// may_hold_at() everywhere between two neighbours of all roots, or behind the last.
bool may_hold_between(const Along& shell, const Parameter& a, const Parameter* b) {
  const bool is_filled = shell.filled || (shell.hollow && sign_between(*shell.hollow, a, b) <= 0);
  return sign_between(shell.outer, a, b) <= 0 && (is_filled || sign_between(shell.inner, a, b) >= 0) &&
         std::all_of(shell.bounds.begin(), shell.bounds.end(),
                     [&](const auto& bound) { return sign_between(bound, a, b) >= 0; });
}

/// Whether the shell goes from one of its walls to the other between the two.
bool goes_through(const Along& shell, const Parameter& begin, const Parameter& end) {
  const auto is_hollow = [&](const Parameter& t) { return !shell.hollow || sign_at(*shell.hollow, t) > 0; };
  const auto is_on = [](const Quadratic<Dyadic>& wall, const Parameter& t) { return sign_at(wall, t) == 0; };
  const bool is_through =
      (is_on(shell.outer, begin) && is_on(shell.inner, end)) || (is_on(shell.inner, begin) && is_on(shell.outer, end));
  return !shell.filled && is_through && is_hollow(begin) && is_hollow(end);
}

/// The stretches of t ≥ 0 in which all conditions of the shell hold.
std::vector<ShellStretch> stretches_of(const Along& shell) {
  const std::vector<Parameter> all = beginnings(shell, {});
  std::vector<ShellStretch> found;
  for (std::size_t i = 0; i < all.size();) {
    if (!may_hold_at(shell, all[i])) {
      ++i;
      continue;
    }
    const Parameter& begin = all[i];
    const auto next = [&] { return i + 1 < all.size() ? &all[i + 1] : nullptr; };
    while (i < all.size() && may_hold_between(shell, all[i], next())) ++i;
    const bool is_endless = i == all.size();
    const std::optional<Parameter> end = is_endless ? std::nullopt : std::optional(all[i]);
    const bool is_one = end && goes_through(shell, begin, *end);
    found.push_back({begin, end, is_one ? std::size_t{1} : most_meetings});
    ++i;
  }
  return found;
}

/// A body that is moved contains it moved in, and lies in it moved out: it is convex, so the ray enters and leaves it
/// at one place each, before and behind the stretch in the inner one.
std::optional<std::vector<ShellStretch>> stretches_of(const AskedBody& body, const model::Rayo& rayo,
                                                      const Precision& precision) {
  if (body.kind == BodyKind::toro) return stretches_of_torus(body, rayo, precision);
  const std::optional<BodyStretches> both = stretches_in(body, rayo, precision);
  if (!both) return std::nullopt;
  const auto& [out, in] = *both;
  const Parameter origin{};
  if (!out || order(out->end, origin) < 0) return std::vector<ShellStretch>{};
  const Parameter& begin = order(out->begin, origin) < 0 ? origin : out->begin;
  if (!in || order(in->end, origin) < 0) return std::vector<ShellStretch>{{begin, out->end, most_meetings}};
  std::vector<ShellStretch> found;
  if (order(in->begin, origin) > 0) found.push_back({begin, in->begin, 1});
  found.push_back({in->end, out->end, 1});
  return found;
}

template <class Shape>
std::optional<std::vector<ShellStretch>> stretches_of(const Shape& shape, const model::Rayo& rayo,
                                                      const Precision& precision) {
  const std::optional<Along> around = shell_along(shape, rayo, precision);
  return around ? std::optional(stretches_of(*around)) : std::nullopt;
}

}  // namespace

std::size_t most_meetings_of(const AskedElements& elements, scene::ElementRef element) {
  if (const AskedSurface* const surface = elements.surface(element)) return most_meetings_of(*surface);
  const AskedBody* const body = elements.body(element);
  return body && body->kind == BodyKind::toro ? most_meetings_of_torus : most_meetings;
}

std::optional<std::vector<ShellStretch>> stretches(const AskedElements& elements, scene::ElementRef element,
                                                   const model::Rayo& rayo, const Precision& precision) {
  using Found = std::optional<std::vector<ShellStretch>>;
  return elements.visit(element, [&](const auto& asked) -> Found { return stretches_of(asked, rayo, precision); });
}

std::optional<Parameter> earliest(const AskedElements& elements, scene::ElementRef element, const model::Rayo& rayo,
                                  const Precision& precision, const Parameter& from) {
  return elements.visit(element, [&](const auto& asked) { return earliest_of(asked, rayo, precision, from); });
}

}  // namespace durero::conform
