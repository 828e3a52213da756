#pragma once
/// A zone is a stretch of a ray that certainly crosses an element, whatever data within the allowance both have; a
/// place is a point of a ray that a claim gives. The functions below compare the two exactly.

#include <optional>
#include <vector>

#include "conform/ask/asked_elements.hpp"
#include "conform/judge/scene_tree.hpp"
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

/// The zones that shells prove, each around an exact crossing t > 0 of the ray. Shapes that the ray first meets
/// behind `limit` may be left out. Every zone holds an exact crossing between the ends of its element, also where the
/// origin is taken to lie on the elements of `en`. The tree is that of the elements' scene.
std::vector<Zone> zones(const AskedElements& elements, const SceneTree& tree, const scene::Query& ray,
                        const Precision& precision, double limit);

/// A lower bound, t ≥ from, on every meeting at such t of the element with the ray of any data within the allowance;
/// nothing where no such ray meets it there. The bound is the first such t in the element's shell, and `from` where the
/// allowance is no small part of the element. Precondition: from ≥ 0.
std::optional<surface::exact::Parameter> earliest(const AskedElements& elements, scene::ElementRef element,
                                                  const model::Rayo& rayo, const Precision& precision,
                                                  const surface::exact::Parameter& from = {});

/// A stretch begin ≤ t ≤ end of the ray, perhaps without end, in which the rays of data within the allowance may meet
/// an element, so many times at most.
struct ShellStretch {
  surface::exact::Parameter begin;
  std::optional<surface::exact::Parameter> end;
  std::size_t most;
};

/// All stretches of t ≥ 0, ascending, in which the rays of any data may meet the element: each meeting lies in one.
/// Nothing where the allowance is no small part of the element: it may then be met anywhere. No ray meets an element
/// more than most_meetings times, but for a torus.
///
/// An element is part of a quadric, which a ray meets twice at most, or lies in it: that counts twice, by its ends. A
/// stretch that goes from one wall of the shell to the other meets the element once at most: for all data the one end
/// is outside the quadric or on it, and the other inside or on it, so that the ray crosses it an odd number of times
/// between them. The walls are far apart at both ends, where the shell has a place for that.
std::optional<std::vector<ShellStretch>> stretches(const AskedElements& elements, scene::ElementRef element,
                                                   const model::Rayo& rayo, const Precision& precision);
inline constexpr std::size_t most_meetings = 2;
/// Of a torus, which a ray meets four times at most, each stretch has room for so many.
inline constexpr std::size_t most_meetings_of_torus = 4;
/// The greatest number of meetings of a ray with the element.
std::size_t most_meetings_of(const AskedElements& elements, scene::ElementRef element);

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

/// t + by/longest, with the largest coordinate of v, which is at most |v|. So t − by/longest is at most t − by/|v|.
surface::exact::Parameter moved_by(const surface::exact::Parameter& t, const number::Dyadic& by,
                                   const model::Rayo& rayo);

/// Whether the zone ends before the place, whatever the data. The place's t is off by at most `own`/|v| for the data of
/// the claimed element. The end of the zone is off by 2δ/|v| for the data of its own element: √3·δ for v and 0.22·δ for
/// roundings.
bool is_behind(const ClaimedPoint& place, const number::Dyadic& own, const Zone& zone, const model::Rayo& rayo);

/// Whether the zone begins behind the place, whatever the data, likewise.
bool is_before(const ClaimedPoint& place, const number::Dyadic& own, const Zone& zone, const model::Rayo& rayo);

/// Whether the place lies on the element for some data within the allowance; may_lie_inside() also counts the inside of
/// the element, as if filled and closed.
bool may_lie_on(const AskedElements& elements, scene::ElementRef element, const ClaimedPoint& place,
                const model::Rayo& rayo, const Precision& precision);
bool may_lie_inside(const AskedElements& elements, scene::ElementRef element, const ClaimedPoint& place,
                    const model::Rayo& rayo, const Precision& precision);

}  // namespace durero::conform
