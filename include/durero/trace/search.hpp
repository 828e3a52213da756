#pragma once
/// Algorithm II.2 for one ray, element by element, in any order: the answer does not depend on it.

#include <boost/container/small_vector.hpp>
#include <memory>
#include <optional>

#include "durero/scene/hit.hpp"
#include "durero/scene/query.hpp"
#include "durero/scene/scene.hpp"
#include "durero/surface/exact.hpp"
#include "durero/trace/counts.hpp"
#include "durero/trace/finding.hpp"
#include "durero/trace/ray.hpp"

namespace durero::trace {

using scene::Origin;

/// Where a ray first meets an element, by the first step that can tell: a parameter t in [low, high].
struct Meeting {
  /// What is met: nothing, a first point, or points as near to the origin as one likes.
  enum class Kind : std::uint8_t { none, point, no_minimum };
  Kind kind = Kind::none;                                ///< the numbers are of a point
  Step step = Step::triage;                              ///< which could tell
  double low = 0, high = 0;                              ///< around the parameter
  Finding finding{};                                     ///< by triage or stable
  std::shared_ptr<const surface::exact::Parameter> t{};  ///< by exact
};

/// An element, and where the ray first meets it.
struct Candidate {
  scene::ElementRef e;  ///< what is met
  Meeting at;           ///< its first point
};

/// The findings of a search in the elements tested so far.
struct Found {
  double limit = no_limit;                                  ///< no point beyond it is the first
  boost::container::small_vector<Candidate, 4> candidates;  ///< in the order of their tests, none beyond the limit
  scene::ElementSet without_minimum;                        ///< met as near to the origin as one likes
};

/// One ray against one scene, both of which must outlive it.
class Search {
 public:
  /// Adds to `counts` what decided. Precondition: the elements of en are in the scene.
  Search(const scene::Scene& scene, const model::Rayo& rayo, Origin en, Counts& counts);

  /// The ray, in the numbers of the steps.
  const Ray& ray() const noexcept { return ray_; }

  /// No point beyond this parameter is the first: at least the first parameter among the elements tested so far.
  double limit() const noexcept { return found_.limit; }

  /// What the caller knows of the numbers of an element: that they are `ordinary`, or nothing.
  enum class Range : std::uint8_t { unknown, ordinary };

  /// Takes an element into account. Precondition: no element is taken twice.
  void test(scene::ElementRef e, Range range = Range::unknown);

  /// The answer over the elements tested. Elements whose points all lie beyond limit() may be left out.
  scene::Hit finish();

  /// t and the point of an element that the triage found to be the nearest, rounded once.
  Rounded rounded_hit(scene::ElementRef e, const Finding& by_triage) const;
  /// The same of the element that is nearest, where it is met so.
  Rounded rounded_hit(scene::ElementRef e, const Meeting& met) const;

  /// The ray meets the element at some t > 0.
  bool blocks(scene::ElementRef e, Range range = Range::unknown) const;
  /// The ray meets the element at some 0 < t < 1.
  bool blocks_segment(scene::ElementRef e, Range range = Range::unknown) const;

  /// Where the ray first meets one element; none also where that is beyond the limit.
  Meeting meeting(scene::ElementRef e, double limit, Range range = Range::unknown) const;
  /// The same without the exact step; nothing where the others cannot tell. A point that they find is a simple root
  /// strictly within the element's ends, edges or rim: they find none where a bound on their error leaves that open.
  std::optional<Meeting> certified_meeting(scene::ElementRef e, double limit) const;

 private:
  const scene::Scene& scene_;
  const model::Rayo& rayo_;
  Origin en_;
  Counts& counts_;
  Ray ray_;
  Found found_;
};

}  // namespace durero::trace
