#pragma once
/// Caustics are light that mirrors and glass bring to matt surfaces. Pencils carry it from the lights (Shinya,
/// Takahashi and Naito): each has a flux, and its matrix tells the spot that it lights.

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>

#include "durero/engine/engine.hpp"
#include "durero/render/bundle/spots.hpp"
#include "durero/scene/scene.hpp"

namespace durero::render {

/// The caustics of a scene.
///
/// From each light, pencils go out over a square about each finite element whose material sends rays on: a grid of
/// them, each as wide as its cell. A pencil is followed by its axis, as rays are, over mirrors and through glass. On
/// each further surface it leaves a spot: the parallelogram that the matrix makes of the cell, blurred. Beside each
/// pencil go three probes, exact rays of its cell. Where they tell that some ray of the cell may end farther than a
/// tolerance from where the matrix says (second_order), or where one meets other elements, the cell is divided into
/// four, up to a limit. Textures do not count for
/// what mirrors and glass send on, and planes gather nothing.
///
/// The light at the first surface is the light's colour, which is the same at every distance.
class Caustics {
 public:
  /// Traces the pencils, of up to so many meetings in a row. Throws std::domain_error where the scene has no light, or
  /// no finite element that sends rays on. Precondition: the engine honours origins.
  Caustics(const scene::Scene& scene, const engine::Engine& engine, std::uint32_t max_depth);

  /// The light that arrives at a point of an element, for each unit of area: a matt surface sends k_d·C of it.
  glm::dvec3 irradiance(scene::ElementRef element, const glm::dvec3& point) const {
    return spots_.density(element, point);
  }

  /// The number of pencils that were sent out.
  std::uint64_t pencils() const noexcept { return pencils_; }
  /// The spots that they left.
  const Spots& spots() const noexcept { return spots_; }
  /// The part of the flux that reached the first elements whose pencils could not be told by their matrices at the
  /// limit of division; they left no spot.
  double left_out() const noexcept { return aimed_ > 0 ? lost_ / aimed_ : 0; }

 private:
  friend class CausticTracer;

  Spots spots_;
  std::uint64_t pencils_ = 0;
  double aimed_ = 0, lost_ = 0;
};

}  // namespace durero::render
