#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <set>
#include <utility>

#include "durero/io/pbrt/pbrt.hpp"
#include "durero/scene/body.hpp"
#include "durero/scene/camera.hpp"
#include "durero/scene/stage.hpp"
#include "io/blur_losses.hpp"
#include "io/losses.hpp"
#include "io/mesh/written_triangles.hpp"
#include "io/written/by_group.hpp"
#include "io/written/left_out.hpp"
#include "io/written/rounded_matrix.hpp"
#include "io/written/simple_look.hpp"
#include "io/written/stage_losses.hpp"
#include "io/written/triangle_sets.hpp"
#include "io/written/turned_axis.hpp"
#include "io/written/written_box.hpp"

namespace durero::io {
namespace {

/// Of three numbers, as a statement has them.
std::string three_of(const glm::dvec3& v) { return fmt::format("{} {} {}", v.x, v.y, v.z); }
std::string rgb_parameter(std::string_view name, const glm::dvec3& color) {
  return fmt::format(" \"rgb {}\" [{}]", name, three_of(color));
}
std::string point_parameter(std::string_view name, const glm::dvec3& p) {
  return fmt::format(" \"point3 {}\" [{}]", name, three_of(p));
}
std::string float_parameter(std::string_view name, double value) {
  return fmt::format(" \"float {}\" {}", name, value);
}

/// The corners of the cube from −1 to 1 in their order of bits, and the triangles of its faces, seen from outside.
constexpr std::string_view cube_text =
    "Shape \"trianglemesh\" \"integer indices\" [0 3 1 0 2 3 4 7 6 4 5 7 0 5 4 0 1 5 2 7 3 2 6 7 0 6 2 0 4 6 1 7 5 1 3 "
    "7] \"point3 P\" [-1 -1 -1 1 -1 -1 -1 1 -1 1 1 -1 -1 -1 1 1 -1 1 -1 1 1 1 1 1]\n";

/// A matrix column by column, as transformations of pbrt have it.
std::string concat_text(const RoundedMatrix& m) {
  return fmt::format("ConcatTransform [{} 0 {} 0 {} 0 {} 1]\n", three_of(m.axes[0]), three_of(m.axes[1]),
                     three_of(m.axes[2]), three_of(m.origin));
}

/// The type and the parameters of a look.
struct PbrtWrittenLook {
  std::string_view type;
  std::string parameters;
};
PbrtWrittenLook pbrt_look(const SimpleLook& look) {
  switch (look.kind) {
    case SimpleKind::diffuse:
      return {"diffuse", rgb_parameter("reflectance", look.color)};
    case SimpleKind::mirror:
      return {"conductor", rgb_parameter("reflectance", look.color)};
    case SimpleKind::glass:
      return {"dielectric", float_parameter("eta", look.index)};
  }
  __builtin_unreachable();  // a kind is one of its enumerators
}

/// The look that pbrt has of a material: its glass has no colour.
SimpleLook look_for_pbrt(const scene::Material& material) {
  SimpleLook look = simple_look(material);
  if (look.kind == SimpleKind::glass) look.color = glm::dvec3(1);
  return look;
}

class PbrtWriter {
 public:
  PbrtWriter(const scene::Scene& scene, const scene::Groups& groups) : scene_(scene), groups_(groups) {}

  Exported write() {
    write_camera();
    out_.text += "WorldBegin\n";
    write_lights();
    for (const scene::Material& material : scene_.stage().materials) {
      const SimpleLook look = look_for_pbrt(material);
      if (!is_look(look, material)) ++other_looks_;
      materials_.push_back(material_name(material.name));
      make_material(materials_.back(), look);
    }
    write_triangles();
    for (const GroupedElement& element : others_by_group(scene_, groups_)) write_element(element);
    name_losses();
    return std::move(out_);
  }

