#include "durero/accel/octree.hpp"

#include <bit>
#include <deque>
#include <stdexcept>

#include "durero/accel/touch.hpp"

namespace durero::accel {
namespace {

/// The depth at which eight children a level give a cell for each element, and three levels more, which separate
/// surfaces that meet.
int depth_for(std::size_t elements) { return (static_cast<int>(std::bit_width(elements)) + 2) / 3 + 3; }

int depth_of(const OctreeOptions& options, std::size_t elements) {
  if (options.max_depth > Octree::deepest) throw std::invalid_argument("an octree deeper than its names have digits");
  return options.max_depth >= 0 ? options.max_depth : depth_for(elements);
}

}  // namespace

// The corner is a multiple of an eighth of the side, so that a scene that is moved by little keeps its cube. It is less
// than 2³¹ sides away, so every plane down to depth 19 is less than 2⁵¹ times the finest cell: a binary64 number.
Lattice cube_over(const surface::Box& box) {
  double extent = 0x1p-120;
  for (int axis = 0; axis < 3; ++axis)
    extent = std::max({extent, box.high[axis] - box.low[axis], 0x1p-30 * std::abs(box.low[axis]),
                       0x1p-30 * std::abs(box.high[axis])});
  for (int exponent = std::ilogb(extent);; ++exponent) {
    Lattice cube{{}, std::ldexp(1, exponent), {1, 1, 1}};
    bool holds = true;
    for (int axis = 0; axis < 3; ++axis) {
      cube.low[axis] = std::floor(box.low[axis] / cube.h * 8) / 8 * cube.h;
      holds = holds && box.high[axis] < cube.plane(axis, 1);
    }
    if (holds) return cube;
  }
}

Lattice finest_cells(const surface::Box& box, int depth) {
  const Lattice cube = cube_over(box);
  return {cube.low, std::ldexp(cube.h, -depth), Cell(1 << depth)};
}

/// Divides cells in the order of their depth, so that all are about equally deep where memory ends.
class OctreeBuilder {
 public:
  OctreeBuilder(Octree& octree, int max_depth, const OctreeOptions& options)
      : octree_(octree), max_depth_(max_depth), max_objects_(options.max_objects) {
    const std::size_t n = octree.contents_.elements.size();
    max_bytes_ = options.max_bytes != 0 ? options.max_bytes : (std::size_t{1} << 16) + 256 * n;
  }

  void build() {
    std::vector<std::uint32_t> all(octree_.contents_.elements.size());
    for (std::uint32_t i = 0; i < all.size(); ++i) all[i] = i;
    octree_.nodes_.push_back(0);
    references_ = all.size();
    waiting_.push_back({0, {0, 0, 0}, 0, std::move(all)});
    for (; !waiting_.empty(); waiting_.pop_front()) place(waiting_.front());
    octree_.lists_ = Lists::elements_of_cells(listed_, octree_.leaves_.size());
    octree_.nodes_.shrink_to_fit();
    octree_.leaves_.shrink_to_fit();
  }

 private:
  struct Waiting {
    std::size_t node;
    Cell corner;
    int depth;
    std::vector<std::uint32_t> elements;
  };

  void place(const Waiting& cell) {
    using Why = Octree::Why;
    if (cell.elements.size() <= max_objects_) return leaf(cell, Why::few_objects);
    if (cell.depth == max_depth_) return leaf(cell, Why::max_depth);
    if (full_) return leaf(cell, Why::max_bytes);
    std::array<Waiting, 8> children;
    std::size_t references = references_ - cell.elements.size();
    for (unsigned octant = 0; octant < 8; ++octant) {
      children[octant] = child(cell, octant);
      references += children[octant].elements.size();
    }
    if (bytes(octree_.nodes_.size() + 8, references) > max_bytes_) {
      full_ = true;
      return leaf(cell, Why::max_bytes);
    }
    references_ = references;
    octree_.nodes_[cell.node] = static_cast<Octree::Node>(octree_.nodes_.size());
    octree_.nodes_.resize(octree_.nodes_.size() + 8);
    for (Waiting& each : children) {
      each.node += octree_.nodes_[cell.node];
      waiting_.push_back(std::move(each));
    }
  }

