#include "durero/accel/volumes.hpp"

#include <algorithm>

#include "accel/finite_box.hpp"
#include "durero/accel/hierarchy.hpp"

namespace durero::accel {

template <class Choose>
void Volumes::bound(Choose choose) {
  scene_->for_each([&](scene::ElementRef e, const auto& shape) {
    if (!finite_box(*scene_, e)) return apart_.push_back(e);
    const scene::ShapeView element(shape);
    bounded_.push_back({e, {{choose(element).around(element, outline(element))}}});
  });
  std::ranges::stable_sort(bounded_, {}, [](const Bounded& one) { return one.volume.parts[0].index(); });
}

Volumes::Volumes(const scene::Scene& scene, const Kind& kind) : scene_(&scene) {
  bound([&](scene::ShapeView) -> const Kind& { return kind; });
}

Volumes::Volumes(const scene::Scene& scene) : scene_(&scene) {
  std::optional<surface::Box> all;
  scene.for_each([&](scene::ElementRef e, const auto&) {
    if (const auto box = finite_box(scene, e)) all = all ? around(*all, *box) : *box;
  });
  bound([&](scene::ShapeView element) -> const Kind& { return cheapest(element, area<double>(*all)); });
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
