#include "crossing.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace durero::oracle::sampled {
namespace {

/// The points with parameters (u ± half_u, v ± half_v).
struct Cell {
  double u, v, half_u, half_v;
};

class CrossingSearch {
 public:
  CrossingSearch(const ElementSurface& surface, const ScaledRay& line, double before, double finest, double slack)
      : surface_(surface), line_(line), before_(before), finest_(std::max(finest, slack)), slack_(slack) {}

  SampledVerdict verdict() {
    visit({0.5, 0.5, 0.5, 0.5});
    return verdict_;
  }

 private:
  void visit(const Cell& cell) {
    if (verdict_ == SampledVerdict::unsound) return;
    // A path along the profile and then around the axis leads from the middle to any point of the cell.
    const PlacedSurface& surface = surface_.surface;
    const double along = surface.length() * cell.half_u;
    const double around = surface.around_within(cell.u, along) * cell.half_v;
    const double reach = along + around + slack_;
    const SurfacePoint middle = surface.at(cell.u, cell.v);
    const double foot = line_.foot(middle.point);
    if (glm::length(middle.point - line_.at(foot)) > reach || foot - reach > before_) return;
    if (!surface_.may_have(middle.point, reach)) return;
    const double slope = std::abs(glm::dot(line_.direction, middle.normal));
    const double flattest = slope + middle.curvature * reach;  // of the points of the cell, if no edge is near
    const bool whole = 20 * reach <= middle.edge && surface_.has_all(middle.point, 9 * reach);
    if (whole && crosses(slope, middle.curvature * reach) && foot - 8 * reach > 0 && foot + 8 * reach < before_) {
      verdict_ = SampledVerdict::unsound;
    } else if (whole && flattest <= 1.0 / 8) {
      excuse(SampledVerdict::grazing);
    } else if (along + around <= finest_) {
      excuse(reason(foot, reach, whole));
    } else {
      visit_halves(cell, along > around);
    }
  }

  void visit_halves(const Cell& cell, bool of_u) {
    const double by_u = of_u ? cell.half_u / 2 : 0, by_v = of_u ? 0 : cell.half_v / 2;
    for (const double side : {-1.0, 1.0}) {
      visit({cell.u + side * by_u, cell.v + side * by_v, cell.half_u - by_u, cell.half_v - by_v});
    }
  }

  /// The condition of the proof on |d·n| and κD.
  static bool crosses(double slope, double bend) { return bend <= 1.0 / 36 && slope > 1.0 / 8 + 82.0 / 8 * bend; }

  /// Why the finest points near this foot prove nothing.
  SampledVerdict reason(double foot, double reach, bool whole) const {
    if (foot - 8 * reach <= 0) return SampledVerdict::origin;
    if (foot + 8 * reach >= before_) return SampledVerdict::agrees;  // the claimed hit may be the one that is near
    return whole ? SampledVerdict::grazing : SampledVerdict::rim;
  }

  void excuse(SampledVerdict reason) { verdict_ = std::max(verdict_, reason); }

  const ElementSurface& surface_;
  const ScaledRay& line_;
  double before_, finest_, slack_;
  SampledVerdict verdict_ = SampledVerdict::agrees;
};

}  // namespace

SampledVerdict crossing(const ElementSurface& surface, const ScaledRay& line, double before, double finest,
                        double slack) {
  return CrossingSearch(surface, line, before, finest, slack).verdict();
}

}  // namespace durero::oracle::sampled
