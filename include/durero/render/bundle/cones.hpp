#pragma once
/// A picture by cones (Amanatides; Kirk): a pixel's colour is that of what its cone covers, by area; a light of some
/// size is seen as far as the cone to it is open; and a dull mirror sends a wider cone on.

#include "durero/engine/engine.hpp"
#include "durero/render/output/picture.hpp"
#include "durero/render/render.hpp"
#include "durero/scene/scene.hpp"

namespace durero::render {

/// Whether every cone of a picture is a ray: a spread of 0, lights that are points, and no dull mirror.
bool cones_are_rays(const scene::Stage& stage, double spread);

/// Draws the scene by cones: as many for a pixel as there are samples, in a grid, each of the solid angle of its part
/// of the pixel times the square of `spread`. Where all cones are rays, the colours are those of
/// render().
///
/// A cone of light to a sphere is open as far as no element stands in it. A mirror with a gloss n sends a cone on whose
/// solid angle is that of the lobe, 2π/(n + 1), and whose start is as wide as the cone that came. A part of a cone has
/// the colour of its middle.
///
/// Throws std::domain_error where the scene has an element that is no sphere, plane or triangle; a material that lets
/// light through or has a relief; a light of another shape than a point or a sphere; or a lens or a shutter. Otherwise
/// as render() does. Preconditions: those of render(), grid samples, and spread ≥ 0.
Picture by_cones(const scene::Scene& scene, const engine::Engine& engine, const Progress& progress,
                 const RenderSettings& frame, double spread);

}  // namespace durero::render
