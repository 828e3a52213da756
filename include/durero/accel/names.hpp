#pragma once
/// Glassner's names for the nodes of a tree, and the hash table that finds a node by its name.

#include <cstdint>
#include <optional>

#include "durero/accel/bsp.hpp"
#include "durero/accel/octree.hpp"

namespace durero::accel {

/// The name of a node: a number that its path from the root makes.
using Name = std::uint64_t;

/// The nodes that have an entry, each in the list name mod size of a table.
class NameTable {
 public:
  /// Of an inner node; a leaf has its number.
  static constexpr std::uint32_t inner = 0xffffffffu;

  explicit NameTable(std::size_t lists) : lists_(lists) {}  ///< empty, of so many lists
  void enter(Name name, std::uint32_t leaf);                ///< `inner`, or a leaf's number; once for each name
  /// What was entered; nothing where nobody has the name.
  std::optional<std::uint32_t> find(Name name) const;
  std::size_t longest_chain() const;  ///< of all lists
  std::size_t names() const;          ///< how many were entered

 private:
  struct Entry {
    Name name;
    std::uint32_t leaf;
  };
  std::vector<std::vector<Entry>> lists_;
};

/// The names of an octree. The children of a node are 1 … 8, and the name of a child is 10 · its parent's name + its
/// digit. The seed does not say what the root is called: here 0, so that a name is the digits of the path and has as
/// many as the depth. A digit is one more than that of the octal code.
class OctreeNames {
 public:
  static constexpr Name root_name = 0;  ///< of no digit

  /// Of the inner nodes and of the leaves that are not empty: an empty leaf has no name in the table.
  OctreeNames(const Octree& octree, std::size_t lists);

  /// The name of a child. Preconditions: digit in 1 … 8; the child is no deeper than Octree::deepest.
  static constexpr Name child(Name parent, unsigned digit) { return 10 * parent + digit; }
  /// The name of a leaf, or of the node at a lesser depth that holds it.
  Name name(const Octree::Leaf& leaf, int depth) const;
  /// Where the names are.
  const NameTable& table() const noexcept { return table_; }
  /// The leaf that holds a point of the root: from the root, the name of the eighth that the point is in, until that is
  /// a leaf's or nobody's, and then nothing: the leaf is empty. Adds to `probes` the names looked for.
  std::optional<std::uint32_t> leaf_at(const glm::dvec3& point, std::size_t& probes) const;

 private:
  const Octree& octree_;
  NameTable table_;
};

/// The same form for a tree of halves: the root is 1, and the name of a child is 2 · its parent's name + 1 above the
/// plane and + 0 below it. What a pointer says in Bsp::nodes is said by the name; a node's plane is by its name too.
class BspNames {
 public:
  static constexpr Name root_name = 1;  ///< so that no two paths make one number

  /// Of every node.
  BspNames(const Bsp& bsp, std::size_t lists);

  /// The name of a child. Precondition: the child is no deeper than Bsp::deepest.
  static constexpr Name child(Name parent, bool above) { return 2 * parent + (above ? 1 : 0); }
  /// Where the names are; of an inner node and of a leaf, its place in Bsp::nodes.
  const NameTable& table() const noexcept { return table_; }
  /// The leaf that holds a point of the root.
  std::uint32_t leaf_at(const glm::dvec3& point) const;

 private:
  const Bsp& bsp_;
  NameTable table_;
};

}  // namespace durero::accel
