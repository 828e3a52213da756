#pragma once
/// Pictures of all that is around a point: the environment maps of the realism seed (1.5), drawn from a scene. Of a
/// scene without elements it is the same surroundings laid out in another way.

#include <cstdint>
#include <vector>

#include "durero/engine/engine.hpp"
#include "durero/render/image.hpp"
#include "durero/render/whitted.hpp"
#include "durero/scene/scene.hpp"

namespace durero::render {

/// The size of one picture whose rows have so many texels: of a panorama half as many rows, else as many.
scene::Resolution size_of(scene::Surroundings kind, std::uint32_t width);

/// The pictures of what is seen from a point, as many as pictures_of() says: each texel the colour that a ray from
/// there in its direction brings. Rows are shared among threads; every texel is the same whatever their number. Throws
/// std::domain_error of a gradient, which has no pictures, and as brought() does. Precondition: `width` is at least 1.
std::vector<Image> environment_map(const scene::Scene& scene, const engine::Engine& engine, scene::Surroundings kind,
                                   std::uint32_t width, const glm::dvec3& from, const Limits& limits);

}  // namespace durero::render
