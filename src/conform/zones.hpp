#pragma once
/// Where a ray meets an element whatever data within the allowance both have, and where a point may lie on one.

#include <optional>
#include <vector>

#include "conform/asked_elements.hpp"
#include "durero/scene/query.hpp"
#include "durero/scene/scene.hpp"
#include "durero/surface/equation.hpp"
#include "durero/surface/exact_element.hpp"

namespace durero::conform {

/// A stretch 0 < begin ≤ t ≤ end in which the ray of all data within the allowance meets the element; of a mesh, from 0
/// on.
struct Zone {
  scene::ElementRef element;
  surface::exact::Parameter begin, end;
  number::Dyadic delta;  ///< δ of the element, where t ≤ end
};

/// Every such stretch of the elements that the ray first meets at a parameter ≤ limit; it may leave out, of those, what
/// lies behind the limit. An exact crossing within the ends of the element lies in each, also where the origin is taken
/// to lie on the elements of en.
std::vector<Zone> zones(const AskedElements& elements, const scene::Query& ray, const Precision& precision,
                        double limit);

/// That of the triangles of the scene, named by the first, where they are a closed mesh around the origin: every edge
/// is one of two triangles with the very same vertices, or of an even number. Here vertices that triangles share move
/// together, and the ray is one for all: what a system claims that is watertight.
///
/// How often a point is inside a closed mesh, modulo 2, is the number of crossings of any ray from it that meets no
/// edge; it changes nowhere but on the mesh. Let vertices and origin move to their places in straight lines: the mesh
/// stays closed, each of its points moves by at most √3·δ and the origin by as much, so that an origin farther than
/// 2√3·δ from every triangle never meets the mesh, and stays inside; 6δ is farther. Nothing far away is inside, so the
/// ray meets the mesh, whatever its direction. There no coordinate of t·v is larger than twice the largest L of
/// vertices and origin by more than 2δ, so M ≤ (2 + 2⁻⁴)·L where 32δ ≤ L. That point lies in the box of the mesh grown
/// by δ; p is off by δ and t·v by as much, so that p + t·v lies in the box grown by 3δ, which the ray leaves before it
/// leaves that grown by 4δ: the end of the stretch.
std::optional<Zone> zone_of_mesh(const scene::Scene& scene, const model::Rayo& rayo, const Precision& precision);

/// The least t ≥ 0 at which the ray of some data within the allowance may meet the element, as far as shells tell;
/// nothing where the ray of no such data meets it.
std::optional<surface::exact::Parameter> earliest(const AskedElements& elements, scene::ElementRef element,
                                                  const model::Rayo& rayo, const Precision& precision);

/// A place on a ray as a claim gives it. Its t is that of moved data but where it was computed from a length or a
/// point: then of a length, off by √3·δ for v and a rounding, less than 2δ/|v|; of a point, off by 2√3·δ and a
/// rounding, less than 4δ/|v|.
struct Place {
  surface::exact::Parameter t;
  surface::Point<number::Dyadic> punto;
  number::Dyadic way;             ///< the largest coordinate of t·v, without its sign
  int deviation = 0;              ///< 0, 2 or 4: by how many δ/|v| t is off
  std::optional<double> given{};  ///< t, where it is a number of binary64
};

/// δ of an element at the place.
number::Dyadic delta(const AskedElements& elements, scene::ElementRef element, const Place& place,
                     const model::Rayo& rayo, const Precision& precision);

/// Whether the zone ends before the place, whatever the data, where t is off by `own`/|v| for those of the element that
/// is claimed: with the data of the zone's element its end is off by 2δ/|v|, which is √3·δ for v and 0.22·δ for
/// roundings.
bool is_behind(const Place& place, const number::Dyadic& own, const Zone& zone, const model::Rayo& rayo);

/// Whether the place lies on the element, or inside it where the element is filled and closed, for some data.
bool may_lie_on(const AskedElements& elements, scene::ElementRef element, const Place& place, const model::Rayo& rayo,
                const Precision& precision);
bool may_lie_inside(const AskedElements& elements, scene::ElementRef element, const Place& place,
                    const model::Rayo& rayo, const Precision& precision);

}  // namespace durero::conform
