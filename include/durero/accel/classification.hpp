#pragma once
/// Ray classification (A §1.6, Arvo and Kirk): rays are points of five dimensions, an origin in space and a direction
/// on the direction cube, and each box of those, a box of space and a square of the cube, has a list of the elements
/// that its rays may meet. Boxes are halved where rays come, and lists made from those of the boxes about them when
/// they are first asked for. A list depends on its box alone: of two threads that make the same one at once, the first
/// is kept.
///
/// The rays of a box start within a distance h of its middle c, in directions within a cone. A ray from o that meets a
/// ball, moved by c − o, starts at c and meets the ball moved as much: so a ball of radius R is met only if, grown to
/// R + h, it is seen from c in the cone; and a ray has no point of it before the distance to the grown ball.
///
/// A ray from outside the box of all elements starts where it enters that, up to rounding, for which all boxes are
/// taken to be greater than they are.

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

/// A Structure whose lists are made when they are asked for. What has no ball is apart.
class Classification {
 public:
  /// Of a scene, which must outlive it unedited.
  explicit Classification(const scene::Scene& scene);
  Classification(const Classification&) = delete;
  Classification& operator=(const Classification&) = delete;
  ~Classification();

  /// @{ As every Structure has it. The size is that of the lists that have been made.
  const scene::Scene& scene() const noexcept { return *scene_; }
  std::span<const scene::ElementRef> extraordinary() const noexcept { return extraordinary_; }
  Size size() const;
  template <class Limit, class Visit>
  bool any(const trace::Ray& ray, Limit limit, Visit visit, Work& work) const;
  /// @}

 private:
  /// An element, and what the rays of a box have at least to go to it.
  struct Entry {
    std::uint32_t number;
    double near;
  };
  struct Node;
  /// Where a ray starts, within the box of all elements.
  struct Start {
    double t;
    glm::dvec3 place;
  };

  std::optional<Start> start(const trace::Ray& ray, const Beam& beam, const Stretch& stretch) const;
  std::span<const Entry> list(const glm::dvec3& place, const trace::Ray& ray, Work& work) const;
  bool is_leaf(const Node& node) const;
  std::unique_ptr<Node> child(const Node& node, std::uint32_t which) const;
  void make_list(Node& node, std::span<const Entry> of_parent) const;

  const scene::Scene* scene_;
  std::vector<scene::ElementRef> elements_;
  std::vector<surface::Ball> balls_;  // of each
  std::vector<surface::Box> boxes_;   // of each
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
  const Stretch inside = stretch(bounds_, beam, limit());
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
    // |v|·(t − from.t) is not less than entry.near, and `length` not less than |v|; the factor pays for three
    // roundings.
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
