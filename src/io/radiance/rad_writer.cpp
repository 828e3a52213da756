#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <set>
#include <utility>

#include "durero/io/radiance/radiance.hpp"
#include "durero/scene/body.hpp"
#include "durero/scene/camera.hpp"
#include "durero/scene/stage.hpp"
#include "io/axis.hpp"
#include "io/blur_losses.hpp"
#include "io/ends.hpp"
#include "io/losses.hpp"
#include "io/mesh/written_triangles.hpp"
#include "io/written/left_out.hpp"
#include "io/written/stage_losses.hpp"
#include "io/written/written_box.hpp"
#include "rad_command.hpp"
#include "rad_sun.hpp"
#include "rad_written_look.hpp"

namespace durero::io {
namespace {

/// As wide as the sun, in degrees; its share, which colours are divided by, is a power of two: 2⁻¹⁶.
constexpr double written_sun = 0.4476235620376596;

std::string blank_parted(const glm::dvec3& v) { return fmt::format("{} {} {}", v.x, v.y, v.z); }

/// Of an element without a material: as a picture here shows it.
const RadWrittenLook plain_look{"plastic", {0.8, 0.8, 0.8, 0, 0}};

class RadWriter {
 public:
  RadWriter(const scene::Scene& scene, const scene::Groups& groups) : scene_(scene), groups_(groups) {}

  Exported write() {
    write_view();
    write_surroundings();
    for (const scene::Material& material : scene_.stage().materials) write_material(material);
    for (const GroupedElement& element : elements_by_group(scene_, groups_)) write_element(element);
    name_losses();
    return std::move(out_);
  }

 private:
  /// A text has no camera: a comment has the options of the program that draws.
  void write_view() {
    if (!scene_.stage().camera) return;
    const scene::Camera& camera = *scene_.stage().camera;
    const scene::Resolution size = scene_.stage().resolution.value_or(scene::default_resolution);
    glm::dvec3 way = camera.look_at - camera.eye;
    std::string lens;
    if (camera.aperture > 0) {  // in focus where the way ends
      lens = fmt::format(" -pd {}", camera.aperture);
      if (camera.focus > 0) way = camera.focus * glm::normalize(way);
    }
    const double half = std::tan(glm::radians(camera.fov_y) / 2) * size.width / size.height;
    out_.text += fmt::format("# rpict -vtv -vp {} -vd {} -vu {} -vh {} -vv {}{} -x {} -y {}\n",
                             blank_parted(camera.eye), blank_parted(way), blank_parted(camera.up),
                             glm::degrees(2 * std::atan(half)), camera.fov_y, lens, size.width, size.height);
  }

  void write_surroundings() {
    const scene::Stage& stage = scene_.stage();
    if (stage.background && !stage.environment) {
      primitive("void", "glow", "background", {stage.background->x, stage.background->y, stage.background->z, 0});
      primitive("background", "source", "background", {0, 0, 1, 360});
    }
    for (const scene::DirectionalLight& light : stage.directional_lights) write_sun(light);
  }

  void write_sun(const scene::DirectionalLight& light) {
    const double share = share_of_sun(written_sun);
    const glm::dvec3 shone = light.color / share, towards = -light.direction;
    if (!std::isfinite(shone.x + shone.y + shone.z)) {
      ++beyond_;
      return;
    }
    if (shone * share != light.color) ++rounded_suns_;
    const std::string name = fmt::format("sun{}", ++suns_);
    primitive("void", "light", name, {shone.x, shone.y, shone.z});
    primitive(name, "source", name, {towards.x, towards.y, towards.z, written_sun});
  }

  void write_material(const scene::Material& material) {
    const RadWrittenLook look = rad_written_look(material);
    scene::Material read = rad_read_look(look);
    read.name = material.name;
    if (read.e != material.e && read.k_s > 0 && roughly(read.e, material.e)) {
      ++rounded_gleams_;
      read.e = material.e;
    }
    if (read.k_s == 0) read.e = material.e;  // of no highlight
    if (read.k_t == 0) read.index = material.index;
    if (read != material) ++other_looks_;
    modifiers_.push_back(modifier_of(material));
    primitive("void", look.type, modifiers_.back(), look.numbers);
  }
  /// Whether an exponent is another by the rounding of a roughness alone: a root and a square, of 2⁻⁵³ each.
  static bool roughly(double a, double b) { return std::abs(a - b) <= 0x1p-49 * b; }

  /// A word that is its own.
  std::string modifier_of(const scene::Material& material) {
    std::string name = model::Elemento::is_name(material.name) && material.name != "void"
                           ? material.name
                           : fmt::format("m{}", modifiers_.size() + 1);
    while (!taken_.insert(name).second) name += '_';
    return name;
  }
  const std::string& plain_modifier() {
    if (plain_.empty()) {
      plain_ = modifier_of({.name = "plain"});
      primitive("void", plain_look.type, plain_, plain_look.numbers);
    }
    return plain_;
  }

  void write_element(const GroupedElement& element) {
    const auto material = scene_.material(element.element);
    modifier_ = material ? modifiers_[*material] : plain_modifier();
    identifier_ = identifier_of(element);
    if (const scene::Body* const body = scene_.body(element.element))
      write_body(*body);
    else
      scene_.visit(element.element, [&](const auto& shape) { write_shape(shape); });
  }

