#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <set>
#include <utility>

#include "durero/io/mitsuba/mitsuba.hpp"
#include "durero/scene/body.hpp"
#include "durero/scene/camera.hpp"
#include "durero/scene/stage.hpp"
#include "io/blur_losses.hpp"
#include "io/ends.hpp"
#include "io/losses.hpp"
#include "io/mesh/ply_mesh.hpp"
#include "io/mesh/written_triangles.hpp"
#include "io/written/by_group.hpp"
#include "io/written/left_out.hpp"
#include "io/written/rounded_matrix.hpp"
#include "io/written/simple_look.hpp"
#include "io/written/stage_losses.hpp"
#include "io/written/turned_axis.hpp"
#include "io/written/written_box.hpp"

namespace durero::io {
namespace {

std::string comma_parted(const glm::dvec3& v) { return fmt::format("{}, {}, {}", v.x, v.y, v.z); }
std::string point_tag(std::string_view name, const glm::dvec3& p) {
  return fmt::format("<point name=\"{}\" x=\"{}\" y=\"{}\" z=\"{}\"/>", name, p.x, p.y, p.z);
}
std::string rgb_tag(std::string_view name, const glm::dvec3& color) {
  return fmt::format("<rgb name=\"{}\" value=\"{}\"/>", name, comma_parted(color));
}
std::string float_tag(std::string_view name, double value) {
  return fmt::format("<float name=\"{}\" value=\"{}\"/>", name, value);
}
std::string to_world(std::string_view parts) {
  return fmt::format("<transform name=\"to_world\">{}</transform>", parts);
}
std::string lookat(const glm::dvec3& from, const glm::dvec3& at, const glm::dvec3& up) {
  return fmt::format("<lookat origin=\"{}\" target=\"{}\" up=\"{}\"/>", comma_parted(from), comma_parted(at),
                     comma_parted(up));
}
std::string matrix_tag(const RoundedMatrix& m) {
  std::string rows;
  for (int i = 0; i < 3; ++i)
    rows += fmt::format("{} {} {} {}  ", m.axes[0][i], m.axes[1][i], m.axes[2][i], m.origin[i]);
  return fmt::format("<matrix value=\"{}0 0 0 1\"/>", rows);
}

/// What a look is in Mitsuba: surfaces of a scene have two sides.
std::string bsdf_text(const SimpleLook& look, const std::string& id) {
  const auto two_sided = [&](std::string_view type, const std::string& parts) {
    return fmt::format("<bsdf type=\"twosided\" id=\"{}\"><bsdf type=\"{}\">{}</bsdf></bsdf>\n", id, type, parts);
  };
  switch (look.kind) {
    case SimpleKind::diffuse:
      return two_sided("diffuse", rgb_tag("reflectance", look.color));
    case SimpleKind::mirror:
      return two_sided("conductor",
                       "<string name=\"material\" value=\"none\"/>" + rgb_tag("specular_reflectance", look.color));
    case SimpleKind::glass:
      return fmt::format("<bsdf type=\"dielectric\" id=\"{}\">{}{}{}</bsdf>\n", id, float_tag("int_ior", look.index),
                         float_tag("ext_ior", 1), rgb_tag("specular_transmittance", look.color));
  }
  __builtin_unreachable();  // a kind is one of its enumerators
}

/// The name of a file that an attribute of XML holds, in which `$` begins the name of a parameter.
std::string attribute_name(std::string name) {
  for (char& c : name)
    if (std::string_view("&<>\"'$,").find(c) != std::string_view::npos || static_cast<unsigned char>(c) < ' ') c = '_';
  return name;
}

class MitsubaWriter {
 public:
  MitsubaWriter(const scene::Scene& scene, const scene::Groups& groups, const std::string& stem)
      : scene_(scene), groups_(groups), stem_(attribute_name(stem)) {}

  Exported write() {
    out_.text = "<scene version=\"3.0.0\">\n";
    write_sensor();
    write_emitters();
    for (const scene::Material& material : scene_.stage().materials) write_material(material);
    write_triangles();
    for (const GroupedElement& element : others_by_group(scene_, groups_)) write_element(element);
    out_.text += "</scene>\n";
    name_losses();
    return std::move(out_);
  }

 private:
  /// Mitsuba's +x is on the left of a picture, as a scene's is that is not mirrored.
  void write_sensor() {
    if (!scene_.stage().camera) return;
    const scene::Camera& camera = *scene_.stage().camera;
    const scene::Resolution size = scene_.stage().resolution.value_or(scene::default_resolution);
    std::string lens;
    if (camera.aperture > 0)
      lens = float_tag("aperture_radius", camera.aperture / 2) +
             float_tag("focus_distance", camera.focus > 0 ? camera.focus : glm::length(camera.look_at - camera.eye));
    out_.text += fmt::format(
        "<sensor type=\"{}\">{}<string name=\"fov_axis\" value=\"y\"/>{}{}<film type=\"hdrfilm\">"
        "<integer name=\"width\" value=\"{}\"/><integer name=\"height\" value=\"{}\"/></film></sensor>\n",
        lens.empty() ? "perspective" : "thinlens", float_tag("fov", camera.fov_y), lens,
        to_world((camera.mirrored ? "<scale x=\"-1\"/>" : "") + lookat(camera.eye, camera.look_at, camera.up)),
        size.width, size.height);
  }

