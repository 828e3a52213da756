#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <utility>

#include "durero/io/pov/pov.hpp"
#include "durero/scene/body.hpp"
#include "durero/scene/by_name.hpp"
#include "durero/scene/camera.hpp"
#include "durero/scene/stage.hpp"
#include "io/blur_losses.hpp"
#include "io/ends.hpp"
#include "io/losses.hpp"
#include "pov_light.hpp"
#include "pov_texture.hpp"

namespace durero::io {
namespace {

std::string bracketed(const glm::dvec3& v) { return fmt::format("<{}, {}, {}>", v.x, v.y, v.z); }

/// So far away that a parallel light stands before all that a scene has: as far as POV-Ray sees, but for a tenth.
constexpr double far_away = 1e6;

/// Rays of a pixel through a lens.
constexpr int blur_samples = 64;

/// Rays in a row of a scene that names no number: the most that its materials may need (docs/rendering.md).
constexpr std::uint32_t most_depth = 15;

class PovWriter {
 public:
  PovWriter(const scene::Scene& scene, const scene::Groups& groups)
      : scene_(scene), groups_(groups), patterns_(scene.stage().textures) {}

  Exported write() {
    const scene::Stage& stage = scene_.stage();
    const scene::Resolution size = stage.resolution.value_or(scene::default_resolution);
    out_.text = fmt::format("// povray +W{} +H{} -A File_Gamma=sRGB\n#version 3.7;\n", size.width, size.height);
    // POV-Ray's first ray has level 0.
    out_.text += fmt::format("global_settings {{ assumed_gamma 1 max_trace_level {} adc_bailout 0 }}\n",
                             stage.max_depth.value_or(most_depth));
    write_camera(size);
    const std::size_t before = out_.text.size();
    if (stage.environment)
      write_sky(*stage.environment);
    else if (stage.background)
      out_.text += fmt::format("background {{ rgb {} }}\n", bracketed(*stage.background));
    write_lights();
    for (const scene::Material& material : stage.materials) looks_.push_back(pov_attributes(material, patterns_, {}));
    write_elements();
    out_.text.insert(before, patterns_.declarations(out_.text));
    name_losses();
    return std::move(out_);
  }

 private:
  /// By the rays through the middles of the edges of the picture, so that every pixel has the ray that it has here.
  void write_camera(scene::Resolution size) {
    if (!scene_.stage().camera) {
      out_.lost.emplace_back("no camera in the scene: no view was written");
      return;
    }
    const scene::PrimaryRays rays(*scene_.stage().camera, size);
    const double right = size.width - 0.5, bottom = size.height - 0.5, x = (size.width - 1) / 2.0,
                 y = (size.height - 1) / 2.0;
    const auto direction = [&](double across, double down) { return rays.ray_at(across, down).v().xyz(); };
    const scene::Camera& camera = *scene_.stage().camera;
    out_.text += fmt::format("camera {{ location {} direction {} right {} up {}{} }}\n", bracketed(camera.eye),
                             bracketed(direction(x, y)), bracketed(direction(right, y) - direction(-0.5, y)),
                             bracketed(direction(x, -0.5) - direction(x, bottom)), lens_text(camera));
  }

  /// POV-Ray's lens is half as wide as its aperture says.
  static std::string lens_text(const scene::Camera& camera) {
    if (camera.aperture == 0) return "";
    const glm::dvec3 way = camera.look_at - camera.eye;
    const glm::dvec3 focus = camera.focus > 0 ? camera.eye + camera.focus * glm::normalize(way) : camera.look_at;
    return fmt::format(" aperture {} focal_point {} blur_samples {} variance 0", 2 * camera.aperture, bracketed(focus),
                       blur_samples);
  }

  void write_sky(const scene::Environment& environment) {
    const std::string sky = pov_sky(environment);
    if (sky.empty())
      out_.lost.emplace_back("1 environment left out: by their names its files are neither PNG nor JPEG");
    out_.text += sky;
  }

