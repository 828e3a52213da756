#pragma once
/// Data off by no more than the declared backward error, drawn at random and at the corners of what is allowed, and
/// their exact answer. Of the judge's code nothing is used: what it allows is said here once more.

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <string_view>

#include "durero/conform/claim.hpp"
#include "durero/conform/profile.hpp"
#include "durero/conform/suite.hpp"
#include "durero/scene/attributes.hpp"
#include "durero/surface/exact.hpp"
#include "support/shapes.hpp"

namespace durero::test {

/// A case whose truths are the exact hits.
inline conform::SuiteCase answered(const conform::Family& family, conform::Case the_case) {
  conform::SuiteCase of{.family = &family, .the_case = std::move(the_case)};
  for (const scene::Query& query : of.the_case.rays)
    of.truths.push_back({.hit = surface::exact::first_hit(of.the_case.scene, query.rayo, query.en)});
  return of;
}

/// Of every type, in that format, with names.
inline conform::Profile wide_profile(conform::Format format) {
  conform::Profile profile;
  profile.format = format;
  for (std::size_t i = 0; i < model::tipo_count; ++i) profile.tipos.push_back(static_cast<model::Tipo>(i));
  return profile;
}

inline double narrowed(double x, conform::Format format) {
  return format == conform::Format::binary32 ? static_cast<double>(static_cast<float>(x)) : x;
}

/// How a number may be moved: anywhere, or to an end of what is allowed.
enum class Draw { anywhere, ends, one };

class Perturbation {
 public:
  Perturbation(std::uint64_t seed, conform::Format format)
      : random_(seed), u_(format == conform::Format::binary32 ? 0x1p-20 : 0x1p-49), format_(format) {}

  /// The claim that is the exact answer of moved data; nothing where the draw left no element or ray, or left what is
  /// allowed since its answer lies before the distance that it was drawn for.
  std::optional<conform::Claim> answer(const scene::Scene& scene, const scene::Query& query, double t,
                                       conform::Measure measure) {
    draw_ = static_cast<Draw>(random_.below(3));
    std::optional<Nearest> nearest;
    bool is_whole = true;
    scene.for_each([&](scene::ElementRef element, const auto& shape) {
      auto moved = shape;
      const glm::dvec3 &p = query.rayo.p().xyz(), &v = query.rayo.v().xyz();
      const double M = std::max({longest(shape), longest(p), t * longest(v)});
      scene::for_each_attribute<std::decay_t<decltype(shape)>>(
          [&](const auto& attribute) { move(attribute.word, moved.*attribute.field, M); });
      glm::dvec3 from = p, along = v;
      move(from, u_ * M);
      move(along, u_ * longest(v));
      is_whole = is_whole && is_shape(moved) && along != glm::dvec3(0) && std::isfinite(longest(from));
      if (!is_whole) return;
      const model::Rayo rayo = ray(from, along);
      const surface::exact::Reach reach = surface::exact::reach(moved, rayo);
      if (reach.empty() || reach.no_minimum()) return;
      if (!nearest || surface::exact::order(reach.first(), nearest->t) < 0)
        nearest = Nearest{element, rayo, reach.first()};
    });
    if (!is_whole) return std::nullopt;
    if (!nearest) return conform::Claim{.outcome = conform::Claim::Outcome::miss};
    return claim_of(*nearest, t, measure);
  }

  /// The same of triangles alone where vertices that they share move together, and the ray is one for all: each vertex
  /// by as much as each of its triangles allows, or, where M is given, by that much for all.
  std::optional<conform::Claim> answer_of_mesh(const scene::Scene& scene, const scene::Query& query,
                                               std::optional<double> M = {}) {
    draw_ = static_cast<Draw>(random_.below(3));
    const glm::dvec3 &p = query.rayo.p().xyz(), &v = query.rayo.v().xyz();
    using Key = std::array<double, 3>;
    const auto key = [](const glm::dvec3& vertex) { return Key{vertex.x, vertex.y, vertex.z}; };
    std::map<Key, double> allowed;
    double least = std::numeric_limits<double>::infinity();
    for (const scene::Triangle& triangle : scene.shapes<scene::Triangle>()) {
      const double of_triangle = M.value_or(std::max(longest(triangle), longest(p)));
      least = std::min(least, of_triangle);
      for (const glm::dvec3& vertex : triangle.vertices) {
        double& most = allowed.try_emplace(key(vertex), of_triangle).first->second;
        most = std::min(most, of_triangle);
      }
    }
    std::map<Key, glm::dvec3> moved;
    for (const auto& [vertex, most] : allowed) {
      glm::dvec3 place(vertex[0], vertex[1], vertex[2]);
      move(place, u_ * most);
      moved[vertex] = place;
    }
    glm::dvec3 from = p, along = v;
    move(from, u_ * least);
    move(along, u_ * longest(v));
    scene::Scene mesh;
    for (const scene::Triangle& triangle : scene.shapes<scene::Triangle>()) {
      const auto& [a, b, c] = triangle.vertices;
      const scene::Triangle of_moved{{moved[key(a)], moved[key(b)], moved[key(c)]}};
      if (!is_shape(of_moved)) return std::nullopt;
      add(mesh, of_moved);
    }
    if (along == glm::dvec3(0)) return std::nullopt;
    const scene::Hit hit = surface::exact::first_hit(mesh, ray(from, along));
    if (hit.resultado == model::Resultado::miss) return conform::Claim{.outcome = conform::Claim::Outcome::miss};
    if (hit.resultado == model::Resultado::no_minimum) return std::nullopt;
    return conform::Claim{
        .outcome = conform::Claim::Outcome::hit, .element = hit.elementos[0], .t = narrowed(hit.t, format_)};
  }

