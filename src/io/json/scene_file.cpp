#include "durero/io/json/scene_file.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "body_reader.hpp"
#include "durero/io/json/groups_file.hpp"
#include "durero/io/json/json.hpp"
#include "durero/scene/stage.hpp"
#include "durero/text/shown.hpp"
#include "element_reader.hpp"
#include "groups_reader.hpp"
#include "mesh_fields.hpp"
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
  environment,
  prototypes,
  mallas
};
constexpr std::string_view scene_keys[] = {"format",     "version",  "elementos",          "camera",     "resolution",
                                           "background", "lights",   "directional_lights", "materials",  "max_depth",
                                           "groups",     "textures", "environment",        "prototypes", "mallas"};
constexpr std::size_t required_scene_keys = 3;

class SceneReader {
 public:
  /// Null: the first error is thrown.
  explicit SceneReader(std::vector<InputError>* errors, Bodies bodies)
      : errors_(errors), written_{.bodies = bodies == Bodies::read} {}
  /// The same with elements of types of a Z text.
  SceneReader(std::vector<InputError>* errors, WrittenElements written) : errors_(errors), written_(written) {}

  scene::GroupedScene read(const Source& source) {
    scene_.put_off_audits();
    attempt([&] { read_document(source); });
    scene_.audit();
    return {std::move(scene_), std::move(made_groups_)};
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
    for (const json::Reader& mesh : meshes_) attempt([&] { read_mesh_at(mesh); });
    const auto make = [&](auto&& what) {
      if (!attempt(what)) elements_are_known_ = false;
    };
    if (elements_are_known_) body_reader_.make_all(in, make);
    if (elements_are_known_) attempt([&] { made_groups_ = make_groups(in, groups_, scene_); });
    if (!materials_are_known_) return;
    for (const MaterialUse& use : uses_) attempt([&] { set_material(in, use); });
    for (const auto& material : body_reader_.materials_of_prototypes()) attempt([&] { known_material(in, material); });
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
          if (!read_or_pass(in, [&] { read_item(in); })) elements_are_known_ = false;
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
        return;
      case prototypes:
        return body_reader_.keep_prototypes(in);
      case mallas:
        return in.array("mallas", [&] {
          meshes_.push_back(in);
          in.skip();
        });
    }
  }

  void read_item(json::Reader& in) {
    const BodyTipo* const tipo = body_tipo(in);
    if (tipo == nullptr || written_type(in, written_.types)) return read_element(in, scene_, uses_, written_);
    if (!written_.bodies) {
      in.fail(in.member("tipo")->offset(), fmt::format("tipo (type) is {}", text::shown(tipo->word)),
              "expected a shape of the program's own: what asks here knows no other");
    }
    body_reader_.keep_element(in);
  }

  /// A mesh is read when the materials are known.
  void read_mesh_at(json::Reader in) {
    const json::Reader at = in;
    FileMesh read = read_mesh(in);
    if (read.material && materials_are_known_) read.mesh.material = known_material(in, *read.material);
    add_mesh(at, scene_, std::move(read.mesh));
  }

  /// The place of a material among the scene's.
  std::uint32_t known_material(const json::Reader& in, const Placed<std::string_view>& material) const {
    const auto& all = scene_.stage().materials;
    const auto found = std::ranges::lower_bound(all, material.value, {}, &scene::Material::name);
    if (found == all.end() || found->name != material.value) {
      in.fail(material.offset, fmt::format("unknown material {}", text::shown(material.value)),
              "expected one of the scene's materials");
    }
    return static_cast<std::uint32_t>(found - all.begin());
  }

  void set_material(const json::Reader& in, const MaterialUse& use) {
    const std::uint32_t place = known_material(in, use.material);
    const scene::ElementRef element = scene_.find(use.element).value();
    if (has_textures(scene_.stage().materials[place]) && (is_written(use.element) || scene_.body(element) != nullptr)) {
      in.fail(use.material.offset, fmt::format("material {} has textures", text::shown(use.material.value)),
              "expected one without: neither what a text declares nor a copy has coordinates (u, v)");
    }
    scene_.set_material(element, place);
  }

  /// Whether the element is of a type that a Z text declares.
  bool is_written(std::string_view element) const {
    return written_.elements != nullptr &&
           std::ranges::find(*written_.elements, element, &WrittenElement::id) != written_.elements->end();
  }

  std::vector<InputError>* errors_;
  WrittenElements written_{};
  scene::Scene scene_;
  scene::Groups made_groups_;
  std::vector<MaterialUse> uses_;
  std::vector<WrittenGroup> groups_;
  std::vector<json::Reader> meshes_;
  BodyReader body_reader_{scene_, uses_, groups_};
  bool materials_are_known_ = true, textures_are_known_ = true,
       elements_are_known_ = true;  // otherwise nothing is said of who names them
};

/// The place of a face in its mesh; an empty pointer where no mesh has one of that name.
ElementPlace face_place(const Source& source, const json::Reader& document, std::string_view name) {
  ElementPlace place{};
  auto meshes = document.member("mallas");
  if (!meshes) return place;
  std::size_t mesh = 0;
  meshes->array("mallas", [&] {
    const auto face = scene::face_number(meshes->member("id").value().string("id"), name);
    std::uint32_t number = 0;
    json::Reader caras = meshes->member("caras").value();
    if (face) {
      caras.array("caras", [&] {
        if (number++ == *face) place = {fmt::format("/mallas/{}/caras/{}", mesh, *face), source.place(caras.offset())};
        caras.skip();
      });
    }
    meshes->skip();
    ++mesh;
  });
  return place;
}

}  // namespace

scene::Scene read_scene(const Source& source, Bodies bodies) { return SceneReader(nullptr, bodies).read(source).scene; }

scene::Scene read_scene(const Source& source, std::vector<InputError>& errors, Bodies bodies) {
  return SceneReader(&errors, bodies).read(source).scene;
}

scene::GroupedScene read_grouped_scene(const Source& source, Bodies bodies) {
  return SceneReader(nullptr, bodies).read(source);
}

scene::Scene read_scene(const Source& source, std::span<const WrittenType> types, std::vector<WrittenElement>& elements,
                        Bodies bodies) {
  return SceneReader(nullptr, WrittenElements{types, &elements, bodies == Bodies::read}).read(source).scene;
}

scene::Scene read_scene(const Source& source, std::span<const WrittenType> types, std::vector<WrittenElement>& elements,
                        std::vector<InputError>& errors, Bodies bodies) {
  return SceneReader(&errors, WrittenElements{types, &elements, bodies == Bodies::read}).read(source).scene;
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
  return place.pointer.empty() ? face_place(source, json::Reader(document), name) : place;
}

}  // namespace durero::io
