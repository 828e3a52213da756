#pragma once
/// A claim is the answer of a system to a ray, as the system gives it: nothing of it is trusted, and no number need be
/// finite.

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "durero/scene/element_ref.hpp"

namespace durero::conform {

/// One answer to a ray, or the reason why there is none.
struct Claim {
  /// The outcome of a question to a system.
  enum class Outcome {
    hit,        ///< the system says that the ray meets something
    miss,       ///< the system says that the ray meets nothing
    crashed,    ///< the system ended while it was asked
    hung,       ///< the system gave no answer in its time
    unanswered  ///< the system was not asked, refused the scene, or wrote a malformed line
  };

  Outcome outcome = Outcome::unanswered;       ///< unanswered until somebody asks
  std::optional<scene::ElementRef> element{};  ///< the element of the hit, where the system names one
  std::optional<double> t{};           ///< the number that the system calls distance, in the sense of Profile::measure
  std::optional<glm::dvec3> punto{};   ///< the point, where the system gives it
  std::optional<glm::dvec3> normal{};  ///< the normal there, where the system gives it, in the sense of Profile::normal
  std::optional<bool> is_front{};  ///< whether the ray comes from the outward normal's side, where the system says it
  std::optional<glm::dvec2> uv{};  ///< u and v of (1 − u − v)·a + u·b + v·c on a triangle, where it gives them
  std::vector<Claim> behind{};     ///< the hits behind this one, where all were asked for, in the system's order
  std::optional<std::uint64_t> count{};  ///< the number of all hits, where that was asked for
  std::string why{};                     ///< the reason for neither hit nor miss, in a few words of one line

  bool operator==(const Claim&) const = default;
};

/// Whether the claim says anything beside the element and the place of its hit.
inline bool has_besides(const Claim& claim) { return claim.normal || claim.is_front || claim.uv; }

}  // namespace durero::conform
