#pragma once
/// A shape of any type, for functions that are compiled once for all of them.

#include <type_traits>
#include <utility>
#include <variant>

#include "durero/scene/shapes.hpp"

namespace durero::scene {

/// It refers to a shape, which must outlive it.
class ShapeView {
 public:
  /// Of any shape of the closed set.
  template <class Shape>
    requires std::is_same_v<decltype(Shape::tipo), const model::Tipo>
  ShapeView(const Shape& shape) noexcept : shape_(&shape) {}

  /// visit(shape).
  template <class Visit>
  decltype(auto) visit(Visit&& visit) const {
    return std::visit([&](const auto* shape) -> decltype(auto) { return visit(*shape); }, shape_);
  }

 private:
  template <class List>
  struct PointerTo;
  template <class... Shape>
  struct PointerTo<std::tuple<Shape...>> {
    using type = std::variant<const Shape*...>;
  };
  typename PointerTo<Shapes>::type shape_;
};

}  // namespace durero::scene
