// The parameters of each surface: its points by their distances from centre and axis, which the parametrisation does
// not compute; normals, curvature and edges by neighbouring points.
#include "durero/oracle/parametrisation.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

#include "support/catch.hpp"
#include "support/scenes.hpp"

using namespace durero;
using oracle::Parametrisation;
using oracle::SurfacePoint;

namespace {

/// Distances of a point from the centre, along the axis and across it.
struct Place {
  double along, across;
};

Place place(const glm::dvec3& point, const glm::dvec3& centro, const glm::dvec3& axis) {
  const glm::dvec3 q = point - centro;
  const double along = glm::dot(q, axis);
  return {along, glm::length(q - axis * along)};
}

/// Whether normals stand across both parameters, and turn by no more than the curvature allows.
void check_shape(const Parametrisation& surface, test::Random& random) {
  for (int i = 0; i < 200; ++i) {
    const double u = random.uniform(0.02, 0.98), v = random.uniform(0.02, 0.98), step = 0x1p-20;
    const SurfacePoint here = surface.at(u, v);
    const glm::dvec3 by_u = surface.point(u + step, v) - surface.point(u - step, v);
    const glm::dvec3 by_v = surface.point(u, v + step) - surface.point(u, v - step);
    CHECK(glm::length(here.normal) == Approx(1));
    CHECK(std::abs(glm::dot(here.normal, glm::normalize(by_u))) < 1e-6);
    CHECK(std::abs(glm::dot(here.normal, glm::normalize(by_v))) < 1e-6);
    CHECK(glm::length(by_u) <= 2 * step * surface.length() * (1 + 1e-6));
    CHECK(glm::length(by_v) == Approx(2 * step * surface.around(u)).epsilon(1e-6));
    CHECK(surface.around_within(u, 0.01) >= surface.around(std::min(1.0, u + 0.01 / surface.length())) * (1 - 1e-12));
    CHECK(surface.around_within(u, 0.01) >= surface.around(std::max(0.0, u - 0.01 / surface.length())) * (1 - 1e-12));
    CHECK(glm::length(here.point - surface.middle(0.5)) <= surface.reach(u, surface.middle(0.5)) * (1 + 1e-12));
    CHECK(here.point == surface.point(u, v));
    // From here to a point within edge/2, by a path along the profile and then around.
    const double reach = std::min(here.edge / 2, surface.widest()) * random.uniform(0, 1);
    const double part = random.uniform(-1, 1), along = part * reach;
    const double other_u = std::clamp(u + along / surface.length(), 0.01, 0.99);
    const double walked = std::abs(other_u - u) * surface.length();
    const double around = (reach - walked) / surface.around(other_u);
    const SurfacePoint other = surface.at(other_u, v + around);
    CHECK(glm::length(other.normal - here.normal) <= here.curvature * reach * (1 + 1e-9) + 1e-12);
    // And there the surface bends no more than the bound, around the axis, where it bends most.
    const double arc = surface.around(other_u) * step;
    const glm::dvec3 turned = surface.at(other_u, v + around + step).normal;
    CHECK(glm::length(turned - other.normal) <= here.curvature * arc * (1 + 1e-6));
  }
}

}  // namespace

TEST_CASE("a sphere is a half circle turned around") {
  test::Random random(21);
  const scene::Sphere sphere{{1, -2, 3}, 2.5};
  const Parametrisation surface(sphere);
  for (int i = 0; i < 200; ++i) {
    const double u = random.uniform(0, 1), v = random.uniform(0, 1);
    CHECK(glm::length(surface.point(u, v) - sphere.centro) == Approx(2.5));
    CHECK(surface.at(u, v).edge == std::numeric_limits<double>::infinity());
    CHECK(surface.at(u, v).curvature == Approx(1 / 2.5));
  }
  CHECK(surface.length() == Approx(2.5 * std::numbers::pi));
  check_shape(surface, random);
}

TEST_CASE("a cylinder is a segment turned around, with a rim at either end") {
  test::Random random(22);
  const scene::Cylinder c{{1, -2, 3}, 0.5, random.axis().xyz(), 4};
  const Parametrisation surface(c);
  for (int i = 0; i < 200; ++i) {
    const double u = random.uniform(0, 1), v = random.uniform(0, 1);
    const Place at = place(surface.point(u, v), c.centro, c.vector);
    CHECK(at.along == Approx(4 * u).margin(1e-12));
    CHECK(at.across == Approx(0.5));
    CHECK(surface.at(u, v).edge == Approx(4 * std::min(u, 1 - u)));
    CHECK(surface.at(u, v).curvature == Approx(2));
  }
  check_shape(surface, random);
}

