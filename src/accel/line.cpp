#include "durero/accel/line.hpp"

#include "durero/number/dyadic.hpp"

namespace durero::accel {

using number::Dyadic;

// (a − p)/v < (b − q)/w, times |v|·|w|. Crossings of planes that the ray never crosses, or crossed before all others,
// and ends come here only beside their like, with which they coincide.
int AxisRay::order_exactly(const PlaneCrossing& a, const PlaneCrossing& b) const {
  if (std::abs(a.t) >= never) return 0;
  const auto way = [&](const PlaneCrossing& crossing) {
    const Dyadic whole = Dyadic(crossing.plane) - Dyadic(p_[crossing.axis]);
    return backwards(crossing.axis) ? -whole : whole;
  };
  const auto speed = [&](const PlaneCrossing& crossing) { return Dyadic(std::abs(v_[crossing.axis])); };
  // The start is at t = 0, whatever the speed along its axis, which may be 0.
  const Dyadic of_a = a.t == 0 ? Dyadic(0) : way(a) * speed(b), of_b = b.t == 0 ? Dyadic(0) : way(b) * speed(a);
  const int by_t = number::sign(of_a - of_b);
  return by_t != 0 ? by_t : static_cast<int>(a.backwards) - static_cast<int>(b.backwards);
}

}  // namespace durero::accel
