#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>

#include "durero/accel/wide_bvh.hpp"

namespace durero::accel {
namespace {

/// Bytes of nodes; with less an order costs more than it gains. Segments in order stay together in bundles.
constexpr std::size_t least_of_segments = 1 << 20, least_of_rays = 1 << 23;
constexpr std::size_t least_rays = 1 << 10;
constexpr unsigned bits_at_a_time = 12;

/// Most of some rays leave where the ray before them does, as from an eye: they come in an order already.
bool from_one_point(std::span<const scene::Query> queries) {
  constexpr std::size_t asked = 32;
  std::size_t same = 0;
  for (std::size_t i = 1; i <= asked; ++i) {
    const std::size_t at = i * (queries.size() - 1) / asked;
    same += queries[at].rayo.p() == queries[at - 1].rayo.p();
  }
  return 2 * same > asked;
}

/// Cells that lie close together have numbers that mostly do (Morton), each octant of directions its own.
class RayKeys {
 public:
  /// Cells as wide as the elements lie apart, or half that.
  RayKeys(const WideNode& root, double spacing) {
    std::array<double, 3> width{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low_[axis] = static_cast<double>(*std::ranges::min_element(root.planes[axis]));
      width[axis] = static_cast<double>(*std::ranges::max_element(root.planes[axis + 3])) - low_[axis];
    }
    const double widest = *std::ranges::max_element(width);
    while (bits_ < most_bits && std::ldexp(spacing, static_cast<int>(bits_)) < widest) ++bits_;
    const double cells = std::ldexp(1, static_cast<int>(bits_));
    last_ = cells - 1;
    if (widest > 0) scale_ = cells / widest;
  }
  /// No key has more bits.
  unsigned bits() const { return 3 * bits_ + 3; }
  std::uint32_t operator()(const model::Rayo& rayo) const {
    std::uint32_t key = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto i = static_cast<int>(axis);
      key |= apart(cell(rayo.p().xyz()[i] - low_[axis])) << axis;
      key |= static_cast<std::uint32_t>(rayo.v().xyz()[i] < 0) << (3 * bits_ + axis);
    }
    return key;
  }

 private:
  static constexpr unsigned most_bits = 9;  // of a cell's place along an axis

  /// In which cell an origin lies; whatever lies in none counts to the first or the last.
  std::uint32_t cell(double from_low) const {
    const double at = from_low * scale_;
    return at > 0 ? static_cast<std::uint32_t>(std::min(at, last_)) : 0;
  }
  /// The nine bits of a number, two of 0 between each.
  static std::uint32_t apart(std::uint32_t x) {
    x = (x | x << 16) & 0x030000ff;
    x = (x | x << 8) & 0x0300f00f;
    x = (x | x << 4) & 0x030c30c3;
    return (x | x << 2) & 0x09249249;
  }

  std::array<double, 3> low_{};
  double scale_ = 0, last_ = 0;  // cells by length; the last cell
  unsigned bits_ = 0;
};

struct Keyed {
  std::uint32_t key, number;
};

/// By counting some bits of the keys: those of equal bits stay in the order in which they come.
void sort_by_bits(std::span<const Keyed> from, std::span<Keyed> to, unsigned shift) {
  constexpr std::uint32_t mask = (1 << bits_at_a_time) - 1;
  std::vector<std::uint32_t> next(mask + 2);
  for (const Keyed& each : from) ++next[(each.key >> shift & mask) + 1];
  std::partial_sum(next.begin(), next.end(), next.begin());
  for (const Keyed& each : from) to[next[each.key >> shift & mask]++] = each;
}

}  // namespace

std::vector<std::uint32_t> WideBvh::order(std::span<const scene::Query> queries, trace::Asked asked) const {
  const std::size_t least_bytes = asked == trace::Asked::first ? least_of_rays : least_of_segments;
  if (nodes().size_bytes() < least_bytes || queries.size() < least_rays || from_one_point(queries)) return {};
  const RayKeys key_of(nodes().front(), spacing());
  std::vector<Keyed> keyed(queries.size()), sorted(queries.size());
  for (std::uint32_t i = 0; i < queries.size(); ++i) keyed[i] = {key_of(queries[i].rayo), i};
  for (unsigned shift = 0; shift < key_of.bits(); shift += bits_at_a_time) {
    sort_by_bits(keyed, sorted, shift);
    keyed.swap(sorted);
  }
  std::vector<std::uint32_t> order(queries.size());
  std::ranges::transform(keyed, order.begin(), &Keyed::number);
  return order;
}

}  // namespace durero::accel
