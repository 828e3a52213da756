#pragma once
/// The space of a body, moved out or moved in, against which errors of data are measured.
///
/// A torus, which is not convex, has a space of its own (torus_space.hpp).
///
/// The points of a body are centro + a·x + b·y + c·z with a, b and c in a set, or lie within a radius of such. Data
/// within the allowance move each point by the errors of the middle and the sides. A coordinate of a side is off by δ;
/// a system may also take a side as an axis, off by u in each coordinate, and a length, off by δ: then its end is off
/// by √3·u·√3·M + δ ≤ 4δ, which is more than √3·δ. The middle is off by √3·δ.
///
/// - *Box*: |a|, |b|, |c| ≤ 1, so a point is off by 1.74·δ + 3·4δ < 13.74·δ.
/// - *Ellipsoid*: |a| + |b| + |c| ≤ √3, so a point is off by 1.74·δ + √3·4δ < 8.67·δ.
/// - *Capsule*: the middles of its ends are off by 1.74·δ + 4δ, and its radius by 4δ: 9.74·δ. Their roundings to
///   binary64 in exact_body() are less than 0.2·δ.
///
/// - *Rounded box*: a point is off by those of a box, 13.74·δ, and by δ for the radius. Its roundings in exact_body(),
///   of lengths up to √3·M + M and of directions, are less than 1.5·δ: 24 roundings, of which δ has 16 of M.
///
/// With the share of p + t·v, 2√3·δ + 0.22·δ < 3.69·δ, these are less than 18δ, 13δ, 14δ and 20δ: η below. Let K be the
/// body and K' the body that moved data have, moved again as the ray's share moves a point. Each point of one is within
/// η of a point of the other. So K' lies in K moved out by η. And K moved in by η, the points w whose ball of radius η
/// lies in K, lies in K': if w were not in K', which is convex, a plane through w would have all of K' on one side, and
/// the point of the ball that is farthest from K' would be η from each of its points, though it is in K.
///
/// A ray that goes from outside of K moved out to inside of K moved in hence meets the surface of each K' between, and
/// a point of the surface of some K' lies in K moved out and not inside of K moved in.

#include <algorithm>
#include <optional>
#include <vector>

#include "conform/judge/shell.hpp"
#include "durero/conform/families/asked_body.hpp"
#include "durero/surface/exact_element.hpp"

namespace durero::conform {

/// The largest magnitude of a body's coordinates.
double largest_length(const AskedBody& body);
/// The magnitude M of a body.
Dyadic magnitude(const AskedBody& body, const model::Rayo& rayo, const Dyadic& way);

/// The way by which a body is moved out, and in.
Dyadic eta_of(const AskedBody& body, const Allowance& allowed);

/// The body moved out by η, or in where η is negative, at a point: whether the point lies in it, or on its surface.
enum class BodyPlace { outside, surface, inside };
BodyPlace place_in(const AskedBody& body, const Point<Dyadic>& w, const Dyadic& eta);

/// A stretch of a ray, both ends of which belong to it.
struct BodyStretch {
  surface::exact::Parameter begin, end;
};
/// The stretch of the ray's whole line in the body moved out by η, or in where η is negative; nothing where there is
/// none. Precondition: the body is convex.
std::optional<BodyStretch> stretch_in(const AskedBody& body, const model::Rayo& rayo, const Dyadic& eta);

/// The distance of a point from the body's surface, in units of M: of a box from the face that the point is farthest
/// out of, of an ellipsoid up to the second order. Precondition: M > 0.
double distance_of_body(const AskedBody& body, const Point<Dyadic>& w, const Dyadic& M);
/// The square of a body's size, which is half its greatest extent along a side.
Dyadic squared_size_of_body(const AskedBody& body);

}  // namespace durero::conform
