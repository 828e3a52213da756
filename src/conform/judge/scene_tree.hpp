#pragma once
/// A scene's tree finds the elements that a ray may meet, where there are many of them. An element that it passes over
/// meets the ray at no 0 < t ≤ limit (trace/candidates.hpp), so that what is asked of all elements may be asked of
/// those that it names.

#include <optional>

#include "durero/accel/wide/wide_bvh.hpp"
#include "durero/scene/query.hpp"
#include "durero/scene/scene.hpp"
#include "durero/trace/candidates.hpp"

namespace durero::conform {

class SceneTree {
 public:
  /// The tree of a scene, which must outlive it unedited, for about so many rays. Few elements, or few rays, are asked
  /// one by one: there is no tree then.
  SceneTree(const scene::Scene& scene, std::size_t rays) : scene_(&scene) {
    if (scene.size() >= least_elements && rays >= least_rays) tree_.emplace(scene);
  }

  const scene::Scene& scene() const { return *scene_; }

  /// visit(e) once for each element that the ray may meet at 0 < t ≤ limit(), or starts on, and perhaps for others. The
  /// limit may fall between visits.
  template <class Limit, class Visit>
  void along(const trace::Ray& ray, scene::Origin en, Limit limit, Visit visit) const {
    const auto visit_it = [&](scene::ElementRef e, auto) {
      visit(e);
      return false;
    };
    if (tree_)
      trace::any_candidate(*tree_, ray, en, limit, visit_it);
    else
      trace::any_element(*scene_, visit_it);
  }

 private:
  // A tree of n elements takes the time of some ten rays against each of them.
  static constexpr std::size_t least_elements = 48, least_rays = 8;

  const scene::Scene* scene_;
  std::optional<accel::WideBvh> tree_;
};

}  // namespace durero::conform
