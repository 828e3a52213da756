#pragma once
/// The surface of every shape of scene::Shapes.

#include <concepts>
#include <tuple>

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

}  // namespace durero::surface
