#include "stage_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "durero/text/shown.hpp"
#include "stage_reader.hpp"
#include "stage_rules.hpp"

namespace durero::io {
namespace {

std::uint32_t read_pixels(json::Reader& in) {
  const std::size_t at = in.offset();
  const double value = in.number("resolution");
  if (!is_side(value)) {
    in.fail(at, fmt::format("resolution is {}", value), "expected whole numbers of pixels, 1 to 65535");
  }
  return static_cast<std::uint32_t>(value);
}

}  // namespace

scene::Camera read_camera(json::Reader& in) {
  constexpr std::string_view keys[] = {"eye", "look_at", "up", "fov_y"};
  scene::Camera camera{};
  const std::size_t at = in.offset();
  in.object("camera", keys, std::size(keys), [&](std::size_t key) {
    const std::size_t value_at = in.offset();
    switch (key) {
      case 0:
        camera.eye = in.vec3("eye");
        break;
      case 1:
        camera.look_at = in.vec3("look_at");
        break;
      case 2:
        camera.up = in.vec3("up");
        if (camera.up == glm::dvec3{}) in.fail(value_at, "up is the null vector", "expected a direction");
        break;
      default:
        camera.fov_y = in.number("fov_y");
        if (!is_view_angle(camera.fov_y)) {
          in.fail(value_at, fmt::format("fov_y is {}", camera.fov_y), "expected an angle in degrees, 0 < fov_y < 180");
        }
    }
  });
  if (camera.eye == camera.look_at) in.fail(at, "the camera looks at its own eye", "expected look_at elsewhere");
  return camera;
}

scene::Resolution read_resolution(json::Reader& in) {
  const std::size_t at = in.offset();
  std::uint32_t size[2] = {};
  std::size_t count = 0;
  in.array("resolution", [&] {
    if (count == 2) in.fail(in.offset(), "resolution has a third item", "expected width and height");
    size[count++] = read_pixels(in);
  });
  if (count != 2) in.fail(at, fmt::format("resolution has {} items", count), "expected width and height");
  return {size[0], size[1]};
}

glm::dvec3 read_color(json::Reader& in, std::string_view what) {
  const std::size_t at = in.offset();
  const glm::dvec3 color = in.vec3(what);
  if (!is_color(color)) {
    in.fail(at, fmt::format("{} is negative", what), "expected red, green and blue, each from 0");
  }
  return color;
}

std::vector<scene::Light> read_lights(json::Reader& in) {
  constexpr std::string_view keys[] = {"position", "color"};
  std::vector<scene::Light> lights;
  in.array("lights", [&] {
    scene::Light& light = lights.emplace_back();
    in.object("a light", keys, std::size(keys), [&](std::size_t key) {
      if (key == 0) {
        light.position = in.vec3("position");
      } else {
        light.color = read_color(in, "color");
      }
    });
  });
  return lights;
}

std::vector<scene::Material> read_materials(json::Reader& in) {
  constexpr std::string_view keys[] = {"color"};
  std::vector<scene::Material> materials;
  std::set<std::string_view> names;
  in.members("materials", [&](const json::Key& key) {
    if (key.name.empty()) in.fail(key.offset, "the name of a material is empty", "expected a name");
    if (!names.insert(key.name).second) {
      in.fail(key.offset, fmt::format("material {} stands twice", text::shown(key.name)), "expected it once");
    }
    glm::dvec3 color{};
    in.object("a material", keys, std::size(keys), [&](std::size_t) {
      const std::size_t at = in.offset();
      color = read_color(in, "color");
      if (!is_share(color)) {
        in.fail(at, "the color of a material is above 1", "expected the share of light it sends back, 0 to 1");
      }
    });
    materials.push_back({std::string(key.name), color});
  });
  std::ranges::sort(materials, {}, &scene::Material::name);
  return materials;
}

}  // namespace durero::io
