#include "durero/shader/page.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <vector>

#include "durero/render/still_scene.hpp"
#include "durero/scene/stage.hpp"
#include "durero/shader/fragment.hpp"
#include "parts.hpp"

namespace durero::shader {
namespace {

/// The text with what stands for itself in HTML.
std::string escaped(std::string_view text) {
  std::string safe;
  for (const char c : text) {
    if (c == '&')
      safe += "&amp;";
    else if (c == '<')
      safe += "&lt;";
    else
      safe += c;
  }
  return safe;
}

std::string list(const glm::dvec3& x) { return fmt::format("[{}, {}, {}]", x.x, x.y, x.z); }

std::string camera_text(const scene::Camera& camera, scene::Resolution size) {
  return fmt::format("{{ eye: {}, look_at: {}, up: {}, fov_y: {}, aspect: {}, mirrored: {} }}", list(camera.eye),
                     list(camera.look_at), list(camera.up), camera.fov_y, static_cast<double>(size.width) / size.height,
                     camera.mirrored);
}

/// The names of the elements, each a text of the language of the page: no letter of a name needs to be escaped.
std::string names_text(const scene::Scene& scene) {
  std::vector<std::string> names;
  scene.for_each([&](scene::ElementRef element, const auto&) {
    names.push_back(fmt::format("\"{}\"", scene.name(element).name()));
  });
  return fmt::format("[{}]", fmt::join(names, ", "));
}

void put(std::string& page, std::string_view place, std::string_view text) {
  page.replace(page.find(place), place.size(), text);
}

}  // namespace

std::string shader_page(const scene::Scene& scene, std::string_view title) {
  const scene::Camera& camera = render::still_camera(scene);
  const std::string fragment = fragment_shader(scene, ShaderOutput::color);
  std::string page(parts::page);
  for (int i = 0; i < 2; ++i) put(page, "@TITLE@", escaped(title));
  put(page, "@VERTEX@", vertex_shader());
  put(page, "@FRAGMENT@", fragment);
  put(page, "@CAMERA@", camera_text(camera, scene.stage().resolution.value_or(scene::default_resolution)));
  put(page, "@NAMES@", names_text(scene));
  return page;
}

}  // namespace durero::shader
