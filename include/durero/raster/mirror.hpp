#pragma once
/// A planar mirror drawn by a second camera (realism seed, 1.5).

#include <string_view>

#include "durero/engine/engine.hpp"
#include "durero/render/output/picture.hpp"
#include "durero/scene/scene.hpp"
#include "durero/scene/stage.hpp"

namespace durero::raster {

/// The picture of a scene in two passes: what a camera behind the mirror sees is laid into the pixels that show the
/// mirror. Throws std::domain_error where the name is of no element, of one that is not flat, or of one whose look is
/// not a sharp mirror's alone (glass, gloss, a texture, a relief), and where the scene is not still, as RasterScene
/// does. Precondition: max_depth is at least 1.
render::Picture by_second_camera(const scene::Scene& scene, const engine::Engine& engine, scene::Resolution size,
                                 std::string_view mirror, std::uint32_t max_depth);

}  // namespace durero::raster
