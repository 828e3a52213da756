#include "durero/distance/sphere_tracing.hpp"

#include <algorithm>
#include <boost/container/small_vector.hpp>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <vector>

#include "durero/distance/bounds.hpp"

namespace durero::distance {
namespace {

/// Beyond this magnitude of a coordinate bounds tell nothing; nothing that they told of lies there.
constexpr double farthest = 0x1p99;

double low_of(const scene::Scene& scene, scene::ElementRef e, const glm::dvec3& p) {
  return scene.visit(e, [&](const auto& shape) { return bounds(shape, p).low; });
}

/// A ray as it is walked along. The computed point p + t·v is off by two roundings in each coordinate, and the computed
/// length of v by four: what a distance loses by the first, and a step by the second.
struct SteppedRay {
  glm::dvec3 p, v;
  double speed;
  explicit SteppedRay(const model::Rayo& ray) : p(ray.p().xyz()), v(ray.v().xyz()), speed(glm::length(v)) {}
  glm::dvec3 at(double t) const { return p + t * v; }
  double lost(double t) const {
    const glm::dvec3 sum = glm::abs(p) + std::abs(t) * glm::abs(v);
    return (sum.x + sum.y + sum.z) * 0x1p-51;
  }
  double step(double distance) const { return distance / speed * (1 - 0x1p-49); }
};

/// The parameter from which on the ray is outside a box for ever, or more.
double end_of(const surface::Box& box, const SteppedRay& way) {
  double end = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    const double plane = way.v[i] > 0 ? box.high[i] : box.low[i];
    if (way.v[i] != 0) end = std::min(end, (plane - way.p[i]) / way.v[i]);
  }
  return end + std::abs(end) * 0x1p-49;
}

double usual_epsilon(const accel::Hierarchy& tree) {
  constexpr double share = 0x1p-20;
  if (tree.empty()) return share;
  const surface::Box& box = tree[tree.root()].box;
  return share * std::max({box.high.x - box.low.x, box.high.y - box.low.y, box.high.z - box.low.z});
}

}  // namespace

/// The least lower bound of the distances of the elements, and whose it is.
struct SphereTracer::Least {
  double low = std::numeric_limits<double>::infinity();
  scene::ElementRef element{};
};

SphereTracer::SphereTracer(const scene::Scene& scene, double epsilon)
    : tree_(scene), epsilon_(epsilon > 0 ? epsilon : usual_epsilon(tree_.hierarchy())) {}

SphereTracer::Least SphereTracer::least(const glm::dvec3& p, std::span<const scene::ElementRef> without) const {
  const accel::Hierarchy& tree = tree_.hierarchy();
  Least found;
  const auto attempt = [&](scene::ElementRef e) {
    if (std::ranges::find(without, e) != without.end()) return;
    const double low = low_of(tree_.scene(), e, p);
    if (low < found.low) found = {low, e};
  };
  for (const scene::ElementRef e : tree_.extraordinary()) attempt(e);
  const auto descend = [&](auto&& again, accel::Hierarchy::Number node) -> void {
    if (tree[node].is_leaf()) return attempt(tree[node].element);
    boost::container::small_vector<std::pair<double, accel::Hierarchy::Number>, 16> children;
    tree.any_child(node, [&](accel::Hierarchy::Number child) {
      children.emplace_back(least_distance(tree[child].box, p), child);
      return false;
    });
    std::ranges::sort(children);
    for (const auto& [low, child] : children)
      if (low < found.low) again(again, child);
  };
  if (!tree.empty()) descend(descend, tree.root());
  return found;
}

Walk SphereTracer::walk(const scene::Query& query) const {
  const SteppedRay way(query.rayo);
  const accel::Hierarchy& tree = tree_.hierarchy();
  const bool bounded = tree_.extraordinary().empty();
  constexpr double never = std::numeric_limits<double>::infinity();
  const double end = !bounded ? never : tree.empty() ? -never : end_of(tree[tree.root()].box, way);
  scene::ElementSet own(query.en.begin(), query.en.end());
  Walk walk;
  for (; walk.steps < most_steps; ++walk.steps) {
    const glm::dvec3 p = way.at(walk.t);
    const bool is_far = std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) > farthest;
    if (walk.t > end || is_far || !std::isfinite(walk.t)) return walk;
    const auto has_left = [&](scene::ElementRef e) { return low_of(tree_.scene(), e, p) > epsilon_; };
    own.erase(std::remove_if(own.begin(), own.end(), has_left), own.end());
    const Least nearest = least(p, {own.data(), own.size()});
    const double distance = nearest.low - way.lost(walk.t);
    if (distance <= epsilon_) {
      walk.end = WalkEnd::near;
      walk.element = nearest.element;
      return walk;
    }
    walk.t += way.step(own.empty() ? distance : std::min(distance, epsilon_));
  }
  walk.end = WalkEnd::tired;
  return walk;
}

}  // namespace durero::distance
