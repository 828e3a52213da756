#pragma once
/// The sight in the middle of each pixel, beside its colour: an OpenEXR file may hold it as channels of their own.

#include <cstdint>
#include <glm/vec3.hpp>
#include <limits>
#include <string>
#include <vector>

#include "durero/engine/engine.hpp"
#include "durero/render/render.hpp"
#include "durero/scene/scene.hpp"

namespace durero::render {

/// The first meeting of the ray through the centre of a pixel; the default values stand for none.
struct PrimaryHit {
  double depth = std::numeric_limits<double>::infinity();  ///< the distance from the eye, in the scene's unit
  glm::dvec3 normal{0};                                    ///< the unit normal, on the side of the eye
  std::uint32_t element = 0;  ///< the number of the element: from 1, ascending by name; 0 for none
  /// The step that decided where the ray meets the element, the greatest where several are at one point: 1 triage, 2
  /// stable, 3 exact (trace::Step). It is that of the tracer with certificates, whatever engine draws.
  std::uint32_t level = 0;
};

/// The sight of each pixel, rows from the top. Throws as render does. Preconditions: as render; the program has shapes
/// for all elements.
std::vector<PrimaryHit> seen(const scene::Scene& scene, const engine::Engine& engine, const RenderSettings& frame = {});

/// The names of the elements by their numbers, that of 1 first.
std::vector<std::string> numbered(const scene::Scene& scene);

}  // namespace durero::render
