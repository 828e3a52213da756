#include "durero/accel/volume/volume.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

#include "durero/accel/hierarchy.hpp"
#include "durero/surface/surfaces.hpp"

namespace durero::accel {
namespace {

using std::numbers::pi;

VolumeTest within(BoxInterval stretch, double limit) {
  if (!stretch.meets()) return VolumeTest::missed;
  stretch.exit = std::min(stretch.exit, limit);
  return stretch.meets() ? VolumeTest::met : VolumeTest::beyond;
}

struct Test {
  const PrecomputedRay& asked;
  double limit;

  VolumeTest operator()(const surface::Ball& ball) const { return verdict(ball, asked.ray, limit); }
  VolumeTest operator()(const Ellipsoid& ellipsoid) const { return verdict(ellipsoid, asked.ray, limit); }
  VolumeTest operator()(const surface::Box& box) const { return within(stretch(box, asked.beam, never), limit); }
  VolumeTest operator()(const OrientedBox& box) const { return within(stretch(box, asked.ray), limit); }
  VolumeTest operator()(const Slabs& slabs) const { return within(stretch(slabs, asked.projections), limit); }
};

/// The points w with n·w ≤ d.
struct HalfSpace {
  glm::dvec3 n;
  double d;
};
using HalfSpaces = std::vector<HalfSpace>;

void push(HalfSpaces& all, const glm::dvec3& n, const Slab& slab) {
  const double length = glm::length(n);
  all.push_back({n / length, slab.high / length});
  all.push_back({-n / length, -slab.low / length});
}

HalfSpaces half_spaces(const surface::Box& box) {
  HalfSpaces all;
  for (int i = 0; i < 3; ++i) push(all, slab_directions(3)[std::size_t(i)], {box.low[i], box.high[i]});
  return all;
}
HalfSpaces half_spaces(const OrientedBox& box) {
  HalfSpaces all;
  for (std::size_t i = 0; i < 3; ++i) push(all, box.normal[i], box.along[i]);
  return all;
}
HalfSpaces half_spaces(const Slabs& slabs) {
  HalfSpaces all;
  for (std::size_t i = 0; i < slabs.along.size(); ++i) push(all, slab_directions(most_slabs)[i], slabs.along[i]);
  return all;
}

/// The part of a flat polygon that lies in a half-space.
std::vector<glm::dvec3> clipped(const std::vector<glm::dvec3>& polygon, const HalfSpace& by) {
  std::vector<glm::dvec3> result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double beyond_a = glm::dot(by.n, a) - by.d, beyond_b = glm::dot(by.n, b) - by.d;
    if (beyond_a <= 0) result.push_back(a);
    if ((beyond_a < 0 && beyond_b > 0) || (beyond_a > 0 && beyond_b < 0))
      result.push_back(a + beyond_a / (beyond_a - beyond_b) * (b - a));
  }
  return result;
}

/// Σ weight(n)·area over the faces of the polyhedron of some half-spaces with unit normals.
template <class Weight>
double over_faces(const HalfSpaces& all, Weight weight) {
  double far = 0, sum = 0;
  for (const HalfSpace& half : all) far += 2 * std::abs(half.d);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const glm::dvec3 n = all[i].n;
    const glm::dvec3 x = glm::normalize(glm::cross(n, std::abs(n.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)));
    const glm::dvec3 y = glm::cross(n, x), middle = all[i].d * n;
    std::vector<glm::dvec3> face{middle + far * (x + y), middle + far * (y - x), middle - far * (x + y),
                                 middle + far * (x - y)};
    for (std::size_t j = 0; j < all.size(); ++j)
      if (j != i && j / 2 != i / 2) face = clipped(face, all[j]);
    glm::dvec3 twice(0);
    for (std::size_t j = 2; j < face.size(); ++j) twice += glm::cross(face[j - 1] - face[0], face[j] - face[0]);
    sum += weight(n) * glm::length(twice) / 2;
  }
  return sum;
}

struct SurfaceArea {
  double operator()(const surface::Ball& ball) const { return 4 * pi * ball.radius * ball.radius; }
  double operator()(const surface::Box& box) const { return area<double>(box); }
  double operator()(const Ellipsoid& e) const {
    const double a = e.rho, c = e.rho / e.lambda;  // across the axis, and along it
    if (std::abs(e.lambda - 1) < 1e-6) return 4 * pi * a * a;
    if (c < a) {
      const double eccentricity = std::sqrt(1 - c * c / (a * a));
      return 2 * pi * a * a * (1 + c * c / (a * a) * std::atanh(eccentricity) / eccentricity);
    }
    const double eccentricity = std::sqrt(1 - a * a / (c * c));
    return 2 * pi * a * a * (1 + c / a * std::asin(eccentricity) / eccentricity);
  }
  template <class Polyhedron>
  double operator()(const Polyhedron& polyhedron) const {
    return over_faces(half_spaces(polyhedron), [](const glm::dvec3&) { return 1.0; });
  }
};

