#pragma once
/// A scene in another unit of length. Every length times one power of two is exact, and so is every answer, which is so
/// much as well: so what lies outside the range of the bounds for its unit alone is brought into it.

#include <cstdint>
#include <optional>
#include <vector>

#include "durero/scene/hit.hpp"
#include "durero/scene/query.hpp"
#include "durero/scene/scene.hpp"

namespace durero::engine {

/// The exponent of the power of two by which the lengths of a scene are multiplied, so that the most of its elements
/// are ordinary: in the middle of those that do. Nothing where as many are as it is, or where some length would not be
/// exact.
std::optional<int> unit_of(const scene::Scene& scene);

/// The scene with every length times 2^unit; each ElementRef is the same element. Precondition: it is exact, as
/// unit_of has it.
scene::Scene in_unit(const scene::Scene& scene, int unit);

/// A ray in a unit, and by what its parameter there is multiplied to be that of the ray: 2^of_parameter.
struct RayInUnit {
  model::Rayo rayo;
  int of_parameter;
};
/// The origin in the unit, the direction with a length in the range of the bounds, where it can be; nothing where a
/// number would not be exact.
std::optional<RayInUnit> in_unit(const model::Rayo& rayo, int unit);
/// Both in the unit, so that the parameter is the same.
std::optional<model::Rayo> segment_in_unit(const model::Rayo& rayo, int unit);

/// The answer to a ray of that scene, where `hit` is that in the unit: multiplied, which is exact of what is neither
/// subnormal nor infinite, and else rounded of the exact point again.
scene::Hit out_of_unit(const scene::Scene& scene, const scene::Query& query, scene::Hit hit, int unit,
                       int of_parameter);

}  // namespace durero::engine
