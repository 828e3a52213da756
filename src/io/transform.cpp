#include "transform.hpp"

#include <cmath>
#include <glm/matrix.hpp>
#include <numbers>

namespace durero::io {
CosineSine turn_of(double degrees) {
  const double rest = std::remainder(degrees, 360);
  if (rest == 0) return {1, 0};
  if (rest == 90) return {0, 1};
  if (rest == -90) return {0, -1};
  if (std::abs(rest) == 180) return {-1, 0};
  const double angle = degrees * std::numbers::pi / 180;
  return {std::cos(angle), std::sin(angle)};
}

glm::dvec3 Transform::normal(const glm::dvec3& n) const { return glm::transpose(glm::inverse(linear)) * n; }

bool Transform::keeps_axes() const {
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      if (i != j && linear[i][j] != 0) return false;
  return true;
}

Transform Transform::then(const Transform& other) const {
  Transform both;
  both.linear = other.linear * linear;
  both.shift = other.linear * shift + other.shift;
  both.scale = scale && other.scale ? std::optional(*scale * *other.scale) : std::nullopt;
  return both;
}

model::Mapa Transform::map() const {
  const auto exact = [](const glm::dvec3& v) {
    return model::ExactVector{number::exact(v.x), number::exact(v.y), number::exact(v.z)};
  };
  return {exact(shift), exact(linear[0]), exact(linear[1]), exact(linear[2])};
}

Transform turn_about(int axis, double degrees) {
  const auto [c, s] = turn_of(degrees);
  const int next = (axis + 1) % 3, last = (axis + 2) % 3;
  Transform turn;
  turn.linear[next][next] = c, turn.linear[next][last] = s;
  turn.linear[last][next] = -s, turn.linear[last][last] = c;
  return turn;
}

Transform scaling_by(const glm::dvec3& factors) {
  Transform made;
  for (int axis = 0; axis < 3; ++axis) made.linear[axis][axis] = factors[axis];
  const glm::dvec3 sizes(std::abs(factors.x), std::abs(factors.y), std::abs(factors.z));
  made.scale = sizes.x == sizes.y && sizes.y == sizes.z ? std::optional(sizes.x) : std::nullopt;
  return made;
}

Transform shift_by(const glm::dvec3& way) {
  Transform made;
  made.shift = way;
  return made;
}

}  // namespace durero::io
