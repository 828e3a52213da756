#include "sampled_solid.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>

namespace durero::oracle {
namespace {

/// The most planes whose corners are looked for: each three of them may have one.
constexpr std::size_t most_planes = 40;

/// The point that three planes have in common; nothing where two of them are nearly parallel or all along one line.
std::optional<glm::dvec3> corner(const SolidLeaf::HalfSpace& a, const SolidLeaf::HalfSpace& b,
                                 const SolidLeaf::HalfSpace& c) {
  const glm::dvec3 bc = glm::cross(b.normal, c.normal), ca = glm::cross(c.normal, a.normal),
                   ab = glm::cross(a.normal, b.normal);
  const double volume = glm::dot(a.normal, bc);
  if (std::abs(volume) < 0x1p-20) return std::nullopt;
  return (glm::dot(a.point, a.normal) * bc + glm::dot(b.point, b.normal) * ca + glm::dot(c.point, c.normal) * ab) /
         volume;
}

/// A ball around balls.
class Around {
 public:
  void add(const SolidLeaf::Extent& ball) {
    low_ = glm::min(low_, ball.center - ball.radius);
    high_ = glm::max(high_, ball.center + ball.radius);
  }
  /// Nothing where none was added.
  std::optional<SolidLeaf::Extent> ball() const {
    if (low_.x > high_.x) return std::nullopt;
    return SolidLeaf::Extent{0.5 * (low_ + high_), 0.5 * glm::length(high_ - low_)};
  }

 private:
  glm::dvec3 low_{std::numeric_limits<double>::infinity()}, high_{-std::numeric_limits<double>::infinity()};
};

}  // namespace

SampledSolid::SampledSolid(const scene::Compound& solid) : root_(node_of(solid)) {
  seen_ = extent();
  for (std::size_t leaf = 0; leaf < leaves_.size(); ++leaf)
    for (const PlacedSurface& surface : surfaces(leaf)) rounding_ = std::max(rounding_, surface.rounding());
}

SampledSolid::Node SampledSolid::node(const scene::Body& body) {
  return std::visit([&](const auto& form) { return node_of(form); }, body.form);
}

SampledSolid::Node SampledSolid::node_of(const scene::Instance& instance) {
  leaves_.emplace_back(instance);
  return {scene::Compound::Operation::united, {}, leaves_.size() - 1};
}

SampledSolid::Node SampledSolid::node_of(const scene::Compound& solid) {
  Node joined{solid.operation, {}, 0};
  for (const scene::Body& part : solid.parts) joined.parts.push_back(node(part));
  return joined;
}

SampledSolid::Truth SampledSolid::truth(const Node& node, const std::vector<Truth>& sides) {
  if (node.parts.empty()) return sides[node.leaf];
  using enum scene::Compound::Operation;
  const auto negated = [](Truth of) { return static_cast<Truth>(-static_cast<int>(of)); };
  Truth all = truth(node.parts.front(), sides);
  for (std::size_t i = 1; i < node.parts.size(); ++i) {
    const Truth next = truth(node.parts[i], sides);
    switch (node.operation) {
      case united:
        all = std::max(all, next);
        break;
      case intersected:
        all = std::min(all, next);
        break;
      case subtracted:
        all = std::min(all, negated(next));
        break;
    }
  }
  return all;
}

// A margin has few roundings of the lengths that it is made of.
std::vector<SampledSolid::Truth> SampledSolid::sides(const glm::dvec3& w, double reach) const {
  const double near = reach + rounding_ + 0x1p-45 * glm::length(w);
  std::vector<Truth> sides;
  sides.reserve(leaves_.size());
  for (const SolidLeaf& leaf : leaves_) {
    const double margin = leaf.margin(w);
    sides.push_back(margin < -near ? Truth::inside : margin > near ? Truth::outside : Truth::open);
  }
  return sides;
}

bool SampledSolid::may_have(const glm::dvec3& w, double reach) const {
  return truth(root_, sides(w, reach)) == Truth::open;
}

bool SampledSolid::may_have(const glm::dvec3& w, std::size_t leaf, double reach) const {
  std::vector<Truth> sides = this->sides(w, reach);
  sides[leaf] = Truth::open;
  return truth(root_, sides) == Truth::open;
}

bool SampledSolid::has_all(const glm::dvec3& w, std::size_t leaf, double reach) const {
  std::vector<Truth> sides = this->sides(w, reach);
  sides[leaf] = Truth::inside;
  const Truth in = truth(root_, sides);
  sides[leaf] = Truth::outside;
  return in != Truth::open && truth(root_, sides) != Truth::open && truth(root_, sides) != in;
}

/// The corners of the planes that may be in the solid. Of too many planes it is the points that they are given by.
std::vector<glm::dvec3> SampledSolid::corners() const {
  std::vector<const SolidLeaf::HalfSpace*> planes;
  std::vector<glm::dvec3> given, corners;
  for (const SolidLeaf& leaf : leaves_) {
    if (leaf.plane() == nullptr) continue;
    planes.push_back(leaf.plane());
    given.push_back(leaf.plane()->point);
  }
  if (planes.size() > most_planes) return given;
  for (std::size_t a = 0; a < planes.size(); ++a)
    for (std::size_t b = 0; b < a; ++b)
      for (std::size_t c = 0; c < b; ++c) {
        const auto at = corner(*planes[a], *planes[b], *planes[c]);
        if (at && may_hold(*at, glm::length(given[a]) + glm::length(given[b]) + glm::length(given[c])))
          corners.push_back(*at);
      }
  return corners;
}

/// Whether the solid may hold a corner that was found from lengths like this one.
bool SampledSolid::may_hold(const glm::dvec3& corner, double length) const {
  return truth(root_, sides(corner, 0x1p-30 * (length + glm::length(corner)))) != Truth::outside;
}

/// A ball that holds what the planes bound, and the leaves that end. Where there is neither, points that planes are
/// given by say where they are looked at.
SolidLeaf::Extent SampledSolid::extent() const {
  Around bounded, given;
  for (const SolidLeaf& leaf : leaves_) (leaf.plane() == nullptr ? bounded : given).add(leaf.extent());
  for (const glm::dvec3& at : corners()) bounded.add({at, 0});
  SolidLeaf::Extent seen = bounded.ball() ? *bounded.ball() : *given.ball();
  seen.radius = seen.radius > 0 ? 1.25 * seen.radius : Parametrisation::default_patch;
  return seen;
}

}  // namespace durero::oracle
