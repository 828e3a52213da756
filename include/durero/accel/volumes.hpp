#pragma once
/// Bounding volumes without a hierarchy: one around each element, each ray tested against all. The tests saved are
/// of elements; their number stays a multiple of the number of elements.

#include <span>
#include <vector>

#include "durero/accel/volume/volume.hpp"
#include "durero/accel/work.hpp"
#include "durero/scene/scene.hpp"

namespace durero::accel {

/// Each element of a scene in a volume of its own kind.
class Volumes {
 public:
  /// For each element the volume, of one kind or composed, that is cheapest for isotropic rays through the box about
  /// the scene. The scene must outlive it unedited.
  explicit Volumes(const scene::Scene& scene);
  /// One kind for all.
  Volumes(const scene::Scene& scene, const Kind& kind);

  /// The surface of the box about all elements of a scene that have one; 0 where none has.
  static double region(const scene::Scene& scene);

  /// What it is made of.
  const scene::Scene& scene() const noexcept { return *scene_; }
  /// The elements that are not ordinary, and planes.
  std::span<const scene::ElementRef> extraordinary() const noexcept { return apart_; }
  /// What it holds.
  Size size() const;

  /// An element and its volume.
  struct Bounded {
    scene::ElementRef element;  ///< what is within
    Volume volume;              ///< one kind, or composed
  };
  /// All of them, those that are made alike together, so that the processor foresees what comes next. A volume may be
  /// replaced by another that contains the element.
  std::span<Bounded> bounded() noexcept { return bounded_; }
  /// The same, to look at.
  std::span<const Bounded> bounded() const noexcept { return bounded_; }

  /// As trace::Candidates has it; adds what it did to `work`.
  template <class Limit, class Visit>
  bool any(const trace::Ray& ray, Limit limit, Visit visit, Work& work) const {
    if (bounded_.empty()) return false;
    const Asked asked(ray, most_slabs_);
    for (const auto& [element, volume] : bounded_) {
      const Verdict found = verdict(volume, asked, limit(), work);
      if (found == Verdict::missed) ++work.by_miss;
      if (found == Verdict::beyond) ++work.by_distance;
      if (found != Verdict::met) continue;
      ++work.candidates;
      if (visit(element)) return true;
    }
    return false;
  }

 private:
  template <class Choose>
  void bound(Choose choose);

  const scene::Scene* scene_;
  std::vector<Bounded> bounded_;
  std::vector<scene::ElementRef> apart_;
  std::size_t most_slabs_ = most_slabs;
};

}  // namespace durero::accel
