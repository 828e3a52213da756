#pragma once
/// The parts of a shader and of its page that are the same for all scenes. Each stands in a file of its own, as one
/// text of C++.

#include <string_view>

namespace durero::shader::parts {

/// @{ The texts, by the names of their files.
inline constexpr std::string_view head =
#include "parts/head.glsl"
    ;
inline constexpr std::string_view first =
#include "parts/first.glsl"
    ;
inline constexpr std::string_view certificate =
#include "parts/certificate.glsl"
    ;
inline constexpr std::string_view patterns =
#include "parts/patterns.glsl"
    ;
inline constexpr std::string_view looks =
#include "parts/looks.glsl"
    ;
inline constexpr std::string_view light =
#include "parts/light.glsl"
    ;
inline constexpr std::string_view main =
#include "parts/main.glsl"
    ;
inline constexpr std::string_view vertex =
#include "parts/vertex.glsl"
    ;
inline constexpr std::string_view page =
#include "parts/page.html"
    ;
/// @}

}  // namespace durero::shader::parts