  void write_lights() {
    for (const scene::Light& light : scene_.stage().lights) out_.text += pov_light(light);
    for (const scene::DirectionalLight& light : scene_.stage().directional_lights) {
      const glm::dvec3& d = light.direction;
      const double greatest = std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)});  // whose square may overflow
      const glm::dvec3 from = -far_away * glm::normalize(d / greatest);
      out_.text += fmt::format("light_source {{ {}, rgb {} parallel point_at <0, 0, 0> }}\n", bracketed(from),
                               bracketed(light.color));
    }
  }

  /// Those that are in no group, then groups: each is made once all that are in it are.
  void write_elements() {
    for (const scene::ElementRef element : scene::elements_by_name(scene_))
      if (groups_.of_element(scene_.name(element).name()).empty()) out_.text += object_text(element);
    std::map<std::string_view, std::string> unions;
    for (const std::string_view name : groups_.bottom_up()) unions.emplace(name, union_text(name, unions));
    for (const auto& [name, text] : unions) out_.text += text;
  }

  /// Takes the groups that are in it from those that are made. Empty where nothing is in it.
  std::string union_text(std::string_view name, std::map<std::string_view, std::string>& made) {
    const scene::Group& group = groups_.table().find(name)->second;
    std::string members;
    for (const std::string& e : group.elementos) members += object_text(scene_.find(e).value());
    for (const std::string& g : group.groups) members += made.extract(g).mapped();
    if (members.empty()) ++empty_groups_;
    return members.empty() ? "" : fmt::format("union {{\n{}}}  // {}\n", members, name);
  }

  /// A line, or two; empty where the element is left out.
  std::string object_text(scene::ElementRef element) {
    const auto normals = scene_.vertex_normals(element);
    const scene::Body* const body = scene_.body(element);
    const std::string shape = body != nullptr ? body_text(*body)
                              : !normals      ? plain_text(element)
                                              : smooth_text(scene_.shapes<scene::Triangle>()[element.index], *normals);
    if (shape.empty()) return "";
    const auto material = scene_.material(element);
    const bool is_glass = material && scene_.stage().materials[*material].k_t > 0;
    std::string text = fmt::format("object {{ {} {}{} }}  // {}\n", shape, look(element, material),
                                   is_glass ? " no_shadow" : "", scene_.name(element).name());
    if (is_glass) text += fmt::format("object {{ {} no_image no_reflection }}  // its shadow\n", shape);
    return text;
  }

  std::string look(scene::ElementRef element, std::optional<std::uint32_t> material) const {
    if (!material) return pov_attributes({.color = glm::dvec3(0.8)}, patterns_, {});
    const scene::Material& m = scene_.stage().materials[*material];
    if (!m.textures.any() && !m.bump) return looks_[*material];
    const PovCoordinates at = pov_coordinates(scene_, element);
    if (!m.bump || !is_seen_from_behind(element)) return pov_attributes(m, patterns_, at);
    scene::Material turned = m;
    turned.bump->height = -m.bump->height;
    return pov_attributes(turned, patterns_, at);
  }

  /// Of a flat element, by the eye. POV-Ray turns a normal to whoever looks before a relief turns it, so that what is
  /// high in front would be high behind.
  bool is_seen_from_behind(scene::ElementRef element) const {
    if (!scene_.stage().camera) return false;
    const glm::dvec3& eye = scene_.stage().camera->eye;
    return scene_.visit(element, [&]<class Shape>(const Shape& shape) {
      if constexpr (std::is_same_v<Shape, scene::Triangle>) {
        const auto& [a, b, c] = shape.vertices;
        return glm::dot(glm::cross(b - a, c - a), eye - a) < 0;
      } else if constexpr (std::is_same_v<Shape, scene::Plane> || std::is_same_v<Shape, scene::Disc>) {
        return glm::dot(shape.vector, eye - shape.centro) < 0;
      } else {
        return false;
      }
    });
  }

  std::string plain_text(scene::ElementRef element) {
    return scene_.visit(element, [&](const auto& geometry) { return shape_text(geometry); });
  }

  std::string body_text(const scene::Body& body) {
    return std::visit([&](const auto& form) { return form_text(form); }, body.form);
  }
  std::string form_text(const scene::Instance& instance) {
    const std::string shape = std::visit([&](const auto& geometry) { return shape_text(geometry); }, instance.shape);
    if (shape.empty() || model::identidad(instance.mapa)) return shape;
    return fmt::format("object {{ {} matrix <{}> }}", shape, entries(instance.mapa));
  }
  /// POV-Ray's union has faces within, its merge has none. A part that cannot be written leaves the whole out.
  std::string form_text(const scene::Compound& solid) {
    const bool was_within = std::exchange(is_within_solid_, true);
    std::string parts;
    bool is_whole = true;
    for (const scene::Body& part : solid.parts) {
      const std::string text = body_text(part);
      is_whole = is_whole && !text.empty();
      parts += text + " ";
    }
    is_within_solid_ = was_within;
    return is_whole ? fmt::format("{} {{ {}}}", pov_word(solid.operation), parts) : "";
  }
  static std::string_view pov_word(scene::Compound::Operation operation) {
    switch (operation) {
      case scene::Compound::Operation::united:
        return "merge";
      case scene::Compound::Operation::intersected:
        return "intersection";
      case scene::Compound::Operation::subtracted:
        return "difference";
    }
    __builtin_unreachable();  // an operation is one of its enumerators
  }
  std::string_view caps() const { return is_within_solid_ ? "" : " open"; }
  /// What becomes of the axes, and where the origin goes: the twelve numbers of a matrix.
  std::string entries(const model::Mapa& mapa) {
    std::string text;
    bool is_exact = true;
    const auto add = [&](const number::Rational& entry) {
      const double rounded = number::round_to_binary64(entry);
      is_exact = is_exact && std::isfinite(rounded) && number::exact(rounded) == entry;
      text += fmt::format("{}{}", text.empty() ? "" : ", ", rounded);
    };
    for (const model::ExactVector* row : {&mapa.x, &mapa.y, &mapa.z, &mapa.centro})
      for (const number::Rational* entry : {&row->x, &row->y, &row->z}) add(*entry);
    if (!is_exact) ++rounded_maps_;
    return text;
  }

  std::string shape_text(const scene::Sphere& s) {
    return fmt::format("sphere {{ {}, {} }}", bracketed(s.centro), s.radio);
  }
  std::string shape_text(const scene::Plane& p) {
    return fmt::format("plane {{ {}, 0 translate {} }}", bracketed(p.vector), bracketed(p.centro));
  }
  std::string shape_text(const scene::Disc& d) {
    return fmt::format("disc {{ {}, {}, {} }}", bracketed(d.centro), bracketed(d.vector), d.radio);
  }
  std::string shape_text(const scene::Triangle& t) {
    return fmt::format("triangle {{ {}, {}, {} }}", bracketed(t.vertices[0]), bracketed(t.vertices[1]),
                       bracketed(t.vertices[2]));
  }
  static std::string smooth_text(const scene::Triangle& t, const scene::VertexNormals& n) {
    return fmt::format("smooth_triangle {{ {}, {}, {}, {}, {}, {} }}", bracketed(t.vertices[0]), bracketed(n[0]),
                       bracketed(t.vertices[1]), bracketed(n[1]), bracketed(t.vertices[2]), bracketed(n[2]));
  }
  std::string shape_text(const scene::Cylinder& c) {
    const auto ends = ends_.of(c);
    return ends ? fmt::format("cylinder {{ {}, {}, {}{} }}", bracketed(ends->base), bracketed(ends->top), ends->wide,
                              caps())
                : "";
  }
  std::string shape_text(const scene::Cone& c) { return cone_text(ends_.of(c)); }
  std::string shape_text(const scene::TruncatedCone& c) { return cone_text(ends_.of(c)); }
  std::string cone_text(const std::optional<AxisEnds>& ends) const {
    return ends ? fmt::format("cone {{ {}, {}, {}, {}{} }}", bracketed(ends->base), ends->wide, bracketed(ends->top),
                              ends->narrow, caps())
                : "";
  }

  void name_losses() {
    add_loss(out_.lost, scene_.stage().directional_lights.size(), "directional light", "directional lights",
             "written as parallel ones, 1000000 away: POV-Ray has none without a place");
    add_loss(out_.lost, patterns_.unknown(), "texture", "textures",
             "left out: by its name a file is neither PNG nor JPEG");
    const auto& textures = scene_.stage().textures;
    add_loss(out_.lost,
             static_cast<std::size_t>(std::ranges::count(textures, scene::Filter::mipmap, &scene::Texture::filter)),
             "mipmap", "mipmaps", "drawn by the picture alone: POV-Ray has no levels");
    add_loss(out_.lost,
             static_cast<std::size_t>(std::ranges::count_if(
                 scene_.stage().materials,
                 [&](const scene::Material& m) { return m.bump && !patterns_.is_exact(*m.bump); })),
             "relief", "reliefs", "drawn by the differences of POV-Ray: only those of waves are slopes");
    const auto lights_of = [&](auto which) {
      return static_cast<std::size_t>(std::ranges::count_if(scene_.stage().lights, which));
    };
    add_loss(out_.lost,
             lights_of([](const scene::Light& light) { return light.extent.shape == scene::LightShape::triangle; }),
             "triangle that shines", "triangles that shine", "written as a point: POV-Ray has no such light");
    add_motion_losses(out_.lost, scene_, "POV-Ray");
    ends_.name_losses(out_.lost, "POV-Ray");
    add_loss(out_.lost, rounded_maps_, "map", "maps", "rounded: an entry is no binary64");
    add_loss(out_.lost, empty_groups_, "group", "groups", "left out: nothing is in it");
  }

  const scene::Scene& scene_;
  const scene::Groups& groups_;
  const PovPatterns patterns_;
  Exported out_;
  std::vector<std::string> looks_;  // of the materials
  WrittenEnds ends_;
  std::size_t empty_groups_ = 0, rounded_maps_ = 0;
  bool is_within_solid_ = false;  // where cylinders and cones are closed
};

}  // namespace

Exported pov_text(const scene::Scene& scene, const scene::Groups& groups) { return PovWriter(scene, groups).write(); }

}  // namespace durero::io
