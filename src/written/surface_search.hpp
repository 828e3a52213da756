#pragma once
/// The search of a ray among elements that a Z text defines.

#include <optional>
#include <span>
#include <vector>

#include "durero/engine/engine.hpp"
#include "durero/written/surface.hpp"

namespace durero::written {

/// An element and its points.
struct SurfaceElement {
  scene::ElementRef place;
  Surface surface;

  /// Whether a ray starts on it.
  bool has_origin_of(const scene::Query& query) const { return scene::Origin(query.en).contains(place); }
};

/// The nearest elements that a ray meets, and elements without a nearest point.
class SurfaceSearch {
 public:
  /// The query must outlive the search.
  explicit SurfaceSearch(const scene::Query& query) : query_(query) {}

  void ask(const SurfaceElement& element);
  /// @{ An element that the ray meets at t; one whose points on the ray come as near to `from` as one likes, to 0
  /// without it.
  void meet(scene::ElementRef place, algebra::Root t);
  void approach(scene::ElementRef place, std::optional<algebra::Root> from);
  /// @}

  /// Whether nothing was met or approached.
  bool empty() const { return !nearest_ && without_.empty(); }
  /// The least t that was met, rounded once; nothing where an element was approached, or none was met.
  std::optional<double> rounded_t() const;
  /// The hit of the search. A point at t is nearest where no stretch begins before t: a stretch that begins behind t,
  /// or at t itself, leaves it so.
  scene::Hit hit() const;

 private:
  scene::Hit at(const algebra::Root& t) const;

  const scene::Query& query_;
  std::optional<algebra::Root> nearest_, bound_;  // bound_: nothing is 0, where without_ is not empty
  scene::ElementSet met_, without_;
};

/// Adds the points of elements that a ray meets on a stretch, each rounded once. False where one of them does not pass
/// light, or the ray lies in it there.
bool add_points(std::span<const SurfaceElement> elements, const scene::Query& query, surface::exact::RayStretch stretch,
                const surface::exact::Passes& passes, std::vector<surface::exact::ElementPoint>& points);

}  // namespace durero::written
