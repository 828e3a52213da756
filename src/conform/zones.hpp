#pragma once
/// Where a ray meets an element whatever data within the allowance both have, and where a point may lie on one.

#include <optional>
#include <vector>

#include "durero/conform/profile.hpp"
#include "durero/scene/query.hpp"
#include "durero/scene/scene.hpp"
#include "durero/surface/equation.hpp"
#include "durero/surface/exact_element.hpp"

namespace durero::conform {

/// A stretch 0 < begin ≤ t ≤ end in which the ray of all data within the allowance meets the element.
struct Zone {
  scene::ElementRef element;
  surface::exact::Parameter begin, end;
  number::Dyadic delta;  ///< δ of the element, where t ≤ end
};

/// Every such stretch. An exact crossing lies in each, also where the origin is taken to lie on the elements of en.
std::vector<Zone> zones(const scene::Scene& scene, const scene::Query& ray, Format format);

/// A place on a ray as a claim gives it.
struct Place {
  surface::exact::Parameter t;
  surface::Point<number::Dyadic> punto;
  number::Dyadic way;             ///< the largest coordinate of t·v, without its sign
  std::optional<double> given{};  ///< t, where it is a number of binary64
};

/// Whether the zone ends before the place, whatever the data: t is off by at most 2δ/|v|, which is √3·δ for v and
/// 0.22·δ for roundings.
bool is_behind(const Place& place, const Zone& zone, const model::Rayo& rayo);

/// Whether the place lies on the element, or inside it where the element is filled and closed, for some data.
bool may_lie_on(const scene::Scene& scene, scene::ElementRef element, const Place& place, const model::Rayo& rayo,
                Format format);
bool may_lie_inside(const scene::Scene& scene, scene::ElementRef element, const Place& place, const model::Rayo& rayo,
                    Format format);

}  // namespace durero::conform
