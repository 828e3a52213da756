#pragma once
/// How a claim stands to the truth.

#include <string>
#include <string_view>

namespace durero::conform {

enum class Verdict {
  exact,          ///< right to the bit, in the system's format
  right,          ///< the answer of some data within the declared backward error of those given
  off,            ///< none of those, yet of the right element and near
  phantom,        ///< off: a hit where there is none
  missed,         ///< off: no hit where there is one
  wrong_element,  ///< off: of an element that is not first
  far_root,       ///< off: a later crossing of the right element
  misplaced,      ///< off by more than 0.001 of the size
  non_finite,     ///< a hit with a number that is none
  crashed,
  hung,
  skipped  ///< outside the profile
};
inline constexpr int verdict_count = 12;
std::string_view name(Verdict verdict);
/// What the verdict says, in one line.
std::string_view meaning(Verdict verdict);
/// Off, and the picture is another: a hit for a miss or a miss for a hit, another element, or far from the point.
bool is_gross(Verdict verdict);

struct Judgement {
  Verdict verdict = Verdict::skipped;
  double ulps = 0;  ///< of a hit: |t − t!| in units of the last place of t! in the system's format
  double backward =
      0;  ///< of a hit: how far its point is from the element's surface, in units of ε of the largest magnitude
  std::string clause{};  ///< skipped: of the profile
};

}  // namespace durero::conform
