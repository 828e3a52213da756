#pragma once
/// The elements of a scene as constants of a shader, and numbers as its language writes them.

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "durero/scene/scene.hpp"

namespace durero::shader {

/// @{ Numbers of binary32, by the fewest digits that read back.
/// Throws std::domain_error where it has no such number.
inline std::string numbers(double x) {
  const auto rounded = static_cast<float>(x);
  if (!std::isfinite(rounded))
    throw std::domain_error("a number of the scene is beyond binary32; expected smaller ones in a shader");
  std::string text = fmt::format("{}", rounded);
  return text.find_first_of(".e") == text.npos ? text + ".0" : text;
}
inline std::string numbers(const glm::dvec2& x) { return fmt::format("vec2({}, {})", numbers(x.x), numbers(x.y)); }
inline std::string numbers(const glm::dvec3& x) {
  return fmt::format("vec3({}, {}, {})", numbers(x.x), numbers(x.y), numbers(x.z));
}
inline std::string numbers(const glm::dvec3& x, double w) {
  return fmt::format("vec4({}, {}, {}, {})", numbers(x.x), numbers(x.y), numbers(x.z), numbers(w));
}
/// @}

/// The declaration of a constant array. Precondition: it has an entry.
std::string array(std::string_view type, std::string_view name, const std::vector<std::string>& entries);

/// The constants of all elements, and how many there are of each kind. Precondition: Scene::for_each meets them kind by
/// kind.
std::string element_tables(const scene::Scene& scene);

}  // namespace durero::shader
