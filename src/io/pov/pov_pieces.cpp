#include "pov_pieces.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>

namespace durero::io {

using number::Rational;

namespace {

PovPolynomial coordinate(std::size_t axis) { return PovPolynomial::coordinate(axis); }
/// u² − u, which is above 0 outside of 0 … 1.
PovPolynomial between_ends(std::size_t axis) { return coordinate(axis) * coordinate(axis) - coordinate(axis); }
PovPolynomial squared_radius() { return power(coordinate(0), 2) + power(coordinate(2), 2); }
PovPolynomial squared_length() { return squared_radius() + power(coordinate(1), 2); }

/// A space in which a thing has simple numbers, and whether rounding has moved it.
struct PovSpace {
  PovTransform place{};
  bool is_rounded = false;
};

PovSpace space_of(const glm::dmat3& axes, const glm::dvec3& origin, bool is_rounded) {
  PovTransform place;
  place.linear = axes;
  place.shift = origin;
  place.scale.reset();
  return {place, is_rounded};
}

/// A ball of radius 1 about the origin.
PovSpace space_of_ball(const glm::dvec3& center, double radius) { return space_of(glm::dmat3(radius), center, false); }

/// b − a, and whether that is rounded.
glm::dvec3 difference(const glm::dvec3& b, const glm::dvec3& a, bool& is_rounded) {
  const glm::dvec3 way = b - a;
  for (int i = 0; i < 3; ++i)
    if (number::exact(way[i]) != number::exact(b[i]) - number::exact(a[i])) is_rounded = true;
  return way;
}

/// The box from the origin to (1, 1, 1).
PovSpace space_of_box(const std::array<glm::dvec3, 2>& box) {
  bool is_rounded = false;
  const glm::dvec3 way = difference(box[1], box[0], is_rounded);
  return space_of(glm::dmat3(way.x, 0, 0, 0, way.y, 0, 0, 0, way.z), box[0], is_rounded);
}

/// The space about an axis, which goes from the origin to (0, 1, 0); at its beginning the radius is 1. Nothing where
/// the ends give no axis.
std::optional<PovSpace> space_about(const std::array<RoundEnd, 2>& ends) {
  bool is_rounded = false;
  const glm::dvec3 way = difference(ends[1].at, ends[0].at, is_rounded);
  const auto axis = axis_between(glm::dvec3(0), way);
  if (!axis) return std::nullopt;
  const glm::dvec3& d = axis->vector;
  const glm::dvec3 size = glm::abs(d);
  // Across the axis stands what it makes with the coordinate along which it is shortest. Both are exact along one.
  const int least = size.x <= size.y && size.x <= size.z ? 0 : size.y <= size.z ? 1 : 2;
  glm::dvec3 beside(0);
  beside[least] = 1;
  const glm::dvec3 x = glm::normalize(glm::cross(d, beside)), z = glm::cross(x, d);
  if ((d.x != 0) + (d.y != 0) + (d.z != 0) > 1) is_rounded = true;
  return space_of(glm::dmat3(ends[0].radius * x, way, ends[0].radius * z), ends[0].at, is_rounded);
}

/// x² + z² − (1 + (k − 1)·y)², for a narrow radius that is k of the wide one.
PovPolynomial wall(const std::array<RoundEnd, 2>& ends) {
  const Rational k = number::exact(ends[1].radius) / number::exact(ends[0].radius);
  return squared_radius() - power(PovPolynomial(1.0) + PovPolynomial(Rational(k - 1)) * coordinate(1), 2);
}

/// The wall about an axis, and its two discs where it is closed.
std::optional<std::vector<PovPiece>> round_pieces(const PovShape& shape) {
  const auto& ends = *shape.ends;
  if (!(ends[0].radius > 0)) return std::nullopt;
  const auto space = space_about(ends);
  if (!space) return std::nullopt;
  const auto piece = [&](PovPolynomial equation, PovPolynomial within) {
    return PovPiece{std::move(equation), {std::move(within)}, space->place, space->is_rounded};
  };
  std::vector<PovPiece> all{piece(wall(ends), between_ends(1))};
  if (!shape.is_closed) return all;
  const Rational k = number::exact(ends[1].radius) / number::exact(ends[0].radius);
  all.push_back(piece(coordinate(1), squared_radius() - 1.0));
  if (k != 0) all.push_back(piece(coordinate(1) - 1.0, squared_radius() - Rational(k * k)));
  return all;
}

/// n·w − d.
PovPolynomial plane_of(const glm::dvec3& normal, double distance) {
  PovPolynomial sum = PovPolynomial() - distance;
  for (std::size_t i = 0; i < 3; ++i) sum = sum + PovPolynomial(normal[static_cast<int>(i)]) * coordinate(i);
  return sum;
}

PovPiece piece_of(const scene::Disc& disc, double hole) {
  PovPiece piece{plane_of(disc.vector, 0), {squared_length() - power(disc.radio, 2)}};
  if (hole != 0) piece.within.push_back(power(PovPolynomial(hole), 2) - squared_length());
  piece.place.shift = disc.centro;
  return piece;
}

/// Its six faces.
std::vector<PovPiece> pieces_of_box(const std::array<glm::dvec3, 2>& box) {
  const PovSpace space = space_of_box(box);
  std::vector<PovPiece> all;
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const double side : {0.0, 1.0})
      all.push_back({coordinate(axis) - side,
                     {between_ends((axis + 1) % 3), between_ends((axis + 2) % 3)},
                     space.place,
                     space.is_rounded});
  return all;
}

std::optional<std::vector<PovPiece>> pieces_of_shape(const PovShape& shape) {
  if (shape.ends) return round_pieces(shape);
  if (const auto* const sphere = std::get_if<scene::Sphere>(&shape.surface))
    return std::vector{PovPiece{squared_length() - 1.0, {}, space_of_ball(sphere->centro, sphere->radio).place}};
  if (const auto* const plane = std::get_if<scene::Plane>(&shape.surface))
    return std::vector{PovPiece{plane_of(plane->vector, shape.distance.value_or(0))}};
  if (const auto* const disc = std::get_if<scene::Disc>(&shape.surface))
    return std::vector{piece_of(*disc, shape.hole)};
  return std::nullopt;
}

}  // namespace