struct Projected {
  glm::dvec3 v;

  double operator()(const surface::Ball& ball) const { return pi * ball.radius * ball.radius; }
  /// The area of the projection of {|M·x| ≤ 1} along a unit vector is π·|M·v|/det M.
  double operator()(const Ellipsoid& e) const {
    return pi * e.rho * e.rho * glm::length(v + (e.lambda - 1) * glm::dot(v, e.axis) * e.axis) / e.lambda;
  }
  template <class Polyhedron>
  double operator()(const Polyhedron& polyhedron) const {
    return over_faces(half_spaces(polyhedron), [&](const glm::dvec3& n) { return std::abs(glm::dot(n, v)) / 2; });
  }
};

template <std::size_t k>
Simple slabs_of(scene::ShapeView, const Outline& outline) {
  return slabs_around(outline, k);
}

// The costs were measured over two thousand random elements and a thousand rays, all of one kind.
constexpr std::array all_kinds = {
    VolumeKind{"ball", 11,
               [](scene::ShapeView e, const Outline&) -> Simple {
                 return e.visit([](const auto& shape) { return surface::ball(shape); });
               }},
    VolumeKind{"box", 11,
               [](scene::ShapeView e, const Outline&) -> Simple {
                 return e.visit([](const auto& shape) { return surface::box(shape); });
               }},
    VolumeKind{"oriented-box", 48, [](scene::ShapeView, const Outline& o) -> Simple { return oriented_box_around(o); }},
    VolumeKind{"ellipsoid", 17, [](scene::ShapeView, const Outline& o) -> Simple { return ellipsoid_around(o); }},
    VolumeKind{"slabs-3", 18, slabs_of<3>},
    VolumeKind{"slabs-7", 30, slabs_of<7>},
    VolumeKind{"slabs-13", 49, slabs_of<13>},
};

/// The kind of the least T, where share(kind) of the rays meet its volume. A share is not computed where the test alone
/// costs more than the least T, because it takes long for many slabs.
template <class Share>
const VolumeKind& cheapest_by(Share share) {
  const VolumeKind* best = all_kinds.data();
  double least = std::numeric_limits<double>::infinity();
  for (const VolumeKind& kind : all_kinds) {
    if (kind.B >= least) continue;
    const double T = kind.B + std::min(1.0, share(kind)) * I;
    if (T < least) {
      best = &kind;
      least = T;
    }
  }
  return *best;
}

}  // namespace

VolumeTest verdict(const Simple& volume, const PrecomputedRay& asked, double limit) {
  return std::visit(Test{asked, limit}, volume);
}

VolumeTest verdict(const Volume& volume, const PrecomputedRay& asked, double limit, Work& work) {
  VolumeTest last = VolumeTest::missed;
  bool some_beyond = false;
  for (const Simple& part : volume.parts) {
    ++work.volumes;
    last = verdict(part, asked, limit);
    if ((last == VolumeTest::met) == (volume.rule == Volume::Rule::union_of)) return last;
    some_beyond = some_beyond || last == VolumeTest::beyond;
  }
  return some_beyond ? VolumeTest::beyond : last;
}

double surface_of(const Simple& volume) { return std::visit(SurfaceArea{}, volume); }
double projected(const Simple& volume, const glm::dvec3& v) { return std::visit(Projected{v}, volume); }

double void_area(const Simple& volume, const Outline& outline, const glm::dvec3& v) {
  return projected(volume, v) - outline.projected(v);
}
double mean_fit(const Simple& volume, const Outline& outline) { return (surface_of(volume) - outline.surface()) / 4; }

std::span<const VolumeKind, kind_count> kinds() { return all_kinds; }

const VolumeKind& cheapest(std::span<const double> shares) {
  return cheapest_by([&](const VolumeKind& kind) { return shares[std::size_t(&kind - all_kinds.data())]; });
}
const VolumeKind& cheapest(scene::ShapeView element, double surface_of_region) {
  const Outline around = outline(element);
  return cheapest_by(
      [&](const VolumeKind& kind) { return surface_of(kind.around(element, around)) / surface_of_region; });
}
const VolumeKind& cheapest(scene::ShapeView element, const glm::dvec3& v, double area) {
  const Outline around = outline(element);
  return cheapest_by([&](const VolumeKind& kind) { return projected(kind.around(element, around), v) / area; });
}

}  // namespace durero::accel
