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
/// Where several elements are at the first point, the last of these in the order tangent, rim, edge, apex, in_surface
/// that one of them has. A ray that just misses something exactly is not ambiguous by that: its answer is the answer to
/// other data near enough, and who judges with a backward error sees it.
enum class Ambiguity {
  none,
  tangent,    ///< a double root
  rim,        ///< at an end of an open surface, or of a disc
  edge,       ///< at an edge or a vertex of a triangle
  apex,       ///< at the apex of a cone
  tie,        ///< several elements at one point, none of which a small change removes
  in_surface  ///< the ray lies in the surface
};
/// The word of an ambiguity in files, spelt as its enumerator.
std::string_view name(Ambiguity ambiguity);

/// The exact answer to a ray, and what may be answered in its place.
struct Truth {
  scene::Hit hit;                         ///< of Primera_Interseccion
  Ambiguity ambiguity = Ambiguity::none;  ///< why `hit` is not the only answer; none where it is
  /// What may be answered beside `hit`, nearest first: the crossings behind it until the first that no small change
  /// removes, that one included; then, where there is none, a miss. Of several elements at one point all are answered,
  /// or each alone. A stretch of the ray inside a surface counts with both its ends, and from t → 0⁺ with t = 0; what
  /// lies between them is as good.
  std::vector<scene::Hit> permissible{};
};

/// What the tracer's certified steps find is so; of elements where they cannot tell, and where several are left, by
/// surface::exact. Precondition: the ray is of the scene.
Truth truth(const scene::Scene& scene, const scene::Query& ray);

}  // namespace durero::conform
