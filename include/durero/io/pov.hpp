#pragma once
/// The scene description language of POV-Ray 3.7, written. What one side holds and the other cannot is counted and
/// named, never dropped silently.

#include "durero/io/formats.hpp"

namespace durero::io {

/// Writes a scene that POV-Ray draws by the same model of light, in linear light: camera, background, lights, materials
/// and elements. What a texture of POV-Ray has one of (a colour, a finish) and a material several is an average of
/// textures. Glass casts the full shadow of a stone: it has no shadow itself, and an opaque twin that nothing but a
/// shadow shows.
Exported pov_text(const scene::Scene& scene);

}  // namespace durero::io
