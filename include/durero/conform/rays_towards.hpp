#pragma once
/// Random rays that have something to say of a scene, whatever is in it.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "durero/scene/query.hpp"
#include "durero/scene/scene.hpp"

namespace durero::conform {

/// So many rays as RaysTowards draws them, towards the elements of the scene that have a ball: a plane has none, nor
/// has what is not trace::ordinary. None where no element has.
std::vector<scene::Query> rays_towards(const scene::Scene& scene, std::size_t count, std::uint64_t seed);

}  // namespace durero::conform
