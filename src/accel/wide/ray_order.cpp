#include "durero/accel/wide/ray_order.hpp"

#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/partitioner.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/common.hpp>
#include <memory>
#include <span>
#include <utility>

#include "durero/accel/wide/wide_bvh.hpp"

namespace durero::accel {
namespace {

/// The least bytes of nodes for which a sort gains more than it costs. Sorted segments gain sooner, by longer bundles.
constexpr std::size_t least_of_segments = 1 << 20, least_of_rays = 1 << 23;
constexpr std::size_t least_rays = 1 << 10;
constexpr std::size_t few = 1 << 13;  // keys that are sorted by 8 bits a pass

/// The distance, in spacings of the elements, within which consecutive origins count as coherent for segments. The rest
/// is sorted within each block (WideTraversal).
constexpr double near_for_segments = 8;

/// Whether most of a sample of rays start within `near` of the ray before them along each axis, as camera rays and
/// their secondary rays do. Preconditions: at least two queries.
bool each_near_the_last(std::span<const scene::Query> queries, double near) {
  constexpr std::size_t asked = 32;
  std::size_t count = 0;
  for (std::size_t i = 1; i <= asked; ++i) {
    const std::size_t at = i * (queries.size() - 1) / asked;
    const glm::dvec3 apart = glm::abs(queries[at].rayo.p().xyz() - queries[at - 1].rayo.p().xyz());
    count += std::max({apart.x, apart.y, apart.z}) <= near;
  }
  return 2 * count > asked;
}

struct Keyed {
  std::uint32_t key, number;
};
/// Keys that are not written at first, so that the thread that writes them is the first to touch their pages.
class Keys {
 public:
  explicit Keys(std::size_t size) : keys_(std::make_unique_for_overwrite<Keyed[]>(size)), size_(size) {}
  std::span<Keyed> all() const { return {keys_.get(), size_}; }

 private:
  std::unique_ptr<Keyed[]> keys_;
  std::size_t size_;
};

/// The parts in which so many keys are sorted; they depend on this number alone. Few keys are one part.
std::size_t key_parts(std::size_t size) { return size < (1 << 17) ? 1 : size >> 16; }

/// Calls use(part, begin, end) for each part of so many keys, on as many threads as the calling thread may use.
template <class Use>
void for_each_key_part(std::size_t size, Use use) {
  const std::size_t parts = key_parts(size);
  const auto use_part = [&](std::size_t part) { use(part, part * size / parts, (part + 1) * size / parts); };
  if (parts == 1) return use_part(0);
  oneapi::tbb::parallel_for(std::size_t{0}, parts, use_part, oneapi::tbb::simple_partitioner());
}

/// Sorts by some bits of the keys, stably (counting sort). Each part of the keys has counts of its own: `next` has, for
/// each part, the place of its next entry with each value of the bits.
void sort_by_bits(std::span<const Keyed> from, std::span<Keyed> to, unsigned shift, unsigned bits,
                  std::vector<std::uint32_t>& next) {
  const std::size_t values = std::size_t{1} << bits, parts = key_parts(from.size());
  const auto value_of = [&](const Keyed& each) { return each.key >> shift & (values - 1); };
  next.assign(values * parts, 0);
  for_each_key_part(from.size(), [&](std::size_t part, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) ++next[part * values + value_of(from[i])];
  });
  std::uint32_t before = 0;
  for (std::size_t value = 0; value < values; ++value)
    for (std::size_t part = 0; part < parts; ++part) before += std::exchange(next[part * values + value], before);
  for_each_key_part(from.size(), [&](std::size_t part, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) to[next[part * values + value_of(from[i])]++] = from[i];
  });
}

