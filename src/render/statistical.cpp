#include "statistical.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/common.hpp>
#include <mutex>
#include <numeric>

#include "by_rows.hpp"
#include "points.hpp"

namespace durero::render {
namespace {

/// Of each replica, before it is believed that a pixel whose corners differ is even: what the edge cuts off may be
/// smaller than a few points see.
constexpr std::uint32_t points_of_an_edge = 8;

bool within(const glm::dvec3& v, double width) { return v.x <= width && v.y <= width && v.z <= width; }

}  // namespace

glm::dvec3 deviation(const Estimate& estimate) {
  glm::dvec3 mean(0), squares(0);
  for (const glm::dvec3& sum : estimate.sums) mean += sum / double(estimate.points) / double(replicas);
  for (const glm::dvec3& sum : estimate.sums) {
    const glm::dvec3 off = sum / double(estimate.points) - mean;
    squares += off * off;
  }
  return glm::sqrt(squares / double(replicas - 1));
}

Statistical::Statistical(const View& view, const Samples& samples)
    : view_(view),
      samples_(samples),
      most_points_(std::bit_floor(std::max(1U, samples.most / replicas))),
      factor_(half_width_factor(samples.confidence, std::bit_width(most_points_))),
      corners_(std::size_t(view.crop.size.width + 1) * (view.crop.size.height + 1)) {
  const std::uint32_t in_row = view.crop.size.width + 1;
  std::mutex mutex;
  by_rows(view.crop.size.height + 1, {}, [&](std::uint32_t y) {
    std::vector<glm::dvec2> points(in_row);
    for (std::uint32_t x = 0; x < in_row; ++x) points[x] = view.point(x, y, {-0.5, -0.5});
    const std::vector<Brought> found = view.brought_by(points);
    for (std::uint32_t x = 0; x < in_row; ++x) corners_[std::size_t(y) * in_row + x] = found[x].color;
    const std::lock_guard lock(mutex);
    corner_reach_.samples += found.size();
    for (const Brought& one : found) corner_reach_.rays += one.rays;
  });
}

bool Statistical::corners_agree(std::uint32_t x, std::uint32_t y) const {
  const std::size_t in_row = view_.crop.size.width + 1, at = y * in_row + x;
  const glm::dvec3 &a = corners_[at], &b = corners_[at + 1], &c = corners_[at + in_row], &d = corners_[at + in_row + 1];
  return within(glm::max(glm::max(a, b), glm::max(c, d)) - glm::min(glm::min(a, b), glm::min(c, d)), samples_.width);
}

// NaN, the product of a black material and an infinite light, is not within: such a pixel gets all its rays.
bool Statistical::is_settled(const Estimate& estimate, bool plain) const {
  return (plain || estimate.points >= points_of_an_edge) && within(factor_ * deviation(estimate), samples_.width);
}

/// Twice as many points of each replica as before, or the first one.
void Statistical::take_points(std::uint32_t y, std::span<const std::uint32_t> open, std::vector<Estimate>& row) const {
  const std::uint32_t begin = row[open.front()].points, end = std::max(1U, 2 * begin);
  std::vector<glm::dvec2> points(open.size() * replicas);
  for (std::uint32_t i = begin; i < end; ++i) {
    for (std::size_t k = 0; k < points.size(); ++k) {
      const std::uint32_t x = open[k / replicas], replica = static_cast<std::uint32_t>(k % replicas);
      points[k] = view_.point(x, y, in_net(i, key_of(view_.crop.x + x, view_.crop.y + y, replica)));
    }
    const std::vector<Brought> found = view_.brought_by(points);
    for (std::size_t k = 0; k < points.size(); ++k) {
      Estimate& estimate = row[open[k / replicas]];
      estimate.sums[k % replicas] += found[k].color;
      add(estimate.all, found[k]);
    }
  }
  for (const std::uint32_t x : open) row[x].points = end;
}

Row Statistical::row(std::uint32_t y) const {
  std::vector<Estimate> estimates(view_.crop.size.width);
  std::vector<std::uint32_t> open(estimates.size());
  std::iota(open.begin(), open.end(), 0);
  const auto settled = [&](std::uint32_t x) { return is_settled(estimates[x], corners_agree(x, y)); };
  for (std::uint32_t points = 1; points <= most_points_ && !open.empty(); points *= 2) {
    take_points(y, open, estimates);
    std::erase_if(open, settled);
  }
  Row row{.pixels = {}, .in_doubt = open.size()};
  for (Estimate& estimate : estimates) {
    row.samples += std::uint64_t{estimate.points} * replicas;
    divide(estimate.all, estimate.points * replicas);
    row.pixels.push_back(estimate.all);
  }
  return row;
}

}  // namespace durero::render
