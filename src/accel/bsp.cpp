#include "durero/accel/bsp.hpp"

#include <algorithm>
#include <bit>
#include <deque>
#include <limits>
#include <stdexcept>

#include "durero/accel/octree.hpp"
#include "durero/accel/touch.hpp"

namespace durero::accel {
namespace {

using Numbers = std::vector<std::uint32_t>;

/// A plane across an axis that halves a cell.
struct Halving {
  int axis;
  double plane;
};

/// Half the surface of a box.
double area(const surface::Box& box) {
  const glm::dvec3 side = box.high - box.low;
  return side.x * side.y + side.y * side.z + side.z * side.x;
}

/// The two halves of a cell.
std::pair<surface::Box, surface::Box> halves(const surface::Box& box, const Halving& by) {
  std::pair<surface::Box, surface::Box> result{box, box};
  result.first.high[by.axis] = result.second.low[by.axis] = by.plane;
  return result;
}

/// The least and the greatest coordinates of the elements' boxes along an axis, sorted.
struct SortedExtents {
  SortedExtents(const Contents& contents, const Numbers& elements, int axis) {
    for (const std::uint32_t number : elements) {
      const surface::Box box = contents.box_of(number);
      lows.push_back(box.low[axis]);
      highs.push_back(box.high[axis]);
    }
    std::ranges::sort(lows);
    std::ranges::sort(highs);
  }
  std::vector<double> lows, highs;
};

/// The halving by a plane, if the plane can be crossed exactly (AxisRay::crossing) and lies inside the cell.
std::optional<Halving> checked(const surface::Box& box, int axis, double plane) {
  if (std::abs(plane) < 0x1p-150) plane = 0;
  if (!(box.low[axis] < plane && plane < box.high[axis])) return {};
  return Halving{axis, plane};
}

// The median of the 2m ends of m boxes leaves about as many elements on either side. Let it be the end at the place m,
// counted from 0, with all ends different. Let L elements end below it and R begin above it. The m lesser ends are the
// ends of the L and the beginnings of all but the R, without the beginning in the plane, if the plane is one. So L − R
// is 1 or 0.
std::optional<Halving> at_median(const Contents& contents, const Numbers& elements, const surface::Box& box) {
  const glm::dvec3 side = box.high - box.low;
  std::array<int, 3> axes{0, 1, 2};
  std::ranges::stable_sort(axes, [&](int a, int b) { return side[a] > side[b]; });
  for (const int axis : axes) {
    SortedExtents ends(contents, elements, axis);
    std::vector<double> all = ends.lows;
    all.insert(all.end(), ends.highs.begin(), ends.highs.end());
    const auto middle = all.begin() + static_cast<std::ptrdiff_t>(elements.size());
    std::ranges::nth_element(all, middle);
    const std::optional<Halving> by = checked(box, axis, *middle);
    // A plane that all elements touch would separate none.
    if (by && (ends.highs.front() < by->plane || by->plane < ends.lows.back())) return by;
  }
  return {};
}

// The cost of testing a plane, in tests of an element. The curve is flat: of a thousand elements a ray meets 7.2 with a
// fourth and 8.0 with 1, and tests 22.8 planes or 21.4.
constexpr double cost_of_plane = 0.25;

// The surface area heuristic: a ray through the cell crosses a half as often as the half's area is of the cell's. A
// cell is a leaf where no plane costs less than its elements.
std::optional<Halving> at_least_cost(const Contents& contents, const Numbers& elements, const surface::Box& box) {
  std::optional<Halving> best;
  const auto all = static_cast<double>(elements.size());
  double least = (all - cost_of_plane) * area(box);
  for (int axis = 0; axis < 3; ++axis) {
    const SortedExtents ends(contents, elements, axis);
    const auto consider = [&](double plane) {
      const std::optional<Halving> by = checked(box, axis, plane);
      if (!by) return;
      const auto [low, high] = halves(box, *by);
      const auto count = [](const std::vector<double>& list, auto end) {
        return static_cast<double>(end - list.begin());
      };
      const double below = count(ends.lows, std::ranges::upper_bound(ends.lows, by->plane));
      const double above = all - count(ends.highs, std::ranges::lower_bound(ends.highs, by->plane));
      const double cost = area(low) * below + area(high) * above;
      if (cost < least) best = by, least = cost;
    };
    // Between two ends the cost is linear, so an end is best, or rather its neighbour on the element's free side.
    constexpr double infinity = std::numeric_limits<double>::infinity();
    for (const double low : ends.lows) consider(std::nextafter(low, -infinity));
    for (const double high : ends.highs) consider(std::nextafter(high, infinity));
  }
  return best;
}

std::optional<Halving> placed(Placing placing, const Contents& contents, const Numbers& elements,
                              const surface::Box& box, int depth) {
  switch (placing) {
    case Placing::middle: {
      const int axis = depth % 3;
      return Halving{axis, box.low[axis] + (box.high[axis] - box.low[axis]) / 2};
    }
    case Placing::median:
      return at_median(contents, elements, box);
    case Placing::surface_area:
      return at_least_cost(contents, elements, box);
  }
  return {};
}

/// The number of levels that halve the elements down to a few, and some more for elements that planes cut.
int levels_for(Placing placing, std::size_t elements) {
  const int halvings = static_cast<int>(std::bit_width(elements));
  return placing == Placing::middle ? 3 * ((halvings + 2) / 3 + 3) : 8 + halvings + halvings / 3;
}

/// The root's cell. It extends beyond all elements above, since a point in a plane is above the plane.
surface::Box root_for(Placing placing, const surface::Box& box) {
  if (placing == Placing::middle) return cube_over(box).box({0, 0, 0});
  surface::Box root = box;
  for (int axis = 0; axis < 3; ++axis) {
    if (std::abs(root.low[axis]) < 0x1p-140) root.low[axis] = -0x1p-140;
    root.high[axis] = std::nextafter(root.high[axis], std::numeric_limits<double>::infinity());
    if (std::abs(root.high[axis]) < 0x1p-140) root.high[axis] = 0x1p-140;
  }
  return root;
}

}  // namespace

/// Divides cells in the order of their depth, so that all are about equally deep where memory ends.
class BspBuilder {
 public:
  BspBuilder(Bsp& bsp, const BspOptions& options) : bsp_(bsp), options_(options) {
    const std::size_t n = bsp.contents_.elements.size();
    if (options_.max_depth > Bsp::deepest) throw std::invalid_argument("a tree deeper than its names have digits");
    if (options_.max_depth < 0) options_.max_depth = levels_for(options_.placing, n);
    if (options_.max_bytes == 0) options_.max_bytes = (std::size_t{1} << 16) + 256 * n;
  }