  void emitter(std::string_view type, std::string_view parts) {
    out_.text += fmt::format("<emitter type=\"{}\">{}</emitter>\n", type, parts);
  }
  void write_emitters() {
    const scene::Stage& stage = scene_.stage();
    if (stage.background && !stage.environment) emitter("constant", rgb_tag("radiance", *stage.background));
    for (const scene::Light& light : stage.lights) {
      if (light.cone)
        write_spot(light, *light.cone);
      else
        emitter("point", point_tag("position", light.position) + rgb_tag("intensity", light.color));
    }
    for (const scene::DirectionalLight& light : stage.directional_lights) {
      const glm::dvec3& d = light.direction;
      emitter("directional", fmt::format("<vector name=\"direction\" x=\"{}\" y=\"{}\" z=\"{}\"/>{}", d.x, d.y, d.z,
                                         rgb_tag("irradiance", light.color)));
    }
  }
  void write_spot(const scene::Light& light, const scene::LightCone& cone) {
    if (cone.tightness != 0) ++tight_;
    const glm::dvec3 way = glm::abs(cone.towards - light.position);
    const glm::dvec3 up = way.x <= way.y && way.x <= way.z ? glm::dvec3(1, 0, 0)
                          : way.y <= way.z                 ? glm::dvec3(0, 1, 0)
                                                           : glm::dvec3(0, 0, 1);
    emitter("spot", rgb_tag("intensity", light.color) + float_tag("cutoff_angle", cone.outer) +
                        float_tag("beam_width", cone.inner) + to_world(lookat(light.position, cone.towards, up)));
  }

  /// A name that is its own: all things of a scene of Mitsuba share one set of names.
  std::string id_of(std::string_view name, std::string_view otherwise) {
    std::string id(model::Elemento::is_name(name) ? name : otherwise);
    while (!taken_.insert(id).second) id += '_';
    return id;
  }
  void write_material(const scene::Material& material) {
    const SimpleLook look = simple_look(material);
    if (!is_look(look, material)) ++other_looks_;
    bsdfs_.push_back(id_of(material.name, fmt::format("material{}", bsdfs_.size() + 1)));
    out_.text += bsdf_text(look, bsdfs_.back());
  }

  /// What a shape says of its look.
  std::string look_of(std::optional<std::uint32_t> material, bool may_shine = true) {
    if (!material) {
      if (plain_.empty()) out_.text += bsdf_text(look_of_none, plain_ = id_of("plain", ""));
      return fmt::format("<ref id=\"{}\"/>", plain_);
    }
    const scene::Material& m = scene_.stage().materials[*material];
    std::string text = fmt::format("<ref id=\"{}\"/>", bsdfs_[*material]);
    if (m.emission == glm::dvec3(0)) return text;
    if (!may_shine)
      ++dark_;
    else
      text += fmt::format("<emitter type=\"area\">{}</emitter>", rgb_tag("radiance", m.emission));
    return text;
  }

  void write_triangles() {
    for (const TriangleSet& set : triangle_sets(scene_, groups_)) {
      const std::string name = fmt::format("{}.mesh{}.ply", stem_, out_.beside.size() + 1);
      out_.beside.push_back(
          {name, ply_mesh_bytes(indexed_mesh(scene_, set.triangles, set.has_normals, false), set.has_normals)});
      const std::string look = look_of(set.material);
      out_.text +=
          fmt::format("<shape type=\"ply\" id=\"{}\"><string name=\"filename\" value=\"{}\"/>{}{}</shape>\n",
                      id_of(set.mesh.empty() ? set.group : set.mesh, fmt::format("mesh{}", out_.beside.size())), name,
                      set.has_normals ? "" : "<boolean name=\"face_normals\" value=\"true\"/>", look);
    }
  }

  void write_element(const GroupedElement& element) {
    const scene::Body* const body = scene_.body(element.element);
    if (body != nullptr) return write_body(*body, element);
    const std::string shape = scene_.visit(element.element, [&](const auto& geometry) { return shape_text(geometry); });
    if (!shape.empty()) put(shape, element);
  }
  void put(std::string_view shape, const GroupedElement& element) {
    const std::string look = look_of(scene_.material(element.element));
    out_.text += fmt::format("<shape id=\"{}\" {}{}</shape>\n", id_of(element.name, ""), shape, look);
  }

