#include <fmt/format.h>

#include <vector>

#include "durero/io/nff/nff.hpp"
#include "durero/io/number_text.hpp"
#include "durero/scene/attributes.hpp"
#include "durero/scene/by_name.hpp"
#include "durero/scene/stage.hpp"
#include "io/blur_losses.hpp"
#include "io/ends.hpp"
#include "io/json/stage_fields.hpp"
#include "io/losses.hpp"

namespace durero::io {
namespace {

using scene::ElementRef;

std::string text(double x) { return number_text(x); }
std::string text(const glm::dvec3& v) { return fmt::format("{} {} {}", v.x, v.y, v.z); }

class NffWriter {
 public:
  explicit NffWriter(const scene::Scene& scene) : scene_(scene) {}

  Exported write() {
    write_stage();
    const auto& materials = scene_.stage().materials;
    std::vector<std::vector<ElementRef>> of_material(materials.size());
    for (const ElementRef element : scene::elements_by_name(scene_)) {
      if (const auto material = scene_.material(element)) {
        of_material[*material].push_back(element);
      } else {
        write_element(element);
      }
    }
    for (std::size_t i = 0; i < materials.size(); ++i) {
      write_fill(materials[i]);
      for (const ElementRef element : of_material[i]) write_element(element);
    }
    name_losses();
    return std::move(out_);
  }

 private:
  void write_stage() {
    const scene::Stage& stage = scene_.stage();
    if (stage.background) out_.text += fmt::format("b {}\n", text(*stage.background));
    if (stage.camera) {
      const scene::Resolution size = stage.resolution.value_or(scene::Resolution{512, 512});
      out_.text += "v\n";
      const auto write = [&](const auto& field) {
        out_.text += fmt::format("{} {}\n", field.key, text(*stage.camera.*field.member));
      };
      std::apply([&](const auto&... field) { (write(field), ...); }, view_fields);
      out_.text += fmt::format("hither 0\nresolution {} {}\n", size.width, size.height);
      if (!stage.resolution) out_.lost.emplace_back("no resolution in the scene: 512 512 was written");
    } else {
      out_.lost.emplace_back("no camera in the scene: no view was written");
      if (stage.resolution) out_.lost.emplace_back("1 resolution left out: it is part of a view");
    }
    for (const scene::Light& light : stage.lights) {
      out_.text += fmt::format("l {} {}\n", text(light.position), text(light.color));
    }
  }

  /// NFF has one share for highlight and mirror, and no colour but one.
  void write_fill(const scene::Material& m) {
    out_.text += fmt::format("f {} 1 {} {} {} {}\n", text(m.color), m.k_ps, m.k_ps > 0 ? m.e : 0, m.k_t,
                             m.k_t > 0 ? m.index : 1);
    scene::Material held{.name = m.name, .color = m.color, .k_s = m.k_ps, .k_ps = m.k_ps, .k_t = m.k_t};
    if (held.k_ps > 0) held.e = m.e;
    if (held.k_t > 0) held.index = m.index;
    if (held != m) ++other_looks_;
  }

  void write_element(ElementRef element) {
    if (scene_.body(element) != nullptr) {
      ++bodies_;
      return;
    }
    if (const auto normals = scene_.vertex_normals(element))
      return write_patch(scene_.shapes<scene::Triangle>()[element.index], *normals);
    scene_.visit(element, [&](const auto& shape) { write_shape(shape); });
  }

  void write_shape(const scene::Sphere& s) { out_.text += fmt::format("s {} {}\n", text(s.centro), s.radio); }

  void write_shape(const scene::Plane&) { ++planes_; }
  void write_shape(const scene::Disc&) { ++discs_; }
  void write_shape(const scene::Triangle& triangle) {
    out_.text += "p 3\n";
    for (const glm::dvec3& vertex : triangle.vertices) out_.text += text(vertex) + "\n";
  }

  void write_patch(const scene::Triangle& triangle, const scene::VertexNormals& normals) {
    out_.text += "pp 3\n";
    for (std::size_t i = 0; i < normals.size(); ++i)
      out_.text += fmt::format("{} {}\n", text(triangle.vertices[i]), text(normals[i]));
  }

  template <class Shape>
    requires(scene::has_attribute<Shape, &scene::AnyEscena::mi_altura>())
  void write_shape(const Shape& shape) {
    if (const auto ends = ends_.of(shape))
      out_.text += fmt::format("c {} {} {} {}\n", text(ends->base), ends->wide, text(ends->top), ends->narrow);
  }

  void name_losses() {
    add_loss(out_.lost, scene_.size(), "name of an element", "names of elements", "left out: NFF has none");
    add_loss(out_.lost, scene_.stage().materials.size(), "name of a material", "names of materials",
             "left out: NFF has none");
    add_loss(out_.lost, other_looks_, "material", "materials",
             "written otherwise: NFF has one colour, and one share for highlight and mirror");
    add_loss(out_.lost, scene_.stage().directional_lights.size(), "directional light", "directional lights",
             "left out: NFF has none");
    add_loss(out_.lost, scene_.stage().textures.size(), "texture", "textures", "left out: NFF has none");
    if (scene_.stage().camera && scene_.stage().camera->mirrored)
      out_.lost.emplace_back("1 mirrored camera written unmirrored: NFF has none");
    if (scene_.stage().environment) out_.lost.emplace_back("1 environment left out: NFF has none");
    if (scene_.stage().max_depth) out_.lost.emplace_back("1 max_depth left out: NFF has none");
    add_loss(out_.lost, planes_, "plane", "planes", "left out: NFF has none");
    add_loss(out_.lost, bodies_, "instance or solid", "instances and solids", "left out: NFF has none");
    add_loss(out_.lost, discs_, "disc", "discs", "left out: NFF has none");
    add_blur_losses(out_.lost, scene_, "NFF");
    ends_.name_losses(out_.lost, "NFF");
  }

  const scene::Scene& scene_;
  Exported out_;
  WrittenEnds ends_;
  std::size_t planes_ = 0, discs_ = 0, bodies_ = 0, other_looks_ = 0;
};

}  // namespace

Exported nff_text(const scene::Scene& scene, const scene::Groups& groups) {
  Exported out = NffWriter(scene).write();
  add_loss(out.lost, groups.table().size(), "group", "groups", "left out: NFF has none");
  return out;
}

}  // namespace durero::io
