#pragma once
/// Numbers moved by no more than the declared backward error, at random and to the corners of what is allowed. Of the
/// judge's code nothing is used: what it allows is said here once more.

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <string_view>

#include "durero/conform/ask/profile.hpp"
#include "durero/conform/families/asked_body.hpp"
#include "durero/conform/random.hpp"
#include "durero/model/tipos.hpp"
#include "durero/scene/attributes.hpp"
#include "support/shapes.hpp"

namespace durero::test {

inline double narrowed(double x, conform::NumberFormat format) {
  return format == conform::NumberFormat::binary32 ? static_cast<double>(static_cast<float>(x)) : x;
}

/// @{ Each number rounded to the format.
inline glm::dvec3 narrowed(const glm::dvec3& v, conform::NumberFormat format) {
  return {narrowed(v.x, format), narrowed(v.y, format), narrowed(v.z, format)};
}
inline scene::Corners narrowed(const scene::Corners& c, conform::NumberFormat format) {
  return {narrowed(c[0], format), narrowed(c[1], format), narrowed(c[2], format)};
}
inline conform::AskedBody narrowed(conform::AskedBody body, conform::NumberFormat format) {
  body.centro = narrowed(body.centro, format);
  for (glm::dvec3& side : body.sides) side = narrowed(side, format);
  body.radio = narrowed(body.radio, format);
  return body;
}
template <class Shape>
  requires requires { Shape::word; }
Shape narrowed(Shape shape, conform::NumberFormat format) {
  scene::for_each_attribute<Shape>(
      [&](const auto& attribute) { shape.*attribute.field = narrowed(shape.*attribute.field, format); });
  return shape;
}
/// @}

inline double longest(const glm::dvec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }
/// The largest of its coordinates and lengths.
template <class Shape>
double longest(const Shape& shape) {
  double most = 0;
  if constexpr (requires { shape.vertices; })
    for (const glm::dvec3& corner : shape.vertices) most = std::max(most, longest(corner));
  if constexpr (requires { shape.centro; }) most = longest(shape.centro);
  if constexpr (requires { shape.radio; }) most = std::max(most, shape.radio);
  if constexpr (requires { shape.altura; }) most = std::max(most, shape.altura);
  return most;
}

inline double longest(const conform::AskedBody& body) {
  const auto& [x, y, z] = body.sides;
  return std::max({longest(body.centro), longest(x), longest(y), longest(z), body.radio});
}

/// Whether the model has such a shape, its unit vector aside.
inline bool is_shape(const scene::Triangle& e) {
  return model::Vertices::contains(
      {model::Punto(e.vertices[0]), model::Punto(e.vertices[1]), model::Punto(e.vertices[2])});
}
inline bool is_shape(const conform::AskedBody& body) { return conform::is_body(body); }
template <class Shape>
bool is_shape(const Shape& shape) {
  bool is = std::isfinite(longest(shape.centro));
  if constexpr (requires { shape.radio; }) is = is && model::Rmas::contains(shape.radio);
  if constexpr (requires { shape.altura; }) is = is && model::Rmas::contains(shape.altura);
  if constexpr (requires { shape.proporcion; }) is = is && model::Rmas::contains(shape.proporcion);
  return is;
}

/// How numbers are moved: anywhere, all to an end of what is allowed, or one in six to such an end.
enum class Draw { anywhere, ends, one };

/// Moves numbers by parts of what is allowed, less the rounding of the sum that each is for.
class Mover {
 public:
  Mover(conform::Random& random, conform::NumberFormat format, Draw draw, double thickness = 0, double error = 16)
      : random_(&random),
        draw_(draw),
        u_(error / 16 * (format == conform::NumberFormat::binary32 ? 0x1p-20 : 0x1p-49)),
        thickness_(thickness) {}

  /// Where M is the largest magnitude.
  template <class Shape>
  Shape moved(const Shape& shape, double M) {
    Shape result = shape;
    scene::for_each_attribute<Shape>([&](const auto& attribute) { move(attribute.word, result.*attribute.field, M); });
    return result;
  }
  /// A side is moved as a point is, or its axis and its length apart. A capsule stays round.
  conform::AskedBody moved(conform::AskedBody body, double M) {
    move(body.centro, u_ * M + thickness_);
    const bool by_length = random_->chance(1, 2);
    for (glm::dvec3& side : body.sides) move_side(side, by_length, M);
    if (conform::has_radius(body.kind)) move(body.radio, u_ * M + thickness_);
    if (body.kind == conform::BodyKind::toro) {
      const glm::dvec3 along = body.sides[0] / conform::length_of(body.sides[0]);
      const glm::dvec3 z = body.sides[2] - glm::dot(body.sides[2], along) * along;
      body.sides[2] = conform::length_of(body.sides[0]) / conform::length_of(z) * z;
    }
    if (body.kind == conform::BodyKind::capsula) {
      const double radio = conform::length_of(body.sides[0]);
      const glm::dvec3 along = body.sides[1] / conform::length_of(body.sides[1]);
      const glm::dvec3 x = body.sides[0] - glm::dot(body.sides[0], along) * along;
      body.sides[0] = radio / conform::length_of(x) * x;
      body.sides[2] = glm::cross(body.sides[0], along);
    }
    return body;
  }
  glm::dvec3 moved_point(glm::dvec3 p, double M) {
    move(p, u_ * M + thickness_);
    return p;
  }
  glm::dvec3 moved_direction(glm::dvec3 v) {
    move(v, u_ * longest(v));
    return v;
  }

 private:
  void move_side(glm::dvec3& side, bool by_length, double M) {
    if (!by_length) return move(side, u_ * M + thickness_);
    double length = conform::length_of(side);
    glm::dvec3 axis = side / length;
    move(axis, u_);
    move(length, u_ * M + thickness_);
    side = length * axis;
  }
  double part() {
    switch (draw_) {
      case Draw::anywhere:
        return random_->uniform(-0.875, 0.875);
      case Draw::ends:
        return 0.875 * random_->sign();
      case Draw::one:
        return random_->chance(1, 6) ? 0.875 * random_->sign() : 0;
    }
    return 0;
  }
  void move(double& x, double by) { x += part() * by; }
  void move(glm::dvec3& v, double by) {
    for (int i = 0; i < 3; ++i) move(v[i], by);
  }
  void move(std::string_view word, double& x, double M) {
    move(x, word == "proporcion" ? u_ * std::max(1.0, x) : u_ * M + thickness_);
  }
  void move(std::string_view word, glm::dvec3& v, double M) { move(v, word == "vector" ? u_ : u_ * M + thickness_); }
  void move(std::string_view, scene::Corners& corners, double M) {
    for (glm::dvec3& corner : corners) move(corner, u_ * M + thickness_);
  }

  conform::Random* random_;
  Draw draw_;
  double u_, thickness_;
};

}  // namespace durero::test
