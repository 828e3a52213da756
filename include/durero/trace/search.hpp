#pragma once
/// Algorithm II.2 for one ray, element by element. The answer does not depend on the order of the elements.

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

/// A ray's first point on an element, by the first step that can decide it: a parameter t in [low, high].
struct Meeting {
  /// A ray has no point on the element, a first one, or points as near to its origin as one likes.
  enum class Kind : std::uint8_t { none, point, no_minimum };
  Kind kind = Kind::none;                                ///< the numbers belong to a point
  Step step = Step::triage;                              ///< the step that decided
  double low = 0, high = 0;                              ///< bounds of the parameter
  RootEstimate finding{};                                ///< the finding of triage or stable
  std::shared_ptr<const surface::exact::Parameter> t{};  ///< the exact parameter, where the exact step decided
};

/// An element that the ray meets, and where.
struct Candidate {
  scene::ElementRef e;  ///< the element
  Meeting at;           ///< the ray's first point on it
};

/// A search's findings in the elements tested so far.
struct SearchState {
  double limit = no_limit;                                  ///< the parameter beyond which no first hit lies
  boost::container::small_vector<Candidate, 4> candidates;  ///< in the order of their tests, none beyond the limit
  scene::ElementSet without_minimum;                        ///< met as near to the origin as one likes
};

/// The search of one ray in one scene, both of which must outlive it.
class Search {
 public:
  /// Starts without elements; the search adds its decisions to `counts`. Precondition: the elements of en are in the
  /// scene.
  Search(const scene::Scene& scene, const model::Rayo& rayo, Origin en, Counts& counts);

  /// The ray, in the numbers of the steps.
  const Ray& ray() const noexcept { return ray_; }

  /// The parameter beyond which no first hit lies: an upper bound of the least parameter among the elements tested so
  /// far.
  double limit() const noexcept { return found_.limit; }

  /// The caller's knowledge of an element's numbers: that they are `ordinary`, or nothing.
  enum class Range : std::uint8_t { unknown, ordinary };

  /// Tests an element. Precondition: no element is tested twice.
  void test(scene::ElementRef e, Range range = Range::unknown);

  /// The answer over the elements tested. Elements whose points all lie beyond limit() need not be tested.
  scene::Hit finish();

  /// t and the point, rounded once, of the nearest element, which the triage found.
  RoundedPoint rounded_hit(scene::ElementRef e, const RootEstimate& by_triage) const;
  /// t and the point, rounded once, of the nearest element, where the ray meets it.
  RoundedPoint rounded_hit(scene::ElementRef e, const Meeting& met) const;

  /// Whether the ray meets the element at some t > 0.
  bool blocks(scene::ElementRef e, Range range = Range::unknown) const;
  /// Whether the ray meets the element at some 0 < t < 1.
  bool blocks_segment(scene::ElementRef e, Range range = Range::unknown) const;

  /// The ray's first point on an element; none also where the point lies beyond the limit.
  Meeting meeting(scene::ElementRef e, double limit, Range range = Range::unknown) const;
  /// The ray's first point on an element by triage and stable alone; nothing where these cannot tell. A point that they
  /// find is a simple root strictly within the element's ends, edges or rim, because they leave undecided what their
  /// error bound leaves open.
  std::optional<Meeting> certified_meeting(scene::ElementRef e, double limit) const;

 private:
  const scene::Scene& scene_;
  const model::Rayo& rayo_;
  Origin en_;
  Counts& counts_;
  Ray ray_;
  SearchState found_;
};

}  // namespace durero::trace
