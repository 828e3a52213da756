#pragma once
/// Solids that are made of others.

#include <glm/vec3.hpp>
#include <optional>

#include "durero/scene/body.hpp"

namespace durero::scene {

/// A shape where it stands, as a body.
Body unmoved(const AnyShape& shape);

/// The box between two corners, as what lies behind six planes; nothing where it has no inside.
std::optional<Compound> box_between(const glm::dvec3& a, const glm::dvec3& b);

}  // namespace durero::scene
