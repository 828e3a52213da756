#pragma once
/// The bounding volume hierarchy (BVH) of Rubin and Whitted, with boxes as volumes and one element a leaf (A §1.3).
///
/// The test of a box (accel/slab.hpp) is proved; a leaf has no test of its own, its element is handed over where the
/// parent's box is met. A ray that meets an element at 0 < t ≤ limit() therefore meets every box above it up to that
/// limit, and finds it. Boxes that begin beyond the nearest hit so far are pruned, which only reads the limit; elements
/// beyond it are left to the search, which alone knows their points.

#include <algorithm>
#include <array>
#include <boost/container/small_vector.hpp>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "durero/accel/hierarchy.hpp"
#include "durero/accel/slab.hpp"
#include "durero/accel/work.hpp"
#include "durero/scene/groups.hpp"
#include "durero/scene/scene.hpp"
#include "durero/trace/ray.hpp"

namespace durero::accel {

/// The construction of a hierarchy.
enum class Build : std::uint8_t {
  top_down,     ///< splits by the least Σ surface · elements of both halves; O(n log² n)
  incremental,  ///< Goldsmith and Salmon's insertion, each searched for from the root; O(n log n) where balanced
  every_place,  ///< the same insertion with every position tried; O(n²)
};

/// The default of the greatest number of a node's children.
inline constexpr unsigned usual_children = 8;

/// A BVH over a scene. It follows edits of the scene that it is told of.
class Bvh {
 public:
  /// Builds the hierarchy of a scene, which must outlive it, and is edited only with a call of added() or removed()
  /// after each edit. Precondition: most_children ≥ 2.
  explicit Bvh(const scene::Scene& scene, Build build = Build::top_down, unsigned most_children = usual_children);

  /// Builds the hierarchy from groups: a node for each group of two things or more, with any number of children;
  /// elements outside all groups are below the root. Later changes of the groups change nothing here. Precondition: the
  /// groups are of that scene.
  Bvh(const scene::Scene& scene, const scene::Groups& by_hand);

  /// The scene of the hierarchy.
  const scene::Scene& scene() const noexcept { return *scene_; }
  /// The elements that are not ordinary, and planes.
  std::span<const scene::ElementRef> extraordinary() const noexcept { return apart_; }
  /// The tree of the other elements.
  const Hierarchy& hierarchy() const noexcept { return tree_; }
  /// The hierarchy's size.
  Size size() const;

  /// Inserts an element by the heuristic of Goldsmith and Salmon. Precondition: it was just added to the scene, which
  /// has no mesh.
  void added(scene::ElementRef e);
  /// Removes the element that e named. Precondition: it was just removed from the scene, which has no mesh, and where e
  /// now names the element that was the last of its type.
  void removed(scene::ElementRef e);

  /// Candidates::any (trace/candidates.hpp), nearest boxes first; adds its work to `work`.
  template <class Limit, class Visit>
  bool any(const trace::Ray& ray, Limit limit, Visit visit, Work& work) const;

 private:
  using Number = Hierarchy::Number;
  /// The place of an element: a leaf, or an index in apart_.
  struct Place {
    bool apart;
    std::uint32_t number;
  };
  struct Reached {
    Number node;
    double entry;
  };

  Place& place(scene::ElementRef e) { return places_[static_cast<std::size_t>(e.tipo)][e.index]; }
  void put_apart(scene::ElementRef e);
  /// Makes a leaf, or an entry of apart_, for each element. The leaves.
  std::vector<Number> take_elements();
  void grow(Build build, std::vector<Number> leaves);
  /// Arranges the nodes in memory so that neighbours in the tree are neighbours there.
  void arrange();
  /// Joins the groups' nodes to a root. Precondition: there is a leaf.
  Number join_groups(const scene::Groups& groups, std::span<const Number> leaves);

