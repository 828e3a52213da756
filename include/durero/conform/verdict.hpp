#pragma once
/// How a claim stands to the truth.
///
/// A claim is *right* where some data within the declared backward error of those given have it as their exact answer,
/// as far as exact arithmetic can tell: whatever it cannot tell is decided for the system. The declared backward error
/// is 16ε, with ε = 2⁻²⁴ or 2⁻⁵³, the unit of rounding of the system's format: every coordinate and every length of an
/// element, every coordinate of the origin, and every coordinate of t·v may be off by 16ε·M, where M is the largest
/// magnitude among them; every coordinate of a unit vector by 16ε; a proportion by 16ε of itself or of 1, whichever is
/// the greater. A disc that closes a solid is off by what its wall is off, from which it follows. Each element may be
/// off in its own way; but of a system that claims to be watertight, in a closed mesh the vertices that triangles share
/// are off together, and the ray is one for all of it. A system that declares a thickness of its surfaces may be off by
/// that besides.

#include <optional>
#include <string>
#include <string_view>

namespace durero::conform {

/// What a claim is found to be. Off and what follows it, but for skipped, are failures.
enum class Verdict {
  exact,          ///< right to the bit, in the system's format
  right,          ///< the answer of some data within the declared backward error of those given
  off,            ///< none of those, yet of the right element and within 0.001 of its size of the right point
  phantom,        ///< off: a hit where there is none
  missed,         ///< off: no hit where there is one
  wrong_element,  ///< off: of an element that is not first
  far_root,       ///< off: a later crossing of the right element, by more than 0.001 of its size
  misplaced,      ///< off by more than 0.001 of the size
  non_finite,     ///< a hit with a number that is none
  crashed,        ///< the system ended while it was asked
  hung,           ///< no answer in the time that the system had
  skipped         ///< outside the profile, or no answer
};
/// How many verdicts there are.
inline constexpr int verdict_count = 12;
/// The word of a verdict in files and reports, spelt as its enumerator.
std::string_view name(Verdict verdict);
/// What the verdict says, in one line.
std::string_view meaning(Verdict verdict);
/// Off, and the picture is another: a hit for a miss or a miss for a hit, another element, far from the point, or no
/// number or answer at all.
bool is_gross(Verdict verdict);

/// A verdict, and by how much the claim is off.
struct Judgement {
  Verdict verdict = Verdict::skipped;  ///< on the claim
  /// Of a hit where the truth is a hit: |t − t!| in units of the last place of t! in the system's format; where the
  /// claim is a point alone, of its worst coordinate, in units of the last place of the largest coordinate.
  double ulps = 0;
  /// Of a hit: how far its point is from the surface of the element (the nearest, where none is named), in units of
  /// ε·M. It is the error that is left where what the case itself makes of a rounding of its data is taken away: an
  /// answer within 16 or so is as good as its data, however many ulps it is off. 0 where the verdict is `exact`.
  double backward = 0;
  std::string clause{};  ///< skipped: of the profile
  /// skipped, of a system that answered all the same: what the verdict would be inside the profile. So the report can
  /// say what a user of the system sees there, such as the far root for one nearer than least_t.
  std::optional<Verdict> otherwise{};
};

}  // namespace durero::conform
