#define HWY_TARGET_INCLUDE "accel/wide/wide_split.cpp"  // as seen from src/
#include "lanes/for_each_target.hpp"
//
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "accel/wide/wide_split.hpp"

// Vectors of 32 bytes are passed to functions that are always part of their caller.
#pragma GCC diagnostic ignored "-Wpsabi"

HWY_BEFORE_NAMESPACE();
namespace durero::accel::wide {
namespace HWY_NAMESPACE {
namespace {

/// Coordinates x, y and z in lanes; the last lane means nothing. (Vectors of Highway are as wide as the machine's, and
/// these have one width everywhere.)
using Lanes [[gnu::vector_size(16)]] = float;
using Wholes [[gnu::vector_size(16)]] = std::int32_t;
using Doubles [[gnu::vector_size(32)]] = double;
/// Two corners in lanes: the low one, and the high one with its signs turned, so that a box grows by the least of both.
using Corners [[gnu::vector_size(32)]] = float;
using Masks [[gnu::vector_size(32)]] = std::int32_t;

HWY_INLINE Corners corners_of(const Item& item) {
  static_assert(sizeof(Item) == sizeof(Corners));
  Corners corners;
  std::memcpy(&corners, &item, sizeof corners);
  return corners;
}
/// Writes the whole item that the corners are of; what is read as a vector soon must be written as one.
HWY_INLINE void put(Corners corners, Item& item) { std::memcpy(static_cast<void*>(&item), &corners, sizeof corners); }
HWY_INLINE Lanes first_of(Corners corners) { return __builtin_shufflevector(corners, corners, 0, 1, 2, 3); }
HWY_INLINE Lanes second_of(Corners corners) { return __builtin_shufflevector(corners, corners, 4, 5, 6, 7); }
/// The centre of the box, rounded. It serves to split items, and bounds nothing. It does not overflow.
HWY_INLINE Lanes middle_of(Corners corners) {
  const Corners halves = 0.5F * corners;
  return first_of(halves) - second_of(halves);
}

/// A box that grows; empty at first, as Box32 is.
struct GrowingBox {
  Corners corners = Corners{} + HUGE_VALF;

  HWY_INLINE void join(Corners other) { corners = corners < other ? corners : other; }
  /// Joins a point of the first lanes.
  HWY_INLINE void join(Lanes point) { join(both(point)); }
  static HWY_INLINE Corners both(Lanes point) { return __builtin_shufflevector(point, -point, 0, 1, 2, 3, 4, 5, 6, 7); }
  HWY_INLINE Box32 box() const {
    return {{corners[0], corners[1], corners[2]}, {-corners[4], -corners[5], -corners[6]}};
  }
  /// Box32::area. Precondition: the box is not empty.
  HWY_INLINE double area() const {
    const Doubles width =
        -__builtin_convertvector(second_of(corners), Doubles) - __builtin_convertvector(first_of(corners), Doubles);
    return width[0] * width[1] + width[1] * width[2] + width[2] * width[0];
  }
};

/// Equal bins along each axis, over the box of some centres (binned SAH).
class Bins {
 public:
  static constexpr std::size_t count = 16;

  HWY_INLINE explicit Bins(const Box32& middles) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low_[axis] = middles.low[axis];
      const float scale = count * (1 - 0x1p-18F) / (middles.high[axis] - middles.low[axis]);
      scale_[axis] = std::isfinite(scale) ? scale : 0;
    }
  }
  /// Whether the centres differ along an axis, by so much that the bins' scale is finite.
  HWY_INLINE bool differ(std::size_t axis) const { return scale_[axis] > 0; }
  /// The bin of a centre along each axis; the first where the centres do not differ.
  HWY_INLINE Wholes of(Lanes middle) const {
    const Lanes at = scale_ > 0.0F ? (middle - low_) * scale_ : Lanes{}, last = Lanes{} + static_cast<float>(count - 1);
    return __builtin_convertvector(at < last ? at : last, Wholes);
  }

 private:
  Lanes low_{}, scale_{};
};

/// The items of a bin: their number and their box.
struct Bin {
  GrowingBox box{};
  std::size_t count = 0;

