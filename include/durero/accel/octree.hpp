#pragma once
/// An octree (A §1.4.2): a cube around the scene is divided in eight, and each eighth again where more elements touch
/// it than a leaf may list. A leaf lists the elements that touch it, or is empty.
///
/// A ray crosses each of the three middle planes of a node once, in some order, and so visits at most four of the eight
/// children. The traversal steps among siblings (3DDDA in a lattice of two by two by two), and down and up between
/// groups of siblings, on exact crossings (accel/line.hpp).

#include <string>

#include "durero/accel/cells.hpp"
#include "durero/accel/lattice.hpp"

namespace durero::accel {

/// The limits of the division.
struct OctreeOptions {
  int max_depth = -1;           ///< at most Octree::deepest; below 0: chosen by the number of elements
  std::size_t max_objects = 2;  ///< a cell with no more is a leaf
  std::size_t max_bytes = 0;    ///< of the whole octree; 0: 64 KiB and 256 an element
};

/// An octree over a scene: a structure (accel/structure.hpp).
class Octree : public InCells {
 public:
  /// The names of the nodes at this depth have 19 digits, as many as an integer of 64 bits holds (octree_names).
  static constexpr int deepest = 19;

  /// The reason why a cell is not divided.
  enum class Why : std::uint8_t { few_objects, max_depth, max_bytes };

  /// A leaf: a cube, by the least of the finest cells in it.
  struct Leaf {
    Cell corner;  ///< in units of the finest cells
    int depth;    ///< 0 for the root; each level halves the side
    Why why;      ///< the reason why it is a leaf
  };

  /// Builds the octree of a scene, which must outlive it unedited. Throws std::invalid_argument where max_depth >
  /// `deepest`.
  explicit Octree(const scene::Scene& scene, const OctreeOptions& options = {});

  /// The leaves by number.
  std::span<const Leaf> leaves() const noexcept { return leaves_; }
  /// All possible finest cells: 2^max_depth along each axis of the root.
  const Lattice& finest() const noexcept { return finest_; }
  /// The closed cube of a leaf.
  surface::Box box(const Leaf& leaf) const;
  Size size() const;  ///< the octree's size

  /// @{ The leaf that holds a point, by comparing coordinates with the middle of each node; or a finest cell, by the
  /// digits of the cell's octal code. `probes` counts the nodes. Precondition: the root holds the point or cell.
  std::size_t leaf_at(const glm::dvec3& point, std::size_t& probes) const;
  std::size_t leaf_at(const Cell& cell, std::size_t& probes) const;
  /// @}
  /// The digit of a finest cell's octal code at a depth from 1 on: the number of the child that holds it. Bit i is set
  /// in the upper half of axis i.
  unsigned octal_digit(const Cell& cell, int depth) const;

  /// Traversal by siblings. Calls visit(leaf, event) for every leaf that holds a point of the ray, in the order of the
  /// ray, with the crossing by which the leaf is entered, until visit answers true. Whether it did. group(count) is
  /// called after each group of eight that the ray has left, with the number of siblings visited.
  template <class Visit, class Group>
  bool walk(const AxisRay& line, Visit visit, Group group, Work& work) const;

  /// Traversal by point location, the seed's BuscarObjetosEnOctree: the same leaves, each found from the root by the
  /// point at which the ray left the cell before.
  template <class Visit>
  bool walk_by_location(const AxisRay& line, Visit visit, Work& work) const;

  /// Tests the elements of leaf after leaf in the order of the ray (search_cells).
  template <class Limit, class Visit>
  bool any(const trace::Ray& ray, Limit limit, Visit visit, Work& work) const {
    return search_cells(contents_, lists_, ray, limit, visit, work, [&](const AxisRay& line, auto look) {
      walk(
          line, look, [](unsigned) {}, work);
    });
  }

 private:
  friend class OctreeBuilder;

  /// A leaf, or the place of its eight children.
  using Node = std::uint32_t;
  static constexpr Node leaf_bit = 0x80000000u;

  double side() const { return finest_.h * finest_.count.x; }

  template <class Visit, class Group>
  struct Walk;