  const scene::Scene* scene_;
  unsigned most_children_;
  Hierarchy tree_;
  std::vector<scene::ElementRef> apart_;
  std::array<std::vector<Place>, scene::shape_count> places_;  // of every element
};

/// The BVH of the seed's recursion, as a readable reference: a node's children in no particular order, each box tested
/// when the recursion reaches it (A §1.3.1).
class BvhGlassner {
 public:
  /// Builds the hierarchy of a scene, which must outlive it unedited.
  explicit BvhGlassner(const scene::Scene& scene) : bvh_(scene) {}

  /// The scene of the hierarchy.
  const scene::Scene& scene() const noexcept { return bvh_.scene(); }
  /// The elements that are not ordinary, and planes.
  std::span<const scene::ElementRef> extraordinary() const noexcept { return bvh_.extraordinary(); }
  /// The hierarchy's size.
  Size size() const { return bvh_.size(); }

  /// Candidates::any (trace/candidates.hpp); adds its work to `work`.
  template <class Limit, class Visit>
  bool any(const trace::Ray& ray, Limit limit, Visit visit, Work& work) const {
    return !bvh_.hierarchy().empty() &&
           BVH_intersection(Rayo<Limit, Visit>{Beam(ray), limit, visit, work}, bvh_.hierarchy().root());
  }

 private:
  /// The seed's ray: origin and direction, the least distance so far, and the test of an object.
  template <class Limit, class Visit>
  struct Rayo {
    Beam beam;
    Limit& distancia_minima;
    Visit& intersecar_objeto;
    Work& work;
  };

  /// The seed's `while (nodo.hijo)` becomes a visit of each child. Whether the search is over.
  template <class Ray>
  bool BVH_intersection(const Ray& rayo, Hierarchy::Number nodo) const;

  Bvh bvh_;
};

/// The parameter at which the ray enters the box, or nothing where it does not meet the box up to the limit. It is
/// counted.
inline std::optional<double> entry_into(const surface::Box& box, const Beam& beam, double limit, Work& work) {
  ++work.volumes;
  BoxInterval within = stretch(box, beam, std::numeric_limits<double>::infinity());
  if (!within.meets()) return ++work.by_miss, std::nullopt;
  within.exit = std::min(limit, within.exit);
  if (!within.meets()) return ++work.by_distance, std::nullopt;
  return within.entry;
}

template <class Limit, class Visit>
bool Bvh::any(const trace::Ray& ray, Limit limit, Visit visit, Work& work) const {
  if (tree_.empty()) return false;
  const Beam beam(ray);
  boost::container::small_vector<Reached, 64> left;
  const auto reach = [&](Number number) {
    const Hierarchy::Node& node = tree_[number];
    if (node.is_leaf()) return ++work.cells, ++work.candidates, visit(node.element);
    if (const auto entry = entry_into(node.box, beam, limit(), work)) left.push_back({number, *entry});
    return false;
  };
  if (reach(tree_.root())) return true;
  while (!left.empty()) {
    const Reached nearest = left.back();
    left.pop_back();
    if (!BoxInterval{nearest.entry, limit()}.meets()) {
      ++work.by_distance;
      continue;
    }
    ++work.nodes;
    const std::size_t before = left.size();
    if (tree_.any_child(nearest.node, reach)) return true;
    std::sort(left.begin() + before, left.end(), [](const Reached& a, const Reached& b) { return a.entry > b.entry; });
  }
  return false;
}

template <class Ray>
bool BvhGlassner::BVH_intersection(const Ray& rayo, Hierarchy::Number nodo) const {
  const Hierarchy& arbol = bvh_.hierarchy();
  if (arbol[nodo].is_leaf())
    return ++rayo.work.cells, ++rayo.work.candidates, rayo.intersecar_objeto(arbol[nodo].element);
  if (!entry_into(arbol[nodo].box, rayo.beam, rayo.distancia_minima(), rayo.work)) return false;
  ++rayo.work.nodes;
  return arbol.any_child(nodo, [&](Hierarchy::Number hijo) { return BVH_intersection(rayo, hijo); });
}

}  // namespace durero::accel
