#include "durero/io/json/scene_file.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "durero/io/json/json.hpp"
#include "durero/scene/stage.hpp"
#include "durero/text/shown.hpp"
#include "element_reader.hpp"
#include "groups_reader.hpp"
#include "stage_reader.hpp"
#include "texture_fields.hpp"

namespace durero::io {
namespace {

enum SceneKey : std::size_t {
  format,
  version,
  elementos,
  camera,
  resolution,
  background,
  lights,
  directional_lights,
  materials,
  max_depth,
  groups,
  textures,
  environment
};
constexpr std::string_view scene_keys[] = {"format",     "version",  "elementos",          "camera",    "resolution",
                                           "background", "lights",   "directional_lights", "materials", "max_depth",
                                           "groups",     "textures", "environment"};
constexpr std::size_t required_scene_keys = 3;

class SceneReader {
 public:
  /// Null: the first error is thrown.
  explicit SceneReader(std::vector<InputError>* errors, WrittenElements written = {})
      : errors_(errors), written_(written) {}

  scene::Scene read(const Source& source) {
    scene_.put_off_audits();
    attempt([&] { read_document(source); });
    scene_.audit();
    return std::move(scene_);
  }

 private:
  void read_document(const Source& source) {
    const json::Document document(source);
    json::Reader in(document);
    json::require_version(in, scene_format);
    in.object("a scene", scene_keys, required_scene_keys, [&](std::size_t key) {
      const bool is_right = read_or_pass(in, [&] { read_part(in, static_cast<SceneKey>(key)); });
      if (key == materials) materials_are_known_ = is_right;
      if (key == textures) textures_are_known_ = is_right;
    });
    if (elements_are_known_) attempt([&] { make_groups(in, groups_, scene_); });
    if (!materials_are_known_) return;
    for (const MaterialUse& use : uses_) attempt([&] { set_material(in, use); });
    if (textures_are_known_) attempt([&] { check_texture_names(document, scene_.stage()); });
  }

  /// False where what is read is wrong.
  template <class Read>
  bool attempt(Read&& read) {
    try {
      read();
      return true;
    } catch (const InputError& error) {
      if (errors_ == nullptr) throw;
      errors_->push_back(error);
      return false;
    }
  }

  /// Passes the value that stands here, right or wrong.
  template <class Read>
  bool read_or_pass(json::Reader& in, Read&& read) {
    const json::Reader before = in;
    const bool is_right = attempt(read);
    if (!is_right) {
      in = before;
      in.skip();
    }
    return is_right;
  }

  void read_part(json::Reader& in, SceneKey key) {
    scene::Stage& stage = scene_.stage();
    switch (key) {
      case format:
      case version:  // read before all others
        return in.skip();
      case elementos:
        return in.array("elementos", [&] {
          if (!read_or_pass(in, [&] { read_element(in, scene_, uses_, written_); })) elements_are_known_ = false;
        });
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
      case directional_lights:
        stage.directional_lights = read_directional_lights(in);
        return;
      case materials:
        stage.materials = read_materials(in);
        return;
      case max_depth:
        stage.max_depth = read_max_depth(in);
        return;
      case groups:
        groups_ = read_written_groups(in);
        return;
      case textures:
        stage.textures = read_textures(in);
        return;
      case environment:
        stage.environment = read_environment(in);
    }
  }

  void set_material(const json::Reader& in, const MaterialUse& use) {
    const auto& all = scene_.stage().materials;
    const auto found = std::ranges::lower_bound(all, use.material.value, {}, &scene::Material::name);
    if (found == all.end() || found->name != use.material.value) {
      in.fail(use.material.offset, fmt::format("unknown material {}", text::shown(use.material.value)),
              "expected one of the scene's materials");
    }
    if (has_textures(*found) && is_written(use.element)) {
      in.fail(use.material.offset, fmt::format("material {} has textures", text::shown(use.material.value)),
              "expected one without: what a text declares has no coordinates (u, v)");
    }
    scene_.set_material(scene_.find(use.element).value(), static_cast<std::uint32_t>(found - all.begin()));
  }

  /// Whether the element is of a type that a Z text declares.
  bool is_written(std::string_view element) const {
    return written_.elements != nullptr &&
           std::ranges::find(*written_.elements, element, &WrittenElement::id) != written_.elements->end();
  }

  std::vector<InputError>* errors_;
  WrittenElements written_;
  scene::Scene scene_;
  std::vector<MaterialUse> uses_;
  std::vector<WrittenGroup> groups_;
  bool materials_are_known_ = true, textures_are_known_ = true,
       elements_are_known_ = true;  // otherwise nothing is said of who names them
};

}  // namespace

scene::Scene read_scene(const Source& source) { return SceneReader(nullptr).read(source); }

scene::Scene read_scene(const Source& source, std::vector<InputError>& errors) {
  return SceneReader(&errors).read(source);
}

scene::Scene read_scene(const Source& source, std::span<const WrittenType> types,
                        std::vector<WrittenElement>& elements) {
  return SceneReader(nullptr, {types, &elements}).read(source);
}

scene::Scene read_scene(const Source& source, std::span<const WrittenType> types, std::vector<WrittenElement>& elements,
                        std::vector<InputError>& errors) {
  return SceneReader(&errors, {types, &elements}).read(source);
}

ElementPlace element_place(const Source& source, std::string_view name) {
  const json::Document document(source);
  json::Reader in = json::Reader(document).member("elementos").value();
  ElementPlace place{};
  std::size_t number = 0;
  in.array("elementos", [&] {
    if (in.member("id").value().string("id") == name)
      place = {fmt::format("/elementos/{}", number), source.place(in.offset())};
    in.skip();
    ++number;
  });
  return place;
}

}  // namespace durero::io
