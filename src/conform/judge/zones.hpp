#pragma once
/// A zone is a stretch of a ray that certainly crosses an element, whatever data within the allowance both have; a
/// place is a point of a ray that a claim gives. The functions below compare the two exactly.

#include <optional>
#include <vector>

#include "conform/ask/asked_elements.hpp"
#include "durero/scene/query.hpp"
#include "durero/scene/scene.hpp"
#include "durero/surface/equation.hpp"
#include "durero/surface/exact_element.hpp"

namespace durero::conform {

/// A zone is a stretch begin ≤ t ≤ end in which the rays of all data within the allowance meet the element. 0 < begin,
/// but the zone of a mesh begins at 0.
struct Zone {
  scene::ElementRef element;
  surface::exact::Parameter begin, end;
  number::Dyadic delta;  ///< δ of the element, for every t ≤ end
};

/// The zones that shells prove, each around an exact crossing t > 0 of the ray. Elements that the ray first meets
/// behind `limit` may be left out. Every zone holds an exact crossing between the ends of its element, also where the
/// origin is taken to lie on the elements of `en`.
std::vector<Zone> zones(const AskedElements& elements, const scene::Query& ray, const Precision& precision,
                        double limit);

/// The zone of all triangles of the scene, which bears the name of the first. They make one where they are a closed
/// mesh around the origin: every edge belongs to two triangles with the very same vertices, or to an even number of
/// them. The vertices that triangles share move together here, and the ray is one for all triangles: this is the claim
/// of a watertight system.
///
/// The number of times that a point is inside a closed mesh, modulo 2, is the number of crossings of any ray from it
/// that meets no edge; it changes nowhere but on the mesh. Let vertices and origin move to their places in straight
/// lines: the mesh stays closed, each of its points moves by at most √3·δ and the origin by as much. An origin farther
/// than 2√3·δ from every triangle never meets the mesh, and stays inside; 6δ is farther. Nothing far away is inside, so
/// the ray meets the mesh, whatever its direction. There no coordinate of t·v is larger than twice the largest L of
/// vertices and origin by more than 2δ, so M ≤ (2 + 2⁻⁴)·L where 32δ ≤ L. That point lies in the box of the mesh grown
/// by δ; p is off by δ and t·v by as much, so that p + t·v lies in the box grown by 3δ. The ray leaves this box before
/// it leaves the box grown by 4δ, where the zone ends.
std::optional<Zone> zone_of_mesh(const scene::Scene& scene, const model::Rayo& rayo, const Precision& precision);

/// A lower bound, t ≥ 0, on every meeting of the element with the ray of any data within the allowance; nothing where
/// no such ray meets it. The bound is the first t in the element's shell, and 0 where the allowance is no small part of
/// the element.
std::optional<surface::exact::Parameter> earliest(const AskedElements& elements, scene::ElementRef element,
                                                  const model::Rayo& rayo, const Precision& precision);

/// A place is the point of a ray that a claim gives. A t that the system gives is exactly that of some moved data. A t
/// computed here from a length is off by √3·δ for v and a rounding, less than 2δ/|v|; from a point, by 2√3·δ and a
/// rounding, less than 4δ/|v|.
struct ClaimedPoint {
  surface::exact::Parameter t;
  surface::Point<number::Dyadic> punto;
  number::Dyadic way;             ///< the largest magnitude of a coordinate of t·v
  int deviation = 0;              ///< the greatest error of t, in units of δ/|v|: 0, 2 or 4
  std::optional<double> given{};  ///< t in binary64, where the system gave t or a length
};

/// The allowance δ of an element at the place.
number::Dyadic delta(const AskedElements& elements, scene::ElementRef element, const ClaimedPoint& place,
                     const model::Rayo& rayo, const Precision& precision);

/// Whether the zone ends before the place, whatever the data. The place's t is off by at most `own`/|v| for the data of
/// the claimed element. The end of the zone is off by 2δ/|v| for the data of its own element: √3·δ for v and 0.22·δ for
/// roundings.
bool is_behind(const ClaimedPoint& place, const number::Dyadic& own, const Zone& zone, const model::Rayo& rayo);

/// Whether the place lies on the element for some data within the allowance; may_lie_inside() also counts the inside of
/// the element, as if filled and closed.
bool may_lie_on(const AskedElements& elements, scene::ElementRef element, const ClaimedPoint& place,
                const model::Rayo& rayo, const Precision& precision);
bool may_lie_inside(const AskedElements& elements, scene::ElementRef element, const ClaimedPoint& place,
                    const model::Rayo& rayo, const Precision& precision);

}  // namespace durero::conform
