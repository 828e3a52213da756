#pragma once
/// A scene prepared for many rays without a structure: a ball around each element, all of which the filter tests. It is
/// the simplest source of candidates (trace/candidates.hpp).

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "durero/scene/element_ref.hpp"
#include "durero/scene/scene.hpp"
#include "durero/trace/filter.hpp"
#include "durero/trace/picked.hpp"
#include "durero/trace/ray.hpp"

namespace durero::trace {

/// The balls of a scene, which it keeps a reference to and which must outlive it unedited.
class Tables {
 public:
  /// O(n) for n elements.
  explicit Tables(const scene::Scene& scene);

  /// The scene of the tables.
  const scene::Scene& scene() const noexcept { return *scene_; }
  /// The elements that are not ordinary, and have no ball.
  std::span<const scene::ElementRef> extraordinary() const noexcept { return extraordinary_; }

  // Both functions are inlined into their callers: a call for each ray and element would be slower by some percent.
  /// Candidates::any (trace/candidates.hpp).
  template <class Limit, class Visit>
  [[gnu::always_inline]] bool any(const Ray& ray, Limit limit, Visit visit) const {
    Passed passed;
    for (std::size_t begin = 0; begin < elements_.size(); begin += chunk) {
      const std::size_t count = filter_chunk(ray, limit(), begin, passed);
      for (std::size_t i = 0; i < count; ++i) {
        if (visit(elements_[passed[i]])) return true;
      }
    }
    return false;
  }

  /// PairCandidates::pairs: the balls in chunks that stay in the cache, each chunk against every ray before the next.
  template <class Limit, class Visitor, class Flush>
  [[gnu::always_inline]] void pairs(std::span<const Ray> rays, Limit limit, Visitor take, Flush flush) const {
    Passed passed;
    for (std::size_t begin = 0; begin < elements_.size(); begin += chunk) {
      for (std::uint32_t number = 0; number < rays.size(); ++number) {
        const double farthest = limit(number);
        if (!(farthest > 0)) continue;
        const std::size_t count = filter_chunk(rays[number], farthest, begin, passed);
        for (std::size_t i = 0; i < count; ++i) take(number, elements_[passed[i]]);
      }
      flush();
    }
  }

  /// @{ The operations of PairCandidates. The tables name elements as the scene does.
  template <class Visit>
  decltype(auto) visit(scene::ElementRef own, Visit&& visit) const {
    return scene_->visit(own, visit);
  }
  scene::ElementRef element(scene::ElementRef own) const { return own; }
  scene::ElementRef own(scene::ElementRef e) const { return e; }
  void ask_for_own(scene::ElementRef) const {}
  void ask_for_shape(scene::ElementRef own) const {
    visit(own, [](const auto& shape) { ask_for(shape); });
  }
  /// @}

 private:
  static constexpr std::size_t chunk = 32 * Balls::block;
  using Passed = std::array<std::uint32_t, chunk>;

  std::size_t filter_chunk(const Ray& ray, double limit, std::size_t begin, Passed& passed) const {
    return filter(balls_, ray, limit, begin, std::min(begin + chunk, elements_.size()), passed.data());
  }

  const scene::Scene* scene_;
  Balls balls_;
  std::vector<scene::ElementRef> elements_;  // the element of each ball
  std::vector<scene::ElementRef> extraordinary_;
};

}  // namespace durero::trace