 private:
  /// pbrt shows left to right what no map turns: a scene's camera that is not mirrored needs one that does.
  void write_camera() {
    if (!scene_.stage().camera) return;
    const scene::Camera& camera = *scene_.stage().camera;
    const scene::Resolution size = scene_.stage().resolution.value_or(scene::default_resolution);
    if (!camera.mirrored) out_.text += "Scale -1 1 1\n";
    out_.text +=
        fmt::format("LookAt {}  {}  {}\n", three_of(camera.eye), three_of(camera.look_at), three_of(camera.up));
    out_.text += "Camera \"perspective\"" + float_parameter("fov", smaller_angle(camera.fov_y, size));
    if (camera.aperture > 0)
      out_.text +=
          float_parameter("lensradius", camera.aperture / 2) +
          float_parameter("focaldistance", camera.focus > 0 ? camera.focus : glm::length(camera.look_at - camera.eye));
    out_.text +=
        fmt::format("\nFilm \"rgb\" \"integer xresolution\" {} \"integer yresolution\" {}\n", size.width, size.height);
  }
  /// pbrt's angle is across the smaller side of the picture.
  static double smaller_angle(double fov_y, scene::Resolution size) {
    if (size.height <= size.width) return fov_y;
    const double half = std::tan(glm::radians(fov_y) / 2) * size.width / size.height;
    return glm::degrees(2 * std::atan(half));
  }

  void write_light(std::string_view type, const std::string& parameters) {
    out_.text += fmt::format("LightSource \"{}\"{}\n", type, parameters);
  }
  void write_lights() {
    const scene::Stage& stage = scene_.stage();
    if (stage.background && !stage.environment) write_light("infinite", rgb_parameter("L", *stage.background));
    for (const scene::Light& light : stage.lights) {
      const std::string shone = rgb_parameter("I", light.color) + point_parameter("from", light.position);
      if (!light.cone) {
        write_light("point", shone);
        continue;
      }
      const double delta = light.cone->outer - light.cone->inner;
      if (light.cone->tightness != 0) ++tight_;
      if (light.cone->outer - delta != light.cone->inner) ++rounded_cones_;
      write_light("spot", shone + point_parameter("to", light.cone->towards) +
                              float_parameter("coneangle", light.cone->outer) +
                              float_parameter("conedeltaangle", delta));
    }
    for (const scene::DirectionalLight& light : stage.directional_lights)
      write_light("distant", rgb_parameter("L", light.color) + point_parameter("from", glm::dvec3(0)) +
                                 point_parameter("to", light.direction));
  }

  std::string material_name(std::string_view name) {
    std::string own =
        model::Elemento::is_name(name) ? std::string(name) : fmt::format("material{}", materials_.size() + 1);
    while (!taken_.insert(own).second) own += '_';
    return own;
  }
  void make_material(const std::string& name, const SimpleLook& look) {
    const auto [type, parameters] = pbrt_look(look);
    out_.text += fmt::format("MakeNamedMaterial \"{}\" \"string type\" \"{}\"{}\n", name, type, parameters);
  }

  /// Statements within a state of their own, behind those of the look.
  void put(std::string_view name, std::optional<std::uint32_t> material, std::string_view statements) {
    if (!material && plain_.empty()) make_material(plain_ = material_name("plain"), look_of_none);
    out_.text += fmt::format("AttributeBegin{}{}\nNamedMaterial \"{}\"\n", name.empty() ? "" : "  # ", name,
                             material ? materials_[*material] : plain_);
    if (material && scene_.stage().materials[*material].emission != glm::dvec3(0))
      out_.text += fmt::format("AreaLightSource \"diffuse\"{} \"bool twosided\" true\n",
                               rgb_parameter("L", scene_.stage().materials[*material].emission));
    out_.text += statements;
    out_.text += "AttributeEnd\n";
  }

  void write_triangles() {
    for (const TriangleSet& set : triangle_sets(scene_, groups_)) {
      const IndexedMesh mesh = indexed_mesh(scene_, set.triangles, set.has_normals, false);
      std::string text = "Shape \"trianglemesh\" \"integer indices\" [";
      for (const auto& [a, b, c] : mesh.faces) text += fmt::format("\n{} {} {}", a, b, c);
      text += "] \"point3 P\" [";
      for (const auto& v : mesh.vertices) text += fmt::format("\n{} {} {}", v[0], v[1], v[2]);
      if (set.has_normals) {
        text += "] \"normal N\" [";
        for (const auto& v : mesh.vertices) text += fmt::format("\n{} {} {}", v[3], v[4], v[5]);
      }
      put(set.mesh.empty() ? set.group : set.mesh, set.material, text + "]\n");
    }
  }

  void write_element(const GroupedElement& element) {
    const scene::Body* const body = scene_.body(element.element);
    const std::string statements =
        body != nullptr ? body_text(*body)
                        : scene_.visit(element.element, [&](const auto& shape) { return shape_text(shape); });
    if (!statements.empty()) put(element.name, scene_.material(element.element), statements);
  }

