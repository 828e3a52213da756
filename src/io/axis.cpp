#include "axis.hpp"

#include <cmath>
#include <utility>

#include "durero/model/tipos.hpp"
#include "losses.hpp"

namespace durero::io {

// With 64 bits of significand (x87; more elsewhere) the difference, the length and the quotient are each within a few
// 2⁻⁶⁴ of their values, so a component is off by 2⁻⁵³ of itself when it has been rounded to binary64, and a little
// more; the squared length is then off by 2⁻⁵² and a little more, a quarter of tolerancia_unidad. The exact test
// decides all the same. The wider exponent keeps the squares from overflow and underflow.
std::optional<Axis> axis_between(const glm::dvec3& base, const glm::dvec3& end) {
  using Wide = long double;
  const Wide x = Wide{end.x} - base.x, y = Wide{end.y} - base.y, z = Wide{end.z} - base.z;
  const Wide length = std::sqrt(x * x + y * y + z * z);
  const Axis axis{{static_cast<double>(x / length), static_cast<double>(y / length), static_cast<double>(z / length)},
                  static_cast<double>(length)};
  if (!(axis.altura > 0) || !std::isfinite(axis.altura)) return std::nullopt;
  if (!model::Unitario::contains(model::Vector{axis.vector})) return std::nullopt;
  return axis;
}

glm::dvec3 end_of(const glm::dvec3& base, const Axis& axis) {
  const auto along = [&](double from, double direction) {
    return static_cast<double>(from + static_cast<long double>(axis.altura) * direction);
  };
  return {along(base.x, axis.vector.x), along(base.y, axis.vector.y), along(base.z, axis.vector.z)};
}

double proportion_between(double wide, double narrow, double altura) { return (wide - narrow) / altura; }

void EndRoundings::name_losses(std::vector<std::string>& lost) const {
  add_loss(lost, axes, "axis", "axes", "rounded: a scene holds a direction and a length");
  add_loss(lost, proportions, "proportion", "proportions",
           "rounded: a scene holds how much a cone narrows by its height");
}

std::optional<scene::AnyShape> surface_between(RoundEnd one, RoundEnd other, EndRoundings& rounded) {
  if (one.radius < other.radius) std::swap(one, other);
  const auto axis = axis_between(one.at, other.at);
  if (!axis) return std::nullopt;
  if (end_of(one.at, *axis) != other.at) ++rounded.axes;
  if (one.radius == other.radius) return scene::Cylinder{one.at, one.radius, axis->vector, axis->altura};
  const double proportion = proportion_between(one.radius, other.radius, axis->altura);
  if (other.radius + proportion * axis->altura != one.radius) ++rounded.proportions;
  if (other.radius == 0) return scene::Cone{one.at, proportion, axis->vector, axis->altura};
  return scene::TruncatedCone{one.at, other.radius, proportion, axis->vector, axis->altura};
}

}  // namespace durero::io
