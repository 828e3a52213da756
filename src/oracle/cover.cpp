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

constexpr std::size_t max_samples = std::size_t{1} << 24;

[[noreturn]] void too_many() {
  throw std::length_error("a surface needs more than 2^24 samples; expected a coarser cover");
}

/// How many pieces no longer than `step` a length needs.
std::size_t pieces(double length, double step) {
  const double count = std::max(1.0, std::ceil(length / step));
  if (!(count <= double(max_samples))) too_many();
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

/// Makes the rings of one cover, then the tree of balls over them.
class Rings {
 public:
  Rings(const glm::dvec3& center, const glm::dvec3& axis, double delta)
      : center_(center), frame_(axis), delta_(delta) {}

  /// Adds the circle of this radius at this height, its samples at most δ apart, so an arc of at most δ/2 reaches one.
  void add(double radius, double height) {
    const std::size_t count = pieces(2 * pi * radius, delta_);
    if (samples_.size() + count > max_samples) too_many();
    const std::size_t first = samples_.size();
    for (std::size_t i = 0; i < count; ++i) {
      const double angle = 2 * pi * (double(i) + 0.5) / double(count);
      samples_.push_back(center_ + frame_.e1 * (radius * std::cos(angle)) + frame_.e2 * (radius * std::sin(angle)) +
                         frame_.e3 * height);
    }
    rings_.push_back({radius, height, std::uint32_t(first), std::uint32_t(samples_.size())});
  }

  /// size: the largest length of the element; gradient(δ): the bound of |∇potencia| within δ of it.
  template <class Gradient>
  Cover cover(double size, Gradient gradient) && {
    Cover made;
    made.delta = delta_ + rounding(center_, size);
    made.gradient = gradient(made.delta);
    add_balls(made.balls, 0, rings_.size(), rounding(center_, size));
    made.samples = std::move(samples_);
    return made;
  }

 private:
  struct Ring {
    double radius, height;
    std::uint32_t first, last;
  };

  /// The ball around the rings [first, last): its centre on the axis midway between the outermost of them.
  void add_balls(std::vector<Ball>& balls, std::size_t first, std::size_t last, double slack) const {
    const double middle = (rings_[first].height + rings_[last - 1].height) / 2;
    double radius = 0;
    for (std::size_t i = first; i < last; ++i)
      radius = std::max(radius, std::hypot(rings_[i].radius, rings_[i].height - middle));
    const std::size_t ball = balls.size();
    balls.push_back({center_ + frame_.e3 * middle, radius + slack, rings_[first].first, rings_[last - 1].last, 0});
    if (last - first == 1) return;
    const std::size_t half = (first + last) / 2;
    add_balls(balls, first, half, slack);
    balls[ball].right = std::uint32_t(balls.size());
    add_balls(balls, half, last, slack);
  }

  glm::dvec3 center_;
  Frame frame_;
  double delta_;
  std::vector<glm::dvec3> samples_;
  std::vector<Ring> rings_;
};

}  // namespace

Cover cover(const scene::Sphere& sphere, double fineness) {
  const double r = sphere.radio, delta = fineness * r;
  Rings made(sphere.centro, {0, 0, 1}, delta);
  const std::size_t rings = pieces(pi * r, delta);  // meridian arcs of length ≤ δ, each with its ring in the middle
  for (std::size_t i = 0; i < rings; ++i) {
    const double angle = pi * (double(i) + 0.5) / double(rings);
    made.add(r * std::sin(angle), r * std::cos(angle));
  }
  return std::move(made).cover(r, [=](double d) { return 2 * (r + d); });  // ∇ = 2q
}

Cover cover(const scene::Cylinder& cylinder, double fineness) {
  const double r = cylinder.radio, h = cylinder.altura, delta = fineness * r;
  Rings made(cylinder.centro, cylinder.vector, delta);
  const std::size_t rings = pieces(h, delta);
  for (std::size_t i = 0; i < rings; ++i) made.add(r, h * (double(i) + 0.5) / double(rings));
  return std::move(made).cover(r + h, [=](double d) { return 2 * (r + d); });  // ∇ = 2(q − s·d)
}

Cover cover(const scene::Cone& cone, double fineness) {
  const double k = cone.proporcion, h = cone.altura, base = k * h, slant = std::hypot(base, h);
  const double delta = fineness * std::min(base, slant);
  Rings made(cone.centro, cone.vector, delta);
  const std::size_t rings = pieces(slant, delta);
  for (std::size_t i = 0; i < rings; ++i) {
    const double s = h * (double(i) + 0.5) / double(rings);
    made.add(k * (h - s), s);
  }
  // ∇ = 2(q − s·d) + 2k²(h − s)·d
  return std::move(made).cover(slant, [=](double d) { return 2 * (base + d) + 2 * k * k * (h + d); });
}

}  // namespace durero::oracle
