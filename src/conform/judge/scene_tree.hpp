#pragma once
/// A scene's tree finds the elements that a ray may meet, where there are many of them. An element that it passes over
/// meets the ray at no 0 < t ≤ limit (trace/candidates.hpp), so that what is asked of all elements may be asked of
/// those that it names.

#include <algorithm>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "conform/judge/torus.hpp"
#include "durero/accel/wide/wide_bvh.hpp"
#include "durero/composed/figure.hpp"
#include "durero/scene/query.hpp"
#include "durero/scene/scene.hpp"
#include "durero/trace/candidates.hpp"

namespace durero::conform {

class SceneTree {
 public:
  /// The tree of a scene, which must outlive it unedited, for about so many rays. Few elements, or few rays, are asked
  /// one by one: there is no tree then. Nor is there one of a scene with bodies or surfaces of a text, which stand
  /// elsewhere in the tables; `others`, which must outlive the tree, says which of them are tori, and has the surfaces.
  SceneTree(const scene::Scene& scene, std::size_t rays, const OtherElements& others = {})
      : scene_(&scene), others_(others) {
    if (scene.has_bodies()) make_figures(others.bodies);
    if (!scene.has_bodies() && others.surfaces.empty() && scene.size() >= least_elements && rays >= least_rays)
      tree_.emplace(scene);
  }

  const scene::Scene& scene() const { return *scene_; }

  /// Whether the element is none of the model's shapes.
  bool is_other(scene::ElementRef e) const {
    return figure(e) != nullptr || torus(e) != nullptr || surface(e) != nullptr;
  }
  /// The element, where it is a surface of a text; otherwise null.
  const AskedSurface* surface(scene::ElementRef e) const { return others_.surface(e); }
  /// The element, where it is a torus; otherwise null.
  const Torus* torus(scene::ElementRef e) const {
    const auto found = std::ranges::find(tori_, e, &NamedTorus::element);
    return found == tori_.end() ? nullptr : &found->torus;
  }
  /// The points of the element as a ray meets them, where it is a body and no torus; otherwise null.
  const composed::Figure* figure(scene::ElementRef e) const {
    return figures_.empty() || e.tipo != scene::Sphere::tipo ? nullptr : figures_[e.index].get();
  }

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
  struct NamedTorus {
    scene::ElementRef element;
    Torus torus;
  };

  void make_figures(std::span<const NamedBody> bodies) {
    for (const auto& [element, body] : bodies) {
      if (body.kind == BodyKind::toro) tori_.push_back({element, Torus(body)});
    }
    figures_.resize(scene_->shapes<scene::Sphere>().size());
    for (std::uint32_t i = 0; i < figures_.size(); ++i) {
      const scene::ElementRef e{scene::Sphere::tipo, i};
      const scene::Body* const body = scene_->body(e);
      if (body != nullptr && torus(e) == nullptr) figures_[i] = composed::figure(*body);
    }
  }

  // A tree of n elements takes the time of some ten rays against each of them.
  static constexpr std::size_t least_elements = 48, least_rays = 8;

  const scene::Scene* scene_;
  OtherElements others_;
  std::optional<accel::WideBvh> tree_{};
  std::vector<NamedTorus> tori_{};
  std::vector<std::unique_ptr<const composed::Figure>> figures_{};  // by the row of the sphere that a body stands as
};

}  // namespace durero::conform
