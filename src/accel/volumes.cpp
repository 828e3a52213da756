#include "durero/accel/volumes.hpp"

#include <algorithm>
#include <tuple>

#include "accel/finite_box.hpp"
#include "durero/accel/hierarchy.hpp"
#include "durero/accel/volume/choice.hpp"

namespace durero::accel {

template <class Choose>
void Volumes::bound(Choose choose) {
  scene_->for_each([&](scene::ElementRef e, const auto& shape) {
    if (!finite_box(*scene_, e)) return apart_.push_back(e);
    bounded_.push_back({e, choose(scene::ShapeView(shape))});
  });
  std::ranges::stable_sort(bounded_, {}, [](const Bounded& one) {
    const std::vector<Simple>& parts = one.volume.parts;
    return std::tuple(parts.size(), one.volume.rule, parts.front().index(), parts.back().index());
  });
}

Volumes::Volumes(const scene::Scene& scene, const VolumeKind& kind) : scene_(&scene) {
  bound([&](scene::ShapeView element) { return Volume{{kind.around(element, outline(element))}}; });
}

Volumes::Volumes(const scene::Scene& scene) : scene_(&scene) {
  bound([all = region(scene)](scene::ShapeView element) { return choose(element, all).volume; });
}

double Volumes::region(const scene::Scene& scene) {
  std::optional<surface::Box> all;
  scene.for_each([&](scene::ElementRef e, const auto&) {
    if (const auto box = finite_box(scene, e)) all = all ? around(*all, *box) : *box;
  });
  return all ? area<double>(*all) : 0;
}

Size Volumes::size() const {
  Size size;
  size.elements = size.references = bounded_.size();
  size.cells = bounded_.size();
  size.apart = apart_.size();
  size.bytes = bounded_.capacity() * sizeof(Bounded) + apart_.capacity() * sizeof(scene::ElementRef);
  for (const Bounded& one : bounded_) {
    size.bytes += one.volume.parts.capacity() * sizeof(Simple);
    for (const Simple& part : one.volume.parts)
      if (const auto* slabs = std::get_if<Slabs>(&part)) size.bytes += slabs->along.capacity() * sizeof(Slab);
  }
  return size;
}

}  // namespace durero::accel
