#include "durero/io/json/groups_file.hpp"
#include "durero/io/json/json_writer.hpp"
#include "durero/io/json/scene_file.hpp"
#include "durero/scene/attributes.hpp"
#include "durero/scene/body.hpp"
#include "durero/scene/by_name.hpp"
#include "durero/scene/stage.hpp"
#include "map_fields.hpp"
#include "mesh_fields.hpp"
#include "part_text.hpp"
#include "stage_fields.hpp"
#include "vertex_fields.hpp"

namespace durero::io {
namespace {

using scene::ElementRef;

/// Nothing where there is none.
template <class Lights, class Fields>
void write_lights(json::Writer& out, const char* key, const Lights& lights, const Fields& fields,
                  std::size_t required = all_fields) {
  if (lights.empty()) return;
  out.new_line().key(key).begin_array();
  for (const auto& light : lights) write_fields(out.new_line(), fields, light, required);
  out.end_array();
}

void write_stage(json::Writer& out, const scene::Stage& stage) {
  if (stage.camera) write_fields(out.new_line().key("camera"), camera_fields, *stage.camera, required_of_camera);
  if (stage.resolution) {
    const auto [width, height] = *stage.resolution;
    out.new_line().key("resolution").begin_array().value(std::uint64_t{width}).value(std::uint64_t{height}).end_array();
  }
  if (stage.background) out.new_line().member("background", *stage.background);
  write_lights(out, "lights", stage.lights, light_fields, required_of_light);
  write_lights(out, "directional_lights", stage.directional_lights, directional_light_fields);
  if (stage.environment) write_environment(out.new_line().key("environment"), *stage.environment);
  if (!stage.textures.empty()) {
    out.new_line().key("textures").begin_object();
    for (const scene::Texture& texture : stage.textures) write_texture(out.new_line().key(texture.name), texture);
    out.end_object();
  }
  if (!stage.materials.empty()) {
    out.new_line().key("materials").begin_object();
    for (const scene::Material& material : stage.materials) {
      write_fields(out.new_line().key(material.name), material_fields, material, required_of_material);
    }
    out.end_object();
  }
  if (stage.max_depth) out.new_line().member("max_depth", std::uint64_t{*stage.max_depth});
}

void write_names(json::Writer& out, const char* key, const scene::Names& names) {
  if (names.empty()) return;
  out.key(key).begin_array();
  for (const std::string& name : names) out.value(std::string_view(name));
  out.end_array();
}

void write_groups(json::Writer& out, const scene::Groups& groups) {
  if (groups.empty()) return;
  out.new_line().key("groups").begin_object();
  for (const auto& [name, group] : groups.table()) {
    out.new_line().key(name).begin_object();
    write_names(out, "elementos", group.elementos);
    write_names(out, "groups", group.groups);
    out.end_object();
  }
  out.end_object();
}

void write_attributes(json::Writer& out, const WrittenType& type, const WrittenElement& element) {
  out.member("tipo", type.word);
  for (std::size_t i = 0; i < type.attributes.size(); ++i)
    std::visit([&](const auto& value) { out.member(type.attributes[i].word, value); }, element.values[i]);
}

template <class Shape>
void write_shape(json::Writer& out, const Shape& shape) {
  out.member("tipo", Shape::word);
  scene::for_each_attribute<Shape>([&](const auto& attribute) { out.member(attribute.word, shape.*attribute.field); });
}

void write_form(json::Writer& out, const scene::Instance& instance) {
  out.key("de").begin_object();
  std::visit([&](const auto& shape) { write_shape(out, shape); }, instance.shape);
  write_map(out.end_object().key("mapa"), instance.mapa);
}

void write_part(json::Writer& out, const scene::Body& part);

void write_form(json::Writer& out, const scene::Compound& solid) {
  out.key("de").begin_array();
  for (const scene::Body& part : solid.parts) write_part(out, part);
  out.end_array();
}

void write_body(json::Writer& out, const scene::Body& body) {
  out.member("tipo", scene::word_of(body));
  std::visit([&](const auto& form) { write_form(out, form); }, body.form);
}

/// A shape that no map has moved is itself.
void write_part(json::Writer& out, const scene::Body& part) {
  out.begin_object();
  const auto* const instance = std::get_if<scene::Instance>(&part.form);
  if (instance != nullptr && model::identidad(instance->mapa))
    std::visit([&](const auto& shape) { write_shape(out, shape); }, instance->shape);
  else
    write_body(out, part);
  out.end_object();
}

void write_attributes(json::Writer& out, const scene::Scene& scene, ElementRef element) {
  scene.visit(element, [&](const auto& shape) { write_shape(out, shape); });
}

/// Of a type that a Z text declares; null where it is none.
const WrittenElement* written_element(const WrittenPart& written, const std::string& name) {
  if (written.types.empty()) return nullptr;
  const auto found = written.by_name->find(name);
  return found == written.by_name->end() ? nullptr : &found->second;
}

void write_element(json::Writer& out, const scene::Scene& scene, const WrittenPart& written, ElementRef element) {
  const std::string& name = scene.name(element).name();
  out.begin_object().member("id", name);
  if (const WrittenElement* own = written_element(written, name)) {
    write_attributes(out, written.types[own->type], *own);
  } else if (const scene::Body* body = scene.body(element)) {
    write_body(out, *body);
  } else {
    write_attributes(out, scene, element);
  }
  if (const auto material = scene.material(element)) {
    out.member("material", scene.stage().materials[*material].name);
  }
  write_vertex_looks(out, scene, element);
  if (const glm::dvec3* const motion = scene.motion(element)) out.member("motion", *motion);
  out.end_object();
}

void write_meshes(json::Writer& out, const scene::Scene& scene) {
  if (scene.meshes().size() == 0) return;
  out.new_line().key("mallas").begin_array();
  for (std::size_t i = 0; i < scene.meshes().size(); ++i) write_mesh(out.new_line(), scene.meshes()[i], scene.stage());
  out.new_line().end_array();
}

}  // namespace

std::string part_text(const scene::Body& part) {
  std::string text;
  json::Writer out(text);
  write_part(out, part);
  return text;
}

std::string scene_text(const scene::Scene& scene) { return scene_text(scene, {}); }

std::string scene_text(const scene::Scene& scene, const scene::Groups& groups) { return scene_text(scene, groups, {}); }

std::string scene_text(const scene::Scene& scene, const scene::Groups& groups, const WrittenPart& written) {
  std::string text;
  json::Writer out(text);
  write_version(out.begin_object(), scene_format);
  write_stage(out, scene.stage());
  write_groups(out, groups);
  out.new_line().key("elementos").begin_array();
  const std::vector<ElementRef> singles = scene::singles_by_name(scene);
  for (const ElementRef element : singles) write_element(out.new_line(), scene, written, element);
  if (!singles.empty()) out.new_line();
  out.end_array();
  write_meshes(out, scene);
  out.end_object();
  return text + "\n";
}

}  // namespace durero::io
