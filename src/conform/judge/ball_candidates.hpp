#pragma once
/// The elements that a moving ball may touch, in about the order in which it does. Binary64 leaves out triangles that
/// it certainly does not touch.

#include <limits>
#include <optional>
#include <vector>

#include "durero/scene/scene.hpp"

namespace durero::conform {

/// A ball's way along one ray. The scene must outlive it unedited.
class BallWay {
 public:
  /// Precondition: the radius is positive.
  BallWay(const scene::Scene& scene, const model::Rayo& rayo, double radius);

  /// touch(element) of the elements that the ball may touch at 0 ≤ t ≤ limit(), and perhaps of others, until it returns
  /// true. Triangles come last, in about the order of their first touch. The limit may fall between calls.
  template <class Limit, class Touch>
  bool any_of(Limit limit, Touch touch) const {
    const bool is_found = scene_->any_of([&](scene::ElementRef element, const auto&) {
      return element.tipo != scene::Triangle::tipo && touch(element);
    });
    if (is_found) return true;
    for (const Candidate& candidate : candidates(limit())) {
      if (may_touch(candidate.index, limit()) && touch({scene::Triangle::tipo, candidate.index})) return true;
    }
    return false;
  }

 private:
  struct Candidate {
    double t;  ///< about the first touch
    std::uint32_t index;
  };
  /// The triangles whose boxes the ball may meet up to the limit, by the first touch as binary64 has it.
  std::vector<Candidate> candidates(double limit) const;
  /// Whether the ball may touch the triangle up to the limit: false is certain.
  bool may_touch(std::uint32_t index, double limit) const;
  double usable(double limit) const;

  const scene::Scene* scene_;
  glm::dvec3 p_, v_;
  double radius_, end_;  ///< beyond the end no triangle is touched
};

}  // namespace durero::conform
