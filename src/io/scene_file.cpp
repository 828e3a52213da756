#include "durero/io/scene_file.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "durero/io/json.hpp"
#include "durero/text/shown.hpp"
#include "element_reader.hpp"
#include "stage_reader.hpp"

namespace durero::io {
namespace {

constexpr std::string_view format_name = "durero-scene";

enum Key : std::size_t { format, version, elementos, camera, resolution, background, lights, materials };
constexpr std::string_view keys[] = {"format",     "version",    "elementos", "camera",
                                     "resolution", "background", "lights",    "materials"};
constexpr std::size_t required = 3;

void read_format(json::Reader& in) {
  const std::size_t at = in.offset();
  const std::string_view name = in.string("format");
  if (name != format_name) in.fail(at, fmt::format("format is {}", text::shown(name)), "expected \"durero-scene\"");
}

void read_version(json::Reader& in) {
  const std::size_t at = in.offset();
  const double version = in.number("version");
  if (version != 1) in.fail(at, fmt::format("version is {}", version), "expected 1");
}

void read_part(json::Reader& in, Key key, scene::Scene& scene, std::vector<MaterialUse>& uses) {
  scene::Stage& stage = scene.stage();
  switch (key) {
    case format:
      return read_format(in);
    case version:
      return read_version(in);
    case elementos:
      return in.array("elementos", [&] { read_element(in, scene, uses); });
    case camera:
      stage.camera = read_camera(in);
      return;
    case resolution:
      stage.resolution = read_resolution(in);
      return;
    case background:
      stage.background = read_background(in);
      return;
    case lights:
      stage.lights = read_lights(in);
      return;
    case materials:
      stage.materials = read_materials(in);
  }
}

void set_materials(const json::Reader& in, const std::vector<MaterialUse>& uses, scene::Scene& scene) {
  const auto& all = scene.stage().materials;
  for (const MaterialUse& use : uses) {
    const auto found = std::ranges::lower_bound(all, use.material.value, {}, &scene::Material::name);
    if (found == all.end() || found->name != use.material.value) {
      in.fail(use.material.offset, fmt::format("unknown material {}", text::shown(use.material.value)),
              "expected one of the scene's materials");
    }
    scene.set_material(scene.find(use.element).value(), static_cast<std::uint32_t>(found - all.begin()));
  }
}

}  // namespace

scene::Scene read_scene(const Source& source) {
  const json::Document document(source);
  json::Reader in(document);
  scene::Scene scene;
  scene.put_off_audits();
  std::vector<MaterialUse> uses;
  in.object("a scene", keys, required, [&](std::size_t key) { read_part(in, static_cast<Key>(key), scene, uses); });
  set_materials(in, uses, scene);
  scene.audit();
  return scene;
}

}  // namespace durero::io
