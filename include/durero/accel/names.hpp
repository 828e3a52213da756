#pragma once
/// Glassner's names for the nodes of a tree, and the hash table that finds a node by its name.

#include <cstdint>
#include <optional>

#include "durero/accel/bsp.hpp"
#include "durero/accel/octree.hpp"

namespace durero::accel {

/// The name of a node: a number that its path from the root makes.
using Name = std::uint64_t;

/// A hash table of names: a list of entries for each remainder of a name by the number of lists.
class NameTable {
 public:
  /// The value of an inner node; a leaf's value is its number.
  static constexpr std::uint32_t inner = 0xffffffffu;

  explicit NameTable(std::size_t lists) : lists_(lists) {}  ///< an empty table of so many lists
  void enter(Name name, std::uint32_t leaf);                ///< adds a new name, with `inner` or a leaf's number
  /// The value of a name; nothing where it was not entered.
  std::optional<std::uint32_t> find(Name name) const;
  std::size_t longest_chain() const;  ///< the length of the longest list
  std::size_t names() const;          ///< the number of entries

 private:
  struct Entry {
    Name name;
    std::uint32_t leaf;
  };
  std::vector<std::vector<Entry>> lists_;
};

/// Names for the nodes of an octree. The children of a node have the digits 1 … 8, each one more than in the octal
/// code, and the name of a child is 10 · its parent's name + its digit. The seed does not name the root; here it is 0,
/// so that a name consists of the digits of its path, as many as its depth.
class OctreeNames {
 public:
  static constexpr Name root_name = 0;  ///< a name without digits

  /// Names the inner nodes and the leaves that are not empty. An empty leaf has no name in the table.
  OctreeNames(const Octree& octree, std::size_t lists);

  /// The name of a child. Preconditions: digit in 1 … 8; the child is no deeper than Octree::deepest.
  static constexpr Name child(Name parent, unsigned digit) { return 10 * parent + digit; }
  /// The name of a leaf, or of the node at a lesser depth that holds it.
  Name name(const Octree::Leaf& leaf, int depth) const;
  /// The table of the names.
  const NameTable& table() const noexcept { return table_; }
  /// The leaf that holds a point of the root, or nothing where the leaf is empty. From the root on it looks up the
  /// eighth that holds the point, until the name is a leaf's or unknown. Adds the number of look-ups to `probes`.
  std::optional<std::uint32_t> leaf_at(const glm::dvec3& point, std::size_t& probes) const;

 private:
  const Octree& octree_;
  NameTable table_;
};

/// Names for the nodes of a BSP tree: the root is 1, and the name of a child is 2 · its parent's name + 1 above the
/// plane and + 0 below it. The name replaces the pointers of Bsp::nodes; a node's plane is found by its name too.
class BspNames {
 public:
  static constexpr Name root_name = 1;  ///< so that different paths have different names

  /// Names every node.
  BspNames(const Bsp& bsp, std::size_t lists);

  /// The name of a child. Precondition: the child is no deeper than Bsp::deepest.
  static constexpr Name child(Name parent, bool above) { return 2 * parent + (above ? 1 : 0); }
  /// The table of the names; the value is the place in Bsp::nodes, for inner nodes too.
  const NameTable& table() const noexcept { return table_; }
  /// The leaf that holds a point of the root.
  std::uint32_t leaf_at(const glm::dvec3& point) const;

 private:
  const Bsp& bsp_;
  NameTable table_;
};

}  // namespace durero::accel
