#include "stage_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "durero/io/json/whole_number.hpp"
#include "durero/scene/stage.hpp"
#include "durero/text/shown.hpp"
#include "stage_fields.hpp"

namespace durero::io {

scene::Camera read_camera(json::Reader& in) {
  scene::Camera camera{};
  const std::size_t at = in.offset();
  read_fields(in, "camera", camera_fields, camera, required_of_camera);
  if (camera.eye == camera.look_at) in.fail(at, "the camera looks at its own eye", "expected look_at elsewhere");
  return camera;
}

scene::Resolution read_resolution(json::Reader& in) {
  const std::size_t at = in.offset();
  std::uint32_t size[2] = {};
  std::size_t count = 0;
  in.array("resolution", [&] {
    if (count == 2) in.fail(in.offset(), "resolution has a third item", "expected width and height");
    size[count++] = static_cast<std::uint32_t>(
        json::whole_number(in, "resolution", 1, most_pixels, "whole numbers of pixels, 1 to 65535"));
  });
  if (count != 2) in.fail(at, fmt::format("resolution has {} items", count), "expected width and height");
  return {size[0], size[1]};
}

glm::dvec3 read_background(json::Reader& in) {
  const std::size_t at = in.offset();
  const glm::dvec3 color = in.vec3("background");
  check_rule(in, at, "background", light_color, color);
  return color;
}

std::vector<scene::Light> read_lights(json::Reader& in) {
  std::vector<scene::Light> lights;
  in.array("lights", [&] {
    const std::size_t at = in.offset();
    read_fields(in, "a light", light_fields, lights.emplace_back(), required_of_light);
    check_axis(in, at, lights.back());
  });
  return lights;
}

std::vector<scene::DirectionalLight> read_directional_lights(json::Reader& in) {
  std::vector<scene::DirectionalLight> lights;
  in.array("directional_lights",
           [&] { read_fields(in, "a directional light", directional_light_fields, lights.emplace_back()); });
  return lights;
}

std::vector<scene::Material> read_materials(json::Reader& in) {
  std::vector<scene::Material> materials;
  std::set<std::string_view> names;
  in.members("materials", [&](const json::Key& key) {
    if (key.name.empty()) in.fail(key.offset, "the name of a material is empty", "expected a name");
    if (!names.insert(key.name).second) {
      in.fail(key.offset, fmt::format("material {} stands twice", text::shown(key.name)), "expected it once");
    }
    scene::Material& material = materials.emplace_back();
    material.name = key.name;
    read_fields(in, "a material", material_fields, material, required_of_material);
  });
  std::ranges::sort(materials, {}, &scene::Material::name);
  return materials;
}

std::uint32_t read_max_depth(json::Reader& in) {
  return static_cast<std::uint32_t>(
      json::whole_number(in, "max_depth", 1, scene::greatest_depth, "a whole number of rays in a row, 1 to 1000"));
}

}  // namespace durero::io
