// What two elements close no ray leaves: from inside a solid of an element with an axis and discs, and across a closed
// fan of triangles.
#include <algorithm>
#include <optional>
#include <span>

#include "durero/conform/families/families.hpp"
#include "durero/surface/exact.hpp"
#include "durero/trace/analytic.hpp"
#include "hits.hpp"
#include "support/catch.hpp"
#include "support/exact_vector.hpp"
#include "support/scenes.hpp"
#include "support/shapes.hpp"

using namespace durero;
using namespace durero::test;
using conform::Case;

namespace {

/// What the ray has to do with the one element of a cap scene that has an axis; its ends are where 0 ≤ avance ≤ altura.
struct Solid {
  surface::exact::Coefficients f;
  bool has_base = false, has_far_end = false;

  /// From within, before any surface.
  bool holds_origin() const { return number::sign(f.C) < 0 && number::sign(f.s0) > 0 && f.s0 < *f.altura; }
  /// The ray may leave by the end that is open.
  bool lets_out() const {
    const int way = number::sign(f.s1);
    return (way < 0 && !has_base) || (way > 0 && !has_far_end);
  }
};

Solid solid_of(const scene::Scene& scene, const model::Rayo& rayo) {
  Solid solid;
  glm::dvec3 base(0);
  scene.for_each([&]<class Shape>(scene::ElementRef, const Shape& shape) {
    if constexpr (requires { shape.altura; }) {
      solid.f = surface::exact::coefficients(shape, rayo);
      base = shape.centro;
      solid.has_far_end = std::is_same_v<Shape, scene::Cone>;
    }
  });
  for (const scene::Disc& disc : scene.shapes<scene::Disc>())
    (disc.centro == base ? solid.has_base : solid.has_far_end) = true;
  return solid;
}

using Triangles = std::span<const scene::Triangle>;

/// How many of the triangles have the vertex.
std::ptrdiff_t degree(Triangles triangles, const glm::dvec3& vertex) {
  return std::count_if(triangles.begin(), triangles.end(), [&](const auto& t) {
    return std::find(t.vertices.begin(), t.vertices.end(), vertex) != t.vertices.end();
  });
}

/// The vertex that all triangles have, and the others, each of which two have: of a fan in one plane without a gap.
struct Fan {
  glm::dvec3 hub{};
  std::vector<glm::dvec3> ends{};
};
std::optional<Fan> closed_flat_fan(Triangles triangles) {
  Fan fan;
  const auto& [a, b, c] = triangles[0].vertices;
  const Exact_Vector origin(a), normal = cross(Exact_Vector(b) - origin, Exact_Vector(c) - origin);
  for (const scene::Triangle& triangle : triangles) {
    for (const glm::dvec3& vertex : triangle.vertices) {
      if (number::sign(dot(Exact_Vector(vertex) - origin, normal)) != 0) return std::nullopt;
      const std::ptrdiff_t times = degree(triangles, vertex);
      if (times == 1) return std::nullopt;
      if (times == std::ssize(triangles))
        fan.hub = vertex;
      else
        fan.ends.push_back(vertex);
    }
  }
  return fan;
}

}  // namespace

TEST_CASE("no ray leaves a solid but through an end that is open") {
  std::size_t kept = 0, let_out = 0;
  const conform::Family& family = *conform::find_family("cap");
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const Case drawn = generate(family, seed, 60);
    const std::vector<scene::Hit> hits = trace::first_hits(trace::Tables(drawn.scene), drawn.rays);
    for (std::size_t i = 0; i < hits.size(); ++i) {
      const Solid solid = solid_of(drawn.scene, drawn.rays[i].rayo);
      if (!solid.holds_origin()) continue;
      const bool left = hits[i].resultado == model::Resultado::miss;
      (left ? let_out : kept) += 1;
      INFO(replay(family, seed, 60, i));
      CHECK((!left || solid.lets_out()));
    }
  }
  CHECK(kept > 2500);
  CHECK(let_out > 50);
}

TEST_CASE("no ray passes between triangles that share an edge, however near to the edge or the vertex") {
  std::size_t fans = 0;
  Random random(10);
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    const Case drawn = generate(*conform::find_family("edge"), seed, 1);
    const std::optional<Fan> fan = closed_flat_fan(drawn.scene.singles<scene::Triangle>());
    if (!fan) continue;
    ++fans;
    const trace::Tables tables(drawn.scene);
    std::vector<scene::Query> rays;
    for (const glm::dvec3& end : fan->ends) {
      for (int i = 0; i < 50; ++i) {
        const glm::dvec3 to = fan->hub + (random.integer(0, 7) / 8.0) * (end - fan->hub);
        const glm::dvec3 p = to + random.in_cube(100);
        const scene::Query query{ray(p, random.uniform(0.5, 2) * (to - p)), {}};
        rays.push_back(query);
      }
    }
    const std::vector<scene::Hit> hits = trace::first_hits(tables, rays);
    for (std::size_t i = 0; i < hits.size(); ++i) {
      INFO("seed " << seed << ": " << text(rays[i]));
      CHECK(hits[i].resultado == model::Resultado::hit);
    }
  }
  CHECK(fans > 40);
}

TEST_CASE("no ray leaves a closed mesh, whatever edge or vertex it goes to, in either format") {
  std::size_t at_vertices = 0;
  const conform::Family& family = *conform::find_family("vertex");
  for (const conform::NumberFormat numbers : {conform::NumberFormat::binary32, conform::NumberFormat::binary64}) {
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
      const Case drawn = conform::generate(family, seed, 60, {.numbers = numbers})->the_case;
      const std::vector<scene::Hit> hits = trace::first_hits(trace::Tables(drawn.scene), drawn.rays);
      for (std::size_t i = 0; i < hits.size(); ++i) {
        INFO(replay(family, seed, 60, i));
        CHECK(hits[i].resultado == model::Resultado::hit);
        at_vertices += hits[i].elementos.size() > 2;
      }
    }
  }
  CHECK(at_vertices > 500);
}
