#pragma once
/// A page of the web that draws a scene by its shader.

#include <string>
#include <string_view>

#include "durero/scene/scene.hpp"

namespace durero::shader {

/// The text of the page: one file that asks no other, and opens from a disk. One turns the scene with a pointer or the
/// arrow keys, goes near with a wheel, two fingers or + and −, and sees on request which pixels are in doubt. Where
/// there is no WebGL 2 it says so. Throws std::domain_error as fragment_shader() does. The title may be any text.
std::string shader_page(const scene::Scene& scene, std::string_view title);

}  // namespace durero::shader
