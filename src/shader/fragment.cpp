#include "durero/shader/fragment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <stdexcept>
#include <vector>

#include "durero/render/light/directions.hpp"
#include "durero/render/light/integrator.hpp"
#include "durero/render/light/whitted.hpp"
#include "durero/render/still_scene.hpp"
#include "durero/scene/attributes.hpp"
#include "durero/scene/stage.hpp"
#include "parts.hpp"
#include "tables.hpp"
#include "worn.hpp"

namespace durero::shader {
namespace {

/// Whether each number of an element's geometry is one that a shader may have.
bool is_small(double x) { return std::abs(x) <= greatest_shader_number; }
bool is_small(const glm::dvec3& x) { return is_small(x.x) && is_small(x.y) && is_small(x.z); }
bool is_small(const scene::Corners& corners) {
  return std::ranges::all_of(corners, [](const glm::dvec3& corner) { return is_small(corner); });
}
/// The apex of a truncated cone stands above it, and is one of a shader's numbers.
bool is_small_apex(const auto&) { return true; }
bool is_small_apex(const scene::TruncatedCone& c) { return is_small(c.altura + c.radio / c.proporcion); }
template <class Shape>
bool is_small_shape(const Shape& shape) {
  return is_small_apex(shape) &&
         std::apply([&](const auto&... attribute) { return (is_small(shape.*attribute.field) && ...); },
                    scene::attributes_of<Shape>);
}

void require_elements(const scene::Scene& scene) {
  if (scene.size() == 0 || scene.size() > most_shader_elements)
    throw std::domain_error(
        fmt::format("the scene has {} elements; expected 1 to {} in a shader", scene.size(), most_shader_elements));
  scene.for_each([&](scene::ElementRef element, const auto& shape) {
    if (!is_small_shape(shape))
      throw std::domain_error(fmt::format("element {} has a number beyond 2^24; expected smaller ones in a shader",
                                          scene.name(element).name()));
  });
}

std::vector<std::string> colors_of(const auto& lights) {
  std::vector<std::string> colors;
  for (const auto& light : lights) colors.push_back(numbers(light.color));
  return colors;
}

std::string light_tables(const scene::Stage& stage) {
  std::string text =
      fmt::format("#define LAMPS {}\n#define SUNS {}\n", stage.lights.size(), stage.directional_lights.size());
  std::vector<std::string> places, ways;
  for (const scene::Light& light : stage.lights) places.push_back(numbers(light.position));
  for (const scene::DirectionalLight& light : stage.directional_lights)
    ways.push_back(numbers(-render::unit(light.direction)));
  if (!places.empty()) text += array("vec3", "LAMP_AT", places) + array("vec3", "LAMP_COLOR", colors_of(stage.lights));
  if (!ways.empty())
    text += array("vec3", "SUN_AT", ways) + array("vec3", "SUN_COLOR", colors_of(stage.directional_lights));
  return text;
}

std::string surroundings(const scene::Stage& stage) {
  if (!stage.environment)
    return fmt::format("vec3 from_nowhere(vec3 v) {{ return {}; }}\n",
                       numbers(stage.background.value_or(render::default_background)));
  if (stage.environment->kind != scene::Surroundings::gradient)
    throw std::domain_error("the environment is a picture; expected a gradient or a background in a shader");
  const auto& [below, above] = stage.environment->colors;
  return fmt::format("vec3 from_nowhere(vec3 v) {{ return mix({}, {}, 0.5 + 0.5 * v.y); }}\n", numbers(below),
                     numbers(above));
}

std::string head(const scene::Scene& scene, ShaderOutput output) {
  std::string text =
      "#version 300 es\n// A scene of Durero: the shader that `durero shader` wrote of it. Elements, from 0:\n";
  int i = 0;
  scene.for_each([&](scene::ElementRef element, const auto&) {
    text += fmt::format("// {} {}\n", i++, scene.name(element).name());
  });
  return text + fmt::format("#define COLOR_ONLY 0\n#define ANSWER 1\n#define DOUBTS 2\n#define WRITES {}\n",
                            static_cast<int>(output));
}

std::array<float, 3> rounded(const glm::dvec3& x) {
  return {static_cast<float>(x.x), static_cast<float>(x.y), static_cast<float>(x.z)};
}

}  // namespace

std::string fragment_shader(const scene::Scene& scene, ShaderOutput output) {
  render::still_camera(scene);
  require_elements(scene);
  const scene::Stage& stage = scene.stage();
  const std::uint32_t depth = std::min(render::depth_of(stage), greatest_shader_depth);
  const WornText worn = worn_text(scene, depth);
  const std::string constants = fmt::format("#define DEPTH {}\n", depth) + element_tables(scene) + light_tables(stage) +
                                worn.tables,
                    around = surroundings(stage);
  std::string text = head(scene, output);
  for (const std::string_view part :
       {parts::head, std::string_view(constants), parts::first, parts::certificate, parts::patterns, parts::looks,
        std::string_view(worn.functions), std::string_view(around), parts::light, parts::main})
    text += part;
  return text;
}

std::string_view vertex_shader() { return parts::vertex; }

// The window's middle is half its width to the right of its left edge, and that is half a pixel to the left of the
// first centre; the sums are rounded to binary64, far below the rounding that the certificate counts for these numbers.
ShaderView::ShaderView(const scene::PrimaryRays& rays)
    : eye(rounded(rays.eye())),
      forward(rounded(rays.upper_left() + rays.step_x() * ((rays.resolution().width - 1.0) / 2) +
                      rays.step_y() * ((rays.resolution().height - 1.0) / 2))),
      step_x(rounded(rays.step_x())),
      step_y(rounded(-rays.step_y())),
      size{static_cast<float>(rays.resolution().width), static_cast<float>(rays.resolution().height)} {}

}  // namespace durero::shader
