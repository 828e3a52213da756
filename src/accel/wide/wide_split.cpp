#include "accel/wide/wide_split.hpp"

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace durero::accel::wide {
namespace {

/// x, y and z in lanes; the last lane means nothing. (Highway has no SSE2 target, so its vectors would have one lane
/// here.)
using Lanes [[gnu::vector_size(16)]] = float;
using Wholes [[gnu::vector_size(16)]] = std::int32_t;

Lanes least(Lanes a, Lanes b) { return a < b ? a : b; }
Lanes greatest(Lanes a, Lanes b) { return a > b ? a : b; }

/// @{ The corners of an item's box. Whole lanes are read, within the item itself.
static_assert(offsetof(Item, box) == 0 && offsetof(Box32, high) == sizeof(Corner) && sizeof(Item) >= 7 * sizeof(float));
Lanes lanes_at(const Item& item, std::size_t byte) {
  Lanes lanes;
  std::memcpy(&lanes, reinterpret_cast<const std::byte*>(&item) + byte, sizeof lanes);
  return lanes;
}
Lanes low_of(const Item& item) { return lanes_at(item, 0); }
Lanes high_of(const Item& item) { return lanes_at(item, sizeof(Corner)); }
/// @}
/// The centre of the item's box, rounded. It serves to split items, and bounds nothing. It does not overflow.
Lanes middle_of(const Item& item) { return 0.5F * low_of(item) + 0.5F * high_of(item); }

using Doubles [[gnu::vector_size(32)]] = double;

/// A box that grows; empty at first, as Box32 is.
struct GrowingBox {
  Lanes low = Lanes{} + HUGE_VALF, high = Lanes{} - HUGE_VALF;

  void join(Lanes other_low, Lanes other_high) {
    low = least(low, other_low);
    high = greatest(high, other_high);
  }
  Box32 box() const { return {{low[0], low[1], low[2]}, {high[0], high[1], high[2]}}; }
  /// Box32::area. Precondition: the box is not empty.
  double area() const {
    const Doubles width = __builtin_convertvector(high, Doubles) - __builtin_convertvector(low, Doubles);
    return width[0] * width[1] + width[1] * width[2] + width[2] * width[0];
  }
};

/// Equal bins along each axis, over the box of some centres (binned SAH).
class Bins {
 public:
  static constexpr std::size_t count = 16;

  explicit Bins(const Box32& middles) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low_[axis] = middles.low[axis];
      const float scale = count * (1 - 0x1p-18F) / (middles.high[axis] - middles.low[axis]);
      scale_[axis] = std::isfinite(scale) ? scale : 0;
    }
  }
  /// Whether the centres differ along an axis, by so much that the bins' scale is finite.
  bool differ(std::size_t axis) const { return scale_[axis] > 0; }
  /// The item's bin along each axis; the first where the centres do not differ.
  Wholes of(const Item& item) const {
    const Lanes at = scale_ > 0.0F ? (middle_of(item) - low_) * scale_ : Lanes{};
    return __builtin_convertvector(least(at, Lanes{} + static_cast<float>(count - 1)), Wholes);
  }

 private:
  Lanes low_{}, scale_{};
};

/// The items of a bin: their number and their box.
struct Bin {
  GrowingBox box{};
  std::size_t count = 0;

  void join(Lanes low, Lanes high) {
    box.join(low, high);
    ++count;
  }
  void join(const Bin& other) {
    box.join(other.box.low, other.box.high);
    count += other.count;
  }
  /// The SAH cost. Precondition: the bin has an item.
  double cost() const { return box.area() * static_cast<double>(count); }
};
using Row = std::array<Bin, Bins::count>;

/// A split of items by the bins of an axis: the bins before `bin`, and the others.
struct Split {
  double cost = HUGE_VAL;  ///< the SAH cost: area times number, summed; ∞ for no split
  std::size_t axis = 0, bin = 0;
};

/// Keeps the cheapest split between two bins. A bin without items is skipped: the next bin gives the same split.
void keep_best(Split& best, const Row& row, std::size_t axis) {
  std::array<double, Bins::count> before;  // each bin with items: the cost of those in front
  Bin first = row[0];
  for (std::size_t bin = 1; bin < Bins::count; ++bin) {
    if (row[bin].count == 0) continue;
    before[bin] = first.cost();
    first.join(row[bin]);
  }
  Bin second;
  for (std::size_t bin = Bins::count - 1; bin > 0; --bin) {
    if (row[bin].count == 0) continue;
    second.join(row[bin]);
    const double cost = before[bin] + second.cost();
    if (cost < best.cost) best = {cost, axis, bin};
  }
}

std::pair<ItemRange, ItemRange> in_the_middle(const ItemRange& part) {
  const std::size_t half = part.size() / 2;
  return {part_of(part.items.first(half), part.room.first(half)),
          part_of(part.items.subspan(half), part.room.subspan(half))};
}

/// Selects lanes by a mask.
Lanes either(Wholes mask, Lanes yes, Lanes no) { return mask != 0 ? yes : no; }

