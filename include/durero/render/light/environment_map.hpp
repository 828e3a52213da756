#pragma once
/// An environment map holds pictures of all that surrounds a point (realism seed, 1.5), drawn from a scene. For a scene
/// without elements it is the same surroundings laid out in another way.

#include <cstdint>
#include <vector>

#include "durero/engine/engine.hpp"
#include "durero/render/light/whitted.hpp"
#include "durero/render/output/image.hpp"
#include "durero/scene/scene.hpp"
#include "durero/scene/stage.hpp"

namespace durero::render {

/// The size of one picture whose rows have `width` texels: a panorama has half as many rows, any other picture as many.
scene::Resolution size_of(scene::Surroundings kind, std::uint32_t width);

/// The pictures of the view from a point, as many as pictures_of() says: each texel has the colour that a ray from
/// there in its direction brings. Rows are shared among threads; every texel is the same whatever their number. Throws
/// std::domain_error for a gradient, which has no pictures, and as brought() does. Precondition: `width` is at least 1.
std::vector<Image> environment_map(const scene::Scene& scene, const engine::Engine& engine, scene::Surroundings kind,
                                   std::uint32_t width, const glm::dvec3& from, const PathLimits& limits);

}  // namespace durero::render
