#pragma once
/// The space between a torus moved in and moved out, against which errors of its data are measured.
///
/// The points of the ring are centro + cos·x + sin·z. Data within the allowance move the middle by 1.74·δ, and an end
/// of a side by 4δ (body_space.hpp), so that a point of the ring is off by 1.74·δ + √2·4δ < 7.4·δ; the radius is off by
/// δ. With the ray's share of 3.69·δ, this is less than 13δ: η. The distance of a point from the moved ring, less the
/// moved radius, is off by η from that of the data given. So a point of the surface of some data lies where the
/// distance from the ring is from radio − η to radio + η, and a ray that goes from a point at radio + η or beyond to
/// one at radio − η or nearer meets the surface of all data between them.

#include <optional>
#include <vector>

#include "conform/judge/body_space.hpp"
#include "conform/judge/zones.hpp"

namespace durero::conform {

/// The stretches of t ≥ 0 in which the ray's distance from the ring is from radio − η to radio + η. Nothing where the
/// tube that is moved out has no hole.
std::optional<std::vector<ShellStretch>> torus_stretches(const AskedBody& body, const model::Rayo& rayo,
                                                         const Dyadic& eta);

/// The stretch of the ray around an exact crossing in which it goes from one end of that space to the other; nothing
/// where it does not.
std::optional<BodyStretch> torus_zone(const AskedBody& body, const model::Rayo& rayo, const algebra::Root& crossing,
                                      const Dyadic& eta);

}  // namespace durero::conform
