#pragma once
/// A still scene is seen through a pinhole by point lights, and rests: a raster and a shader draw no others.

#include "durero/scene/scene.hpp"
#include "durero/scene/stage.hpp"

namespace durero::render {

/// The camera of a still scene. Throws std::domain_error, saying what is not so: without a camera, with a lens, with
/// something that moves, and with a light that has an extent or shines into a cone.
const scene::Camera& still_camera(const scene::Scene& scene);

}  // namespace durero::render
