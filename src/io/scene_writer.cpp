#include <fmt/format.h>

#include "durero/io/json.hpp"
#include "durero/io/number_text.hpp"
#include "durero/io/scene_file.hpp"
#include "scene_elements.hpp"

namespace durero::io {
namespace {

using json::append_string;
using json::append_vec3;
using model::Tipo;
using scene::ElementRef;

void append_field(std::string& out, std::string_view key, double value) {
  out.append(",\"").append(key).append("\":");
  append_number(out, value);
}

void append_field(std::string& out, std::string_view key, const glm::dvec3& value) {
  out.append(",\"").append(key).append("\":");
  append_vec3(out, value);
}

void append_stage(std::string& out, const scene::Stage& stage) {
  if (stage.camera) {
    out += ",\n\"camera\":{\"eye\":";
    append_vec3(out, stage.camera->eye);
    append_field(out, "look_at", stage.camera->look_at);
    append_field(out, "up", stage.camera->up);
    append_field(out, "fov_y", stage.camera->fov_y);
    out += '}';
  }
  if (stage.resolution) {
    out += fmt::format(",\n\"resolution\":[{},{}]", stage.resolution->width, stage.resolution->height);
  }
  if (stage.background) {
    out += ",\n\"background\":";
    append_vec3(out, *stage.background);
  }
  if (!stage.lights.empty()) {
    std::string_view separator = ",\n\"lights\":[";
    for (const scene::Light& light : stage.lights) {
      out.append(separator).append("\n{\"position\":");
      append_vec3(out, light.position);
      append_field(out, "color", light.color);
      out += '}';
      separator = ",";
    }
    out += ']';
  }
  if (!stage.materials.empty()) {
    std::string_view separator = ",\n\"materials\":{";
    for (const scene::Material& material : stage.materials) {
      out.append(separator).append("\n");
      append_string(out, material.name);
      out += ":{\"color\":";
      append_vec3(out, material.color);
      out += '}';
      separator = ",";
    }
    out += '}';
  }
}

void append_shape(std::string& out, const scene::Sphere& s) {
  out += "\"esfera\"";
  append_field(out, "centro", s.centro);
  append_field(out, "radio", s.radio);
}

void append_shape(std::string& out, const scene::Cylinder& c) {
  out += "\"cilindro\"";
  append_field(out, "centro", c.centro);
  append_field(out, "radio", c.radio);
  append_field(out, "vector", c.vector);
  append_field(out, "altura", c.altura);
}

void append_shape(std::string& out, const scene::Cone& k) {
  out += "\"cono\"";
  append_field(out, "centro", k.centro);
  append_field(out, "proporcion", k.proporcion);
  append_field(out, "vector", k.vector);
  append_field(out, "altura", k.altura);
}

void append_element(std::string& out, const scene::Scene& scene, ElementRef element) {
  out.append("{\"id\":\"").append(scene.name(element).name()).append("\",\"tipo\":");
  switch (element.tipo) {
    case Tipo::soy_esfera:
      append_shape(out, scene.shapes<scene::Sphere>()[element.index]);
      break;
    case Tipo::soy_cilindro:
      append_shape(out, scene.shapes<scene::Cylinder>()[element.index]);
      break;
    case Tipo::soy_cono:
      append_shape(out, scene.shapes<scene::Cone>()[element.index]);
      break;
  }
  if (const auto material = scene.material(element)) {
    out += ",\"material\":";
    append_string(out, scene.stage().materials[*material].name);
  }
  out += '}';
}

}  // namespace

std::string scene_text(const scene::Scene& scene) {
  std::string out = "{\"format\":\"durero-scene\",\"version\":1";
  append_stage(out, scene.stage());
  out += ",\n\"elementos\":[";
  std::string_view separator = "\n";
  for (const ElementRef element : elements_by_name(scene)) {
    out += separator;
    append_element(out, scene, element);
    separator = ",\n";
  }
  return out + (scene.size() == 0 ? "]}\n" : "\n]}\n");
}

}  // namespace durero::io