/// Sorts by all bits, in passes (radix sort). Many keys pay for wider passes.
void sort(Keys& keyed, unsigned bits) {
  const unsigned at_a_time = keyed.all().size() < few ? 8 : 12;
  Keys sorted(keyed.all().size());
  std::vector<std::uint32_t> next;
  for (unsigned shift = 0; shift < bits; shift += at_a_time) {
    sort_by_bits(keyed.all(), sorted.all(), shift, at_a_time, next);
    std::swap(keyed, sorted);
  }
}

}  // namespace

RayOrderKey::RayOrderKey(const WideNode& root, double spacing) {
  glm::dvec3 width{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<int>(axis);
    low_[i] = static_cast<double>(*std::ranges::min_element(root.planes[axis]));
    width[i] = static_cast<double>(*std::ranges::max_element(root.planes[axis + 3])) - low_[i];
  }
  const double widest = std::max({width.x, width.y, width.z});
  while (bits_ < most_bits && std::ldexp(spacing, static_cast<int>(bits_)) < widest) ++bits_;
  const double cells = std::ldexp(1, static_cast<int>(bits_));
  last_ = cells - 1;
  if (widest > 0) scale_ = cells / widest;
}

namespace {

/// Sorts by key(ray), stably.
template <class Key>
void sort_by_key(Key key, unsigned bits, std::span<const trace::Ray> rays, std::vector<std::uint32_t>& numbers) {
  Keys keyed(numbers.size());
  std::ranges::transform(numbers, keyed.all().begin(), [&](std::uint32_t number) {
    return Keyed{key(rays[number]), number};
  });
  sort(keyed, bits);
  std::ranges::transform(keyed.all(), numbers.begin(), &Keyed::number);
}

/// Whether the ends of a sample of segments spread at most an eighth as far as their origins.
bool end_together(std::span<const trace::Ray> rays, std::span<const std::uint32_t> numbers) {
  constexpr std::size_t asked = 64;
  glm::dvec3 p_low(HUGE_VAL), p_high(-HUGE_VAL), end_low(HUGE_VAL), end_high(-HUGE_VAL);
  for (std::size_t i = 0; i < numbers.size(); i += numbers.size() / asked + 1) {
    const trace::Ray& ray = rays[numbers[i]];
    const glm::dvec3 end = ray.p + ray.v;
    p_low = glm::min(p_low, ray.p), p_high = glm::max(p_high, ray.p);
    end_low = glm::min(end_low, end), end_high = glm::max(end_high, end);
  }
  const glm::dvec3 of_p = p_high - p_low, of_end = end_high - end_low;
  return 8 * (of_end.x + of_end.y + of_end.z) <= of_p.x + of_p.y + of_p.z;
}

}  // namespace

void sort_segments(const RayOrderKey& key_of, std::span<const trace::Ray> rays, std::vector<std::uint32_t>& numbers) {
  if (end_together(rays, numbers)) {
    sort_by_key([](const trace::Ray& ray) { return DirectionKey()(ray.v); }, DirectionKey::bits(), rays, numbers);
  } else {
    sort_by_key([&](const trace::Ray& ray) { return key_of(ray.p, ray.v); }, key_of.bits(), rays, numbers);
  }
}

std::vector<std::uint32_t> WideBvh::order(std::span<const scene::Query> queries, trace::QueryKind asked) const {
  const bool first = asked == trace::QueryKind::first;
  if (nodes().size_bytes() < (first ? least_of_rays : least_of_segments) || queries.size() < least_rays) return {};
  if (each_near_the_last(queries, first ? 0 : near_for_segments * spacing())) return {};
  const RayOrderKey key_of(nodes().front(), spacing());
  Keys keyed(queries.size());
  for_each_key_part(queries.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      keyed.all()[i] = {key_of(queries[i].rayo.p().xyz(), queries[i].rayo.v().xyz()), static_cast<std::uint32_t>(i)};
  });
  sort(keyed, key_of.bits());
  std::vector<std::uint32_t> order(queries.size());
  std::ranges::transform(keyed.all(), order.begin(), &Keyed::number);
  return order;
}

}  // namespace durero::accel
