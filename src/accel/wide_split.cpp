#include "accel/wide_split.hpp"

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace durero::accel::wide {
namespace {

/// x, y and z side by side; what stands in the last lane means nothing. (Highway's lanes are of one number here, as it
/// has no SSE2.)
using Lanes [[gnu::vector_size(16)]] = float;
using Wholes [[gnu::vector_size(16)]] = std::int32_t;

Lanes least(Lanes a, Lanes b) { return a < b ? a : b; }
Lanes greatest(Lanes a, Lanes b) { return a > b ? a : b; }

/// @{ The corners of an item's box: whole lanes are read, of the item itself.
static_assert(offsetof(Item, box) == 0 && offsetof(Box32, high) == sizeof(Corner) && sizeof(Item) >= 7 * sizeof(float));
Lanes lanes_at(const Item& item, std::size_t byte) {
  Lanes lanes;
  std::memcpy(&lanes, reinterpret_cast<const std::byte*>(&item) + byte, sizeof lanes);
  return lanes;
}
Lanes low_of(const Item& item) { return lanes_at(item, 0); }
Lanes high_of(const Item& item) { return lanes_at(item, sizeof(Corner)); }
/// @}
/// The middle of its box, about: it tells items apart, and bounds nothing. It does not overflow.
Lanes middle_of(const Item& item) { return 0.5F * low_of(item) + 0.5F * high_of(item); }

/// A box that grows; of nothing at first, as Box32.
struct LaneBox {
  Lanes low = Lanes{} + HUGE_VALF, high = Lanes{} - HUGE_VALF;

  void join(Lanes other_low, Lanes other_high) {
    low = least(low, other_low);
    high = greatest(high, other_high);
  }
  Box32 box() const { return {{low[0], low[1], low[2]}, {high[0], high[1], high[2]}}; }
};

/// Where the middles of some items lie along each axis, in equal bins.
class Bins {
 public:
  static constexpr std::size_t count = 16;

  explicit Bins(std::span<const Item> items) {
    LaneBox middles;
    for (const Item& item : items) {
      const Lanes middle = middle_of(item);
      middles.join(middle, middle);
    }
    const Box32 box = middles.box();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low_[axis] = box.low[axis];
      const float scale = count * (1 - 0x1p-18F) / (box.high[axis] - box.low[axis]);
      scale_[axis] = std::isfinite(scale) ? scale : 0;
    }
  }
  /// Whether the middles differ along an axis, by more than next to nothing and less than overflows.
  bool differ(std::size_t axis) const { return scale_[axis] > 0; }
  /// In which bin of each axis the item is; in the first where they do not differ.
  Wholes of(const Item& item) const {
    const Lanes at = scale_ > 0.0F ? (middle_of(item) - low_) * scale_ : Lanes{};
    return __builtin_convertvector(least(at, Lanes{} + static_cast<float>(count - 1)), Wholes);
  }

 private:
  Lanes low_{}, scale_{};
};

/// A bin of an axis: how many items, and their box.
struct Bin {
  LaneBox box{};
  std::size_t count = 0;

  void join(const Item& item) {
    box.join(low_of(item), high_of(item));
    ++count;
  }
  void join(const Bin& other) {
    box.join(other.box.low, other.box.high);
    count += other.count;
  }
  double cost() const { return count == 0 ? HUGE_VAL : box.box().area() * static_cast<double>(count); }
};
using Row = std::array<Bin, Bins::count>;

/// A way to part items by the bins of an axis: the first `bin` of them from the rest.
struct Split {
  double cost = HUGE_VAL;  ///< the sum of area times number; ∞ where there is no way
  std::size_t axis = 0, bin = 0;
  Bin first{}, second{};
};

void keep_best(Split& best, const Row& row, std::size_t axis) {
  Row first;  // of the bins before each
  for (std::size_t bin = 1; bin < Bins::count; ++bin) {
    first[bin] = first[bin - 1];
    first[bin].join(row[bin - 1]);
  }
  Bin second;
  for (std::size_t bin = Bins::count - 1; bin > 0; --bin) {
    second.join(row[bin]);
    const double cost = first[bin].cost() + second.cost();
    if (cost < best.cost) best = {cost, axis, bin, first[bin], second};
  }
}

std::pair<Part, Part> in_the_middle(Items items) {
  const Items first = items.first(items.size() / 2), second = items.subspan(items.size() / 2);
  return {{first, box_of(first)}, {second, box_of(second)}};
}

/// The items in two, neither empty: where the surface areas promise least work; in the middle where the middles of all
/// boxes are one, or where nothing but the depth matters any more. Precondition: two items or more.
std::pair<Part, Part> split(Items items, bool evenly) {
  if (evenly) return in_the_middle(items);
  const Bins bins(items);
  std::array<Row, 3> rows;
  for (const Item& item : items) {
    const auto bin = bins.of(item);
    for (std::size_t axis = 0; axis < 3; ++axis) rows[axis][static_cast<std::size_t>(bin[axis])].join(item);
  }
  Split best;
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (bins.differ(axis)) keep_best(best, rows[axis], axis);
  if (best.bin == 0) return in_the_middle(items);
  const auto limit = static_cast<std::int32_t>(best.bin);
  std::ranges::partition(items, [&](const Item& item) { return bins.of(item)[best.axis] < limit; });
  return {{items.first(best.first.count), best.first.box.box()},
          {items.subspan(best.first.count), best.second.box.box()}};
}

/// The greatest of some parts by rank(part), of which 0 takes none; null where all take none.
template <class Rank>
Part* greatest(std::vector<Part>& parts, Rank rank) {
  const auto found = std::ranges::max_element(parts, {}, rank);
  return rank(*found) > 0 ? &*found : nullptr;
}

}  // namespace

Box32 box_of(std::span<const Item> items) {
  Box32 box;
  for (const Item& item : items) box.join(item.box);
  return box;
}

std::vector<Part> parts_of(const Part& whole, bool evenly) {
  constexpr std::size_t width = WideNode::width;
  std::vector<Part> parts;
  parts.reserve(width);
  parts.push_back(whole);
  const auto too_large = [&](const Part& part) {
    if (part.items.size() <= width) return 0.0;
    return evenly ? static_cast<double>(part.items.size()) : part.area + 0x1p-1000;
  };
  while (parts.size() < width) {
    Part* const largest = greatest(parts, too_large);
    if (largest == nullptr) break;
    auto [first, second] = split(largest->items, evenly);
    *largest = first;
    parts.push_back(second);
  }
  const auto fits = [&](const Part& part) {
    const std::size_t n = part.items.size();
    return n > 1 && parts.size() + n - 1 <= width ? part.area + 0x1p-1000 : 0.0;
  };
  while (Part* const fitting = greatest(parts, fits)) {
    const Items items = fitting->items;
    *fitting = {items.first(1), items[0].box};
    for (std::size_t i = 1; i < items.size(); ++i) parts.push_back({items.subspan(i, 1), items[i].box});
  }
  return parts;
}

}  // namespace durero::accel::wide
