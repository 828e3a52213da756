#include "pov_transform.hpp"

#include <fmt/format.h>

#include <cmath>
#include <glm/matrix.hpp>
#include <numbers>

namespace durero::io {
namespace {

struct CosineSine {
  double cosine, sine;
};
/// Of an angle in degrees; exact where it is of whole right angles.
CosineSine turn_of(double degrees) {
  const double rest = std::remainder(degrees, 360);
  if (rest == 0) return {1, 0};
  if (rest == 90) return {0, 1};
  if (rest == -90) return {0, -1};
  if (std::abs(rest) == 180) return {-1, 0};
  const double angle = degrees * std::numbers::pi / 180;
  return {std::cos(angle), std::sin(angle)};
}

/// About the axes x, y and z, one after another.
PovTransform rotation(const glm::dvec3& degrees) {
  PovTransform all;
  for (int axis = 0; axis < 3; ++axis) {
    const auto [c, s] = turn_of(degrees[axis]);
    const int next = (axis + 1) % 3, last = (axis + 2) % 3;
    PovTransform one;
    one.linear[next][next] = c, one.linear[next][last] = s;
    one.linear[last][next] = -s, one.linear[last][last] = c;
    all = all.then(one);
  }
  return all;
}

PovTransform scaling(PovWords& in) {
  glm::dvec3 by = in.triple("scale");
  PovTransform made;
  for (int axis = 0; axis < 3; ++axis) {
    if (by[axis] == 0) by[axis] = 1, ++made.zeros;
    made.linear[axis][axis] = by[axis];
  }
  made.scale.reset();
  if (std::abs(by.x) == std::abs(by.y) && std::abs(by.y) == std::abs(by.z)) made.scale = std::abs(by.x);
  return made;
}

/// matrix <…> of twelve numbers: what becomes of x, y, z and the origin.
PovTransform matrix(PovWords& in, std::size_t at) {
  PovTransform made;
  in.expect("<", "behind matrix");
  for (int row = 0; row < 4; ++row)
    for (int k = 0; k < 3; ++k) {
      (row < 3 ? made.linear[row] : made.shift)[k] = in.number("matrix");
      in.comma();
    }
  in.expect(">", "behind the twelve numbers of matrix");
  const bool is_shift = made.is_shift();
  if (!is_shift) made.scale.reset();
  if (!std::isnormal(glm::determinant(made.linear))) in.fail(at, "a matrix that has no way back", "expected another");
  return made;
}

PovTransform block(PovWords& in, std::size_t at) {
  if (!in.take("{")) {
    if (!in.take("transform")) in.fail_here("expected { behind transform");
    return block(in, at);
  }
  PovTransform made;
  while (!in.take("}")) {
    if (in.take("inverse")) {
      PovTransform back;
      back.linear = glm::inverse(made.linear);
      back.shift = -(back.linear * made.shift);
      back.scale = made.scale ? std::optional(1 / *made.scale) : std::nullopt;
      made = back;
    } else if (const auto one = take_pov_transform(in)) {
      made = made.then(*one);
    } else {
      in.fail_here("expected one of translate, rotate, scale, matrix, transform, inverse, or }");
    }
  }
  return made;
}

}  // namespace

glm::dvec3 PovTransform::normal(const glm::dvec3& n) const { return glm::transpose(glm::inverse(linear)) * n; }

bool PovTransform::keeps_axes() const {
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      if (i != j && linear[i][j] != 0) return false;
  return true;
}

PovTransform PovTransform::then(const PovTransform& other) const {
  PovTransform both;
  both.linear = other.linear * linear;
  both.shift = other.linear * shift + other.shift;
  both.zeros = zeros + other.zeros;
  both.scale = scale && other.scale ? std::optional(*scale * *other.scale) : std::nullopt;
  return both;
}

model::Mapa PovTransform::map() const {
  const auto exact = [](const glm::dvec3& v) {
    return model::ExactVector{number::exact(v.x), number::exact(v.y), number::exact(v.z)};
  };
  return {exact(shift), exact(linear[0]), exact(linear[1]), exact(linear[2])};
}

std::optional<PovTransform> take_pov_transform(PovWords& in) {
  const std::size_t at = in.offset();
  if (in.take("translate")) {
    PovTransform made;
    made.shift = in.triple("translate");
    return made;
  }
  if (in.take("rotate")) return rotation(in.triple("rotate"));
  if (in.take("scale")) return scaling(in);
  if (in.take("matrix")) return matrix(in, at);
  if (in.take("transform")) return block(in, at);
  return std::nullopt;
}

PovTransform take_pov_transforms(PovWords& in) {
  PovTransform all;
  while (const auto one = take_pov_transform(in)) all = all.then(*one);
  return all;
}

}  // namespace durero::io
