#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "durero/accel/wide_bvh.hpp"

namespace durero::accel {
namespace {

constexpr std::size_t least_bytes = 1 << 20;  // of nodes; less is near whatever the order
constexpr std::size_t least_rays = 1 << 10;
constexpr unsigned cells_of_origins = 16;  // along each axis
constexpr std::size_t keys_of_rays = 8 * cells_of_origins * cells_of_origins * cells_of_origins;

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

/// Where a number lies between two others, in equal cells; whatever is not between them lies in the first or the last.
unsigned cell_of_origin(double x, double low, double scale) {
  const double at = (x - low) * scale;
  return at > 0 ? static_cast<unsigned>(std::min(at, cells_of_origins - 1.0)) : 0;
}

/// Cells that lie close together have numbers that mostly do (Morton); then the octant of the direction.
class RayKeys {
 public:
  explicit RayKeys(const WideNode& root) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low_[axis] = static_cast<double>(*std::ranges::min_element(root.planes[axis]));
      const double high = static_cast<double>(*std::ranges::max_element(root.planes[axis + 3]));
      scale_[axis] = high > low_[axis] ? cells_of_origins / (high - low_[axis]) : 0;
    }
  }
  std::uint32_t operator()(const model::Rayo& rayo) const {
    std::uint32_t key = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto i = static_cast<int>(axis);
      const unsigned at = cell_of_origin(rayo.p().xyz()[i], low_[axis], scale_[axis]);
      for (unsigned bit = 0; bit < 4; ++bit) key |= (at >> bit & 1) << (3 * bit + axis + 3);
      key |= static_cast<std::uint32_t>(rayo.v().xyz()[i] < 0) << axis;
    }
    return key;
  }

 private:
  std::array<double, 3> low_{}, scale_{};
};

}  // namespace

/// By counting: rays of one key stay in the order in which they come.
std::vector<std::uint32_t> WideBvh::order(std::span<const scene::Query> queries) const {
  if (nodes().size_bytes() < least_bytes || queries.size() < least_rays || from_one_point(queries)) return {};
  const RayKeys key_of(nodes().front());
  std::vector<std::uint32_t> key(queries.size()), next(keys_of_rays + 1), order(queries.size());
  for (std::size_t i = 0; i < queries.size(); ++i) ++next[(key[i] = key_of(queries[i].rayo)) + 1];
  for (std::size_t k = 1; k <= keys_of_rays; ++k) next[k] += next[k - 1];
  for (std::size_t i = 0; i < queries.size(); ++i) order[next[key[i]]++] = static_cast<std::uint32_t>(i);
  return order;
}

}  // namespace durero::accel
