#include "durero/distance/distances.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "durero/distance/bounds.hpp"
#include "durero/distance/exact.hpp"
#include "durero/surface/surfaces.hpp"

namespace durero::distance {
namespace {

using scene::NearestCount;
using scene::Proximity;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// An element, with a number that its distance is not less than.
struct NearElement {
  double low;
  scene::ElementRef element;
};

/// The elements that can be the nearest, of all that are tried.
class NearElements {
 public:
  NearElements(const scene::Scene& scene, const glm::dvec3& p, DistanceWork& work)
      : scene_(scene), p_(p), work_(work) {}

  /// A number that the scene's distance is not greater than.
  double limit() const { return limit_; }

  void attempt(scene::ElementRef e) {
    ++work_.bounds;
    const Bounds known = scene_.visit(e, [&](const auto& shape) { return bounds(shape, p_); });
    limit_ = std::min(limit_, known.high);
    if (known.low <= limit_) found_.push_back({known.low, e});
  }

  /// The nearest first.
  std::vector<NearElement> left() && {
    std::erase_if(found_, [&](const NearElement& c) { return c.low > limit_; });
    std::ranges::sort(found_, [](const NearElement& a, const NearElement& b) {
      return std::pair(a.low, a.element) < std::pair(b.low, b.element);
    });
    return std::move(found_);
  }

 private:
  const scene::Scene& scene_;
  glm::dvec3 p_;
  DistanceWork& work_;
  double limit_ = infinity;
  std::vector<NearElement> found_;
};

/// Tries the elements below a node, the nearest boxes first, but for boxes beyond the limit.
void descend(const accel::Hierarchy& tree, const glm::dvec3& p, NearElements& candidates, DistanceWork& work) {
  struct Reached {
    double low;
    accel::Hierarchy::Number node;
  };
  std::vector<Reached> left;
  if (!tree.empty()) left.push_back({0, tree.root()});
  while (!left.empty()) {
    const Reached nearest = left.back();
    left.pop_back();
    if (nearest.low > candidates.limit()) continue;
    const accel::Hierarchy::Node& node = tree[nearest.node];
    if (node.is_leaf()) {
      candidates.attempt(node.element);
      continue;
    }
    const auto before = static_cast<std::ptrdiff_t>(left.size());
    tree.any_child(nearest.node, [&](accel::Hierarchy::Number child) {
      ++work.boxes;
      left.push_back({least_distance(tree[child].box, p), child});
      return false;
    });
    std::sort(left.begin() + before, left.end(), [](const Reached& a, const Reached& b) { return a.low > b.low; });
  }
}

/// Puts the point into the answer, rounded.
void put(Proximity& answer, const exact::Nearest& found) {
  answer.count = found.many ? NearestCount::many : NearestCount::one;
  for (int i = 0; i < 3; ++i) answer.point[i] = algebra::round_to_binary64(found.point[static_cast<std::size_t>(i)]);
}

}  // namespace

Proximity Distances::nearest(const glm::dvec3& p, DistanceWork& work) const {
  const scene::Scene& scene = tree_.scene();
  NearElements candidates(scene, p, work);
  for (const scene::ElementRef e : tree_.extraordinary()) candidates.attempt(e);
  descend(tree_.hierarchy(), p, candidates, work);
  std::optional<exact::Nearest> found;
  Proximity answer;
  double limit = infinity;
  for (const auto& [low, e] : std::move(candidates).left()) {
    if (low > limit) break;
    ++work.exact;
    exact::Nearest of_element = scene.visit(e, [&](const auto& shape) { return exact::nearest(shape, p); });
    const auto order = found ? algebra::compare(of_element.squared, found->squared) : std::strong_ordering::less;
    if (order > 0) continue;
    if (order < 0) answer.elementos.clear();
    answer.elementos.push_back(e);
    if (order < 0) {
      found = std::move(of_element);
      answer.distance = algebra::rounded_root(found->squared);
      limit = std::nextafter(answer.distance, infinity);
    } else {
      exact::take(*found, std::move(of_element));
    }
  }
  if (!found) return answer;
  std::ranges::sort(answer.elementos);
  put(answer, *found);
  return answer;
}

Proximity nearest_of(const scene::Scene& scene, scene::ElementRef element, const glm::dvec3& p) {
  const exact::Nearest found = scene.visit(element, [&](const auto& shape) { return exact::nearest(shape, p); });
  Proximity answer{.distance = algebra::rounded_root(found.squared), .elementos = {element}};
  put(answer, found);
  return answer;
}

void Distances::nearest(std::span<const glm::dvec3> points, std::span<Proximity> answers) const {
  tbb::parallel_for(std::size_t{0}, points.size(), [&](std::size_t i) {
    DistanceWork unseen;
    answers[i] = nearest(points[i], unseen);
  });
}

std::optional<double> signed_distance(const scene::Scene& scene, scene::ElementRef element, const glm::dvec3& p) {
  return scene.visit(element, [&]<class Shape>(const Shape& shape) -> std::optional<double> {
    if constexpr (Shape::tipo != model::Tipo::soy_esfera) return std::nullopt;
    using number::Dyadic;
    const surface::Point<Dyadic> w{Dyadic(p.x), Dyadic(p.y), Dyadic(p.z)};
    const double distance = algebra::rounded_root(exact::nearest(shape, p).squared);
    return number::sign(surface::potencia(shape, w)) < 0 ? -distance : distance;
  });
}

}  // namespace durero::distance
