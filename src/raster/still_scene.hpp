#pragma once
/// A still scene is seen through a pinhole by point lights, and rests: what a raster draws.

#include "durero/scene/scene.hpp"
#include "durero/scene/stage.hpp"

namespace durero::raster {

/// The camera of a still scene. Throws std::domain_error, saying what is not so: without a camera, with a lens, with
/// something that moves, and with a light that has an extent.
const scene::Camera& still_camera(const scene::Scene& scene);

}  // namespace durero::raster
