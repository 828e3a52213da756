#pragma once
/// The hierarchy of bounding volumes of Rubin and Whitted: boxes, and one element a leaf.
///
/// A box is tested by the proved test (accel/slab.hpp); a leaf's box is not, its element is handed over where the
/// parent's box is met. So a ray that meets an element at 0 < t ≤ limit() meets every box above it up to that limit,
/// and finds it. Boxes that begin beyond the nearest hit so far are passed over, and so are elements: these by the
/// search, which alone knows where they are met. The test of a box only reads the limit.

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

/// How a hierarchy is made.
enum class Build : std::uint8_t {
  top_down,     ///< halved where Σ surface · elements of both halves is least; O(n log² n)
  incremental,  ///< by Goldsmith and Salmon, one by one, each looked for from the root; O(n log n) where it is balanced
  every_place,  ///< the same, each tried in every position; O(n²)
};

/// How many children a node has at most, where nobody says otherwise.
inline constexpr unsigned usual_children = 8;

/// A scene's elements in a hierarchy. It follows edits of the scene that it is told of.
class Bvh {
 public:
  /// Of a scene, which must outlive it, and is edited only with added() and removed() after each edit. Precondition:
  /// most_children ≥ 2.
  explicit Bvh(const scene::Scene& scene, Build build = Build::top_down, unsigned most_children = usual_children);

  /// The hierarchy that was made by hand: a node for each group, but for such as hold one thing or nothing, of as many
  /// children as are there; what is in no group is under the root. Precondition: the groups are of that scene. Groups
  /// that change later change nothing here.
  Bvh(const scene::Scene& scene, const scene::Groups& by_hand);

  /// What it is made of.
  const scene::Scene& scene() const noexcept { return *scene_; }
  /// The elements that are not ordinary, and planes.
  std::span<const scene::ElementRef> extraordinary() const noexcept { return apart_; }
  /// The tree of the others.
  const Hierarchy& hierarchy() const noexcept { return tree_; }
  /// What it holds.
  Size size() const;

  /// Where an element has been added to the scene: by the heuristic of Goldsmith and Salmon.
  void added(scene::ElementRef e);
  /// Where an element has been taken out of the scene, which was e: the last one of its type has become e.
  void removed(scene::ElementRef e);

  /// As trace::Candidates has it, the nearest boxes first; adds what it did to `work`.
  template <class Limit, class Visit>
  bool any(const trace::Ray& ray, Limit limit, Visit visit, Work& work) const;

 private:
  using Number = Hierarchy::Number;
  /// Of an element: a leaf, or a place among those apart.
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
  /// Makes a leaf or a place apart for each element; the leaves.
  std::vector<Number> take_elements();
  void grow(Build build, std::vector<Number> leaves);
  /// Puts what is near in the tree near in memory.
  void arrange();
  /// The root over the groups. Precondition: a leaf or more.
  Number join_groups(const scene::Groups& groups, std::span<const Number> leaves);

  const scene::Scene* scene_;
  unsigned most_children_;
  Hierarchy tree_;
  std::vector<scene::ElementRef> apart_;
  std::array<std::vector<Place>, scene::shape_count> places_;  // of every element
};

/// The recursion of the text over the same hierarchy, to be read: the children of a node in any order, and each box
/// tested when the recursion comes to it.
class BvhGlassner {
 public:
  /// Of a scene, which must outlive it unedited.
  explicit BvhGlassner(const scene::Scene& scene) : bvh_(scene) {}

  /// What it is made of.
  const scene::Scene& scene() const noexcept { return bvh_.scene(); }
  /// As of Bvh.
  std::span<const scene::ElementRef> extraordinary() const noexcept { return bvh_.extraordinary(); }
  /// What it holds.
  Size size() const { return bvh_.size(); }

  /// As trace::Candidates has it; adds what it did to `work`.
  template <class Limit, class Visit>
  bool any(const trace::Ray& ray, Limit limit, Visit visit, Work& work) const {
    return !bvh_.hierarchy().empty() &&
           BVH_intersection(Rayo<Limit, Visit>{Beam(ray), limit, visit, work}, bvh_.hierarchy().root());
  }

 private:
  /// Origin and direction, the least distance so far, and what takes an object.
  template <class Limit, class Visit>
  struct Rayo {
    Beam beam;
    Limit& distancia_minima;
    Visit& intersecar_objeto;
    Work& work;
  };

  /// The text's `while (nodo.hijo)` stands for each child, one after the other. Whether the search is over.
  template <class Ray>
  bool BVH_intersection(const Ray& rayo, Hierarchy::Number nodo) const;

  Bvh bvh_;
};

/// Where the ray enters the box; nothing where it does not meet it up to the limit. Counted.
inline std::optional<double> entry_into(const surface::Box& box, const Beam& beam, double limit, Work& work) {
  ++work.volumes;
  Stretch within = stretch(box, beam, std::numeric_limits<double>::infinity());
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
    if (!Stretch{nearest.entry, limit()}.meets()) {
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