  std::string body_text(const scene::Body& body) {
    if (const auto box = written_box(body)) {
      const std::string by = map_text(map_of_cube(box->low, box->high, box->by));
      if (by.empty()) return "";
      ++boxes_;
      return by + std::string(cube_text);
    }
    const auto* const instance = std::get_if<scene::Instance>(&body.form);
    if (instance == nullptr) {
      left_out_.add(body);
      return "";
    }
    const std::string shape = std::visit([&](const auto& original) { return shape_text(original); }, instance->shape);
    if (shape.empty() || model::identidad(instance->mapa)) return shape;
    const std::string by = map_text(instance->mapa);
    return by.empty() ? "" : by + shape;
  }
  /// Empty where an entry is beyond binary64.
  std::string map_text(const model::Mapa& map) {
    const RoundedMatrix matrix = rounded_matrix(map);
    if (!is_finite(matrix)) {
      ++beyond_;
      return "";
    }
    if (!matrix.is_exact) ++rounded_maps_;
    return concat_text(matrix);
  }

  std::string shape_text(const scene::Sphere& s) {
    return fmt::format("Translate {}\nShape \"sphere\"{}\n", three_of(s.centro), float_parameter("radius", s.radio));
  }
  std::string shape_text(const scene::Cylinder& c) {
    return fmt::format("{}Shape \"cylinder\"{}{}{}\n", put_along(c.centro, c.vector),
                       float_parameter("radius", c.radio), float_parameter("zmin", 0),
                       float_parameter("zmax", c.altura));
  }
  std::string shape_text(const scene::Disc& d) {
    return fmt::format("{}Shape \"disk\"{}\n", put_along(d.centro, d.vector), float_parameter("radius", d.radio));
  }
  template <class Shape>
  std::string shape_text(const Shape& shape) {
    left_out_.add(shape);
    return "";
  }
  /// Puts the origin at a point, and +z in a direction.
  std::string put_along(const glm::dvec3& at, const glm::dvec3& direction) {
    const TurnedAxis turn = turned_axis(direction);
    if (!turn.is_exact) ++turned_;
    std::string text = fmt::format("Translate {}\n", three_of(at));
    if (turn.degrees != 0) text += fmt::format("Rotate {} {} {} 0\n", turn.degrees, turn.axis.x, turn.axis.y);
    return text;
  }

  void name_losses() {
    const scene::Stage& stage = scene_.stage();
    left_out_.name_losses(out_.lost, "pbrt");
    add_loss(out_.lost, boxes_, "box", "boxes", "written as twelve triangles");
    add_loss(out_.lost, turned_, "direction", "directions", "rounded: pbrt turns cylinders and discs");
    add_loss(out_.lost, rounded_maps_, "map", "maps", "rounded: an entry is no binary64");
    add_loss(out_.lost, beyond_, "element", "elements", "left out: an entry of its map is beyond binary64");
    add_wrap_losses(out_.lost, scene_, "pbrt");
    add_loss(out_.lost, groups_.table().size(), "group", "groups", "left out: pbrt has none");
    add_loss(out_.lost, other_looks_, "material", "materials",
             "written otherwise: of one colour, a mirror or clear glass, by the greatest share");
    add_loss(out_.lost, stage.lights.size(), "light", "lights", "fading with the distance, as those of pbrt do");
    add_extent_losses(out_.lost, scene_, "pbrt");
    add_loss(out_.lost, tight_, "tightness of a light", "tightnesses of lights", "left out: not written to pbrt");
    add_loss(out_.lost, rounded_cones_, "cone of a light", "cones of lights",
             "rounded: pbrt holds the difference of two angles");
    add_stage_losses(out_.lost, scene_, "pbrt");
    add_motion_losses(out_.lost, scene_, "pbrt");
  }

  const scene::Scene& scene_;
  const scene::Groups& groups_;
  Exported out_;
  std::vector<std::string> materials_;  // their names
  std::set<std::string> taken_;
  std::string plain_;  // the name of what stands for no material, once there is one
  LeftOutElements left_out_;
  std::size_t other_looks_ = 0, turned_ = 0, rounded_maps_ = 0, rounded_cones_ = 0, beyond_ = 0, tight_ = 0, boxes_ = 0;
};

}  // namespace

Exported pbrt_text(const scene::Scene& scene, const scene::Groups& groups) { return PbrtWriter(scene, groups).write(); }

}  // namespace durero::io
