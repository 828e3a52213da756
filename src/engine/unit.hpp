#pragma once
/// A scene in another unit of length. Multiplying every length by one power of two is exact, and multiplies every
/// answer by it. A scene whose lengths lie outside the range of the bounds (trace/ray.hpp) is brought into it so.

#include <cstdint>
#include <optional>
#include <vector>

#include "durero/scene/hit.hpp"
#include "durero/scene/query.hpp"
#include "durero/scene/scene.hpp"

namespace durero::engine {

/// The unit in which most elements of a scene are ordinary: the exponent of a power of two that multiplies lengths, the
/// middle one of a range that does equally well. Nothing where no unit does better than the scene's own, or where some
/// length would not be exact.
std::optional<int> unit_of(const scene::Scene& scene);

/// The scene with every length times 2^unit; each ElementRef names the same element. Precondition: the lengths are
/// exact, as after unit_of.
scene::Scene in_unit(const scene::Scene& scene, int unit);

/// A ray in a unit. Its parameters times 2^of_parameter are those of the ray outside.
struct RayInUnit {
  model::Rayo rayo;
  int of_parameter;
};
/// The ray with its origin in the unit, and its direction scaled into the range of the bounds where it is far from it;
/// nothing where a number would not be exact.
std::optional<RayInUnit> in_unit(const model::Rayo& rayo, int unit);
/// The segment with origin and direction in the unit, which keeps the parameter; nothing where a number would not be
/// exact.
std::optional<model::Rayo> segment_in_unit(const model::Rayo& rayo, int unit);

/// The hit of a ray in `scene`, where `hit` is its hit in the unit. Multiplying back is exact for normal numbers;
/// otherwise the exact point is rounded again.
scene::Hit out_of_unit(const scene::Scene& scene, const scene::Query& query, scene::Hit hit, int unit,
                       int of_parameter);

}  // namespace durero::engine