  Waiting child(const Waiting& cell, unsigned octant) const {
    const int half = 1 << (max_depth_ - cell.depth - 1);
    const Cell corner = cell.corner + half * Cell(octant & 1, octant >> 1 & 1, octant >> 2 & 1);
    Waiting result{octant, corner, cell.depth + 1, {}};
    const surface::Box box = octree_.box({corner, cell.depth + 1, {}});
    for (const std::uint32_t number : cell.elements) {
      octree_.contents_.scene->visit(octree_.contents_.elements[number], [&](const auto& shape) {
        if (touches(shape, box)) result.elements.push_back(number);
      });
    }
    return result;
  }

  void leaf(const Waiting& cell, Octree::Why why) {
    const auto number = static_cast<std::uint32_t>(octree_.leaves_.size());
    octree_.nodes_[cell.node] = Octree::leaf_bit | number;
    octree_.leaves_.push_back({cell.corner, cell.depth, why});
    for (const std::uint32_t element : cell.elements) listed_.push_back({element, number});
  }

  /// The bytes of an octree with so many nodes and references. Seven nodes of each group of eight add to the leaves.
  std::size_t bytes(std::size_t nodes, std::size_t references) const {
    const Contents& contents = octree_.contents_;
    const std::size_t leaves = nodes - nodes / 8;
    return sizeof(Octree) + nodes * sizeof(Octree::Node) + leaves * sizeof(Octree::Leaf) +
           (leaves + 1 + references) * sizeof(std::uint32_t) +
           (contents.elements.capacity() + contents.apart.capacity()) * sizeof(scene::ElementRef);
  }

  Octree& octree_;
  int max_depth_;
  std::size_t max_objects_, max_bytes_, references_ = 0;
  bool full_ = false;
  std::deque<Waiting> waiting_;
  std::vector<Reference> listed_;
};

Octree::Octree(const scene::Scene& scene, const OctreeOptions& options) : InCells(scene) {
  const int depth = depth_of(options, contents_.elements.size());
  finest_ = finest_cells(contents_.box, depth);
  OctreeBuilder(*this, depth, options).build();
}

surface::Box Octree::box(const Leaf& leaf) const {
  const int side = finest_.count.x >> leaf.depth;
  surface::Box box{};
  for (int axis = 0; axis < 3; ++axis) {
    box.low[axis] = finest_.plane(axis, leaf.corner[axis]);
    box.high[axis] = finest_.plane(axis, leaf.corner[axis] + side);
  }
  return box;
}

std::size_t Octree::leaf_at(const glm::dvec3& point, std::size_t& probes) const {
  Node node = nodes_[0];
  glm::dvec3 low = finest_.low;
  for (double half = side() / 2; (node & leaf_bit) == 0; half /= 2) {
    ++probes;
    for (int axis = 0; axis < 3; ++axis) {
      if (point[axis] < low[axis] + half) continue;
      low[axis] += half;
      node += 1u << axis;
    }
    node = nodes_[node];
  }
  return node & ~leaf_bit;
}

unsigned Octree::octal_digit(const Cell& cell, int depth) const {
  const int shift = std::countr_zero(static_cast<unsigned>(finest_.count.x)) - depth;
  const auto bit = [&](int axis) { return static_cast<unsigned>(cell[axis] >> shift & 1) << axis; };
  return bit(0) | bit(1) | bit(2);
}

std::size_t Octree::leaf_at(const Cell& cell, std::size_t& probes) const {
  Node node = nodes_[0];
  for (int depth = 1; (node & leaf_bit) == 0; ++depth) {
    ++probes;
    node = nodes_[node + octal_digit(cell, depth)];
  }
  return node & ~leaf_bit;
}

Size Octree::size() const {
  Size size = size_of_lists();
  size.nodes = nodes_.size() / 8;
  size.cells = leaves_.size();
  for (const Leaf& leaf : leaves_) size.depth = std::max(size.depth, static_cast<std::size_t>(leaf.depth));
  size.bytes += sizeof(*this) + nodes_.capacity() * sizeof(Node) + leaves_.capacity() * sizeof(Leaf);
  return size;
}

}  // namespace durero::accel
