#pragma once
/// Ray classification (A §1.6, Arvo and Kirk). A ray is a point of five dimensions, an origin in space and a direction
/// on the direction cube. A box of these dimensions, made of a box of space and a square of the cube, has a list of the
/// elements that its rays may meet. Boxes are halved where rays come, and a list is made from the list of the enclosing
/// box when it is first asked for. A list depends on its box alone; of two threads that make the same list at once, the
/// first one's is kept.
///
/// The test of a list is conservative. The rays of a box start within a distance h of its middle c, in directions
/// within a cone. A ray from o that meets a ball, moved by c − o, starts at c and meets the ball moved by as much. A
/// ball of radius R is therefore met only if, grown to R + h, it is seen from c in the cone; and the ray has no point
/// of it before the distance to the grown ball.
///
/// A ray from outside the box of all elements starts at its entry into that box, up to rounding; a margin on all boxes
/// covers the rounding.

#include <array>
#include <atomic>
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "durero/accel/direction_cube.hpp"
#include "durero/accel/slab.hpp"
#include "durero/accel/structure.hpp"

namespace durero::accel {

/// A structure (accel/structure.hpp) whose lists are made on demand. Elements without a ball are extraordinary.
class Classification {
 public:
  /// Prepares a scene, which must outlive it unedited.
  explicit Classification(const scene::Scene& scene);
  Classification(const Classification&) = delete;
  Classification& operator=(const Classification&) = delete;
  ~Classification();

  /// @{ The operations of a structure. The size is that of the lists made so far.
  const scene::Scene& scene() const noexcept { return *scene_; }
  std::span<const scene::ElementRef> extraordinary() const noexcept { return extraordinary_; }
  Size size() const;
  template <class Limit, class Visit>
  bool any(const trace::Ray& ray, Limit limit, Visit visit, Work& work) const;
  /// @}

 private:
  /// An element of a list, and a lower bound of the distance from the box's rays to it.
  struct Entry {
    std::uint32_t number;
    double near;
  };
  struct Node;
  /// The start of a ray within the box of all elements.
  struct Start {
    double t;
    glm::dvec3 place;
  };

  std::optional<Start> start(const trace::Ray& ray, const Beam& beam, const BoxInterval& stretch) const;
  std::span<const Entry> list(const glm::dvec3& place, const trace::Ray& ray, Work& work) const;
  bool is_leaf(const Node& node) const;
  std::unique_ptr<Node> child(const Node& node, std::uint32_t which) const;
  void make_list(Node& node, std::span<const Entry> of_parent) const;

  const scene::Scene* scene_;
  std::vector<scene::ElementRef> elements_;
  std::vector<surface::Ball> balls_;  // of each element
  std::vector<surface::Box> boxes_;   // of each element
  std::vector<scene::ElementRef> extraordinary_;
  surface::Box bounds_{};
  double reach_ = 0, margin_ = 0;
  std::uint32_t most_halvings_ = 0;
  std::array<std::unique_ptr<Node>, 6> roots_;
};

template <class Limit, class Visit>
bool Classification::any(const trace::Ray& ray, Limit limit, Visit visit, Work& work) const {
  const auto hand_over = [&](std::uint32_t number) {
    ++work.candidates;
    return visit(elements_[number]);
  };
  if (elements_.empty()) return false;
  const Beam beam(ray);
  const BoxInterval inside = stretch(bounds_, beam, limit());
  ++work.volumes;
  if (!inside.meets()) {
    ++work.by_miss;
    return false;
  }
  const std::optional<Start> from = start(ray, beam, inside);
  if (!from) {
    for (std::uint32_t number = 0; number < elements_.size(); ++number)
      if (hand_over(number)) return true;
    return false;
  }
  for (const Entry& entry : list(from->place, ray, work)) {
    // |v|·(t − from.t) ≥ entry.near and `length` ≥ |v|; the factor pays for three roundings.
    if ((from->t + entry.near / ray.length()) * (1 - 0x1p-50) > limit()) {
      ++work.by_distance;
      return false;
    }
    ++work.volumes;
    if (!stretch(boxes_[entry.number], beam, limit()).meets()) {
      ++work.by_miss;
    } else if (hand_over(entry.number)) {
      return true;
    }
  }
  return false;
}

}  // namespace durero::accel
