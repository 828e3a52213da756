#pragma once
/// The cost and the fit of bounding volumes on a scene: T = n·B + m·I, predicted by areas and measured (A §1.2).

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "durero/scene/query.hpp"
#include "durero/scene/scene.hpp"

namespace durero::engine {

/// The fit of a volume around an element. Areas are in the square of the scene's unit of length.
struct Fit {
  double mean_fit = 0;  ///< mean void area over all directions; of a composed volume by its share of lines
  std::optional<double> void_area{};  ///< mean void area over directions of the rays; none for a composed volume
};

/// A way to bound every element of a scene, with its cost for the first hits of some rays.
struct WayOfBounding {
  std::string name;     ///< the kind's; `chosen`, the last, takes the cheapest volume for each element
  Fit fit;              ///< the sum over the elements
  std::uint64_t n = 0;  ///< tests of a volume, over all rays
  std::uint64_t m = 0;  ///< tests of an element, over all rays
  double B = 0;         ///< CPU time of a test of a volume, in nanoseconds
  double T = 0;         ///< n·B + m·I by the ray, in nanoseconds
  double measured = 0;  ///< CPU time of a ray, in nanoseconds
};

/// A volume around an element.
struct Bound {
  std::string name;     ///< of the kind, or of the kinds that compose it
  Fit fit;              ///< how well it fits
  std::uint64_t m = 0;  ///< rays that meet it, at any distance
  double T = 0;         ///< predicted for isotropic rays through the scene's box, in the table's nanoseconds
};

/// The volumes around an element.
struct BoundedElement {
  scene::ElementRef element;  ///< the element
  Bound chosen;               ///< the cheapest
  std::vector<Bound> kinds;   ///< one of each kind
};

/// The figures of a scene.
struct BoundsFigures {
  /// CPU time of a test of an element, in nanoseconds: the time of answers within balls less that of the balls' tests,
  /// and so with everything else that a ray costs.
  double I = 0;
  std::uint64_t rays = 0;                ///< rays that were answered
  std::vector<WayOfBounding> ways;       ///< each kind, then `chosen`
  std::vector<BoundedElement> elements;  ///< the elements that have a volume, in the scene's order
};

/// The figures of a scene on some rays. Without a clock B and I are those of the table of kinds
/// (accel/volume/volume.hpp), and nothing is timed.
BoundsFigures bounds_figures(const scene::Scene& scene, std::span<const scene::Query> queries, bool with_clock);

}  // namespace durero::engine
