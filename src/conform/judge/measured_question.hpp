#pragma once
/// A measured question is a draft with the lengths that remedies and mutations need, in binary64: the exact judge
/// judges what they make.

#include <optional>
#include <string>

#include "conform/judge/draft.hpp"
#include "durero/conform/report/tally.hpp"

namespace durero::conform {

struct MeasuredQuestion {
  Draft draft;
  std::size_t target = 0;  ///< the number of the element that is met first, or else claimed, or else the first
  double size = 1;         ///< the lesser of radius and height of the target, or its longest edge; 1 of a plane
  double extent = 1;       ///< no point of a target that has ends is farther than that from its middle
  glm::dvec3 middle{};     ///< the middle of the target
  double length = 1;       ///< |v|
  glm::dvec3 unit{};       ///< v/|v|
  double distance = 0;     ///< from the origin to the first point, or the claimed one, or the one next to the middle
  bool has_sides = false;  ///< whether the order of the target's corners gives it a side in front

  MeasuredQuestion(const Finding& finding, const Profile& profile);
};

}  // namespace durero::conform