 private:
  struct Nearest {
    scene::ElementRef element;
    model::Rayo rayo;
    surface::exact::Parameter t;
  };

  std::optional<conform::Claim> claim_of(const Nearest& nearest, double t, conform::Measure measure) {
    const scene::Hit hit = surface::exact::rounded_hit(nearest.rayo, nearest.t, {nearest.element});
    if (hit.t < t || !std::isfinite(narrowed(hit.t, format_))) return std::nullopt;
    conform::Claim claim{.outcome = conform::Claim::Outcome::hit, .element = nearest.element};
    const glm::dvec3& v = nearest.rayo.v().xyz();
    const glm::dvec3& q = hit.punto;
    switch (measure) {
      case conform::Measure::parameter:
        claim.t = narrowed(hit.t, format_);
        break;
      case conform::Measure::length:
        claim.t = narrowed(length(hit.t, v), format_);
        break;
      case conform::Measure::point:
        claim.punto = glm::dvec3(narrowed(q.x, format_), narrowed(q.y, format_), narrowed(q.z, format_));
        break;
    }
    return claim;
  }

  /// t·|v|, where long double has room for squares of small numbers.
  static double length(double t, const glm::dvec3& v) {
    const long double x = v.x, y = v.y, z = v.z;
    return static_cast<double>(t * std::sqrt(x * x + y * y + z * z));
  }

  /// A part of what is allowed, less the rounding of the sum that it is for.
  double part() {
    switch (draw_) {
      case Draw::anywhere:
        return random_.uniform(-0.875, 0.875);
      case Draw::ends:
        return 0.875 * random_.sign();
      case Draw::one:
        return random_.chance(1, 6) ? 0.875 * random_.sign() : 0;
    }
    return 0;
  }
  void move(double& x, double by) { x += part() * by; }
  void move(glm::dvec3& v, double by) {
    for (int i = 0; i < 3; ++i) move(v[i], by);
  }
  void move(std::string_view word, double& x, double M) {
    move(x, word == "proporcion" ? u_ * std::max(1.0, x) : u_ * M);
  }
  void move(std::string_view word, glm::dvec3& v, double M) { move(v, word == "vector" ? u_ : u_ * M); }
  void move(std::string_view, scene::Corners& corners, double M) {
    for (glm::dvec3& corner : corners) move(corner, u_ * M);
  }

  static double longest(const glm::dvec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }
  template <class Shape>
  static double longest(const Shape& shape) {
    double most = 0;
    if constexpr (std::is_same_v<Shape, scene::Triangle>) {
      for (const glm::dvec3& corner : shape.vertices) most = std::max(most, longest(corner));
    } else {
      most = longest(shape.centro);
    }
    if constexpr (requires { shape.radio; }) most = std::max(most, shape.radio);
    if constexpr (requires { shape.altura; }) most = std::max(most, shape.altura);
    return most;
  }

  static bool is_shape(const scene::Triangle& e) {
    return model::Vertices::contains(
        {model::Punto(e.vertices[0]), model::Punto(e.vertices[1]), model::Punto(e.vertices[2])});
  }
  template <class Shape>
  static bool is_shape(const Shape& shape) {
    bool is = std::isfinite(longest(shape.centro));
    if constexpr (requires { shape.radio; }) is = is && model::Rmas::contains(shape.radio);
    if constexpr (requires { shape.altura; }) is = is && model::Rmas::contains(shape.altura);
    if constexpr (requires { shape.proporcion; }) is = is && model::Rmas::contains(shape.proporcion);
    return is;
  }

  conform::Random random_;
  double u_;
  conform::Format format_;
  Draw draw_ = Draw::anywhere;
};

}  // namespace durero::test