  std::string identifier_of(const GroupedElement& element) {
    if (!element.group.empty()) {
      if (!scene_.face(element.element)) ++names_;
      return std::string(element.group);
    }
    const auto face = scene_.face(element.element);
    std::string name = face ? face->mesh.m.name() : element.name;
    while (groups_.table().contains(name)) name += '_';
    return name;
  }

  void write_body(const scene::Body& body) {
    const auto box = written_box(body);
    if (!box || !model::identidad(box->by)) return left_out_.add(body);
    ++boxes_;
    const glm::dvec3 ends[2]{box->low, box->high};
    for (const RadFace& face : faces_of(RadBox{"", "", glm::dvec3(1)})) {
      std::vector<double> numbers;
      for (const glm::dvec3& corner : face.corners)
        for (int axis = 0; axis < 3; ++axis) numbers.push_back(ends[corner[axis] == 0 ? 0 : 1][axis]);
      surface("polygon", numbers);
    }
  }

  void write_shape(const scene::Sphere& s) { surface("sphere", {s.centro.x, s.centro.y, s.centro.z, s.radio}); }
  void write_shape(const scene::Plane& plane) { left_out_.add(plane); }
  void write_shape(const scene::Disc& d) {
    const auto axis = axis_between(glm::dvec3(0), d.vector);
    if (!axis || axis->vector != d.vector) ++directions_;
    surface("ring", {d.centro.x, d.centro.y, d.centro.z, d.vector.x, d.vector.y, d.vector.z, 0, d.radio});
  }
  void write_shape(const scene::Triangle& triangle) {
    std::vector<double> numbers;
    for (const glm::dvec3& vertex : triangle.vertices) numbers.insert(numbers.end(), {vertex.x, vertex.y, vertex.z});
    surface("polygon", numbers);
  }
  void write_shape(const scene::Cylinder& c) {
    if (const auto ends = ends_.of(c)) between("cylinder", *ends, {ends->wide});
  }
  void write_shape(const scene::Cone& c) { write_cone(ends_.of(c)); }
  void write_shape(const scene::TruncatedCone& c) { write_cone(ends_.of(c)); }
  void write_cone(const std::optional<AxisEnds>& ends) {
    if (ends) between("cone", *ends, {ends->wide, ends->narrow});
  }
  void between(std::string_view type, const AxisEnds& ends, std::initializer_list<double> radii) {
    std::vector<double> numbers{ends.base.x, ends.base.y, ends.base.z, ends.top.x, ends.top.y, ends.top.z};
    numbers.insert(numbers.end(), radii);
    surface(type, numbers);
  }

  void surface(std::string_view type, const std::vector<double>& numbers) {
    primitive(modifier_, type, identifier_, numbers);
  }
  void primitive(std::string_view modifier, std::string_view type, std::string_view identifier,
                 const std::vector<double>& numbers) {
    out_.text +=
        fmt::format("{} {} {} 0 0 {} {}\n", modifier, type, identifier, numbers.size(), fmt::join(numbers, " "));
  }

  void name_losses() {
    const scene::Stage& stage = scene_.stage();
    left_out_.name_losses(out_.lost, "Radiance");
    add_loss(out_.lost, boxes_, "box", "boxes", "written as six polygons");
    ends_.name_losses(out_.lost, "Radiance");
    add_loss(out_.lost, directions_, "direction of a disc", "directions of discs",
             "rounded: Radiance makes their length 1");
    add_smoothness_loss(out_.lost, scene_, "Radiance has normals by functions alone");
    add_wrap_losses(out_.lost, scene_, "Radiance");
    add_loss(out_.lost, names_, "name of an element", "names of elements", "left out: its group is its identifier");
    add_nesting_loss(out_.lost, groups_, "an identifier of Radiance");
    add_empty_group_losses(out_.lost, groups_);
    add_loss(out_.lost, other_looks_, "material", "materials",
             "written otherwise: Radiance has none of just these shares of light");
    add_loss(out_.lost, rounded_gleams_, "highlight", "highlights", "rounded: Radiance holds a roughness");
    add_loss(out_.lost, stage.lights.size(), "light", "lights", "left out: Radiance has none without a size");
    add_loss(out_.lost, beyond_, "directional light", "directional lights",
             "left out: its radiance is beyond binary64");
    add_loss(out_.lost, rounded_suns_, "directional light", "directional lights",
             "rounded: Radiance holds the radiance of a source");
    add_loss(out_.lost, stage.camera && stage.camera->mirrored, "mirrored camera", "mirrored cameras",
             "written unmirrored: Radiance has none");
    add_stage_losses(out_.lost, scene_, "Radiance");
    add_motion_losses(out_.lost, scene_, "Radiance");
  }

  const scene::Scene& scene_;
  const scene::Groups& groups_;
  Exported out_;
  std::vector<std::string> modifiers_;  // of the materials
  std::set<std::string> taken_;
  std::string plain_;                  // the modifier of what has no material, once there is one
  std::string modifier_, identifier_;  // of the element that is being written
  WrittenEnds ends_;
  LeftOutElements left_out_;
  std::size_t suns_ = 0, rounded_suns_ = 0, beyond_ = 0, other_looks_ = 0, rounded_gleams_ = 0, boxes_ = 0, names_ = 0,
              directions_ = 0;
};

}  // namespace

Exported radiance_text(const scene::Scene& scene, const scene::Groups& groups) {
  return RadWriter(scene, groups).write();
}

}  // namespace durero::io
