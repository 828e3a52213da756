#include "written_box.hpp"

#include <algorithm>

namespace durero::io {
namespace {

/// The plane that a part of a solid is, behind the map that all parts share; null where it is another part.
const scene::Plane* plane_by(const scene::Body& part, const model::Mapa& by) {
  const auto* const copy = std::get_if<scene::Instance>(&part.form);
  return copy != nullptr && copy->mapa == by ? std::get_if<scene::Plane>(&copy->shape) : nullptr;
}

}  // namespace

std::optional<WrittenBox> written_box(const scene::Body& body) {
  const auto* const solid = std::get_if<scene::Compound>(&body.form);
  if (solid == nullptr || solid->operation != scene::Compound::Operation::intersected || solid->parts.size() != 6)
    return std::nullopt;
  const auto* const first = std::get_if<scene::Instance>(&solid->parts.front().form);
  if (first == nullptr) return std::nullopt;
  WrittenBox box{{}, {}, first->mapa};
  for (std::size_t i = 0; i < 6; ++i) {
    const scene::Plane* const plane = plane_by(solid->parts[i], box.by);
    const int axis = static_cast<int>(i / 2);
    glm::dvec3 outwards(0);
    outwards[axis] = i % 2 == 0 ? -1 : 1;
    if (plane == nullptr || plane->vector != outwards) return std::nullopt;
    (i % 2 == 0 ? box.low : box.high)[axis] = plane->centro[axis];
  }
  const bool has_inside = box.low.x < box.high.x && box.low.y < box.high.y && box.low.z < box.high.z;
  return has_inside ? std::optional(box) : std::nullopt;
}

}  // namespace durero::io
