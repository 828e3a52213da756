#pragma once
/// The curves of a POV-Ray text that stand in a plane: the outlines of lathe and prism.

#include <array>
#include <glm/vec2.hpp>
#include <optional>
#include <string_view>
#include <vector>

#include "durero/number/rational.hpp"
#include "pov_words.hpp"
#include "pov_written.hpp"

namespace durero::io {

/// How an outline goes from point to point.
enum class PovCurveKind { linear, quadratic, cubic, bezier };

/// Passes the word of a kind; linear where none stands here.
PovCurveKind take_curve_kind(PovWords& in);

/// A stretch of a curve: its two coordinates are polynomials of a parameter from 0 to 1. The coefficients ascend.
struct PovStretch {
  std::array<glm::dvec2, 4> coefficients{};
  bool is_rounded = false;

  /// Whether it is part of a line, or a point.
  bool is_straight() const;
  /// Both ends of a straight one, where it goes from one to the other without turning; nothing otherwise.
  std::optional<std::array<glm::dvec2, 2>> line() const;
  /// The attributes that hold its coefficients, `r_0` to `r_3` and `h_0` to `h_3`.
  ValuesByWord attributes() const;
};

/// The fewest points of a curve of that kind.
std::size_t least_points(PovCurveKind kind);

/// The stretches of a curve by its points; those of a Bézier curve are four for each. Precondition: there are
/// least_points(kind) of them.
std::vector<PovStretch> stretches_of(PovCurveKind kind, const std::vector<glm::dvec2>& points);

}  // namespace durero::io
