#pragma once
/// The space around a surface that a text defines, in which data within the allowance may put it.
///
/// Nobody says of an attribute of a text whether it is a length, an angle or a coefficient. So each of its numbers is
/// off by u times the largest magnitude of the attribute's own numbers, and by what subnormals cost, and each numeral
/// of the text by u times itself. A coordinate of the origin is off by u·|p|, where |p| is its largest, one of t·v by
/// u·t·L with L the largest of v, and the claimed t, or point, is rounded once, by a 16th of that or less, and its
/// length divided by |v| with one rounding: together less than 5/4·u·(|p| + t·L), and the thickness of surfaces. Each
/// error is a number of its own, and the polynomials of the text follow it (written/spread.hpp): exactly to the first
/// order, and with a bound on the rest. So no allowance is chosen for a kind of surface: the text's own formulas say
/// how far its points and roots move.

#include <optional>
#include <vector>

#include "conform/judge/zones.hpp"
#include "durero/conform/families/asked_surface.hpp"

namespace durero::conform {

/// The largest magnitude of its attributes' numbers.
double largest_length(const AskedSurface& surface);
/// The magnitude M of a surface: of the ray, and not of its attributes.
Dyadic magnitude(const AskedSurface& surface, const model::Rayo& rayo, const Dyadic& way);

/// Whether the place may lie on the surface of some data.
bool may_lie_on(const AskedSurface& surface, const ClaimedPoint& place, const model::Rayo& rayo,
                const Precision& precision);

/// The zones around the exact crossings of the ray, as zones() has them.
std::vector<Zone> zones_of(scene::ElementRef element, const AskedSurface& surface, const model::Rayo& rayo,
                           const Precision& precision);

/// The stretches of t ≥ 0, ascending, in which the ray of any data may meet the surface.
std::vector<ShellStretch> stretches_of(const AskedSurface& surface, const model::Rayo& rayo,
                                       const Precision& precision);
/// The first t ≥ from at which some data may meet it, or a little less; nothing where none do.
std::optional<surface::exact::Parameter> earliest_of(const AskedSurface& surface, const model::Rayo& rayo,
                                                     const Precision& precision, const surface::exact::Parameter& from);
/// The greatest number of meetings of a ray with the surface.
std::size_t most_meetings_of(const AskedSurface& surface);

/// The distance of a point from the surface in units of M, to the first order and to some digits. Precondition: M > 0.
double distance_of_surface(const AskedSurface& surface, const Point<Dyadic>& w, const Dyadic& M);

}  // namespace durero::conform