TEST_CASE("a cone is a segment that ends at the apex, with a rim at its base") {
  test::Random random(23);
  const scene::Cone k{{1, -2, 3}, 0.75, random.axis().xyz(), 4};
  const Parametrisation surface(k);
  for (int i = 0; i < 200; ++i) {
    const double u = random.uniform(0, 1), v = random.uniform(0, 1);
    const Place at = place(surface.point(u, v), k.centro, k.vector);
    CHECK(at.along == Approx(4 * u).margin(1e-12));
    CHECK(at.across == Approx(0.75 * (4 - at.along)).margin(1e-12));
    CHECK(surface.at(u, v).edge == Approx(5 * std::min(u, 1 - u)));
  }
  CHECK(surface.length() == Approx(5));
  CHECK(surface.widest() == Approx(3));
  CHECK(surface.at(1, 0).curvature == std::numeric_limits<double>::infinity());
  check_shape(surface, random);
}

TEST_CASE("a truncated cone is a segment with a rim at either end") {
  test::Random random(24);
  const scene::TruncatedCone k{{1, -2, 3}, 2, 0.75, random.axis().xyz(), 4};
  const Parametrisation surface(k);
  for (int i = 0; i < 200; ++i) {
    const double u = random.uniform(0, 1), v = random.uniform(0, 1);
    const Place at = place(surface.point(u, v), k.centro, k.vector);
    CHECK(at.along == Approx(4 * u).margin(1e-12));
    CHECK(at.across == Approx(2 + 0.75 * (4 - at.along)).margin(1e-12));
    CHECK(surface.at(u, v).edge == Approx(5 * std::min(u, 1 - u)));
  }
  CHECK(surface.length() == Approx(5));
  CHECK(surface.widest() == Approx(5));
  CHECK(surface.at(1, 0).curvature == Approx(0.8 / 2));
  check_shape(surface, random);
}

TEST_CASE("a disc is a radius turned around, flat, with its rim as its only edge") {
  test::Random random(26);
  const scene::Disc disc{{1, -2, 3}, 8, random.axis().xyz()};
  const Parametrisation surface(disc);
  CHECK_FALSE(surface.is_patch());
  for (int i = 0; i < 200; ++i) {
    const double u = random.uniform(0, 1), v = random.uniform(0, 1);
    const Place at = place(surface.point(u, v), disc.centro, disc.vector);
    CHECK(at.along == Approx(0).margin(1e-12));
    CHECK(at.across == Approx(8 * u).margin(1e-12));
    CHECK(surface.at(u, v).edge == Approx(8 * (1 - u)));
    CHECK(surface.at(u, v).curvature == 0);
  }
  CHECK(surface.length() == 8);
  check_shape(surface, random);
}

TEST_CASE("a triangle is a fan from the vertex opposite to its shortest edge") {
  test::Random random(27);
  for (const scene::Triangle& triangle :
       {scene::Triangle{{{{1, -2, 3}, {5, -2, 3}, {1, 1, 3}}}}, scene::Triangle{{{{0, 0, 0}, {4, 1, 2}, {-1, 5, 7}}}},
        scene::Triangle{{{{9, 0, 0}, {0, 0.125, 0}, {0, 0, 0}}}}}) {
    const Parametrisation surface(triangle);
    const auto& [a, b, c] = triangle.vertices;
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    const double area = glm::length(normal);
    double longest = 0;
    for (int i = 0; i < 3; ++i)
      longest = std::max(longest, glm::length(triangle.vertices[(i + 1) % 3] - triangle.vertices[i]));
    CHECK(surface.length() == Approx(longest));
    for (int i = 0; i < 200; ++i) {
      const double u = random.uniform(0, 1), v = random.uniform(0, 1);
      const SurfacePoint at = surface.at(u, v);
      // Twice the areas of the three parts add up to the whole's only within; each over an edge is the distance to it.
      double parts = 0, nearest = std::numeric_limits<double>::infinity();
      for (int k = 0; k < 3; ++k) {
        const glm::dvec3 p = triangle.vertices[k], q = triangle.vertices[(k + 1) % 3];
        const double part = glm::length(glm::cross(q - p, at.point - p));
        parts += part;
        nearest = std::min(nearest, part / glm::length(q - p));
      }
      CHECK(parts == Approx(area));
      CHECK(at.edge <= nearest + 1e-12);
      CHECK(at.edge >= 0.99 * nearest - 1e-12);
      CHECK(at.curvature == 0);
      CHECK(std::abs(glm::dot(at.normal, normal)) == Approx(area));
    }
    check_shape(surface, random);
  }
}

TEST_CASE("of a plane a disc is seen, flat, with its rim as its only edge") {
  test::Random random(25);
  const scene::Plane plane{{1, -2, 3}, random.axis().xyz()};
  const Parametrisation surface(scene::ShapeView(plane), 8);
  CHECK(surface.is_patch());
  for (int i = 0; i < 200; ++i) {
    const double u = random.uniform(0, 1), v = random.uniform(0, 1);
    const Place at = place(surface.point(u, v), plane.centro, plane.vector);
    CHECK(at.along == Approx(0).margin(1e-12));
    CHECK(at.across == Approx(8 * u).margin(1e-12));
    CHECK(surface.at(u, v).edge == Approx(8 * (1 - u)));
    CHECK(surface.at(u, v).curvature == 0);
  }
  CHECK(surface.length() == 8);
  CHECK(surface.widest() == 8);
  CHECK_FALSE(Parametrisation(scene::Sphere{{0, 0, 0}, 1}).is_patch());
}
