#pragma once
/// The finding of a step on one ray and one element.

#include <cstdint>
#include <glm/vec3.hpp>
#include <limits>

namespace durero::trace {

/// A ray misses an element or hits it, or the step cannot tell.
enum class Decision : std::uint8_t { miss, hit, undecided };

/// A·t + B at the root and A, each with its error: half the slope and half the curvature of the quadratic, for Newton's
/// step.
struct Slope {
  double at_root = 0, at_root_error = 0;  ///< A·t + B, and the bound on its error
  double A = 0, A_error = 0;              ///< A, and the bound on its error
};

/// The first point of the ray on the element is within `error` of the parameter t = hi + lo (lo = 0 from the triage).
struct RootEstimate {
  Decision verdict;       ///< the numbers mean something for a hit
  double hi = 0, lo = 0;  ///< t = hi + lo
  double error = 0;       ///< absolute
  Slope slope{};          ///< by the triage
};

/// t and each coordinate of p + t·v rounded once; certain only if every number within the error rounds to the same.
struct RoundedPoint {
  bool certain = false;  ///< where false, the numbers mean nothing
  double t = 0;          ///< t!
  glm::dvec3 punto{};    ///< punto!
};

/// The limit of a ray without a limit.
inline constexpr double no_limit = std::numeric_limits<double>::infinity();

}  // namespace durero::trace
