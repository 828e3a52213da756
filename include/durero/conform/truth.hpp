#pragma once
/// The exact answer to a ray, and what else a right program may answer where data that are off by a rounding would
/// change it.

#include <string_view>
#include <vector>

#include "durero/scene/hit.hpp"
#include "durero/scene/query.hpp"
#include "durero/scene/scene.hpp"

namespace durero::conform {

/// Why the exact answer is not the only one: what of the first crossing a change of the data, however small, removes.
enum class Ambiguity {
  none,
  tangent,    ///< a double root
  rim,        ///< at an end of an open surface, or of a disc
  edge,       ///< at an edge or a vertex of a triangle
  apex,       ///< at the apex of a cone
  tie,        ///< several elements at one point
  in_surface  ///< the ray lies in the surface
};
std::string_view name(Ambiguity ambiguity);

struct Truth {
  scene::Hit hit;  ///< of Primera_Interseccion
  Ambiguity ambiguity = Ambiguity::none;
  /// What may be answered beside `hit`, nearest first: the crossings behind it until the first that no small change
  /// removes, then, where there is none, a miss. Of a tie each element may be answered alone.
  std::vector<scene::Hit> permissible{};
};

/// By surface::exact. Precondition: the ray is of the scene.
Truth truth(const scene::Scene& scene, const scene::Query& ray);

}  // namespace durero::conform
