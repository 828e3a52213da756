#include "durero/trace/tables.hpp"

#include "durero/surface/surfaces.hpp"

namespace durero::trace {

Tables::Tables(const scene::Scene& scene) : scene_(&scene) {
  scene.for_each([&](scene::ElementRef e, const auto& shape) {
    if (!ordinary(shape)) {
      extraordinary_.push_back(e);
      return;
    }
    balls_.push_back(surface::ball(shape));
    elements_.push_back(e);
  });
  balls_.pad();
}

}  // namespace durero::trace
