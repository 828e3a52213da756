#include "pov_turned.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "durero/io/pov/algebraic.hpp"
#include "pov_curve.hpp"

namespace durero::io {

using number::Rational;

namespace {

/// A distance from the axis, and a height.
struct TurnedPoint {
  double radius, height;
};

constexpr std::size_t most_points = 10'000'000;

std::vector<TurnedPoint> turned_points(PovWords& in, std::string_view word, std::size_t least) {
  const std::size_t at = in.offset();
  const double count = in.number(word);
  if (!(count >= double(least) && count <= double(most_points)))
    in.fail(at, fmt::format("{} of {} points", word, count), fmt::format("expected {} to 10,000,000", least));
  std::vector<TurnedPoint> all;
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    in.comma();
    const glm::dvec3 point = in.triple(word);
    all.push_back({point.x, point.y});
  }
  in.comma();
  return all;
}

glm::dvec3 on_axis(double height) { return {0, height, 0}; }

PovObject disc_of(std::size_t at, double height, double radius, double hole) {
  PovObject object{.at = at, .word = "disc"};
  object.shape = PovShape{scene::Disc{on_axis(height), radius, {0, 1, 0}}};
  object.shape->hole = hole;
  return object;
}

/// A line turned about the axis: part of a cone or a cylinder, or a disc. Precondition: both distances from the axis
/// are of one sign, and one of them is not 0.
PovObject turned_line(std::size_t at, const TurnedPoint& a, const TurnedPoint& b) {
  RoundEnd wide{on_axis(a.height), std::abs(a.radius)}, narrow{on_axis(b.height), std::abs(b.radius)};
  if (wide.radius < narrow.radius) std::swap(wide, narrow);
  if (a.height == b.height) return disc_of(at, a.height, wide.radius, narrow.radius);
  PovObject object{.at = at, .word = "cone"};
  object.shape = PovShape{scene::Cylinder{}};
  object.shape->ends = {wide, narrow};
  return object;
}

/// A part of a lathe, in parts of which none is a mere line on the axis; false where it has none.
bool add_turned(std::size_t at, const PovStretch& stretch, std::vector<PovObject>& parts) {
  if (!stretch.is_straight()) {
    PovObject object{.at = at, .word = "lathe"};
    object.element = PovElement{turned_curve, stretch.attributes(), stretch.is_rounded};
    parts.push_back(std::move(object));
    return true;
  }
  const auto ends = stretch.line();
  if (!ends) return false;
  const TurnedPoint a{(*ends)[0].x, (*ends)[0].y}, b{(*ends)[1].x, (*ends)[1].y};
  if ((a.radius < 0) != (b.radius < 0) && a.radius != 0 && b.radius != 0) return false;
  const bool is_point = a.radius == b.radius && a.height == b.height;
  if (!is_point && (a.radius != 0 || b.radius != 0)) parts.push_back(turned_line(at, a, b));
  return true;
}

std::optional<std::vector<PovObject>> lathe(PovWords& in, std::size_t at) {
  const PovCurveKind kind = take_curve_kind(in);
  in.comma();
  const std::size_t count_at = in.offset();
  std::vector<glm::dvec2> points;
  for (const TurnedPoint& point : turned_points(in, "lathe", least_points(kind)))
    points.emplace_back(point.radius, point.height);
  if (kind == PovCurveKind::bezier && points.size() % 4 != 0)
    in.fail(count_at, fmt::format("{} points of Bézier curves", points.size()), "expected four for each");
  std::vector<PovObject> parts;
  for (const PovStretch& stretch : stretches_of(kind, points))
    if (!add_turned(at, stretch, parts)) return std::nullopt;
  return parts;
}

/// The points of sor, whose first and last tell of slopes alone: those between ascend.
std::vector<TurnedPoint> points_of_sor(PovWords& in) {
  const std::size_t at = in.offset();
  std::vector<TurnedPoint> points = turned_points(in, "sor", 4);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i].radius < 0) in.fail(at, "a point of sor left of its axis", "expected radii of 0 or more");
    const bool is_shown = i > 1 && i + 1 < points.size();
    const bool has_slope = i < 2 || points[i].height != points[i - 2].height;
    if ((is_shown && points[i].height <= points[i - 1].height) || !has_slope)
      in.fail(at, "the points of sor do not ascend", "expected each to stand above the last one");
  }
  return points;
}

/// 2·r·dr/dy at the middle one of three points, whose slope is that from its neighbour below to the one above.
Rational slope_at(const TurnedPoint& below, const TurnedPoint& here, const TurnedPoint& above) {
  return 2 * number::exact(here.radius) * (number::exact(above.radius) - number::exact(below.radius)) /
         (number::exact(above.height) - number::exact(below.height));
}

/// The cubic that r² is of the height from p[1] to p[2], by its values and slopes there. Its space has p[1] at the
/// height 0 and p[2] at 1.
PovPiece cubic_piece(const TurnedPoint* p) {
  bool is_rounded = false;
  PovPiece piece;
  const Rational length = number::exact(p[2].height) - number::exact(p[1].height);
  piece.place.shift = on_axis(p[1].height);
  piece.place.linear[1][1] = number::round_to_binary64(length);
  piece.place.scale.reset();
  is_rounded = number::exact(piece.place.linear[1][1]) != length;
  const Rational from = number::exact(p[1].radius) * number::exact(p[1].radius),
                 to = number::exact(p[2].radius) * number::exact(p[2].radius);
  const Rational begin = length * slope_at(p[0], p[1], p[2]), end = length * slope_at(p[1], p[2], p[3]);
  const PovPolynomial u = PovPolynomial::coordinate(1);
  piece.equation = power(PovPolynomial::coordinate(0), 2) + power(PovPolynomial::coordinate(2), 2) - from -
                   PovPolynomial(begin) * u - PovPolynomial(Rational(3 * (to - from) - 2 * begin - end)) * power(u, 2) -
                   PovPolynomial(Rational(2 * (from - to) + begin + end)) * power(u, 3);
  piece.within = {u * u - u};
  piece.is_rounded = is_rounded;
  return piece;
}

std::vector<PovObject> sor(PovWords& in, std::size_t at) {
  const std::vector<TurnedPoint> points = points_of_sor(in);
  std::vector<PovObject> parts;
  for (std::size_t i = 0; i + 3 < points.size(); ++i) {
    PovObject wall{.at = at, .word = "sor"};
    wall.pieces = {cubic_piece(&points[i])};
    parts.push_back(std::move(wall));
  }
  if (in.take("open")) return parts;
  for (const TurnedPoint& end : {points[1], points[points.size() - 2]})
    if (end.radius != 0) parts.push_back(disc_of(at, end.height, end.radius, 0));
  return parts;
}

}  // namespace

std::optional<std::vector<PovObject>> read_pov_turned(PovWords& in, std::string_view word, std::size_t at) {
  return word == "lathe" ? lathe(in, at) : sor(in, at);
}

bool is_turned(std::string_view word) { return word == "lathe" || word == "sor"; }

}  // namespace durero::io
