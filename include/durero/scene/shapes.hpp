#pragma once
/// The closed set of shapes. Each is a header of its own in scene/shape/: its fields with the letters of the attributes
/// that they store, its word in files, and the table of its attributes. A stored value satisfies the invariant of
/// model::Escena, which scene::Scene has checked.

#include <cstddef>
#include <type_traits>

#include "durero/scene/shape/cone.hpp"
#include "durero/scene/shape/cylinder.hpp"
#include "durero/scene/shape/disc.hpp"
#include "durero/scene/shape/plane.hpp"
#include "durero/scene/shape/sphere.hpp"
#include "durero/scene/shape/triangle.hpp"
#include "durero/scene/shape/truncated_cone.hpp"

namespace durero::scene {

/// Every shape, in the order of Tipo.
using Shapes = std::tuple<Sphere, Cylinder, Cone, TruncatedCone, Plane, Disc, Triangle>;

/// How many there are.
inline constexpr std::size_t shape_count = std::tuple_size_v<Shapes>;

/// visit(std::type_identity<Shape>) for the shape of a type. A type without its line here does not compile.
template <class Visit>
constexpr decltype(auto) with_shape(model::Tipo tipo, Visit&& visit) {
  switch (tipo) {
    case model::Tipo::soy_esfera:
      return visit(std::type_identity<Sphere>());
    case model::Tipo::soy_cilindro:
      return visit(std::type_identity<Cylinder>());
    case model::Tipo::soy_cono:
      return visit(std::type_identity<Cone>());
    case model::Tipo::soy_tronco:
      return visit(std::type_identity<TruncatedCone>());
    case model::Tipo::soy_plano:
      return visit(std::type_identity<Plane>());
    case model::Tipo::soy_disco:
      return visit(std::type_identity<Disc>());
    case model::Tipo::soy_triangulo:
      return visit(std::type_identity<Triangle>());
  }
  __builtin_unreachable();  // a Tipo is one of its enumerators
}

/// visit(std::type_identity<Shape>) for every shape, in order.
template <class Visit>
constexpr void for_each_shape(Visit&& visit) {
  [&]<class... Shape>(std::type_identity<std::tuple<Shape...>>) {
    (visit(std::type_identity<Shape>()), ...);
  }(std::type_identity<Shapes>());
}

/// Whether the operation adds the shape, which is then `type`.
template <class Operation, class Shape>
struct IsAdditionOf : std::is_same<Operation, typename Shape::Addition> {
  using type = Shape;  ///< what is added
};
/// Stands for operations that add no shape.
struct NoShape : std::true_type {
  using type = void;  ///< nothing is added
};
/// The first shape of the list that the operation adds, or NoShape.
template <class Operation, class List>
struct AddedBy;
/// The only list that there is: a tuple.
template <class Operation, class... Shape>
struct AddedBy<Operation, std::tuple<Shape...>> : std::disjunction<IsAdditionOf<Operation, Shape>..., NoShape> {};

/// The shape that an operation adds; void for one that is no addition of one shape.
template <class Operation>
using ShapeAddedBy = typename AddedBy<Operation, Shapes>::type;

/// The place of a shape in lists that have one entry for each.
template <class Shape>
inline constexpr std::size_t place_of = static_cast<std::size_t>(Shape::tipo);

// The list is whole and in order: with_shape names each shape of it once, at the place that its type has.
static_assert([] {
  std::size_t place = 0;
  bool in_order = true;
  for_each_shape([&]<class Shape>(std::type_identity<Shape>) {
    in_order = in_order && place_of<Shape> == place++ &&
               with_shape(Shape::tipo,
                          []<class Visited>(std::type_identity<Visited>) { return std::is_same_v<Visited, Shape>; });
  });
  return in_order;
}());

}  // namespace durero::scene
