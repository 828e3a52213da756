#pragma once
/// Random rays that come near the elements of any scene.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "durero/scene/query.hpp"
#include "durero/scene/scene.hpp"

namespace durero::conform {

/// The first `count` rays of RaysTowards, towards the elements of the scene that have a finite ball and are
/// trace::ordinary; a plane has no such ball. Without such an element there are no rays.
std::vector<scene::Query> rays_towards(const scene::Scene& scene, std::size_t count, std::uint64_t seed);

}  // namespace durero::conform