  Lattice finest_;
  std::vector<Node> nodes_;  // the root, then groups of eight
  std::vector<Leaf> leaves_;
};

/// An octree traversed by point location alone: a readable reference, and to be measured against the other traversal.
class OctreeByLocation : public Octree {
 public:
  using Octree::Octree;
  /// Tests the elements of leaf after leaf in the order of the ray (search_cells).
  template <class Limit, class Visit>
  bool any(const trace::Ray& ray, Limit limit, Visit visit, Work& work) const {
    return search_cells(contents(), lists(), ray, limit, visit, work,
                        [&](const AxisRay& line, auto look) { walk_by_location(line, look, work); });
  }
};

/// A cube around a box. Its side is a power of two, the planes of all cells down to Octree::deepest are binary64
/// numbers, and every point of the box is below its upper faces.
Lattice cube_over(const surface::Box& box);
/// The cells of such a cube at a depth. Precondition: 0 ≤ depth ≤ Octree::deepest.
Lattice finest_cells(const surface::Box& box, int depth);

/// The recursion of Octree::walk.
template <class Visit, class Group>
struct Octree::Walk {
  /// Visits the leaves below a node, which the ray enters by `in` and leaves by `out`.
  bool operator()(Node node, const glm::dvec3& low, double side, PlaneCrossing in, const PlaneCrossing& out) {
    if ((node & leaf_bit) != 0) return visit(node & ~leaf_bit, in);
    ++work.nodes;
    work.volumes += 3;
    const double half = side / 2;
    PlaneCrossing middle[3];
    unsigned passed = 0, at = 0, siblings = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const unsigned bit = 1u << axis;
      middle[axis] = line.crossing(axis, low[axis] + half);
      const bool before = line.order(middle[axis], in) <= 0;
      if (before) passed |= bit;
      if (before != line.backwards(axis)) at |= bit;
    }
    for (;;) {
      PlaneCrossing next = out;
      unsigned axes = 0;
      for (int axis = 0; axis < 3; ++axis) {
        const unsigned bit = 1u << axis;
        if ((passed & bit) != 0) continue;
        const int order = line.order(middle[axis], next);
        if (order < 0) next = middle[axis], axes = bit;
        if (order == 0 && axes != 0) axes |= bit;
      }
      ++siblings;
      const glm::dvec3 corner(low.x + (at & 1 ? half : 0), low.y + (at & 2 ? half : 0), low.z + (at & 4 ? half : 0));
      if ((*this)(octree.nodes_[node + at], corner, half, in, next)) return true;
      if (axes == 0) break;
      in = next;
      at ^= axes;
      passed |= axes;
    }
    group(siblings);
    return false;
  }

  const Octree& octree;
  const AxisRay& line;
  Visit& visit;
  Group& group;
  Work& work;
};

template <class Visit, class Group>
bool Octree::walk(const AxisRay& line, Visit visit, Group group, Work& work) const {
  const surface::Box whole = finest_.whole();
  const std::optional<PlaneCrossing> first = way_in(line, whole);
  if (!first) return false;
  const PlaneCrossing out = way_out(line, whole).event;
  return Walk<Visit, Group>{*this, line, visit, group, work}(nodes_[0], whole.low, side(), *first, out);
}

template <class Visit>
bool Octree::walk_by_location(const AxisRay& line, Visit visit, Work& work) const {
  const surface::Box whole = finest_.whole();
  const std::optional<PlaneCrossing> first = way_in(line, whole);
  if (!first) return false;
  const PlaneCrossing end = way_out(line, whole).event;
  PlaneCrossing event = *first;
  do {
    Node node = nodes_[0];
    surface::Box box = whole;
    while ((node & leaf_bit) == 0) {
      ++work.nodes;
      work.volumes += 3;
      const glm::dvec3 middle = 0.5 * box.low + 0.5 * box.high;
      for (int axis = 0; axis < 3; ++axis) {
        const bool above = line.above(axis, middle[axis], event);
        (above ? box.low : box.high)[axis] = middle[axis];
        if (above) node += 1u << axis;
      }
      node = nodes_[node];
    }
    if (visit(node & ~leaf_bit, event)) return true;
    event = way_out(line, box).event;
  } while (line.order(event, end) < 0);
  return false;
}

}  // namespace durero::accel
