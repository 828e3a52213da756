#pragma once
/// A picture by beams: the beam tree tells what each pixel's ray meets, from mirror to mirror, and no ray searches.

#include <cstdint>

#include "durero/engine/engine.hpp"
#include "durero/render/bundle/beam_tree.hpp"
#include "durero/render/output/picture.hpp"
#include "durero/render/render.hpp"
#include "durero/scene/scene.hpp"

namespace durero::render {

/// A picture by beams, its tree, and how much was left to rays.
struct BeamPicture {
  Picture picture;          ///< each pixel has the colour that the ray through its centre brings
  BeamTree tree;            ///< of the drawn part of the picture
  std::uint64_t asked = 0;  ///< the rays, without those to lights, that lie on a line of the tree: the engine's
};

/// Draws the scene by beams. The colours are those of render() at one ray a pixel. Shadows are the engine's. Throws as
/// render() and beam_tree() do. Preconditions: those of render().
BeamPicture by_beams(const scene::Scene& scene, const engine::Engine& engine, const Progress& progress = {},
                     const RenderSettings& frame = {});

}  // namespace durero::render
