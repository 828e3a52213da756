#pragma once
/// Kaplan's BSP tree: a plane across an axis halves a cell, and the halves are halved again until few elements touch
/// each.

#include "durero/accel/cells.hpp"
#include "durero/accel/lattice.hpp"

namespace durero::accel {

/// The placing of planes.
enum class Placing : std::uint8_t {
  middle,       ///< x, y and z in turn, in the middle of cubes: only cubes become leaves
  median,       ///< as many elements on either side, where no two elements' boxes end together
  surface_area  ///< the least sum of area times elements over both sides (MacDonald and Booth)
};

/// The limits of the division, and its placing of planes.
struct BspOptions {
  Placing placing = Placing::surface_area;  ///< of every plane
  int max_depth = -1;                       ///< at most Bsp::deepest; below 0: chosen by the number of elements
  std::size_t max_objects = 2;              ///< a cell with no more is a leaf
  std::size_t max_bytes = 0;                ///< of the whole tree; 0: 64 KiB and 256 an element
};

/// A BSP tree over a scene: a structure (accel/structure.hpp).
class Bsp : public InCells {
 public:
  /// A leaf, or a plane and the places of the cells at its two sides.
  struct Node {
    double plane;         ///< the coordinate that halves the cell
    std::uint32_t below;  ///< the place of the side below, before that of the side above; the number of a leaf
    std::uint32_t axis;   ///< the axis across which the plane lies; 3 for a leaf
    bool leaf() const { return axis == 3; }  ///< whether it is a leaf
  };

  /// The names of the nodes at this depth have 64 binary digits (BspNames).
  static constexpr int deepest = 63;

  /// Builds the tree of a scene, which must outlive it unedited. Throws std::invalid_argument where max_depth >
  /// `deepest`.
  explicit Bsp(const scene::Scene& scene, const BspOptions& options = {});

  /// The nodes by place, the root first.
  std::span<const Node> nodes() const noexcept { return nodes_; }
  /// The root's cell. Its upper faces are above every element.
  const surface::Box& root() const noexcept { return root_; }
  /// The closed cell of each leaf, by number.
  std::vector<surface::Box> leaf_boxes() const;
  Size size() const;  ///< the tree's size

  /// Traversal by Jansen's recursion. Calls visit(leaf, event) for every leaf that holds a point of the ray, in the
  /// order of the ray, with the crossing by which the leaf is entered, until visit answers true. Whether it did.
  /// at_node(place) is called once for each inner node. The recursion goes into the nearer half first, and into both
  /// halves only where the ray crosses the plane.
  template <class Visit, class AtNode>
  bool walk(const AxisRay& line, Visit visit, AtNode at_node) const;

  /// Traversal by point location: the same leaves, each found from the root by the point at which the ray left the cell
  /// before.
  template <class Visit, class AtNode>
  bool walk_by_location(const AxisRay& line, Visit visit, AtNode at_node) const;

  /// Tests the elements of leaf after leaf in the order of the ray (search_cells).
  template <class Limit, class Visit>
  bool any(const trace::Ray& ray, Limit limit, Visit visit, Work& work) const {
    return search_cells(contents_, lists_, ray, limit, visit, work, [&](const AxisRay& line, auto look) {
      walk(line, look, [&](std::size_t) { ++work.nodes, ++work.volumes; });
    });
  }

 private:
  friend class BspBuilder;

  template <class Visit, class AtNode>
  struct Walk;

  surface::Box root_;
  std::vector<Node> nodes_;  // the root, then pairs
};

/// The tree with planes at the median.
class BspMedian : public Bsp {
 public:
  /// Builds the tree of a scene, which must outlive it unedited.
  explicit BspMedian(const scene::Scene& scene) : Bsp(scene, {.placing = Placing::median}) {}
};

/// A BSP tree traversed by point location alone, to be measured against the recursion.
class BspByLocation : public Bsp {
 public:
  using Bsp::Bsp;
  /// Tests the elements of leaf after leaf in the order of the ray (search_cells).
  template <class Limit, class Visit>
  bool any(const trace::Ray& ray, Limit limit, Visit visit, Work& work) const {
    return search_cells(contents(), lists(), ray, limit, visit, work, [&](const AxisRay& line, auto look) {
      walk_by_location(line, look, [&](std::size_t) { ++work.nodes, ++work.volumes; });
    });
  }
};

/// The recursion of Bsp::walk.
template <class Visit, class AtNode>
struct Bsp::Walk {
  /// Visits the leaves below a node, which the ray enters by `in` and leaves by `out`.
  bool operator()(std::size_t place, const PlaneCrossing& in, const PlaneCrossing& out) {
    const Node& node = bsp.nodes_[place];
    if (node.leaf()) return visit(std::size_t{node.below}, in);
    at_node(place);
    const int axis = static_cast<int>(node.axis);
    const PlaneCrossing middle = line.crossing(axis, node.plane);
    const bool passed = line.order(middle, in) <= 0;
    const bool above = passed != line.backwards(axis);
    if (passed || line.order(middle, out) >= 0) return (*this)(node.below + (above ? 1 : 0), in, out);
    return (*this)(node.below + (above ? 1 : 0), in, middle) || (*this)(node.below + (above ? 0 : 1), middle, out);
  }

  const Bsp& bsp;
  const AxisRay& line;
  Visit& visit;
  AtNode& at_node;
};

template <class Visit, class AtNode>
bool Bsp::walk(const AxisRay& line, Visit visit, AtNode at_node) const {
  const std::optional<PlaneCrossing> first = way_in(line, root_);
  if (!first) return false;
  return Walk<Visit, AtNode>{*this, line, visit, at_node}(0, *first, way_out(line, root_).event);
}

template <class Visit, class AtNode>
bool Bsp::walk_by_location(const AxisRay& line, Visit visit, AtNode at_node) const {
  const std::optional<PlaneCrossing> first = way_in(line, root_);
  if (!first) return false;
  const PlaneCrossing end = way_out(line, root_).event;
  PlaneCrossing event = *first;
  do {
    surface::Box box = root_;
    std::size_t place = 0;
    while (!nodes_[place].leaf()) {
      at_node(place);
      const Node& node = nodes_[place];
      const int axis = static_cast<int>(node.axis);
      const bool above = line.above(axis, node.plane, event);
      (above ? box.low : box.high)[axis] = node.plane;
      place = node.below + (above ? 1 : 0);
    }
    if (visit(std::size_t{nodes_[place].below}, event)) return true;
    event = way_out(line, box).event;
  } while (line.order(event, end) < 0);
  return false;
}

}  // namespace durero::accel
