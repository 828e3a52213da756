#pragma once
/// Bounding volumes without a hierarchy: a volume around each element, each tested against every ray (A §1.2). They
/// save tests of elements; the number of tests still grows with the number of elements.

#include <span>
#include <vector>

#include "durero/accel/volume/volume.hpp"
#include "durero/accel/work.hpp"
#include "durero/scene/scene.hpp"

namespace durero::accel {

/// A scene's elements, each in a volume of its own kind.
class Volumes {
 public:
  /// Chooses for each element the volume, simple or composed, that is cheapest for isotropic rays through the scene's
  /// box. The scene must outlive it unedited.
  explicit Volumes(const scene::Scene& scene);
  /// Uses one kind for all elements. The scene must outlive it unedited.
  Volumes(const scene::Scene& scene, const VolumeKind& kind);

  /// The surface of the box around all elements of a scene that have one; 0 where none has.
  static double region(const scene::Scene& scene);

  /// The scene of the volumes.
  const scene::Scene& scene() const noexcept { return *scene_; }
  /// The elements that are not ordinary, and planes.
  std::span<const scene::ElementRef> extraordinary() const noexcept { return apart_; }
  /// The structure's size.
  Size size() const;

  /// An element and its volume.
  struct Bounded {
    scene::ElementRef element;  ///< the element
    Volume volume;              ///< of one kind, or composed
  };
  /// The elements and their volumes. Volumes of one make stand together, so that the processor predicts their tests. A
  /// volume may be replaced by another that contains the element.
  std::span<Bounded> bounded() noexcept { return bounded_; }
  /// The elements and their volumes, read only.
  std::span<const Bounded> bounded() const noexcept { return bounded_; }

  /// Candidates::any (trace/candidates.hpp); adds its work to `work`.
  template <class Limit, class Visit>
  bool any(const trace::Ray& ray, Limit limit, Visit visit, Work& work) const {
    if (bounded_.empty()) return false;
    const PrecomputedRay asked(ray, most_slabs_);
    for (const auto& [element, volume] : bounded_) {
      const VolumeTest found = verdict(volume, asked, limit(), work);
      if (found == VolumeTest::missed) ++work.by_miss;
      if (found == VolumeTest::beyond) ++work.by_distance;
      if (found != VolumeTest::met) continue;
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
