#include "ends.hpp"

#include <fmt/format.h>

#include <cmath>

#include "losses.hpp"

namespace durero::io {

std::optional<AxisEnds> WrittenEnds::of(const glm::dvec3& base, const Axis& axis, double narrow, double proportion) {
  const AxisEnds ends{base, narrow + proportion * axis.altura, end_of(base, axis), narrow};
  if (!std::isfinite(ends.wide)) {
    ++too_wide_;
    return std::nullopt;
  }
  const auto again = axis_between(base, ends.top);
  const double narrows = again ? proportion_between(ends.wide, narrow, again->altura) : 0;
  const bool is_straight = proportion > 0 && ends.wide == narrow;
  const bool is_cone = proportion > 0 && !is_straight;
  if (!again || ends.wide == 0 || (is_cone && !(narrows > 0 && std::isfinite(narrows)))) {
    ++endless_;
    return std::nullopt;
  }
  if (*again != axis) ++rounded_axes_;
  if (is_straight) ++straight_;
  if (narrows != proportion) ++rounded_radii_;
  return ends;
}

void WrittenEnds::name_losses(std::vector<std::string>& lost, std::string_view format) const {
  add_loss(lost, too_wide_, "element", "elements", "left out: the radius of its base is beyond binary64");
  add_loss(lost, endless_, "element", "elements", "left out: no ends in binary64 give it");
  add_loss(lost, straight_, "truncated cone", "truncated cones", "written as a cylinder: its radii round to one");
  add_loss(lost, rounded_axes_, "axis", "axes", fmt::format("rounded: {} holds end points", format));
  add_loss(lost, rounded_radii_, "proportion", "proportions",
           fmt::format("rounded: {} holds the radii of the ends", format));
}

}  // namespace durero::io
