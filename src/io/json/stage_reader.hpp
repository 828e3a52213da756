#pragma once
/// The parts of the scene format, read from JSON.

#include "durero/io/json/json.hpp"
#include "durero/scene/stage.hpp"

namespace durero::io {

scene::Camera read_camera(json::Reader& in);
scene::Resolution read_resolution(json::Reader& in);
glm::dvec3 read_background(json::Reader& in);
std::vector<scene::Light> read_lights(json::Reader& in);
std::vector<scene::DirectionalLight> read_directional_lights(json::Reader& in);
std::vector<scene::Material> read_materials(json::Reader& in);
std::uint32_t read_max_depth(json::Reader& in);

}  // namespace durero::io
