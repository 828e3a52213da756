#include "durero/oracle/cover.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <stdexcept>

namespace durero::oracle {
namespace {

using std::numbers::pi;

/// 2⁻⁴⁵·(|centro| + size): a sample is centro + a·e1 + b·e2 + c·e3 with orthonormal e and |a|, |b|, |c| ≤ size; its
/// few dozen roundings, and those of sine, cosine and e, each move it by less than 2⁻⁵⁰ of that sum.
double rounding(const glm::dvec3& center, double size) { return 0x1p-45 * (glm::length(center) + size); }

/// How many pieces no longer than `step` a length needs.
std::size_t pieces(double length, double step) {
  const double count = std::max(1.0, std::ceil(length / step));
  if (!(count <= 0x1p24)) throw std::length_error("a surface needs more than 2^24 samples; expected a coarser cover");
  return static_cast<std::size_t>(count);
}

/// Three orthonormal vectors, the last along the axis.
struct Frame {
  explicit Frame(const glm::dvec3& axis) : e3(glm::normalize(axis)) {
    const glm::dvec3 other = std::abs(e3.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    e1 = glm::normalize(glm::cross(e3, other));
    e2 = glm::cross(e3, e1);
  }
  glm::dvec3 e1, e2, e3;
};

/// Adds the circle of this radius at this height, its samples at most δ apart, so an arc of at most δ/2 reaches one.
void add_ring(Cover& cover, const glm::dvec3& center, const Frame& frame, double radius, double height, double delta) {
  const std::size_t count = pieces(2 * pi * radius, delta);
  if (cover.size() + count > (std::size_t{1} << 24))
    throw std::length_error("a surface needs more than 2^24 samples; expected a coarser cover");
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = 2 * pi * (double(i) + 0.5) / double(count);
    const glm::dvec3 w =
        center + frame.e1 * (radius * std::cos(angle)) + frame.e2 * (radius * std::sin(angle)) + frame.e3 * height;
    cover.x.push_back(w.x);
    cover.y.push_back(w.y);
    cover.z.push_back(w.z);
  }
}

}  // namespace

Cover cover(const scene::Sphere& sphere, double fineness) {
  const double r = sphere.radio, delta = fineness * r;
  Cover made{{}, {}, {}, delta + rounding(sphere.centro, r), 0, sphere.centro, r};
  made.gradient = 2 * (r + made.delta);  // ∇ = 2q
  const Frame frame({0, 0, 1});
  const std::size_t rings = pieces(pi * r, delta);  // meridian arcs of length ≤ δ, each with its ring in the middle
  for (std::size_t i = 0; i < rings; ++i) {
    const double angle = pi * (double(i) + 0.5) / double(rings);
    add_ring(made, sphere.centro, frame, r * std::sin(angle), r * std::cos(angle), delta);
  }
  return made;
}

Cover cover(const scene::Cylinder& cylinder, double fineness) {
  const double r = cylinder.radio, h = cylinder.altura, delta = fineness * r;
  const Frame frame(cylinder.vector);
  Cover made{{}, {}, {}, delta + rounding(cylinder.centro, r + h), 0, cylinder.centro + frame.e3 * (h / 2), r + h / 2};
  made.gradient = 2 * (r + made.delta);  // ∇ = 2(q − s·d)
  const std::size_t rings = pieces(h, delta);
  for (std::size_t i = 0; i < rings; ++i)
    add_ring(made, cylinder.centro, frame, r, h * (double(i) + 0.5) / double(rings), delta);
  return made;
}

Cover cover(const scene::Cone& cone, double fineness) {
  const double k = cone.proporcion, h = cone.altura, base = k * h, slant = std::hypot(base, h);
  const double delta = fineness * std::min(base, slant);
  const Frame frame(cone.vector);
  Cover made{{}, {}, {}, delta + rounding(cone.centro, slant), 0, cone.centro + frame.e3 * (h / 2), base + h / 2};
  made.gradient = 2 * (base + made.delta) + 2 * k * k * (h + made.delta);  // ∇ = 2(q − s·d) + 2k²(h − s)·d
  const std::size_t rings = pieces(slant, delta);
  for (std::size_t i = 0; i < rings; ++i) {
    const double s = h * (double(i) + 0.5) / double(rings);
    add_ring(made, cone.centro, frame, k * (h - s), s, delta);
  }
  return made;
}

}  // namespace durero::oracle
