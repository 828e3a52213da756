#include "durero/oracle/cover.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace durero::oracle {
namespace {

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

/// The middle of the piece i of n, as a part of the whole.
double middle(std::size_t i, std::size_t n) { return (double(i) + 0.5) / double(n); }

/// The rings of one cover, of which its samples and the tree of balls over them follow.
class Rings {
 public:
  Rings(const Parametrisation& surface, double delta) : surface_(surface), delta_(delta) {
    // Pieces of the profile of length at most δ, each with its ring in the middle.
    const std::size_t rings = pieces(surface.length(), delta);
    rings_.reserve(rings);
    for (std::size_t i = 0; i < rings; ++i) add(middle(i, rings));
  }

  CoverPlan outline() const {
    return {ball(0, rings_.size()), delta(), rings_.back().last * sizeof(glm::dvec3) + balls() * sizeof(BallNode)};
  }

  Cover cover() const {
    Cover cover;
    cover.delta = delta();
    cover.balls.reserve(balls());
    add_balls(cover.balls, 0, rings_.size());
    cover.samples.reserve(rings_.back().last);
    for (const Ring& ring : rings_) {
      const std::size_t count = ring.last - ring.first;
      for (std::size_t i = 0; i < count; ++i) cover.samples.push_back(surface_.point(ring.u, middle(i, count)));
    }
    return cover;
  }

 private:
  struct Ring {
    double u;
    std::uint32_t first, last;
  };

  double delta() const { return delta_ + surface_.rounding(); }
  /// A ball for each ring, and one for each place between two.
  std::size_t balls() const { return 2 * rings_.size() - 1; }

  /// Adds the line of equal u, its samples at most δ apart, so an arc of at most δ/2 reaches one.
  void add(double u) {
    const std::size_t count = pieces(surface_.around(u), delta_);
    const std::size_t first = rings_.empty() ? 0 : rings_.back().last;
    if (first + count > max_samples) too_many();
    rings_.push_back({u, std::uint32_t(first), std::uint32_t(first + count)});
  }

  /// The ball around the rings [first, last): its centre midway between the middles of the outermost of them.
  BallNode ball(std::size_t first, std::size_t last) const {
    const glm::dvec3 center = 0.5 * (surface_.middle(rings_[first].u) + surface_.middle(rings_[last - 1].u));
    double radius = 0;
    for (std::size_t i = first; i < last; ++i) radius = std::max(radius, surface_.reach(rings_[i].u, center));
    return {center, radius + surface_.rounding(), rings_[first].first, rings_[last - 1].last, 0};
  }

  void add_balls(std::vector<BallNode>& balls, std::size_t first, std::size_t last) const {
    const std::size_t at = balls.size();
    balls.push_back(ball(first, last));
    if (last - first == 1) return;
    const std::size_t half = (first + last) / 2;
    add_balls(balls, first, half);
    balls[at].right = std::uint32_t(balls.size());
    add_balls(balls, half, last);
  }

  const Parametrisation& surface_;
  double delta_;
  std::vector<Ring> rings_;
};

}  // namespace

CoverPlan outline(const Parametrisation& surface, double fineness) {
  return Rings(surface, fineness * surface.widest()).outline();
}

Cover cover(const Parametrisation& surface, double fineness) {
  return Rings(surface, fineness * surface.widest()).cover();
}

}  // namespace durero::oracle