/// Moves the items into the room, the first part from its beginning, the second from its end. Each item is written to
/// both ends and only one end advances, which spares a branch that would be mispredicted.
std::pair<ItemRange, ItemRange> parted(const ItemRange& part, const Bins& bins, const Row& row, const Split& split) {
  Item *begin = part.room.data(), *end = begin + part.room.size();
  GrowingBox first_middles, second_middles;
  const GrowingBox nothing;
  for (const Item& item : part.items) {
    const bool first = bins.of(item)[split.axis] < static_cast<std::int32_t>(split.bin);
    *begin = item, end[-1] = item;
    begin += first, end -= !first;
    const Wholes mask = Wholes{} - static_cast<std::int32_t>(first);
    const Lanes middle = middle_of(item);
    first_middles.join(either(mask, middle, nothing.low), either(mask, middle, nothing.high));
    second_middles.join(either(mask, nothing.low, middle), either(mask, nothing.high, middle));
  }
  GrowingBox first, second;
  for (std::size_t bin = 0; bin < Bins::count; ++bin)
    (bin < split.bin ? first : second).join(row[bin].box.low, row[bin].box.high);
  const auto size = static_cast<std::size_t>(begin - part.room.data());
  return {{part.room.first(size), part.items.first(size), first.box(), first_middles.box()},
          {part.room.subspan(size), part.items.subspan(size), second.box(), second_middles.box()}};
}

/// Splits a part in two, neither empty, by the least SAH cost. The split halves the items where all centres are one, or
/// where `evenly` bounds the depth. Precondition: two items at least.
std::pair<ItemRange, ItemRange> split(const ItemRange& part, bool evenly) {
  if (evenly) return in_the_middle(part);
  const Bins bins(part.middles);
  std::array<Row, 3> rows;
  for (const Item& item : part.items) {
    const auto bin = bins.of(item);
    const Lanes low = low_of(item), high = high_of(item);
    rows[0][static_cast<std::size_t>(bin[0])].join(low, high);
    rows[1][static_cast<std::size_t>(bin[1])].join(low, high);
    rows[2][static_cast<std::size_t>(bin[2])].join(low, high);
  }
  Split best;
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (bins.differ(axis)) keep_best(best, rows[axis], axis);
  return best.bin == 0 ? in_the_middle(part) : parted(part, bins, rows[best.axis], best);
}

}  // namespace

ItemRange part_of(Items items, Items room) {
  GrowingBox all, middles;
  for (const Item& item : items) {
    const Lanes middle = middle_of(item);
    all.join(low_of(item), high_of(item));
    middles.join(middle, middle);
  }
  return {items, room, all.box(), middles.box()};
}

Parts parts_of(const ItemRange& whole, bool evenly) {
  constexpr std::size_t enough = WideNode::width * WideNode::width;  // items for a node below
  Parts parts;
  parts.push_back(whole);
  const auto rank = [&](const ItemRange& part) {
    if (part.size() <= enough) return 0.0;
    return evenly ? static_cast<double>(part.size()) : part.area + 0x1p-1000;
  };
  while (parts.size() < WideNode::width) {
    const auto largest = std::ranges::max_element(parts, {}, rank);
    if (!(rank(*largest) > 0)) break;
    const auto [first, second] = split(*largest, evenly);
    *largest = first;
    parts.push_back(second);
  }
  return parts;
}

SplitTree::SplitTree(const ItemRange& whole, std::size_t levels_by_area) {
  branches_.reserve(whole.size() / 2);
  branches_.push_back({whole});
  open(0, levels_by_area);
}

void SplitTree::open(Number number, std::size_t levels_by_area) {
  const ItemRange part = branches_[number].part;
  if (part.is_item() || part.is_block()) return;
  const auto first = static_cast<Number>(branches_.size());
  if (part.size() <= WideNode::width) {
    for (std::size_t i = 0; i < part.size(); ++i) branches_.push_back({part_of(part.items.subspan(i, 1), {})});
    branches_[number] = {part, part.size(), first, static_cast<Number>(part.size())};
    return;
  }
  const auto [one, other] = split(part, levels_by_area == 0);
  branches_.push_back({one});
  branches_.push_back({other});
  const std::size_t below = levels_by_area == 0 ? 0 : levels_by_area - 1;
  open(first, below);
  open(first + 1, below);
  branches_[number] = {part, branches_[first].leaves + branches_[first + 1].leaves, first, 2};
}

boost::container::static_vector<SplitTree::Number, WideNode::width> SplitTree::children(Number number) const {
  constexpr std::size_t width = WideNode::width;
  boost::container::static_vector<Number, width> children;
  const auto open = [&](const Branch& branch) {
    for (Number i = 0; i < branch.count; ++i) children.push_back(branch.first + i);
  };
  if (branches_[number].count == 0) {
    children.push_back(number);
    return children;
  }
  open(branches_[number]);
  const auto rank = [&](Number child) {
    const Branch& branch = branches_[child];
    if (branch.count == 0) return 0.0;
    if (branch.leaves > width) return children.size() < width ? 0x1p600 + branch.part.area * 0x1p600 : 0.0;
    return children.size() + branch.leaves <= width + 1 ? branch.part.area + 0x1p-1000 : 0.0;
  };
  for (;;) {
    const auto largest = std::ranges::max_element(children, {}, rank);
    if (!(rank(*largest) > 0)) return children;
    const Branch& opened = branches_[*largest];
    children.erase(largest);
    open(opened);
  }
}

}  // namespace durero::accel::wide
