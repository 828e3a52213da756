#include "pov_transform.hpp"

#include <cmath>
#include <glm/matrix.hpp>

namespace durero::io {
namespace {

/// About the axes x, y and z, one after another.
PovTransform rotation(const glm::dvec3& degrees) {
  PovTransform all;
  for (int axis = 0; axis < 3; ++axis) all = all.then({turn_about(axis, degrees[axis])});
  return all;
}

PovTransform scaling(PovWords& in) {
  glm::dvec3 by = in.triple("scale");
  std::size_t zeros = 0;
  for (int axis = 0; axis < 3; ++axis)
    if (by[axis] == 0) by[axis] = 1, ++zeros;
  return {scaling_by(by), zeros};
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

std::optional<PovTransform> take_pov_transform(PovWords& in) {
  const std::size_t at = in.offset();
  if (in.take("translate")) return PovTransform{shift_by(in.triple("translate"))};
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
