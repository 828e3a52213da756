#include "statistical.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <mutex>
#include <numeric>

#include "by_rows.hpp"
#include "points.hpp"

namespace durero::render {
namespace {

/// @{ The least points of a pixel whose corners differ, or of one near such a pixel, before it is taken for even: the
/// part that an edge cuts off may be smaller than fewer points see.
constexpr std::uint32_t points_of_an_edge = 32, points_near_an_edge = 8;
/// @}

/// The number of looks at whether a pixel is settled, up to so many points: one at least_samples and one at each power
/// of two after it.
std::uint32_t looks(std::uint32_t points) { return std::bit_width(points / least_samples); }

/// Half the confidence interval for a deviation of 1 at each look, over the part of the width that is asked for there.
/// The last look asks for the whole width, since none comes after it.
std::vector<double> half_widths(double confidence, std::uint32_t most_points) {
  std::vector<double> all;
  for (std::uint32_t points = least_samples; points <= most_points; points *= 2) {
    const double factor = half_width_factor(confidence, looks(most_points), std::min(points, most_blocks));
    all.push_back(factor / (points == most_points ? 1 : part_of_width(points)));
  }
  return all;
}

bool within(const glm::dvec3& v, double width) { return v.x <= width && v.y <= width && v.z <= width; }

}  // namespace

void Estimate::grow_to(std::uint32_t points_then) {
  if (points >= most_blocks) {
    for (std::size_t block = 0; block < most_blocks / 2; ++block) sums[block] = sums[2 * block] + sums[2 * block + 1];
    std::fill(sums.begin() + most_blocks / 2, sums.end(), glm::dvec3(0));
  }
  points = points_then;
}

void Estimate::take(std::uint32_t i, const PathRadiance& brought) {
  sums[i / (points / blocks())] += brought.color;
  add(all, brought);
}

glm::dvec3 deviation(const Estimate& estimate) {
  const std::uint32_t blocks = estimate.blocks();
  const double in_block = double(estimate.points) / blocks;
  const std::span<const glm::dvec3> sums(estimate.sums.data(), blocks);
  glm::dvec3 mean(0), squares(0);
  for (const glm::dvec3& sum : sums) mean += sum / in_block / double(blocks);
  for (const glm::dvec3& sum : sums) {
    const glm::dvec3 off = sum / in_block - mean;
    squares += off * off;
  }
  return glm::sqrt(squares / double(blocks - 1));
}

Statistical::Statistical(const View& view, const Samples& samples)
    : view_(view),
      samples_(samples),
      most_points_(std::bit_floor(std::max(least_samples, samples.most))),
      half_widths_(half_widths(samples.confidence, most_points_)),
      corners_in_row_(view.crop.size.width + 3),
      corners_(std::size_t(corners_in_row_) * (view.crop.size.height + 3)) {
  std::mutex mutex;
  by_rows(view.crop.size.height + 3, {}, [&](std::uint32_t y) {
    std::vector<EyeSample> eye(corners_in_row_);
    for (std::uint32_t x = 0; x < corners_in_row_; ++x) eye[x] = view.sample(x, y, {-1.5, -1.5}, view.key(x, y), 0);
    const std::vector<PathRadiance> found = view.brought_by(eye);
    for (std::uint32_t x = 0; x < corners_in_row_; ++x) corners_[std::size_t(y) * corners_in_row_ + x] = found[x].color;
    const std::lock_guard lock(mutex);
    corner_reach_.samples += found.size();
    for (const PathRadiance& one : found) corner_reach_.rays += one.rays;
  });
}

/// Whether the corners of a pixel, and of so many pixels around it, agree.
bool Statistical::corners_agree(std::uint32_t x, std::uint32_t y, std::uint32_t around) const {
  const std::uint32_t first = 1 - around, count = 2 + 2 * around;
  const glm::dvec3* const upper_left = &corners_[std::size_t(y + first) * corners_in_row_ + x + first];
  glm::dvec3 least = *upper_left, most = least;
  for (std::uint32_t i = 0; i < count * count; ++i) {
    const glm::dvec3& corner = upper_left[std::size_t(i / count) * corners_in_row_ + i % count];
    least = glm::min(least, corner);
    most = glm::max(most, corner);
  }
  return within(most - least, samples_.width);
}

/// Whether so many points of a pixel suffice for the edges that its corners show.
bool Statistical::is_believed(std::uint32_t x, std::uint32_t y, std::uint32_t points) const {
  return points >= points_of_an_edge || corners_agree(x, y, points < points_near_an_edge ? 1 : 0);
}

// NaN, the product of a black material and an infinite light, is not within the width: such a pixel gets all its rays.
bool Statistical::is_settled(const Estimate& estimate) const {
  const double half_width = half_widths_[looks(estimate.points) - 1];
  return within(half_width * deviation(estimate), samples_.width);
}

/// Takes twice as many points of each open pixel as before, or the first ones.
void Statistical::take_points(std::uint32_t y, std::span<const std::uint32_t> open, std::vector<Estimate>& row) const {
  const std::uint32_t begin = row[open.front()].points, end = std::max(least_samples, 2 * begin);
  for (const std::uint32_t x : open) row[x].grow_to(end);
  std::vector<EyeSample> eye(open.size() * least_samples);
  // Each turn takes so many points of each pixel: neighbours meet the same elements, and few rays wait.
  for (std::uint32_t i = begin; i < end; i += least_samples) {
    const auto pixel = [&](std::size_t k) { return open[k / least_samples]; };
    const auto number = [&](std::size_t k) { return i + static_cast<std::uint32_t>(k % least_samples); };
    for (std::size_t k = 0; k < eye.size(); ++k) {
      const std::uint64_t key = view_.key(pixel(k), y);
      eye[k] = view_.sample(pixel(k), y, in_net(number(k), key), key, number(k));
    }
    const std::vector<PathRadiance> found = view_.brought_by(eye);
    for (std::size_t k = 0; k < eye.size(); ++k) row[pixel(k)].take(number(k), found[k]);
  }
}

PixelRow Statistical::row(std::uint32_t y) const {
  std::vector<Estimate> estimates(view_.crop.size.width);
  std::vector<std::uint32_t> open(estimates.size());
  std::iota(open.begin(), open.end(), 0);
  const auto settled = [&](std::uint32_t x) {
    return is_settled(estimates[x]) && is_believed(x, y, estimates[x].points);
  };
  for (std::uint32_t points = least_samples; points <= most_points_ && !open.empty(); points *= 2) {
    take_points(y, open, estimates);
    std::erase_if(open, settled);
  }
  PixelRow row{.pixels = {}, .in_doubt = open.size()};
  for (Estimate& estimate : estimates) {
    row.samples += estimate.points;
    divide(estimate.all, estimate.points);
    row.pixels.push_back(estimate.all);
  }
  return row;
}

}  // namespace durero::render
