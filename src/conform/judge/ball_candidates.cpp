#include "conform/judge/ball_candidates.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "conform/judge/allowance.hpp"

namespace durero::conform {
namespace {

/// A point of the triangle about nearest to x. It need not be: it only says which direction is tried.
glm::dvec3 about_nearest(const scene::Corners& vertices, const glm::dvec3& x) {
  const auto on_edge = [&](const glm::dvec3& a, const glm::dvec3& b) {
    const glm::dvec3 way = b - a;
    const double squared = glm::dot(way, way);
    return a + (squared > 0 ? std::clamp(glm::dot(x - a, way) / squared, 0.0, 1.0) : 0.0) * way;
  };
  const auto& [a, b, c] = vertices;
  const glm::dvec3 n = glm::cross(b - a, c - a);
  const double nn = glm::dot(n, n);
  const auto is_inside = [&](const glm::dvec3& begin, const glm::dvec3& end) {
    return glm::dot(glm::cross(end - begin, x - begin), n) >= 0;
  };
  if (nn > 0 && is_inside(a, b) && is_inside(b, c) && is_inside(c, a)) return x - glm::dot(x - a, n) / nn * n;
  glm::dvec3 best = on_edge(a, b);
  for (const glm::dvec3& other : {on_edge(b, c), on_edge(c, a)})
    if (glm::length(other - x) < glm::length(best - x)) best = other;
  return best;
}

/// The t of 0 … end at which p + t·v is about nearest to the triangle: the distance from a convex set is convex.
double about_nearest_t(const scene::Corners& vertices, const glm::dvec3& p, const glm::dvec3& v, double end) {
  const auto distance = [&](double t) {
    const glm::dvec3 x = p + t * v;
    return glm::length(about_nearest(vertices, x) - x);
  };
  double low = 0, high = end;
  for (int turn = 0; turn < 60; ++turn) {
    const double one = low + (high - low) / 3, other = high - (high - low) / 3;
    (distance(one) <= distance(other) ? high : low) = distance(one) <= distance(other) ? other : one;
  }
  return distance(0) <= distance(low) ? 0 : distance(end) <= distance(high) ? end : (low + high) / 2;
}

/// Whether the way from p to p + end·v is farther than the radius from the triangle, as the direction n shows.
///
/// For any n with |n| ≤ 1 the distance is at least the difference of n·w between the vertices and the way. Let S be the
/// largest of the coordinates of p, the vertices and end·v. A difference w − p is off by 2⁻⁵²·S for each coordinate,
/// its product with n by 6·2⁻⁵²·S together with roundings, and n·v·end by as much: 2⁻⁴⁸·S for all. |n| is at most 1 +
/// 2⁻⁵⁰ where it was divided by its length, for which the radius is made larger by 2⁻⁴⁸ of it. A product that
/// underflows is off by 2⁻¹⁰⁷⁵, times the end for v.
bool is_apart_along(const glm::dvec3& n, const scene::Corners& vertices, const glm::dvec3& p, const glm::dvec3& v,
                    double end, double radius) {
  const double S = std::max({largest(p), largest(vertices), end * largest(v)});
  double least = std::numeric_limits<double>::infinity();
  for (const glm::dvec3& vertex : vertices) least = std::min(least, glm::dot(n, vertex - p));
  const double most = std::max(0.0, glm::dot(n, v) * end);
  const double slack = 0x1p-47 * S + 0x1p-1060 * std::max(1.0, end);
  return least - most > radius * (1 + 0x1p-47) + slack;
}

/// About the first t at which the ball touches: each step goes as far as nothing can be nearer.
double about_first_touch(const scene::Corners& vertices, const glm::dvec3& p, const glm::dvec3& v, double radius,
                         double end) {
  const double speed = glm::length(v);
  double t = 0;
  for (int step = 0; step < 24 && t < end; ++step) {
    const glm::dvec3 x = p + t * v;
    const double apart = glm::length(about_nearest(vertices, x) - x) - radius;
    if (!(apart > 1e-9 * radius)) break;
    t += apart / speed;
  }
  return t;
}

}  // namespace

/// The middle is farther than the radius from all triangles where t·|v| in the largest coordinate of v is more than the
/// largest coordinates of p and of these and the radius together. Roundings are less than 2⁻⁴⁰ of the end.
BallWay::BallWay(const scene::Scene& scene, const model::Rayo& rayo, double radius)
    : scene_(&scene), p_(rayo.p().xyz()), v_(rayo.v().xyz()), radius_(radius) {
  double farthest = 0;
  for (const scene::Triangle& triangle : scene.shapes<scene::Triangle>())
    farthest = std::max(farthest, largest(triangle.vertices));
  end_ = (largest(p_) + farthest + radius) / largest(v_) * (1 + 0x1p-40);
}

double BallWay::usable(double limit) const { return std::min(limit, end_); }

std::vector<BallWay::Candidate> BallWay::candidates(double limit) const {
  const double end = usable(limit);
  std::vector<Candidate> all;
  const auto& triangles = scene_->shapes<scene::Triangle>();
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    const scene::Corners& vertices = triangles[i].vertices;
    if (!std::isfinite(end)) {
      all.push_back({0, i});
      continue;
    }
    const glm::dvec3 x = p_ + end * v_;
    bool is_apart = false;  // from the box of the way, along a coordinate
    for (int k = 0; k < 3 && !is_apart; ++k) {
      glm::dvec3 n(0);
      for (n[k] = -1; n[k] < 2 && !is_apart; n[k] += 2) is_apart = is_apart_along(n, vertices, p_, v_, end, radius_);
    }
    if (!is_apart && std::isfinite(largest(x)))
      all.push_back({about_first_touch(vertices, p_, v_, radius_, end), i});
    else if (!is_apart)
      all.push_back({0, i});
  }
  std::ranges::sort(all, [](const Candidate& a, const Candidate& b) { return a.t < b.t; });
  return all;
}

bool BallWay::may_touch(std::uint32_t index, double limit) const {
  const double end = usable(limit);
  if (!std::isfinite(end)) return true;
  const scene::Corners& vertices = scene_->shapes<scene::Triangle>()[index].vertices;
  const glm::dvec3 x = p_ + about_nearest_t(vertices, p_, v_, end) * v_, way = about_nearest(vertices, x) - x;
  const double length = glm::length(way);
  if (!(length > 0) || !std::isfinite(length)) return true;
  return !is_apart_along(way / length, vertices, p_, v_, end, radius_);
}

}  // namespace durero::conform
