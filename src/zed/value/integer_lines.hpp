#pragma once
/// An integer line is the function that gives slope · x + constant to each whole number x, or to each from a least one
/// on. Its pairs have no end, and yet it is decided in which sets of functions it is:
///   - its values are one number where the slope is 0, and else have no end: those from the value at the least number
///   on,
///     in steps of the slope, upwards or downwards; or both ways, where there is no least number;
///   - it gives one value twice where the slope is 0, and nowhere else;
///   - it has each whole number from some one on as a value only where the slope is 1 or, without a least number, −1.

#include <optional>

#include "zed/operators.hpp"
#include "zed/value/context.hpp"

namespace durero::zed {

/// A line with whole coefficients.
struct IntegerLine {
  std::optional<int> least{};  ///< it has a value at each whole number from this one on; at each, where there is none
  Real slope, constant;
};

/// A set that may be an integer line.
class LineSource {
 public:
  virtual ~LineSource() = default;
  /// Returns the line that it is; nothing where it is another set, or that is not known.
  virtual std::optional<IntegerLine> line(Context& context) const = 0;
};

/// Returns the line that a value is; nothing where it is none, or that is not known.
std::optional<IntegerLine> integer_line(const Value& value, Context& context);

/// Returns the line of values, each the value at this unknown in the place of a number from the least one on.
std::optional<IntegerLine> line_through(const Value& at_unknown, Unknown unknown, std::optional<int> least);

/// Says whether the line is in the set that an arrow makes between two sets. Nothing where that is not known.
std::optional<Truth> line_is_in(const IntegerLine& line, const Value& from, const Value& to, const Arrow& arrow,
                                Context& context);

/// Makes the function that the line is.
Value line_function(const IntegerLine& line);

/// Returns a few lines of small coefficients.
std::vector<IntegerLine> small_lines(std::optional<int> least);

}  // namespace durero::zed
