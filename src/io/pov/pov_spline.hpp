#pragma once
/// The splines of POV-Ray's language: vectors at numbers, and what lies between them.

#include <optional>
#include <string_view>
#include <vector>

#include "pov_expression.hpp"

namespace durero::io {

/// How a spline goes from vector to vector.
enum class PovSplineKind { linear, quadratic, cubic, natural };

/// The kind of a word such as `cubic_spline`.
std::optional<PovSplineKind> pov_spline_kind(std::string_view word);

/// A spline of two numbers or more. Its values are POV-Ray's, in binary64.
class PovSpline {
 public:
  PovSplineKind kind = PovSplineKind::linear;

  /// Puts a vector at a number, in the place of one that is there.
  void put(double at, const PovNumbers& value);
  /// How many there are.
  std::size_t size() const noexcept { return points_.size(); }
  /// The value at a number, by that kind. Before the first vector and behind the last it is theirs; a cubic one needs
  /// those for its slopes, and ends at their neighbours. Precondition: size() > 0.
  PovNumbers value(double at, PovSplineKind by) const;

 private:
  struct Point {
    double at;
    PovNumbers value;
  };
  double component(double at, PovSplineKind by, std::size_t i) const;

  std::vector<Point> points_{};  ///< ascending
  std::size_t width_ = 2;        ///< of the widest value
};

}  // namespace durero::io
