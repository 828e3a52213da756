#pragma once
/// Sphere tracing: a ray goes on by the least distance of any element until that is small. The search is that of the
/// lectures, d = min Fᵢ until d ≤ ε or after the greatest number of steps, with bounds of the distances in binary64. A
/// step is never longer than the exact distance, so no surface is passed (a_distancia.conj.4). But what comes nearer
/// than ε is taken for met, and a ray that grazes may need more steps than there are.

#include <cstdint>
#include <span>

#include "durero/accel/bvh.hpp"
#include "durero/model/tipos.hpp"
#include "durero/scene/query.hpp"

namespace durero::distance {

/// How the walk along a ray ends.
enum class WalkEnd : std::uint8_t {
  near,     ///< an element is not farther than ε, but for the rounding of the point
  outside,  ///< nothing lies ahead
  tired,    ///< the steps are used up
};

/// A walk along a ray.
struct Walk {
  WalkEnd end = WalkEnd::outside;  ///< how it ends
  double t = 0;                    ///< where it ends: no element is met at a lesser parameter, and none before it
  scene::ElementRef element{};     ///< near: the nearest element
  std::uint32_t steps = 0;         ///< how many steps were made
};

/// Sphere tracing in a scene, which must outlive it unedited. Many threads may ask it.
class SphereTracer {
 public:
  /// The greatest number of steps.
  static constexpr std::uint32_t most_steps = 1000;

  /// Builds a tree of boxes about the elements. `epsilon` is a length; where none is given it is 2⁻²⁰ of the scene's
  /// longest side, or 2⁻²⁰ where no element has a bound.
  explicit SphereTracer(const scene::Scene& scene, double epsilon = 0);

  /// ε
  double epsilon() const noexcept { return epsilon_; }

  /// Walks along the ray of a query. An element that it starts on is not near until the ray has been ε away from it;
  /// until then a step is no shorter than ε on its account.
  Walk walk(const scene::Query& query) const;

 private:
  struct Least;
  Least least(const glm::dvec3& p, std::span<const scene::ElementRef> without) const;

  accel::Bvh tree_;
  double epsilon_;
};

}  // namespace durero::distance
