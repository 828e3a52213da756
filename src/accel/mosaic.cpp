#include "durero/accel/mosaic.hpp"

#include <algorithm>
#include <stdexcept>
#include <type_traits>

#include "durero/accel/touch.hpp"
#include "durero/number/dyadic.hpp"
#include "durero/surface/surfaces.hpp"

namespace durero::accel {
namespace {

using number::Dyadic;
using ExactVector = surface::Point<Dyadic>;

/// The squares of the distances from a point to the nearest and to the farthest point of a box.
struct SquaredDistances {
  Dyadic nearest, farthest;
};

SquaredDistances squared_distances(const glm::dvec3& from, const surface::Box& box) {
  SquaredDistances sum{0, 0};
  for (int axis = 0; axis < 3; ++axis) {
    const Dyadic below = Dyadic(from[axis]) - box.low[axis], above = Dyadic(box.high[axis]) - from[axis];
    if (from[axis] < box.low[axis]) sum.nearest += square(below);
    if (from[axis] > box.high[axis]) sum.nearest += square(above);
    sum.farthest += square(std::max(below, above));
  }
  return sum;
}

/// Whether a plane across the vector separates the triangle from the box.
bool parts(const ExactVector& across, const scene::Triangle& triangle, const surface::Box& box) {
  Dyadic least = 0, greatest = 0;  // across·w of the points w of the box
  const Dyadic* const components[] = {&across.x, &across.y, &across.z};
  for (int axis = 0; axis < 3; ++axis) {
    const auto [low, high] = std::minmax({*components[axis] * box.low[axis], *components[axis] * box.high[axis]});
    least += low;
    greatest += high;
  }
  const auto along = [&](const glm::dvec3& w) { return across.x * w.x + across.y * w.y + across.z * w.z; };
  const auto [first, last] =
      std::minmax({along(triangle.vertices[0]), along(triangle.vertices[1]), along(triangle.vertices[2])});
  return last < least || greatest < first;
}

// touches() with exact planes: across the axes of space, across the triangle, and along an edge of it and one of the
// box. Two convex bodies with flat faces are apart only where one of these separates them.
bool has_exact_point(const scene::Triangle& triangle, const surface::Box& box) {
  const auto& [a, b, c] = triangle.vertices;
  const ExactVector p = surface::between<Dyadic>(a, b), q = surface::between<Dyadic>(a, c);
  const ExactVector normal{p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x};
  if (parts(normal, triangle, box)) return false;
  return std::ranges::none_of(std::array{p, q, surface::between<Dyadic>(b, c)}, [&](const ExactVector& edge) {
    return parts({0, edge.z, -edge.y}, triangle, box) || parts({-edge.z, 0, edge.x}, triangle, box) ||
           parts({edge.y, -edge.x, 0}, triangle, box);
  });
}

// The sphere and the box are connected: the sphere has a point in the box where the box is neither all outside nor all
// inside.
bool has_exact_point(const scene::Sphere& sphere, const surface::Box& box) {
  const auto [nearest, farthest] = squared_distances(sphere.centro, box);
  const Dyadic radius_squared = square(Dyadic(sphere.radio));
  return nearest <= radius_squared && radius_squared <= farthest;
}

}  // namespace

bool has_point_in(scene::ShapeView element, const surface::Box& box) {
  if (!touches(element, box)) return false;
  return element.visit([&]<class Shape>(const Shape& shape) {
    if constexpr (is_exact_in_mosaics(Shape::tipo)) return has_exact_point(shape, box);
    return true;
  });
}

bool encloses(scene::ShapeView element, const surface::Box& box) {
  return element.visit([&]<class Shape>(const Shape& shape) {
    if constexpr (std::is_same_v<Shape, scene::Sphere>)
      return squared_distances(shape.centro, box).farthest < square(Dyadic(shape.radio));
    return false;
  });
}

/// Divides cubes in eight, depth first.
struct Mosaic::Cutter {
  using Numbers = std::vector<std::uint32_t>;

  void cut(const Cell& corner, int side, const Numbers& nearby, Numbers inside) {
    const surface::Box box = mosaic.box(corner, side);
    Numbers surface;
    for (const std::uint32_t number : nearby) {
      mosaic.contents_.scene->visit(mosaic.contents_.elements[number], [&](const auto& shape) {
        if (has_point_in(shape, box))
          surface.push_back(number);
        else if (mosaic.filling_ == Filling::solid && encloses(shape, box))
          inside.push_back(number);
      });
    }
    if (surface.empty() && inside.empty()) return;
    if (side > 1 && !surface.empty()) return cut_in_eight(corner, side / 2, surface, inside);
    std::ranges::sort(inside);
    visit({corner, code, surface, inside});
  }

  void cut_in_eight(const Cell& corner, int half, const Numbers& surface, const Numbers& inside) {
    for (int octant = 0; octant < 8; ++octant) {
      code.push_back(static_cast<char>('0' + octant));
      cut(corner + half * Cell(octant & 1, octant >> 1 & 1, octant >> 2 & 1), half, surface, inside);
      code.pop_back();
    }
  }

  const Mosaic& mosaic;
  const std::function<void(const Voxel&)>& visit;
  std::string code{};
};

Mosaic::Mosaic(const scene::Scene& scene, int depth, Filling filling) : contents_(scene), filling_(filling) {
  if (depth < 0 || depth > deepest) throw std::invalid_argument("the depth of a mosaic is from 0 to 17");
  finest_ = finest_cells(contents_.box, depth);
}

surface::Box Mosaic::box(const Cell& corner, int side) const {
  return {finest_.box(corner).low, finest_.box(corner + side - 1).high};
}

void Mosaic::for_each(const std::function<void(const Voxel&)>& visit) const {
  std::vector<std::uint32_t> all(contents_.elements.size());
  for (std::uint32_t number = 0; number < all.size(); ++number) all[number] = number;
  Cutter{*this, visit}.cut({0, 0, 0}, finest_.count.x, all, {});
}

}  // namespace durero::accel