  void build() {
    Numbers all(bsp_.contents_.elements.size());
    for (std::uint32_t i = 0; i < all.size(); ++i) all[i] = i;
    references_ = all.size();
    bsp_.nodes_.push_back({});
    waiting_.push_back({0, bsp_.root_, 0, std::move(all)});
    while (!waiting_.empty()) {
      const Waiting next = std::move(waiting_.front());
      waiting_.pop_front();
      place(next);
    }
    bsp_.lists_ = Lists::elements_of_cells(listed_, leaves_);
    bsp_.nodes_.shrink_to_fit();
  }

 private:
  struct Waiting {
    std::size_t node;
    surface::Box box;
    int depth;
    Numbers elements;
  };

  /// Whether a cell may be a leaf. With planes in the middle, cells between two cubes may not, because cubes are
  /// divided in eight.
  bool whole(int depth) const { return options_.placing != Placing::middle || depth % 3 == 0; }

  void place(const Waiting& cell) {
    if (whole(cell.depth) &&
        (cell.elements.size() <= options_.max_objects || cell.depth >= options_.max_depth || full_))
      return leaf(cell);
    const std::optional<Halving> by = placed(options_.placing, bsp_.contents_, cell.elements, cell.box, cell.depth);
    if (!by) return leaf(cell);
    const auto [low, high] = halves(cell.box, *by);
    Waiting below{bsp_.nodes_.size(), low, cell.depth + 1, within(cell, low)};
    Waiting above{bsp_.nodes_.size() + 1, high, cell.depth + 1, within(cell, high)};
    const std::size_t references = references_ - cell.elements.size() + below.elements.size() + above.elements.size();
    // A cube adds at most seven planes, and each element in every eighth.
    const bool cube = options_.placing == Placing::middle;
    if (whole(cell.depth) && bytes(bsp_.nodes_.size() + (cube ? 14 : 2),
                                   cube ? references_ + 7 * cell.elements.size() : references) > options_.max_bytes) {
      full_ = true;
      return leaf(cell);
    }
    references_ = references;
    bsp_.nodes_[cell.node] = {by->plane, static_cast<std::uint32_t>(bsp_.nodes_.size()),
                              static_cast<std::uint32_t>(by->axis)};
    bsp_.nodes_.resize(bsp_.nodes_.size() + 2);
    for (Waiting* const half : {&above, &below}) {
      if (whole(half->depth)) {
        waiting_.push_back(std::move(*half));
      } else {
        waiting_.push_front(std::move(*half));
      }
    }
  }

