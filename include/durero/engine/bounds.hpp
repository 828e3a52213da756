#pragma once
/// What bounding volumes cost on a scene, and how well they fit: T = n·B + m·I, foretold by areas and measured.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "durero/scene/query.hpp"
#include "durero/scene/scene.hpp"

namespace durero::engine {

/// How well a volume fits. Areas are in the square of the scene's unit.
struct Fit {
  double mean_fit = 0;  ///< mean void area over all directions; of a composed one as its share of lines says
  std::optional<double> void_area{};  ///< in the mean over directions of the rays; none of a composed one
};

/// All elements of a scene in volumes that were chosen in one way, and rays that were asked for their first hits.
struct WayOfBounding {
  std::string name;     ///< of the kind; `chosen` where each element has the volume that costs least: the last
  Fit fit;              ///< summed over the elements
  std::uint64_t n = 0;  ///< tests of a volume, all rays together
  std::uint64_t m = 0;  ///< elements that were tested
  double B = 0;         ///< what a test of a volume took, in nanoseconds of the processor
  double T = 0;         ///< n·B + m·I for a ray, in nanoseconds
  double measured = 0;  ///< what a ray took, in nanoseconds of the processor
};

/// A volume for an element.
struct Bound {
  std::string name;     ///< of the kind, or of those of which it is composed
  Fit fit;              ///< how well it fits
  std::uint64_t m = 0;  ///< rays that meet it, at whatever distance
  double T = 0;  ///< foretold of isotropic rays through the box about the scene, in nanoseconds of the table of kinds
};

/// An element's volumes.
struct BoundedElement {
  scene::ElementRef element;  ///< which
  Bound chosen;               ///< what costs least
  std::vector<Bound> kinds;   ///< one of each
};

/// What was found.
struct BoundsFigures {
  /// What a test of an element took, in nanoseconds of the processor: what the answers within balls took more than
  /// tests of these, with all that a ray takes besides.
  double I = 0;
  std::uint64_t rays = 0;                ///< that were asked
  std::vector<WayOfBounding> ways;       ///< every kind, then the chosen ones
  std::vector<BoundedElement> elements;  ///< those that have a volume, in the order of the scene
};

/// Of a scene and rays. Without a clock B and I are those of the table of kinds (accel/volume/volume.hpp), and nothing
/// is measured.
BoundsFigures bounds_figures(const scene::Scene& scene, std::span<const scene::Query> queries, bool with_clock);

}  // namespace durero::engine
