#pragma once
/// Kaplan's division of space: a plane across an axis halves a cell, and again, until few elements touch a half.

#include "durero/accel/cells.hpp"
#include "durero/accel/lattice.hpp"

namespace durero::accel {

/// Where planes are placed.
enum class Placing : std::uint8_t {
  middle,       ///< x, y and z in turn, in the middle of cubes: cells are looked at when they are cubes again
  median,       ///< as many elements on either side, where no element's box ends where another does
  surface_area  ///< where the sides' areas, times what is in them, add up to least (MacDonald and Booth)
};

/// When cells are no longer divided, and how they are.
struct BspOptions {
  Placing placing = Placing::surface_area;  ///< of every plane
  int max_depth = -1;                       ///< at most Bsp::deepest; below 0: what the number of elements asks for
  std::size_t max_objects = 2;              ///< a cell with no more is a leaf
  std::size_t max_bytes = 0;                ///< of memory for the whole tree; 0: 64 KiB and 256 an element
};

/// A structure (accel/structure.hpp).
class Bsp : public InCells {
 public:
  /// A leaf, or a plane and where the two sides of it are.
  struct Node {
    double plane;         ///< the coordinate that halves the cell
    std::uint32_t below;  ///< the side below, and right after it the side above; of a leaf its number
    std::uint32_t axis;   ///< that the plane lies across; 3: a leaf
    bool leaf() const { return axis == 3; }  ///< of a list
  };

  /// The names of the nodes at this depth have 64 binary digits (BspNames).
  static constexpr int deepest = 63;

  /// Throws std::invalid_argument where max_depth is more than `deepest`.
  explicit Bsp(const scene::Scene& scene, const BspOptions& options = {});

  /// The root, and its nodes by place.
  std::span<const Node> nodes() const noexcept { return nodes_; }
  /// The root's cell. Its upper faces are above every element.
  const surface::Box& root() const noexcept { return root_; }
  /// The closed cell of each leaf, by number.
  std::vector<surface::Box> leaf_boxes() const;
  Size size() const;  ///< as of every structure

  /// visit(leaf, event) for every leaf that holds a point of the ray, in its order, and the crossing by which it is
  /// entered, until it answers true. Whether it did. Jansen's recursion: the nearer half of the ray in the nearer half
  /// of the cell, then the farther ones, where the ray crosses the plane at all. at_node(place) once for each inner
  /// node.
  template <class Visit, class AtNode>
  bool walk(const Line& line, Visit visit, AtNode at_node) const;

  /// The same leaves, each found again from the root: the point of the ray where it has left a cell is in the next one.
  template <class Visit, class AtNode>
  bool walk_by_location(const Line& line, Visit visit, AtNode at_node) const;

  /// Leaf by leaf in the order of the ray (search_cells).
  template <class Limit, class Visit>
  bool any(const trace::Ray& ray, Limit limit, Visit visit, Work& work) const {
    return search_cells(contents_, lists_, ray, limit, visit, work, [&](const Line& line, auto look) {
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
  /// As Bsp has it.
  explicit BspMedian(const scene::Scene& scene) : Bsp(scene, {.placing = Placing::median}) {}
};

/// The tree walked by location alone: to be measured against the recursion.
class BspByLocation : public Bsp {
 public:
  using Bsp::Bsp;
  /// As Bsp::any.
  template <class Limit, class Visit>
  bool any(const trace::Ray& ray, Limit limit, Visit visit, Work& work) const {
    return search_cells(contents(), lists(), ray, limit, visit, work, [&](const Line& line, auto look) {
      walk_by_location(line, look, [&](std::size_t) { ++work.nodes, ++work.volumes; });
    });
  }
};

/// The recursion.
template <class Visit, class AtNode>
struct Bsp::Walk {
  /// From the crossing by which the node is entered to that by which it is left.
  bool operator()(std::size_t place, const Crossing& in, const Crossing& out) {
    const Node& node = bsp.nodes_[place];
    if (node.leaf()) return visit(std::size_t{node.below}, in);
    at_node(place);
    const int axis = static_cast<int>(node.axis);
    const Crossing middle = line.crossing(axis, node.plane);
    const bool passed = line.order(middle, in) <= 0;
    const bool above = passed != line.backwards(axis);
    if (passed || line.order(middle, out) >= 0) return (*this)(node.below + (above ? 1 : 0), in, out);
    return (*this)(node.below + (above ? 1 : 0), in, middle) || (*this)(node.below + (above ? 0 : 1), middle, out);
  }

  const Bsp& bsp;
  const Line& line;
  Visit& visit;
  AtNode& at_node;
};

template <class Visit, class AtNode>
bool Bsp::walk(const Line& line, Visit visit, AtNode at_node) const {
  const std::optional<Crossing> first = way_in(line, root_);
  if (!first) return false;
  return Walk<Visit, AtNode>{*this, line, visit, at_node}(0, *first, way_out(line, root_).event);
}

template <class Visit, class AtNode>
bool Bsp::walk_by_location(const Line& line, Visit visit, AtNode at_node) const {
  const std::optional<Crossing> first = way_in(line, root_);
  if (!first) return false;
  const Crossing end = way_out(line, root_).event;
  Crossing event = *first;
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