  HWY_INLINE void join(Corners item) {
    box.join(item);
    ++count;
  }
  HWY_INLINE void join(const Bin& other) {
    box.join(other.box.corners);
    count += other.count;
  }
  /// The SAH cost. Precondition: the bin has an item.
  HWY_INLINE double cost() const { return box.area() * static_cast<double>(count); }
};
using Row = std::array<Bin, Bins::count>;

/// A split of items by the bins of an axis: the bins before `bin`, and the others.
struct Split {
  double cost = HUGE_VAL;  ///< the SAH cost: area times number, summed; ∞ for no split
  std::size_t axis = 0, bin = 0;
};

/// Keeps the cheapest split between two bins. A bin without items is skipped: the next bin gives the same split.
HWY_INLINE void keep_best(Split& best, const Row& row, std::size_t axis) {
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

/// Moves the items into the room, the first part from its beginning, the second from its end. Each item is written to
/// both ends and only one end advances, which spares a branch that would be mispredicted.
HWY_INLINE std::pair<ItemRange, ItemRange> parted(const ItemRange& part, const Bins& bins, const Row& row,
                                                  const Split& split) {
  Item *begin = part.room.data(), *end = begin + part.room.size();
  GrowingBox first_middles, second_middles;
  const Corners nothing = GrowingBox().corners;
  const auto bound = static_cast<std::int32_t>(split.bin);
  for (const Item& item : part.items) {
    const Corners corners = corners_of(item);
    const Lanes middle = middle_of(corners);
    const bool first = bins.of(middle)[split.axis] < bound;
    put(corners, *begin), put(corners, end[-1]);
    begin += first, end -= !first;
    const Masks mask = Masks{} - static_cast<std::int32_t>(first);
    const Corners both = GrowingBox::both(middle);
    first_middles.join(mask != 0 ? both : nothing);
    second_middles.join(mask != 0 ? nothing : both);
  }
  GrowingBox first, second;
  for (std::size_t bin = 0; bin < Bins::count; ++bin) (bin < split.bin ? first : second).join(row[bin].box.corners);
  const auto size = static_cast<std::size_t>(begin - part.room.data());
  return {{part.room.first(size), part.items.first(size), first.box(), first_middles.box()},
          {part.room.subspan(size), part.items.subspan(size), second.box(), second_middles.box()}};
}

ItemRange bounded(Items items, Items room) {
  GrowingBox all, middles;
  for (const Item& item : items) {
    const Corners corners = corners_of(item);
    all.join(corners);
    middles.join(middle_of(corners));
  }
  return {items, room, all.box(), middles.box()};
}

std::pair<ItemRange, ItemRange> in_the_middle(const ItemRange& part) {
  const std::size_t half = part.size() / 2;
  return {bounded(part.items.first(half), part.room.first(half)),
          bounded(part.items.subspan(half), part.room.subspan(half))};
}

std::pair<ItemRange, ItemRange> halves(const ItemRange& part, bool evenly) {
  if (evenly) return in_the_middle(part);
  const Bins bins(part.middles);
  std::array<Row, 3> rows;
  for (const Item& item : part.items) {
    const Corners corners = corners_of(item);
    const auto bin = bins.of(middle_of(corners));
    rows[0][static_cast<std::size_t>(bin[0])].join(corners);
    rows[1][static_cast<std::size_t>(bin[1])].join(corners);
    rows[2][static_cast<std::size_t>(bin[2])].join(corners);
  }
  Split best;
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (bins.differ(axis)) keep_best(best, rows[axis], axis);
  return best.bin == 0 ? in_the_middle(part) : parted(part, bins, rows[best.axis], best);
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace durero::accel::wide
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace durero::accel::wide {
namespace {

HWY_EXPORT(bounded);
HWY_EXPORT(halves);

/// Splits a part in two, neither empty, by the least SAH cost. The split halves the items where all centres are one, or
/// where `evenly` bounds the depth. Precondition: two items at least.
std::pair<ItemRange, ItemRange> split(const ItemRange& part, bool evenly) {
  return HWY_DYNAMIC_DISPATCH(halves)(part, evenly);
}

}  // namespace

ItemRange part_of(Items items, Items room) { return HWY_DYNAMIC_DISPATCH(bounded)(items, room); }

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
#endif