std::vector<PovClip> faces_of_box(const std::array<glm::dvec3, 2>& box) {
  std::vector<PovClip> all;
  for (PovPiece& face : pieces_of_box(box))
    all.push_back({{std::move(face.equation), face.within[0], face.within[1]}, false, face.place, face.is_rounded});
  return all;
}

PovClip inside_of_box(const std::array<glm::dvec3, 2>& box) {
  const PovSpace space = space_of_box(box);
  return {{between_ends(0), between_ends(1), between_ends(2)}, false, space.place, space.is_rounded};
}

PovClip inside_of_ball(const scene::Sphere& ball) {
  return {{squared_length() - 1.0}, false, space_of_ball(ball.centro, ball.radio).place};
}

std::optional<std::vector<PovPiece>> pieces_of(const PovObject& object) {
  if (!object.pieces.empty()) return object.pieces;
  if (object.box) return pieces_of_box(*object.box);
  if (object.shape) return pieces_of_shape(*object.shape);
  if (object.surface) return std::vector{PovPiece{object.surface->polynomial}};
  return std::nullopt;
}

namespace {

/// The inside of one object, before its transformations.
std::optional<PovClip> own_clip(const PovObject& object) {
  const auto clip = [](std::vector<PovPolynomial> within, PovSpace space) {
    return PovClip{std::move(within), false, space.place, space.is_rounded};
  };
  if (object.box) return inside_of_box(*object.box);
  if (object.surface && object.surface->polynomial.degree() <= 2) return clip({object.surface->polynomial}, {});
  if (!object.shape) return std::nullopt;
  const PovShape& shape = *object.shape;
  if (shape.ends) {
    const auto space = (*shape.ends)[0].radius > 0 ? space_about(*shape.ends) : std::nullopt;
    return space ? std::optional(clip({wall(*shape.ends), between_ends(1)}, *space)) : std::nullopt;
  }
  if (const auto* const sphere = std::get_if<scene::Sphere>(&shape.surface)) return inside_of_ball(*sphere);
  if (const auto* const plane = std::get_if<scene::Plane>(&shape.surface))
    return clip({plane_of(plane->vector, shape.distance.value_or(0))}, {});
  return std::nullopt;
}

/// The points outside of a clip. Of one polynomial that is where its opposite is not above 0, but for the surface
/// itself.
PovClip turned_out(PovClip clip) {
  if (clip.within.size() == 1)
    clip.within.front() = PovPolynomial() - clip.within.front();
  else
    clip.is_outside = !clip.is_outside;
  return clip;
}

std::optional<PovClip> clip_of(const PovObject& object) {
  if (object.is_left_out || object.is_clipped()) return std::nullopt;
  const bool is_holder = object.word == "object" || object.word == "intersection" ||
                         (object.parts.size() == 1 && (object.word == "union" || object.word == "merge"));
  auto clip = is_holder && !object.parts.empty() ? clip_by(object.parts) : own_clip(object);
  if (!clip) return std::nullopt;
  clip->place = clip->place.then(object.moved);
  if (!object.moved.is_identity() && clip->within.size() > 0) clip->is_rounded = true;
  return object.is_inverse ? turned_out(*std::move(clip)) : clip;
}

bool is_same_place(const PovTransform& a, const PovTransform& b) { return a.linear == b.linear && a.shift == b.shift; }

/// The most quadrics of a clip.
constexpr std::size_t most_quadrics = 3;

}  // namespace

std::optional<PovClip> common_clip(const std::vector<PovClip>& clips) {
  if (clips.size() == 1) return clips.front();
  PovClip common;
  const bool is_one_place =
      std::ranges::all_of(clips, [&](const PovClip& c) { return is_same_place(c.place, clips.front().place); });
  if (is_one_place) common.place = clips.front().place;
  for (const PovClip& clip : clips) {
    if (clip.is_outside || !has_way_back(clip.place)) return std::nullopt;
    common.is_rounded = common.is_rounded || clip.is_rounded;
    for (const PovPolynomial& each : clip.within)
      common.within.push_back(is_one_place ? each : moved(each, clip.place));
  }
  return common.within.size() <= most_quadrics ? std::optional(std::move(common)) : std::nullopt;
}

std::optional<PovClip> clip_by(const std::vector<PovObject>& objects) {
  std::vector<PovClip> all;
  for (const PovObject& object : objects) {
    auto clip = clip_of(object);
    if (!clip) return std::nullopt;
    all.push_back(*std::move(clip));
  }
  return all.empty() ? std::nullopt : common_clip(all);
}

}  // namespace durero::io
