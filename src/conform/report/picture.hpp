#pragma once
/// The pictures of a report, as SVG.

#include <string>

#include "durero/conform/report/tally.hpp"

namespace durero::conform {

/// The colour of a verdict, as CSS says it.
std::string_view colour(Verdict verdict);

/// The plot of errors: the backward error of each case (upwards, log₂ of ε) against the family's parameter (to the
/// right). A case whose worst ray has no distance, such as a missed one, stands at the top.
std::string spread_svg(const FamilyTally& family);

/// The drawing of a case in oblique parallel projection: its elements as lines, and the points at which rays should
/// hit, coloured by verdict; a failing ray is drawn as it arrives.
std::string scene_svg(const JudgedCase& judged);

}  // namespace durero::conform