  Numbers within(const Waiting& cell, const surface::Box& half) const {
    if (!whole(cell.depth + 1)) return cell.elements;
    Numbers result;
    for (const std::uint32_t number : cell.elements) {
      bsp_.contents_.scene->visit(bsp_.contents_.elements[number], [&](const auto& shape) {
        if (touches(shape, half)) result.push_back(number);
      });
    }
    return result;
  }

  void leaf(const Waiting& cell) {
    bsp_.nodes_[cell.node] = {0, static_cast<std::uint32_t>(leaves_), 3};
    for (const std::uint32_t element : cell.elements) listed_.push_back({element, static_cast<std::uint32_t>(leaves_)});
    ++leaves_;
  }

  /// The bytes of a tree with so many nodes and references, half of the nodes being leaves.
  std::size_t bytes(std::size_t nodes, std::size_t references) const {
    const Contents& contents = bsp_.contents_;
    return sizeof(Bsp) + nodes * sizeof(Bsp::Node) + (nodes / 2 + 2 + references) * sizeof(std::uint32_t) +
           (contents.elements.capacity() + contents.apart.capacity()) * sizeof(scene::ElementRef);
  }

  Bsp& bsp_;
  BspOptions options_;
  std::size_t references_ = 0, leaves_ = 0;
  bool full_ = false;
  std::deque<Waiting> waiting_;
  std::vector<Reference> listed_;
};

Bsp::Bsp(const scene::Scene& scene, const BspOptions& options)
    : InCells(scene), root_(root_for(options.placing, contents_.box)) {
  BspBuilder(*this, options).build();
}

std::vector<surface::Box> Bsp::leaf_boxes() const {
  std::vector<surface::Box> of_nodes(nodes_.size()), of_leaves(lists_.rows());
  of_nodes[0] = root_;
  for (std::size_t place = 0; place < nodes_.size(); ++place) {
    const Node& node = nodes_[place];
    if (node.leaf()) {
      of_leaves[node.below] = of_nodes[place];
    } else {
      std::tie(of_nodes[node.below], of_nodes[node.below + 1]) =
          halves(of_nodes[place], {static_cast<int>(node.axis), node.plane});
    }
  }
  return of_leaves;
}

Size Bsp::size() const {
  Size size = size_of_lists();
  size.nodes = nodes_.size() / 2;
  size.cells = lists_.rows();
  std::vector<std::size_t> depths(nodes_.size());
  for (std::size_t place = 0; place < nodes_.size(); ++place) {
    const Node& node = nodes_[place];
    size.depth = std::max(size.depth, depths[place]);
    if (!node.leaf()) depths[node.below] = depths[node.below + 1] = depths[place] + 1;
  }
  size.bytes += sizeof(*this) + nodes_.capacity() * sizeof(Node);
  return size;
}

}  // namespace durero::accel
