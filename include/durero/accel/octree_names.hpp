#pragma once
/// Glassner's names for the nodes of an octree, and the hash table that finds a node by its name.

#include <cstdint>
#include <optional>

#include "durero/accel/octree.hpp"

namespace durero::accel {

/// The children of a node are 1 … 8, and the name of a child is 10 · its parent's name + its digit. The seed does not
/// say what the root is called: here 0, so that a name is the digits of the path and has as many as the depth. A digit
/// is one more than that of the octal code. The node `name` is in the list name mod size of the table.
class OctreeNames {
 public:
  using Name = std::uint64_t;           ///< of 19 decimal digits at most
  static constexpr Name root_name = 0;  ///< of no digit

  /// Of the inner nodes and of the leaves that are not empty: an empty leaf has no entry. A table of `lists` lists.
  OctreeNames(const Octree& octree, std::size_t lists);

  /// The name of a child. Preconditions: digit in 1 … 8; the child is no deeper than Octree::deepest.
  static constexpr Name child(Name parent, unsigned digit) { return 10 * parent + digit; }
  /// The name of a leaf, or of the node at a lesser depth that holds it.
  Name name(const Octree::Leaf& leaf, int depth) const;
  /// The leaf of that name; nothing where it is an inner node's, or nobody's.
  std::optional<std::size_t> find(Name name) const;
  /// The leaf that holds a point of the root: from the root, the name of the eighth that the point is in, until that is
  /// a leaf's or nobody's, and then nothing: the leaf is empty. Adds to `probes` the names looked for.
  std::optional<std::size_t> leaf_at(const glm::dvec3& point, std::size_t& probes) const;
  std::size_t longest_chain() const;  ///< of the lists of the table
  std::size_t names() const;          ///< how many nodes have an entry

 private:
  struct Entry {
    Name name;
    std::uint32_t leaf;
  };
  static constexpr std::uint32_t inner = 0xffffffffu;

  const Entry* entry(Name name) const;
  void enter(Name name, std::uint32_t leaf);

  const Octree& octree_;
  std::vector<std::vector<Entry>> table_;
};

}  // namespace durero::accel
