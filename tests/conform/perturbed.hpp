#pragma once
/// The exact answers of data off by no more than the declared backward error (mover.hpp).

#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "durero/conform/ask/claim.hpp"
#include "durero/conform/ask/profile.hpp"
#include "durero/conform/families/suite.hpp"
#include "durero/surface/exact.hpp"
#include "mover.hpp"

namespace durero::test {

/// A case whose truths are the exact hits.
inline conform::SuiteCase answered(const conform::Family& family, conform::Case the_case) {
  conform::SuiteCase of{.family = &family, .the_case = std::move(the_case)};
  for (const scene::Query& query : of.the_case.rays)
    of.truths.push_back({.hit = surface::exact::first_hit(of.the_case.scene, query.rayo, query.en)});
  return of;
}

/// Of every type, in that format, with names.
inline conform::Profile wide_profile(conform::NumberFormat format) {
  conform::Profile profile;
  profile.format = format;
  for (std::size_t i = 0; i < model::tipo_count; ++i) profile.tipos.push_back(static_cast<model::Tipo>(i));
  return profile;
}

class Perturbation {
 public:
  Perturbation(std::uint64_t seed, conform::NumberFormat format) : random_(seed), format_(format) {}

  /// The claim that is the exact answer of moved data; nothing where the draw left no element or ray, or left what is
  /// allowed since its answer lies before the distance that it was drawn for.
  std::optional<conform::Claim> answer(const scene::Scene& scene, const scene::Query& query, double t,
                                       conform::Measure measure) {
    Mover mover(random_, format_, static_cast<Draw>(random_.below(3)));
    std::optional<Nearest> nearest;
    bool is_whole = true;
    scene.for_each([&](scene::ElementRef element, const auto& shape) {
      const glm::dvec3 &p = query.rayo.p().xyz(), &v = query.rayo.v().xyz();
      const double M = std::max({longest(shape), longest(p), t * longest(v)});
      const auto moved = mover.moved(shape, M);
      const glm::dvec3 from = mover.moved_point(p, M), along = mover.moved_direction(v);
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
    Mover mover(random_, format_, static_cast<Draw>(random_.below(3)));
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
      moved[vertex] = mover.moved_point({vertex[0], vertex[1], vertex[2]}, most);
    }
    const glm::dvec3 from = mover.moved_point(p, least), along = mover.moved_direction(v);
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

  conform::Random random_;
  conform::NumberFormat format_;
};

}  // namespace durero::test
