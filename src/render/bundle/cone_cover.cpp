#include "cone_cover.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace durero::render {
namespace {

/// The flat fans that a cone is cut into where elements overlap in it. A fan in the middle is 2/128 of a cone, so that
/// an edge along the fans is off by half of that at most, which is 2/255.
constexpr int fans = 128;

/// An element that a cone may see.
struct PartlySeen {
  const ConeTarget* target;
  double share;
};

/// The solid angle of the directions (x', y) with x' from 0 to x, for each unit of y.
double within_fan(double x, double y) { return x / ((1 + y * y) * std::sqrt(1 + x * x + y * y)); }

/// Collects the pieces of a cone's fans, by what is seen on each.
class FanSum {
 public:
  FanSum(const RayCone& cone, std::span<const PartlySeen> seen, double end) : cone_(cone), seen_(seen), end_(end) {}

  std::vector<ConePart> parts() {
    for (int i = 0; i < fans; ++i) add_fan(std::numbers::pi * ((i + 0.5) / fans - 0.5));
    double whole = 0;
    for (const auto& [target, sum] : sums_) whole += sum.weight;
    std::vector<ConePart> parts;
    for (const auto& [target, sum] : sums_) {
      const glm::dvec2 at = sum.place / sum.weight;
      const double t = target ? target->parameter(cone_.apex, cone_.direction(at), cone_.start) : infinity;
      parts.push_back({target, sum.weight / whole, at, t});
    }
    return parts;
  }

 private:
  struct Sum {
    double weight = 0;
    glm::dvec2 place{0};
  };
  struct Stretch {
    const ConeTarget* target;
    double low, high;
  };

  /// Adds the fan at y = tangent·sin(turn), which reaches to x = ±tangent·cos(turn).
  void add_fan(double turn) {
    const double y = cone_.tangent * std::sin(turn), reach = cone_.tangent * std::cos(turn);
    std::vector<Stretch> met;
    std::vector<double> cuts{-reach, reach};
    for (const PartlySeen& one : seen_) {
      const auto stretch = one.target->stretch(cone_, y);
      if (!stretch || (*stretch)[1] <= -reach || (*stretch)[0] >= reach) continue;
      met.push_back({one.target, (*stretch)[0], (*stretch)[1]});
      for (const double x : *stretch)
        if (x > -reach && x < reach) cuts.push_back(x);
    }
    std::ranges::sort(cuts);
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) add_piece(met, y, reach, cuts[i], cuts[i + 1], 12);
  }

  /// Adds a piece on which the same elements are met. Where the nearest of them is not the same at its ends, it is cut
  /// in the middle, some times.
  void add_piece(std::span<const Stretch> met, double y, double weight, double low, double high, int halvings) {
    const double inset = 1e-6 * (high - low);
    const ConeTarget* const first = nearest(met, y, low + inset);
    if (halvings > 0 && first != nearest(met, y, high - inset)) {
      add_piece(met, y, weight, low, (low + high) / 2, halvings - 1);
      add_piece(met, y, weight, (low + high) / 2, high, halvings - 1);
      return;
    }
    Sum& sum = sums_[first];
    const double part = weight * (within_fan(high, y) - within_fan(low, y));
    sum.weight += part;
    sum.place += part * glm::dvec2((low + high) / 2, y);
  }

  const ConeTarget* nearest(std::span<const Stretch> met, double y, double x) const {
    const ConeTarget* found = nullptr;
    double least = end_;
    for (const Stretch& one : met) {
      if (x < one.low || x > one.high) continue;
      const double t = one.target->parameter(cone_.apex, cone_.direction({x, y}), cone_.start);
      if (t < least) found = one.target, least = t;
    }
    return found;
  }

  /// Elements in their order in the scene, so that sums have one order.
  struct InOrder {
    bool operator()(const ConeTarget* a, const ConeTarget* b) const {
      if (!a || !b) return a && !b;
      return a->element() < b->element();
    }
  };

  const RayCone& cone_;
  std::span<const PartlySeen> seen_;
  double end_;
  std::map<const ConeTarget*, Sum, InOrder> sums_{};
};

/// The nearest of the elements that cover the whole cone, by its axis.
ConePart backdrop(const RayCone& cone, std::span<const PartlySeen> seen, double end) {
  ConePart whole{nullptr, 1, {0, 0}, infinity};
  for (const PartlySeen& one : seen) {
    if (one.share < 1) continue;
    const double t = one.target->parameter(cone.apex, cone.axis, cone.start);
    if (t < std::min(whole.t, end)) whole = {one.target, 1, {0, 0}, t};
  }
  return whole;
}

/// Whether a surface is nearer than another all over the cone: at its axis and at eight places of its rim.
bool is_before(const RayCone& cone, const ConeTarget& one, const ConeTarget& other) {
  for (int i = 0; i <= 8; ++i) {
    const double turn = std::numbers::pi * i / 4;
    const glm::dvec2 at = i == 8 ? glm::dvec2(0) : cone.tangent * glm::dvec2(std::cos(turn), std::sin(turn));
    const double t = one.parameter(cone.apex, cone.direction(at), cone.start);
    if (t >= other.parameter(cone.apex, cone.direction(at), cone.start)) return false;
  }
  return true;
}

}  // namespace

std::vector<ConePart> parts_of(const RayCone& cone, std::span<const ConeTarget> targets,
                               const scene::ElementSet& origins, double end) {
  std::vector<PartlySeen> seen, partly;
  for (const ConeTarget& target : targets) {
    if (std::ranges::find(origins, target.element()) != origins.end()) continue;
    const double share = target.share(cone);
    if (share <= 0) continue;
    seen.push_back({&target, share});
    if (share < 1) partly.push_back(seen.back());
  }
  const ConePart behind = backdrop(cone, seen, end);
  const auto is_behind = [&](const PartlySeen& one) {
    return one.target == behind.target || one.share < 1 ||
           (behind.target && is_before(cone, *behind.target, *one.target));
  };
  if (partly.size() > 1 || !std::ranges::all_of(seen, is_behind)) return FanSum(cone, seen, end).parts();
  if (partly.empty()) return {behind};
  const auto& [target, share] = partly.front();
  if (behind.target && !is_before(cone, *target, *behind.target)) return FanSum(cone, seen, end).parts();
  const glm::dvec2 at = target->middle(cone), rest = -share / (1 - share) * at;
  const double t = target->parameter(cone.apex, cone.direction(at), cone.start);
  if (!(t < end)) return {behind};
  const double beyond =
      behind.target ? behind.target->parameter(cone.apex, cone.direction(rest), cone.start) : infinity;
  return {{target, share, at, t}, {behind.target, 1 - share, rest, beyond}};
}

}  // namespace durero::render
