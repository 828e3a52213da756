#pragma once
/// The points of a surface that a ray may meet where numbers are off: those of the surface, the origin and the way.
///
/// A condition that is evaluated at a point which moves with s has formulas in s, each with its spread: x of a Formula
/// stands for s. Over a stretch of s each formula lies between two numbers, whatever the errors are: its exact part, as
/// Taylor's form about the middle of the stretch bounds it, and its spread, as the magnitudes of its coefficients do.

#include "durero/written/formula.hpp"

namespace durero::written {

/// A point at + s·step. Each coordinate of it is off by off + s·off_by_step at most, which is not negative.
struct MovedPoint {
  std::array<number::Rational, 3> at;    ///< where it is at s = 0
  std::array<number::Rational, 3> step;  ///< how far it goes for each s
  number::Rational off;                  ///< the greatest error of a coordinate at s = 0
  number::Rational off_by_step;          ///< what is added to that for each s
};

/// A stretch of s, both ends of which belong to it.
struct MovedStretch {
  number::Rational begin;  ///< the least s
  number::Rational end;    ///< the greatest s
};

/// The points of a set, by the condition that they satisfy, on the way of a point.
class MovedPoints {
 public:
  /// The points that satisfy the condition, whose formulas are in x alone.
  explicit MovedPoints(Condition condition) : condition_(std::move(condition)) {}

  /// Whether some errors may put a point into the stretch. False is certain.
  bool may_be_within(const MovedStretch& stretch) const;
  /// Whether some errors may put a point at an s that is no less. False is certain. Precondition: from > 0.
  bool may_be_from(const number::Rational& from) const;
  /// Whether there is a point in the stretch whatever the errors are: an equation has opposite signs at its ends, and
  /// all that stands beside it is true between them. True is certain.
  bool is_certain_within(const MovedStretch& stretch) const;
  /// About how far from s = 0 the nearest such stretch reaches, if an equation is nearly linear there; 0 where no
  /// equation says.
  double rough_reach() const;
  /// The greatest number of points in the stretch, of a line that does not lie in the surface: of each equation one,
  /// where its slope has one sign there whatever the errors are, and otherwise its degree.
  std::size_t most_within(const MovedStretch& stretch) const;

 private:
  Condition condition_;
};

}  // namespace durero::written
