#pragma once
/// The commands that a text of Radiance has in it, as far as they are carried out: xform, genbox and cat, one behind
/// another. No other program is run.

#include <array>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "io/transform.hpp"

namespace durero::io {

/// One of the things that xform makes of each primitive: where it is, and what stands before its identifier.
struct RadCopy {
  Transform placed{};
  std::string prefix{};
};

/// What xform does to the primitives that it is given.
struct RadTransform {
  std::vector<RadCopy> copies{{}};        ///< one, unless there is an array
  std::optional<std::string> modifier{};  ///< of all surfaces, in the place of their own
};

/// A box, as genbox makes it.
struct RadBox {
  std::string modifier, identifier;
  glm::dvec3 size;
};

/// Files, or a box, and what one after another makes of them.
struct RadCommand {
  std::variant<std::vector<std::string>, RadBox> of;
  std::vector<RadTransform> then;
};

/// The command of a line; nothing where another program would have to be run, or one of these in another way.
std::optional<RadCommand> rad_command(std::string_view line);

/// A face of a box: what its identifier ends in, and its corners, around.
struct RadFace {
  std::string_view name;
  std::array<glm::dvec3, 4> corners;
};
/// The faces of a box from the origin, named as genbox names them: by the numbers of their corners.
std::array<RadFace, 6> faces_of(const RadBox& box);

}  // namespace durero::io
