#pragma once
/// The part of a scene that is left without elements which stand in the tables for others (scene/body.hpp), as a scene
/// of its own. Only spheres have other places there.

#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "durero/scene/grouped_scene.hpp"
#include "durero/scene/query.hpp"

namespace durero::scene {

/// A part of a scene, and where its elements stand in the whole.
class Remainder {
 public:
  /// The whole without the elements for which `leaves_out` is true. Precondition: in the tables these are spheres.
  Remainder(const GroupedScene& whole, const std::function<bool(ElementRef)>& leaves_out);

  /// The part that is left.
  const GroupedScene& scene() const { return left_; }

  /// @{ Queries to the whole as those to what is left: without the elements left out that a ray starts on.
  Query query(const Query& of) const;
  std::vector<Query> queries(std::span<const Query> of) const;
  /// @}
  /// @{ Elements that are left, where they stand in the whole.
  ElementRef element(ElementRef left) const {
    return left.tipo == Sphere::tipo ? ElementRef{left.tipo, place_in_whole_[left.index]} : left;
  }
  ElementSet elements(const ElementSet& left) const;
  /// @}

 private:
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  GroupedScene left_;
  std::vector<std::uint32_t> place_left_, place_in_whole_;  // of spheres
};

}  // namespace durero::scene
