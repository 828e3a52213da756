#pragma once
/// The inputs of Primera_Interseccion: a ray, and the elements that its origin lies on.

#include <algorithm>
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
  Origin(const ElementSet& elements) noexcept : elements_(elements.data(), elements.size()) {}
  /// @}

  /// @{ As of a range of ElementRef.
  auto begin() const noexcept { return elements_.begin(); }
  auto end() const noexcept { return elements_.end(); }
  bool empty() const noexcept { return elements_.empty(); }
  /// @}
  /// Whether the element is one of them.
  bool contains(ElementRef element) const noexcept { return !empty() && std::find(begin(), end(), element) != end(); }

 private:
  std::span<const ElementRef> elements_;
};

/// rayo? and en? (Pregunta). Precondition of those who answer it: the elements of en are in the scene.
struct Query {
  model::Rayo rayo;  ///< rayo?
  ElementSet en{};   ///< en?, ascending
  bool operator==(const Query&) const = default;
};

}  // namespace durero::scene
