#pragma once
/// Rays and answers in the caller's plain arrays, one number of every ray in each. Some tens of thousands of rays are
/// answered at a time, in memory that is allocated once a call. A single ray allocates only where it needs exact
/// numbers, or meets more elements at one point than a set keeps in place.

#include <array>
#include <cstddef>
#include <optional>
#include <span>

#include "durero/engine/engine.hpp"

namespace durero::engine {

/// A number of every ray, read only.
using Numbers = std::span<const double>;

/// Rays as columns of equal length.
struct RayArrays {
  std::array<Numbers, 3> p;  ///< x, y and z of the origins
  std::array<Numbers, 3> v;  ///< x, y and z of the directions, whose length is not 0
  /// The element that each ray starts on, or nothing; empty where no ray starts on one. A ray that starts on several
  /// elements needs a Query.
  std::span<const std::optional<scene::ElementRef>> start{};

  /// The number of rays.
  std::size_t size() const noexcept { return p[0].size(); }
};

/// The first points of rays: t and the point, rounded once; 0 where the ray has no hit.
struct PointArrays {
  std::span<double> t;                     ///< t!
  std::array<std::span<double>, 3> point;  ///< x, y and z of punto!
};

/// @{ The functions of Engine, with each answer in its ray's place. Throws std::invalid_argument, before anything is
/// written, where the arrays differ in length; std::domain_error where a number is not finite, and contract_violation
/// where a v is 0: the arrays of answers mean nothing then. Precondition: the elements that rays start on are in the
/// scene.
void first_hits(const Engine& engine, const RayArrays& rays, std::span<trace::FirstElement> elements,
                const PointArrays& points);
void first_elements(const Engine& engine, const RayArrays& rays, std::span<trace::FirstElement> elements);
void occluded_segments(const Engine& engine, const RayArrays& rays, std::span<bool> occluded);
/// @}

}  // namespace durero::engine
