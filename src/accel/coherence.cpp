#include "durero/accel/coherence.hpp"

namespace durero::accel {

// The sum is rounded twice, each time by less than half of the factor's increase.
ApparentBall seen_from_within(const surface::Ball& from, const surface::Ball& to) {
  return seen({to.centre, (to.radius + from.radius) * (1 + 0x1p-50)}, from.centre);
}

bool may_reach(const surface::Ball& from, const glm::dvec3& direction, const surface::Ball& to) {
  return may_be_seen(seen_from_within(from, to), cone(direction, 1, 0));
}

}  // namespace durero::accel
