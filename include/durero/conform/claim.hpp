#pragma once
/// What a system answers to a ray, as it says it: nothing of it is trusted, and no number need be finite.

#include <glm/vec3.hpp>
#include <optional>
#include <string>

#include "durero/scene/element_ref.hpp"

namespace durero::conform {

/// One answer, or why there is none.
struct Claim {
  /// What came of asking.
  enum class Outcome {
    hit,        ///< the system says that the ray meets something
    miss,       ///< the system says that the ray meets nothing
    crashed,    ///< the system ended while it was asked
    hung,       ///< it gave no answer in the time that it had
    unanswered  ///< it was not asked, refused the scene, or wrote what is no answer
  };

  Outcome outcome = Outcome::unanswered;       ///< as long as nobody asked: unanswered
  std::optional<scene::ElementRef> element{};  ///< where the system names one
  std::optional<double> t{};                   ///< what the system calls the distance: Profile::measure says of what
  std::optional<glm::dvec3> punto{};           ///< where the system gives the point
  std::string why{};                           ///< of no hit and no miss: the reason, in a few words of one line

  bool operator==(const Claim&) const = default;
};

}  // namespace durero::conform