  void write_body(const scene::Body& body, const GroupedElement& element) {
    if (const auto box = written_box(body)) {
      const RoundedMatrix matrix = rounded_matrix(map_of_cube(box->low, box->high, box->by));
      if (is_kept(matrix)) put("type=\"cube\">" + to_world(matrix_tag(matrix)), element);
    } else if (const auto* const instance = std::get_if<scene::Instance>(&body.form)) {
      write_instance(*instance, element);
    } else {
      left_out_.add(body);
    }
  }
  void write_instance(const scene::Instance& instance, const GroupedElement& element) {
    const std::string shape = std::visit([&](const auto& geometry) { return shape_text(geometry); }, instance.shape);
    if (shape.empty()) return;
    if (model::identidad(instance.mapa)) return put(shape, element);
    const RoundedMatrix matrix = rounded_matrix(instance.mapa);
    if (!is_kept(matrix)) return;
    const std::string id = id_of(element.name, ""), group = id_of(element.name + ".original", "original"),
                      look = look_of(scene_.material(element.element), false);
    out_.text += fmt::format(
        "<shape type=\"shapegroup\" id=\"{0}\"><shape {1}{2}</shape></shape>\n"
        "<shape id=\"{3}\" type=\"instance\"><ref id=\"{0}\"/>{4}</shape>\n",
        group, shape, look, id, to_world(matrix_tag(matrix)));
  }
  bool is_kept(const RoundedMatrix& matrix) {
    if (!is_finite(matrix)) {
      ++beyond_;
      return false;
    }
    if (!matrix.is_exact) ++rounded_maps_;
    return true;
  }

  std::string shape_text(const scene::Sphere& s) {
    return fmt::format("type=\"sphere\">{}{}", point_tag("center", s.centro), float_tag("radius", s.radio));
  }
  std::string shape_text(const scene::Cylinder& c) {
    const auto ends = ends_.of(c);
    return ends ? fmt::format("type=\"cylinder\">{}{}{}", point_tag("p0", ends->base), point_tag("p1", ends->top),
                              float_tag("radius", ends->wide))
                : "";
  }
  std::string shape_text(const scene::Disc& d) {
    const TurnedAxis turn = turned_axis(d.vector);
    if (!turn.is_exact) ++turned_discs_;
    std::string parts = fmt::format("<scale value=\"{}\"/>", d.radio);
    if (turn.degrees != 0)
      parts += fmt::format("<rotate x=\"{}\" y=\"{}\" angle=\"{}\"/>", turn.axis.x, turn.axis.y, turn.degrees);
    parts += fmt::format("<translate x=\"{}\" y=\"{}\" z=\"{}\"/>", d.centro.x, d.centro.y, d.centro.z);
    return "type=\"disk\">" + to_world(parts);
  }
  template <class Shape>
  std::string shape_text(const Shape& shape) {
    left_out_.add(shape);
    return "";
  }

  void name_losses() {
    const scene::Stage& stage = scene_.stage();
    left_out_.name_losses(out_.lost, "Mitsuba");
    ends_.name_losses(out_.lost, "Mitsuba");
    add_loss(out_.lost, turned_discs_, "direction of a disc", "directions of discs", "rounded: Mitsuba turns discs");
    add_loss(out_.lost, rounded_maps_, "map", "maps", "rounded: an entry is no binary64");
    add_loss(out_.lost, beyond_, "element", "elements", "left out: an entry of its map is beyond binary64");
    add_wrap_losses(out_.lost, scene_, "Mitsuba");
    add_loss(out_.lost, groups_.table().size(), "group", "groups", "left out: Mitsuba has none");
    add_loss(out_.lost, other_looks_, "material", "materials",
             "written otherwise: of one colour, a mirror or glass, by the greatest share");
    add_loss(out_.lost, dark_, "copy", "copies", "written without its light: Mitsuba has no copies that shine");
    add_loss(out_.lost, stage.lights.size(), "light", "lights", "fading with the distance, as those of Mitsuba do");
    add_extent_losses(out_.lost, scene_, "Mitsuba");
    add_loss(out_.lost, tight_, "tightness of a light", "tightnesses of lights", "left out: not written to Mitsuba");
    add_stage_losses(out_.lost, scene_, "Mitsuba");
    add_motion_losses(out_.lost, scene_, "Mitsuba");
  }

  const scene::Scene& scene_;
  const scene::Groups& groups_;
  const std::string stem_;
  Exported out_;
  std::set<std::string> taken_;
  std::vector<std::string> bsdfs_;  // of the materials
  std::string plain_;               // the bsdf of what has no material, once there is one
  WrittenEnds ends_;
  LeftOutElements left_out_;
  std::size_t other_looks_ = 0, turned_discs_ = 0, rounded_maps_ = 0, beyond_ = 0, dark_ = 0, tight_ = 0;
};

}  // namespace

Exported mitsuba_text(const scene::Scene& scene, const scene::Groups& groups, const std::string& stem) {
  return MitsubaWriter(scene, groups, stem).write();
}

}  // namespace durero::io
