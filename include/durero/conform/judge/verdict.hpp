#pragma once
/// The verdict on a claim compares it with the exact answer, within the backward error that the system declares.
///
/// A claim is *right* where some data within the declared backward error of the data given have it as their exact
/// answer, as far as exact arithmetic can tell: a doubt that it leaves is decided for the system. The declared backward
/// error is 16ε, with ε = 2⁻²⁴ or 2⁻⁵³, the unit of rounding of the system's format: every coordinate and every length
/// of an element, every coordinate of the origin, and every coordinate of t·v may be off by 16ε·M, where M is the
/// largest magnitude among them; every coordinate of a unit vector by 16ε; a proportion by 16ε of itself or of 1,
/// whichever is the greater. A disc that closes a solid follows from its wall, and is off by the errors of the wall.
/// Each element may be off in its own way; but for a system that claims to be watertight, the vertices that the
/// triangles of a closed mesh share are off together, and the ray is one for all triangles. A system that declares a
/// thickness of its surfaces may be off by that besides.

#include <optional>
#include <string>
#include <string_view>

namespace durero::conform {

/// The verdicts on claims. `off` and the verdicts after it, except `skipped`, are failures.
enum class Verdict {
  exact,          ///< right to the bit, in the system's format
  right,          ///< the answer of some data within the declared backward error
  off,            ///< no such answer, yet of the right element and within 0.001 of its size of the right point; also a
                  ///< right hit with a normal, or u and v, that are off by as little
  phantom,        ///< off: a hit where there is none
  missed,         ///< off: no hit where there is one
  wrong_element,  ///< off: of an element that is not first
  far_root,       ///< off: a later crossing of the right element, by more than 0.001 of its size
  misplaced,      ///< off by more than 0.001 of the size
  out_of_range,   ///< off: a hit outside the range that was asked about
  doubled,        ///< in a list of all hits, a hit of an element that is crossed less often there
  unsorted,       ///< a list of right hits that are not in the order of the ray
  wrong_count,    ///< a number of hits that no such data have
  wrong_normal,   ///< a right hit with the normal of no such data, off by more than 0.001 of its length
  wrong_face,     ///< a right hit of the other side of the element
  wrong_uv,       ///< a right hit with u and v of a point that is off by more than 0.001 of the triangle's size
  non_finite,     ///< a hit with a number that is missing, infinite or NaN
  crashed,        ///< the system ended while it was asked
  hung,           ///< no answer in the time that the system had
  skipped         ///< outside the profile, or no answer
};
/// The number of verdicts.
inline constexpr int verdict_count = 19;
/// The word of a verdict in files and reports, spelt as its enumerator.
std::string_view name(Verdict verdict);
/// The meaning of a verdict, in one line.
std::string_view meaning(Verdict verdict);
/// Whether the verdict is a failure that changes the picture: a hit for a miss or a miss for a hit, another element, a
/// point far away, or no number or answer at all.
bool is_gross(Verdict verdict);

/// A verdict on a claim, and the amount by which the claim is off.
struct ClaimJudgement {
  Verdict verdict = Verdict::skipped;  ///< on the claim
  /// The error of a hit where the truth is a hit too: |t − t!| in units of the last place of t! in the system's format,
  /// with t for the number that the system calls distance. For a claim of a point alone it is the error of the worst
  /// coordinate, in units of the last place of the largest coordinate. Otherwise 0.
  double ulps = 0;
  /// The backward error of a hit: the distance of its point from the surface of the element (the nearest, where none is
  /// named), in units of ε·M. It leaves out the error that the case itself makes of a rounding of its data: an answer
  /// within 16 or so is as good as its data, however many ulps it is off. 0 where the verdict is `exact`.
  double backward = 0;
  std::string clause{};  ///< the clause of the profile that excludes a skipped ray, or why there is no answer
  /// The verdict that a skipped claim would get inside the profile, where the system answered all the same. The report
  /// tells a user of the system from it which errors occur there, such as the far root for one nearer than least_t.
  std::optional<Verdict> otherwise{};
};

}  // namespace durero::conform
