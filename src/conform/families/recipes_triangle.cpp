#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "conform/families/recipes.hpp"

namespace durero::conform::recipes {
namespace {

using model::Tipo;

constexpr std::array<std::array<std::size_t, 3>, 6> orders{
    {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};

/// The triangle with these vertices in any order.
FramedShape in_any_order(Draws& random, const scene::Corners& vertices, bool lattice) {
  const auto& [i, j, k] = random.any_of(orders);
  return triangle({vertices[i], vertices[j], vertices[k]}, lattice);
}

/// A basis of space: three vectors, of the lattice or any.
struct Basis {
  glm::dvec3 u, w, n;
};
Basis basis(Draws& random, bool lattice) {
  for (;;) {
    const auto vector = [&] { return lattice ? random.lattice_vector(3) : 3.0 * random.direction(); };
    const glm::dvec3 u = vector(), w = vector(), n = vector();
    if (std::abs(glm::dot(glm::cross(u, w), n)) >= 1) return {u, w, n};
  }
}

/// Vertices around the hub, in one plane where the height is 0. Seen from the hub along n each follows the one before
/// by less than half a turn.
std::vector<glm::dvec3> ring(Draws& random, const glm::dvec3& hub, const Basis& in, int count, int height) {
  constexpr std::array<std::array<int, 2>, 8> eighths{
      {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};
  std::vector<glm::dvec3> ends;
  for (int i = 0; i < count; ++i) {
    const auto [x, y] = eighths[static_cast<std::size_t>(8 * i / count)];
    const double length = 8 * random.integer(1, 8), rise = 8 * random.integer(-height, height);
    const glm::dvec3 across = static_cast<double>(x) * in.u + static_cast<double>(y) * in.w;
    ends.push_back(random.rounded(hub + length * across + rise * in.n));
  }
  return ends;
}

/// The outer vertices of a closed fan of three, four or eight triangles, in one plane or not.
std::vector<glm::dvec3> ends_of_spokes(Draws& random, const glm::dvec3& hub, bool lattice) {
  constexpr std::array counts{3, 4, 8};
  const Basis in = basis(random, lattice);
  const int count = random.any_of(counts), height = random.chance(1, 2) ? 0 : 4;
  return ring(random, hub, in, count, height);
}

glm::dvec3 any_hub(Draws& random, bool lattice) {
  const glm::dvec3 anywhere = random.in_cube(300);
  return lattice ? glm::floor(anywhere) : random.rounded(anywhere);
}

/// Adds the points at eighths of the way along an edge to the shared points of the shape, both vertices among them.
void share(FramedShape& shape, const glm::dvec3& from, const glm::dvec3& to) {
  for (int i = 0; i < 8; ++i) shape.shared.push_back({from + i / 8.0 * (to - from), shape.d, shape.e1, shape.e2});
  shape.shared.push_back({to, shape.d, shape.e1, shape.e2});
}

/// A sliver in a coordinate plane, with its length along e1: each height down to 2⁻⁵⁰ of that is exact.
FramedShape lattice_sliver(Draws& random, int minus_log2_height) {
  const FramedShape frame = lattice_shape(random, Tipo::soy_plano);
  const double length = std::ldexp(1, random.integer(3, 9)), height = std::ldexp(length, -minus_log2_height);
  const double x = random.integer(-32, 32), z = random.integer(-32, 32), foot = random.integer(0, 8) / 8.0;
  const glm::dvec3 a = x * frame.e1 + z * frame.d;
  return in_any_order(random, {a, a + length * frame.e1, a + foot * length * frame.e1 + height * frame.e2}, true);
}

FramedShape tilted_sliver(Draws& random, int minus_log2_height) {
  for (;;) {
    const double length = std::ldexp(1, random.integer(3, 9));
    const glm::dvec3 a = random.in_cube(32), along = random.direction(), aside = glm::cross(along, random.direction());
    const glm::dvec3 c = a + random.uniform(0, 1) * length * along + std::ldexp(length, -minus_log2_height) * aside;
    const scene::Corners vertices = random.rounded(scene::Corners{a, a + length * along, c});
    if (are_corners(vertices)) return in_any_order(random, vertices, false);
  }
}

/// The sliver moved far from 0: along its length, where a lattice sliver stays exact. A tilted sliver that would be no
/// triangle any more is not moved.
FramedShape far_from_zero(Draws& random, const FramedShape& sliver) {
  const glm::dvec3 way = sliver.lattice ? sliver.e1 : random.lattice_vector(4);
  return moved(sliver, std::ldexp(1, random.integer(10, 30)) * way);
}

FramedShape huge_through(Draws& random, const glm::dvec3& place) {
  const FramedShape moderate = any_shape(random, Tipo::soy_triangulo);
  const FramedShape huge = scaled(moderate, random.integer(20, 40));
  return moved(huge, place - surface_point(random, huge).position);
}

bool is_huge(const FramedShape& shape) { return shape.radius() >= 0x1p20; }

/// A triangle around any place, its edges integer combinations of two vectors.
FramedShape triangle_between(Draws& random, const glm::dvec3& place, const glm::dvec3& u, const glm::dvec3& w) {
  for (;;) {
    scene::Corners vertices;
    for (glm::dvec3& vertex : vertices) {
      const double x = 8 * random.integer(-6, 6), y = 8 * random.integer(-6, 6);
      vertex = place + x * u + y * w;
    }
    if (are_corners(vertices)) return triangle(vertices, true);
  }
}

/// Discs and triangles in one coordinate plane, or triangles in any.
FramedShapes overlapping(Draws& random) {
  FramedShape disc = lattice_shape(random, Tipo::soy_disco);
  const bool any_plane = random.chance(1, 3);
  const Basis in = any_plane ? basis(random, true) : Basis{disc.e1, disc.e2, disc.d};
  const glm::dvec3 place = disc.centro;
  FramedShapes shapes{triangle_between(random, place, in.u, in.w)};
  for (int left = random.integer(1, 3); left > 0; --left) {
    if (any_plane || random.chance(1, 2)) {
      shapes.push_back(triangle_between(random, place, in.u, in.w));
      continue;
    }
    const double x = random.integer(-20, 20), y = random.integer(-20, 20);
    disc.centro = place + x * in.u + y * in.w;
    shapes.push_back(disc);
  }
  if (!any_plane && random.chance(1, 4)) shapes.push_back(disc), shapes.back().tipo = Tipo::soy_plano;
  return shapes;
}

/// A tilted shape and a second one in its plane: the same vertices in another order, or a disc of half the radius.
FramedShapes tilted_twins(Draws& random) {
  if (random.chance(1, 2)) {
    const FramedShape first = tilted_shape(random, Tipo::soy_triangulo);
    return {first, in_any_order(random, first.vertices, false)};
  }
  FramedShapes shapes{tilted_shape(random, Tipo::soy_disco)};
  shapes.push_back(shapes[0]);
  shapes[1].radio /= 2;
  return shapes;
}

}  // namespace

/// Triangles around a vertex, each of which shares an edge with the next; one in three has a gap.
FramedShapes fan(Draws& random, int) {
  const bool lattice = random.chance(2, 3);
  const glm::dvec3 hub = any_hub(random, lattice);
  const std::vector<glm::dvec3> ends = ends_of_spokes(random, hub, lattice);
  FramedShapes shapes;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const glm::dvec3 &end = ends[i], &next = ends[(i + 1) % ends.size()];
    FramedShape shape = in_any_order(random, {hub, end, next}, lattice);
    share(shape, hub, end);
    share(shape, hub, next);
    shapes.push_back(shape);
  }
  if (random.chance(1, 3)) shapes.pop_back();
  return shapes;
}

DrawnRay edge(Draws& random, int log2_distance, ShapeSpan shapes) {
  const std::size_t place = random.below(shapes.size());
  const FramedShape& shape = shapes[place];
  const FramedPoint& at = random.any_of(shape.shared);
  const glm::dvec3 w = random.chance(1, 8) ? tangent_vector(random, at) : any_vector(random, shape);
  DrawnRay ray = arriving(random, at.position, w, steps(w, shape.radius(), log2_distance));
  if (!random.chance(1, 8)) return one_in_three_nudged(random, ray);
  ray.p = at.position;
  ray.on.push_back(place);
  return ray;
}

/// Two fans on one ring. They are closed, for seen from the hub their triangles fill all directions, each once. Their
/// shared points are those of all their edges.
FramedShapes closed_mesh(Draws& random, int sides) {
  const bool lattice = random.chance(2, 3);
  const glm::dvec3 hub = any_hub(random, lattice);
  const Basis in = basis(random, lattice);
  const std::vector<glm::dvec3> ends = ring(random, hub, in, sides, 4);
  const double above = 8 * random.integer(1, 8), below = -8 * random.integer(1, 8);
  FramedShapes shapes;
  for (const double height : {above, below}) {
    const glm::dvec3 top = random.rounded(hub + height * in.n);
    for (std::size_t i = 0; i < ends.size(); ++i) {
      const glm::dvec3 &end = ends[i], &next = ends[(i + 1) % ends.size()];
      FramedShape shape = in_any_order(random, {top, end, next}, lattice);
      shape.centro = hub;
      share(shape, top, end);
      share(shape, end, next);
      shapes.push_back(shape);
    }
  }
  return shapes;
}

/// A ray from inside a closed mesh to one of its shared points.
DrawnRay vertex(Draws& random, int, ShapeSpan shapes) {
  const glm::dvec3 hub = shapes.front().centro;
  const glm::dvec3 side = random.any_of(random.any_of(shapes).vertices);
  const glm::dvec3 p = random.rounded(hub + random.integer(0, 2) / 4.0 * (side - hub));
  const FramedPoint& at = random.any_of(random.any_of(shapes).shared);
  return one_in_three_nudged(random, {p, std::ldexp(1, random.integer(-3, 3)) * (at.position - p)});
}

/// A sliver, one in three far from 0, and a huge triangle through its place.
FramedShapes sliver(Draws& random, int minus_log2_height) {
  const FramedShape near =
      random.chance(2, 3) ? lattice_sliver(random, minus_log2_height) : tilted_sliver(random, minus_log2_height);
  const FramedShape sliver = random.chance(1, 3) ? far_from_zero(random, near) : near;
  return {sliver, huge_through(random, glm::floor(sliver.vertices[0]))};
}

DrawnRay sliver(Draws& random, int, ShapeSpan shapes) {
  const FramedShape& shape = random.any_of(shapes);
  const FramedPoint at = random.chance(1, 2) ? rim_point(random, shape) : surface_point(random, shape);
  const glm::dvec3 w = random.chance(1, 6) ? tangent_vector(random, at) : any_vector(random, shape);
  const int log2_distance = is_huge(shape) ? random.integer(-40, -20) : random.integer(-2, 30);
  return one_in_three_nudged(random, arriving(random, at.position, w, steps(w, shape.radius(), log2_distance)));
}

FramedShapes coplanar(Draws& random, int) { return random.chance(3, 4) ? overlapping(random) : tilted_twins(random); }

DrawnRay coplanar(Draws& random, int minus_log2_angle, ShapeSpan shapes) {
  const FramedShape& shape = random.any_of(shapes);
  const FramedPoint at = random.chance(1, 4) ? rim_point(random, shape) : surface_point(random, shape);
  if (random.chance(1, 2)) {
    const glm::dvec3 w = any_vector(random, shape);
    return one_in_three_nudged(random,
                               arriving(random, at.position, w, steps(w, shape.radius(), random.integer(0, 6))));
  }
  glm::dvec3 w = tangent_vector(random, at);
  if (random.chance(1, 2)) w += std::ldexp(steps(shape.d, 1, 0), -minus_log2_angle) / steps(w, 1, 0) * shape.d;
  return arriving(random, at.position, w, std::ldexp(1, random.integer(-4, 6)));
}

}  // namespace durero::conform::recipes
