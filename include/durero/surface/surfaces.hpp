#pragma once
/// The surface of every shape of scene::Shapes.

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

/// A shape that has all that a surface is asked for; one that lacks a part does not compile.
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

/// A shape whose potencia is linear: a plane, or part of one. A ray that is not in its plane meets it at most once.
template <class Shape>
concept Flat =
    std::same_as<decltype(potencia(std::declval<Shape>(), std::declval<Point<Linear<double>>>())), Linear<double>>;

/// Whether shapes of the type are.
constexpr bool is_flat(model::Tipo tipo) {
  return scene::with_shape(tipo, []<class Shape>(std::type_identity<Shape>) { return Flat<Shape>; });
}

}  // namespace durero::surface
