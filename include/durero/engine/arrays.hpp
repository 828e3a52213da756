#pragma once
/// Rays and answers in plain arrays of the caller's, a number of every ray in each. Some tens of thousands of rays are
/// answered at a time, in memory that a call asks for once: none is asked for a single ray, but for one that needs
/// exact numbers or meets more elements at one point than a set keeps in place.

#include <array>
#include <cstddef>
#include <optional>
#include <span>

#include "durero/engine/engine.hpp"

namespace durero::engine {

/// Numbers of rays, which are read.
using Numbers = std::span<const double>;

/// Rays: at each place of these arrays, which are equally long, what is of one of them.
struct RayArrays {
  std::array<Numbers, 3> p;  ///< x, y and z of the origins
  std::array<Numbers, 3> v;  ///< of the directions, of any length but 0
  /// The element that each starts on, if it does; empty where none does. Whoever has rays that start on several asks by
  /// Query.
  std::span<const std::optional<scene::ElementRef>> start{};

  /// How many.
  std::size_t size() const noexcept { return p[0].size(); }
};

/// Where rays meet what they meet first: t and the point rounded once, 0 where none is hit.
struct PointArrays {
  std::span<double> t;                     ///< t!
  std::array<std::span<double>, 3> point;  ///< x, y and z of punto!
};

/// @{ As Engine has it, in the places of the rays. Throws std::invalid_argument, before anything is written, where the
/// arrays are not equally long; std::domain_error where a number is not finite, and contract_violation where a v is 0:
/// what is written then means nothing. Precondition: the elements that rays start on are in the scene.
void first_hits(const Engine& engine, const RayArrays& rays, std::span<trace::FirstElement> elements,
                const PointArrays& points);
void first_elements(const Engine& engine, const RayArrays& rays, std::span<trace::FirstElement> elements);
void occluded_segments(const Engine& engine, const RayArrays& rays, std::span<bool> occluded);
/// @}

}  // namespace durero::engine
