#pragma once
/// The losses of what lights and blurs a picture, where a format has no such thing.

#include <string>
#include <string_view>
#include <vector>

#include "durero/scene/scene.hpp"

namespace durero::io {

/// @{ Adds a line for lens, shapes and cones of lights, shutter, motions and glossy mirrors, of a scene that has them;
/// or of shapes of lights alone; or of the last three alone. `format` is the name of the other format.
void add_blur_losses(std::vector<std::string>& lost, const scene::Scene& scene, std::string_view format);
void add_extent_losses(std::vector<std::string>& lost, const scene::Scene& scene, std::string_view format);
void add_motion_losses(std::vector<std::string>& lost, const scene::Scene& scene, std::string_view format);
/// @}

}  // namespace durero::io
