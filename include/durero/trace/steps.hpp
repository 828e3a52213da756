#pragma once
/// The steps by which the tracer decides: triage (binary64 with a bound), stable (double-double with a bound), exact
/// (surface::exact). Each says hit or miss of one element only where it has proved it; what a step leaves undecided
/// goes to the next, and the last leaves nothing. quadratic-inl.hpp holds the forms and their bounds.

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <limits>

#include "durero/model/tipos.hpp"
#include "durero/scene/shapes.hpp"

namespace durero::trace {

enum class Step : std::uint8_t { triage, stable, exact };

/// How many decisions of each kind each step made. A plain value: every thread counts in its own, and adds.
struct Counts {
  using Steps = std::array<std::uint64_t, 3>;  ///< by Step
  Steps element{};                             ///< whether and where the ray first meets an element (after the filter)
  Steps order{};                               ///< which of several elements is the nearest: by the last step needed
  Steps rounding{};                            ///< t and point of a hit, rounded once

  Counts& operator+=(const Counts& other);
  bool operator==(const Counts&) const = default;
};

/// The ray in the numbers the steps use.
struct Beam {
  explicit Beam(const model::Rayo& rayo);

  glm::dvec3 p, v;
  double speed;           ///< V ≥ |v|
  double length_squared;  ///< |v|², greater by 60u to 80u
  double length;          ///< |v|, greater by 30u to 40u
  double allowance;       ///< 16u·(|p.x| + |p.y| + |p.z|), for the filter (tables.hpp)
  bool ordinary;          ///< every component is 0 or of magnitude 2⁻¹⁰⁰ … 2¹⁰⁰
};

/// Every number of the element is 0 or of magnitude 2⁻¹⁰⁰ … 2¹⁰⁰: the bounds hold, nothing over- or underflows.
bool ordinary(const scene::Sphere& sphere) noexcept;
bool ordinary(const scene::Cylinder& cylinder) noexcept;
bool ordinary(const scene::Cone& cone) noexcept;

enum class Verdict : std::uint8_t { miss, hit, undecided };

/// A·t + B at the root and A, each with its error: half the slope and curvature of the quadratic, to improve t with.
struct Slope {
  double at_root = 0, at_root_error = 0;
  double A = 0, A_error = 0;
};

/// The first point of the ray on one element is within `error` of the parameter t = hi + lo (lo = 0 from the triage).
struct Finding {
  Verdict verdict;
  double hi = 0, lo = 0;
  double error = 0;
  Slope slope{};  ///< by the triage
};

inline constexpr double no_limit = std::numeric_limits<double>::infinity();

/// The first point of the ray on the element, or a miss: no point at all, or none at a parameter ≤ limit.
/// on: the ray starts on the element. Precondition: element and beam are ordinary.
Finding triage(const scene::Sphere& sphere, const Beam& beam, bool on, double limit = no_limit);
Finding triage(const scene::Cylinder& cylinder, const Beam& beam, bool on, double limit = no_limit);
Finding triage(const scene::Cone& cone, const Beam& beam, bool on, double limit = no_limit);

/// The same in double-double.
Finding stable(const scene::Sphere& sphere, const Beam& beam, bool on, double limit = no_limit);
Finding stable(const scene::Cylinder& cylinder, const Beam& beam, bool on, double limit = no_limit);
Finding stable(const scene::Cone& cone, const Beam& beam, bool on, double limit = no_limit);

/// A finding of the triage improved by one step of Newton's, the quadratic taken in double-double; undecided where the
/// slope may be 0. Precondition: the finding is a hit of this element by triage, for the same `on`.
Finding improved(const scene::Sphere& sphere, const Beam& beam, bool on, const Finding& finding);
Finding improved(const scene::Cylinder& cylinder, const Beam& beam, bool on, const Finding& finding);
Finding improved(const scene::Cone& cone, const Beam& beam, bool on, const Finding& finding);

/// t and each coordinate of p + t·v rounded once; certain only if every number within the error rounds the same.
struct Rounded {
  bool certain = false;
  double t = 0;
  glm::dvec3 punto{};
};
/// Precondition: the finding is a hit by stable or improved.
Rounded rounded(const Beam& beam, const Finding& finding);

}  // namespace durero::trace
