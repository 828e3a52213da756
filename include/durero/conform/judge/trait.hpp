#pragma once
/// A trait of a failing question is what its failure may be caused by, such as a direction that is not of length 1. A
/// trait has a remedy, a change of the question that takes it away and changes little else; a system that is right
/// about the changed question shows that the trait causes the failure.

#include <array>
#include <string_view>

#include "durero/conform/ask/runner.hpp"
#include "durero/conform/report/tally.hpp"

namespace durero::conform {

/// The traits, in the order in which their remedies are tried: the remedies that change least come first.
enum class Trait {
  minus_zero,     ///< a number is −0
  not_unit,       ///< v is not of length 1
  small,          ///< the element is smaller than 1/32
  large,          ///< the element is larger than 32
  far_from_zero,  ///< the element is more than 32 of its sizes from (0, 0, 0)
  far_origin,     ///< the origin is more than 32 sizes from the point
  inside,         ///< the origin is inside an element
  near_surface,   ///< the origin is nearer to the point than 1/32 of the size
  several,        ///< there is more than one element
  one_sided,      ///< the element is a triangle, of which a side is seen
  coincidence,    ///< a change of the data by a rounding changes the exact answer
  parallel,       ///< v or an axis is parallel to an axis or a plane of coordinates
  one_axis,       ///< an axis of coordinates is not as good as another
  grazing,        ///< the ray does not go to the middle of the element
  none            ///< no trait of these, or no remedy that helps
};
/// The number of traits, `none` among them.
inline constexpr std::size_t trait_count = 15;

/// The word of a trait in files, spelt as its enumerator.
std::string_view name(Trait trait);
/// The trait as a cause, a sentence without its end: "The direction is not of length 1".
std::string_view title(Trait trait);
/// The remedy in words, such as "with v/|v| for v"; empty for none.
std::string_view remedy(Trait trait);

/// The first trait whose remedy makes the system right, also where the changed question is off by a few roundings. The
/// failure is made tidy before (minimise.hpp). A remedy whose question the profile does not cover, or whose exact
/// answer is another, shows nothing. A failure to answer in time is not asked again.
Trait cause_of(const Finding& finding, const Profile& profile, const Ask& ask);

/// The trait that is likeliest to be the cause, as the question alone tells: nobody is asked.
Trait likely_cause(const Finding& finding, const Profile& profile);

}  // namespace durero::conform
