#pragma once
/// A set of points of a ray, by their parameters: what makes the questions of spec/interseccion.tex decidable. Along a
/// ray the power of a point is a polynomial of degree at most two, so a surface meets it in at most two points, or in
/// one interval where the ray runs inside the surface.

#include <optional>
#include <vector>

#include "durero/model/exact_point.hpp"
#include "durero/model/quadratic.hpp"

namespace durero::model {

/// The parameters from a first one to a last one that belongs to it; without a last one, all that are greater.
struct Interval {
  Surd first;                ///< the lower bound
  bool has_first;            ///< false: `first` itself is not one of them
  std::optional<Surd> last;  ///< the upper bound, which is one of them; nothing where there is none
};

/// { t > 0 | q(t) = 0 ∧ t is in the stretch }: finitely many parameters, or an interval of them.
struct Parameters {
  std::vector<Surd> points;          ///< ascending, each > 0
  std::optional<Interval> interval;  ///< where q = 0 for every t; `points` is then empty

  /// Whether there is no such parameter.
  bool is_empty() const { return points.empty() && !interval; }
  /// t ∈ this set.
  bool contains(const Surd& t) const;
  /// The least parameter; nothing where the set is empty, or is an interval without its first one.
  std::optional<Surd> minimum() const;
  /// Whether some parameter is less than the bound. Precondition: bound > 0.
  bool any_below(const Surd& bound) const;
};

/// { t | t > 0 }
inline Interval all_positive() { return {0, false, std::nullopt}; }

/// { t > 0 | q(t) ≥ 0 }; nothing where there are none. (Interval.first is 0 and not one of them where q bounds t > 0 on
/// no left side.) Precondition: q is concave, q.a ≤ 0.
std::optional<Interval> not_negative(const RationalQuadratic& q);

/// The parameters of both; nothing where there are none.
std::optional<Interval> intersection(const Interval& a, const Interval& b);

/// { t | q(t) = 0 } inside the interval.
Parameters zeros(const RationalQuadratic& q, const Interval& interval);

}  // namespace durero::model
