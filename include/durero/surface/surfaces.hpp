#pragma once
/// The surfaces of all shapes of scene::Shapes.

#include <concepts>
#include <tuple>
#include <type_traits>
#include <utility>

#include "durero/surface/shape/cone.hpp"
#include "durero/surface/shape/cylinder.hpp"
#include "durero/surface/shape/disc.hpp"
#include "durero/surface/shape/plane.hpp"
#include "durero/surface/shape/sphere.hpp"
#include "durero/surface/shape/triangle.hpp"
#include "durero/surface/shape/truncated_cone.hpp"

namespace durero::surface {

/// A shape with an equation, a ball and a box; a shape that lacks one does not compile.
template <class Shape>
concept Surface = requires(const Shape& shape, const Point<double>& w) {
  { potencia(shape, w) } -> std::same_as<double>;
  { ball(shape) } -> std::same_as<Ball>;
  { box(shape) } -> std::same_as<Box>;
};

/// Whether every shape of a list is a Surface.
template <class List>
inline constexpr bool all_are_surfaces = false;
template <class... Shape>
inline constexpr bool all_are_surfaces<std::tuple<Shape...>> = (Surface<Shape> && ...);
static_assert(all_are_surfaces<scene::Shapes>);

/// A flat shape: a plane, or part of one, whose potencia is linear. A ray that is not in its plane meets it at most
/// once.
template <class Shape>
concept Flat =
    std::same_as<decltype(potencia(std::declval<Shape>(), std::declval<Point<Linear<double>>>())), Linear<double>>;

/// Whether the shapes of a type are flat.
constexpr bool is_flat(model::Tipo tipo) {
  return scene::with_shape(tipo, []<class Shape>(std::type_identity<Shape>) { return Flat<Shape>; });
}

}  // namespace durero::surface
