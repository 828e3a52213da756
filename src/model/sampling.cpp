#include "sampling.hpp"

namespace durero::model {
namespace {

constexpr int grain = 1 << 16;

/// 0 ≤ avance(w, centro, dir) ≤ h
bool within(const ExactPoint& w, const Punto& centro, const Vector& dir, const Rmas& h) {
  const Surd s = avance(w, centro, dir);
  return s >= 0 && s <= Surd(h.value());
}

}  // namespace

Rational any_share(Random& random) { return Rational(std::uniform_int_distribution<int>(0, grain)(random), grain); }

ExactVector any_direction(Random& random) {
  std::uniform_int_distribution<int> component(-grain, grain);
  for (;;) {
    const int x = component(random), y = component(random), z = component(random);
    if (x != 0 || y != 0 || z != 0) return {x, y, z};
  }
}

ExactVector any_normal(const Vector& dir, Random& random) {
  const ExactVector d(dir);
  for (;;) {
    const ExactVector u = any_direction(random);
    ExactVector normal(d.y * u.z - d.z * u.y, d.z * u.x - d.x * u.z, d.x * u.y - d.y * u.x);
    if (!normal.x.is_zero() || !normal.y.is_zero() || !normal.z.is_zero()) return normal;
  }
}

ExactPoint any_on_axis(const Punto& centro, const Vector& dir, const Rmas& h, Random& random) {
  const ExactVector d(dir);
  const Rational squared_length = d.x * d.x + d.y * d.y + d.z * d.z;  // the advance of centro + dir
  return along(centro, d, Surd(Rational(any_share(random) * number::exact(h.value()) / squared_length)));
}

Puntos axial_points(const Potencia& power, const Punto& centro, const Vector& dir, const Rmas& h) {
  const auto member = [=](const ExactPoint& w) { return power(w) == 0 && within(w, centro, dir, h); };
  // A line at a right angle to the axis keeps its advance. It meets the surface where the power of its point on the
  // axis is negative, as it is near the centre; far from it an axis that is not quite a unit vector has drifted.
  return Puntos(member, [=](Random& random) {
    const ExactVector normal = any_normal(dir, random);
    const auto drawn = any_crossing(power, member, any_on_axis(centro, dir, h, random), normal, random);
    return drawn ? drawn : any_crossing(power, member, centro, normal, random);
  });
}

}  // namespace durero::model
