#include "located.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <ranges>

#include "bounds_of_side.hpp"
#include "pixel_view.hpp"

namespace durero::render {
namespace {

/// How far the point of the pixel plane that an engine's ray leads through may be from the centre of its pixel. Each
/// component of a direction is a sum of three terms, and its roundings err by at most 4u of the terms' magnitudes, of
/// which S is the sum: the direction by less than 7u·S. The window is at the distance 1, up to rounding, and S ≥ 1, so
/// the point there by less than 7u·S·(1 + S) ≤ 14u·S². That is less than 2⁻⁴⁸·S²/s pixels of the side s.
double reach_of(const scene::PrimaryRays& rays) {
  const double x = glm::length(rays.step_x()), y = glm::length(rays.step_y());
  const double sum = glm::length(rays.upper_left()) + x * rays.resolution().width + y * rays.resolution().height;
  return 0x1p-48 * sum * sum / std::min(x, y);
}

/// The lines around an outline, each positive inside.
std::vector<polygon::PlaneSide> sides_of(const polygon::Polygon& outline) {
  const int turn = polygon::doubled_area(outline).z.sign();
  std::vector<polygon::PlaneSide> sides;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const polygon::RationalPoint &p = outline[i], &q = outline[(i + 1) % outline.size()];
    const polygon::RationalPoint normal{turn * (p.y - q.y), turn * (q.x - p.x), 0};
    sides.push_back({normal, polygon::dot(normal, p)});
  }
  return sides;
}

/// The least and the greatest pixel of a row or column that a stretch may hold.
struct PixelRange {
  PixelRange(double low, double high, std::uint32_t first, std::uint32_t count)
      : begin(static_cast<std::int64_t>(std::max(std::floor(low) - 1, double(first)))),
        end(static_cast<std::int64_t>(std::min(std::ceil(high) + 2, double(first) + count))) {}
  std::int64_t begin, end;
};

class PixelLocator {
 public:
  PixelLocator(const scene::PrimaryRays& rays, const Crop& crop)
      : rays_(rays),
        crop_(crop),
        view_(rays),
        reach_(reach_of(rays)),
        regions_(std::size_t(crop.size.width) * crop.size.height, without_parent) {}

  /// Gives a region the pixels within it, of those that its parent has.
  void add(const BeamRegion& region, std::uint32_t index) {
    const std::vector<polygon::PlaneSide> sides = sides_of(region.outline);
    const std::vector<SideBounds> about(sides.begin(), sides.end());
    const auto [left, right] = extent(region.outline, &polygon::RationalPoint::x);
    const auto [top, bottom] = extent(region.outline, &polygon::RationalPoint::y);
    const PixelRange rows(top, bottom, crop_.y, crop_.size.height), columns(left, right, crop_.x, crop_.size.width);
    for (std::int64_t y = rows.begin; y < rows.end; ++y)
      for (std::int64_t x = columns.begin; x < columns.end; ++x) {
        std::uint32_t& at = regions_[std::size_t(y - crop_.y) * crop_.size.width + std::size_t(x - crop_.x)];
        if (at == region.parent && holds(sides, about, x, y)) at = index;
      }
  }

  std::vector<std::uint32_t> taken() { return std::move(regions_); }

 private:
  static std::pair<double, double> extent(const polygon::Polygon& outline,
                                          polygon::Rational polygon::RationalPoint::*component) {
    const auto [least, greatest] = std::ranges::minmax(outline | std::views::transform(component));
    return {number::round_to_binary64(least), number::round_to_binary64(greatest)};
  }

  bool holds(const std::vector<polygon::PlaneSide>& sides, const std::vector<SideBounds>& about, std::int64_t x,
             std::int64_t y) const {
    bool sure = true;
    for (const SideBounds& side : about) {
      if (side.surely_negative(double(x), double(y), reach_)) return false;
      sure = sure && side.surely_positive(double(x), double(y), reach_);
    }
    if (sure) return true;
    const model::Rayo ray = rays_.ray(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y));
    const polygon::RationalPoint point = view_.point_of(polygon::exact(ray.v().xyz()));
    return std::ranges::all_of(sides, [&](const polygon::PlaneSide& side) { return side.depth(point) > 0; });
  }

  const scene::PrimaryRays& rays_;
  Crop crop_;
  PixelView view_;
  double reach_;
  std::vector<std::uint32_t> regions_;
};

}  // namespace

std::vector<std::uint32_t> located(const BeamTree& tree, const scene::PrimaryRays& rays, const Crop& crop) {
  PixelLocator locator(rays, crop);
  for (std::uint32_t i = 0; i < tree.size(); ++i) locator.add(tree[i], i);
  return locator.taken();
}

}  // namespace durero::render
