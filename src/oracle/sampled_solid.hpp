#pragma once
/// A solid that is made of others, as the sampled oracle knows it.
///
/// A point of a leaf's surface is one of the solid's where the solid has it by one side of the leaf and not by the
/// other (repartos.def.1, superficie.def.1). All points within a distance are on one side of a leaf whose surface is
/// farther than that. So a point tells of all that are near: of each leaf it tells the side, or leaves it open where
/// the leaf is near. What the sets make of open sides is Kleene's logic of three values, which tells of the solid only
/// what holds whatever the open sides are. Sides that are left open more often than the text leaves them make nothing
/// wrong, but less is told: where faces of two leaves coincide, nothing.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "durero/scene/body.hpp"
#include "solid_leaf.hpp"

namespace durero::oracle {

/// Leaves that are joined, and whether points are on their common surface.
class SampledSolid {
 public:
  /// Precondition: the body bounds a solid.
  explicit SampledSolid(const scene::Compound& solid);

  /// A ball that holds the part of it that rays are aimed at: all that its planes and its other leaves bound.
  const SolidLeaf::Extent& seen() const { return seen_; }
  /// How many leaves it has.
  std::size_t size() const { return leaves_.size(); }
  /// The surface of a leaf in pieces; of a plane a patch that holds what the planes and the other leaves bound.
  std::vector<PlacedSurface> surfaces(std::size_t leaf) const { return leaves_[leaf].surfaces(seen_); }

  /// Whether some point within `reach` of w may be on the surface.
  bool may_have(const glm::dvec3& w, double reach) const;
  /// @{ Of the points of a leaf's surface within `reach` of w: whether some may be on the solid's, and whether all are,
  /// except in the leaf's own rims.
  bool may_have(const glm::dvec3& w, std::size_t leaf, double reach) const;
  bool has_all(const glm::dvec3& w, std::size_t leaf, double reach) const;
  /// @}

 private:
  /// In the order of the logic: false, open, true.
  enum class Truth : std::int8_t { outside = -1, open = 0, inside = 1 };
  struct Node {
    scene::Compound::Operation operation;
    std::vector<Node> parts;
    std::size_t leaf;  // where there are no parts
  };

  Node node(const scene::Body& body);
  Node node_of(const scene::Instance& instance);
  Node node_of(const scene::Compound& solid);
  static Truth truth(const Node& node, const std::vector<Truth>& sides);
  std::vector<Truth> sides(const glm::dvec3& w, double reach) const;
  SolidLeaf::Extent extent() const;
  std::vector<glm::dvec3> corners() const;
  bool may_hold(const glm::dvec3& corner, double length) const;

  std::vector<SolidLeaf> leaves_;
  Node root_;
  double rounding_ = 0;
  SolidLeaf::Extent seen_;
};

}  // namespace durero::oracle
