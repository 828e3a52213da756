#pragma once
/// Selects the elements that a structure can hold.

#include <cmath>
#include <optional>

#include "durero/scene/scene.hpp"
#include "durero/surface/surfaces.hpp"
#include "durero/trace/ray.hpp"

namespace durero::accel {

/// The box of an element; nothing where the element is not ordinary, or has no finite box, as a plane.
inline std::optional<surface::Box> finite_box(const scene::Scene& scene, scene::ElementRef e) {
  return scene.visit(e, [](const auto& shape) -> std::optional<surface::Box> {
    if (!trace::ordinary(shape)) return {};
    const surface::Box box = surface::box(shape);
    if (!std::isfinite(box.low.x) || !std::isfinite(box.high.x)) return {};
    return box;
  });
}

}  // namespace durero::accel
