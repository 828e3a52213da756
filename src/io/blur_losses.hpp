#pragma once
/// The losses of what blurs a picture, where a format has no such thing.

#include <string>
#include <string_view>
#include <vector>

#include "durero/scene/scene.hpp"

namespace durero::io {

/// Adds a line for lens, shutter, motions, shapes of lights and glossy mirrors, of a scene that has them. `format` is
/// the name of the other format.
void add_blur_losses(std::vector<std::string>& lost, const scene::Scene& scene, std::string_view format);

}  // namespace durero::io
