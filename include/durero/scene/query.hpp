#pragma once
/// The inputs of Primera_Interseccion: a ray, and the elements that its origin lies on.

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "durero/model/tipos.hpp"
#include "durero/scene/element_ref.hpp"

namespace durero::scene {

/// en?: the elements that the origin of a ray lies on. It refers to them and does not hold them.
class Origin {
 public:
  Origin() = default;
  /// @{ Of what outlives it. An ElementSet is ascending; the others need not be.
  Origin(const ElementRef& element) noexcept : elements_(&element, 1) {}
  Origin(std::span<const ElementRef> elements) noexcept : elements_(elements) {}
  Origin(const std::vector<ElementRef>& elements) noexcept : elements_(elements) {}
  Origin(const ElementSet& elements) noexcept
      : elements_(elements.data(), elements.size()), ascending_(elements.size() > few) {}
  /// @}

  /// @{ As of a range of ElementRef.
  auto begin() const noexcept { return elements_.begin(); }
  auto end() const noexcept { return elements_.end(); }
  bool empty() const noexcept { return elements_.empty(); }
  /// @}
  /// Whether the element is one of them. Of an ElementSet O(log n): where a ray starts on many, each of them is asked
  /// about.
  bool contains(ElementRef element) const noexcept {
    if (ascending_) return std::binary_search(begin(), end(), element);
    return !empty() && std::find(begin(), end(), element) != end();
  }

 private:
  static constexpr std::size_t few = 8;  // elements, which are looked through

  std::span<const ElementRef> elements_;
  bool ascending_ = false;  // and not few
};

/// rayo? and en? (Pregunta). Precondition of those who answer it: the elements of en are in the scene.
struct Query {
  model::Rayo rayo;  ///< rayo?
  ElementSet en{};   ///< en?, ascending
  bool operator==(const Query&) const = default;
};

}  // namespace durero::scene
