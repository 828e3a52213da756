#pragma once
/// Points as operations have them.

#include <fmt/format.h>

#include <glm/vec3.hpp>
#include <string>

#include "durero/io/number_text.hpp"

namespace durero::io {

/// `(x,y,z)`, each number in the shortest form that reads back.
inline std::string point_text(const glm::dvec3& p) {
  return fmt::format("({},{},{})", number_text(p.x), number_text(p.y), number_text(p.z));
}

}  // namespace durero::io
