#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <map>
#include <utility>

#include "buffer_uri.hpp"
#include "durero/io/json/json_writer.hpp"
#include "durero/io/mesh/gltf.hpp"
#include "durero/scene/body.hpp"
#include "durero/scene/camera.hpp"
#include "durero/scene/stage.hpp"
#include "gltf_buffer.hpp"
#include "io/blur_losses.hpp"
#include "io/byte_order.hpp"
#include "io/losses.hpp"
#include "io/written/left_out.hpp"
#include "io/written/simple_look.hpp"
#include "io/written/stage_losses.hpp"
#include "io/written/triangle_sets.hpp"
#include "io/written/turned_axis.hpp"
#include "written_triangles.hpp"

namespace durero::io {
namespace {

/// Whether a number rounds to a finite binary32: those from half a step beyond the greatest on do not.
bool is_within_floats(double x) { return std::abs(x) < 0x1.ffffffp127; }

std::uint64_t whole(std::size_t n) { return n; }

template <class Numbers>
void write_numbers(json::Writer& out, std::string_view name, const Numbers& numbers) {
  out.key(name).begin_array();
  for (const double number : numbers) out.value(number + 0.0);  // −0 becomes 0
  out.end_array();
}

/// A colour as one of shares and how bright it is.
struct BrightColor {
  glm::dvec3 color;
  double intensity;
};
BrightColor bright(const glm::dvec3& color) {
  const double greatest = std::max({color.x, color.y, color.z});
  return greatest > 0 ? BrightColor{color / greatest, greatest} : BrightColor{color, 0};
}

class GltfWriter {
 public:
  GltfWriter(const scene::Scene& scene, const scene::Groups& groups) : scene_(scene), groups_(groups) {}

  /// The JSON, but for the buffer, which `write_buffer` adds where there is one.
  template <class WriteBuffer>
  Exported write(WriteBuffer&& write_buffer) {
    count_elements();
    find_primitives();
    json::Writer out(out_.text);
    out.begin_object().key("asset").begin_object().member("version", "2.0").member("generator", "Durero").end_object();
    out.new_line().member("scene", whole(0));
    write_nodes(out);
    write_meshes(out);
    write_materials(out);
    write_stage(out);
    if (!buffer_.bytes().empty()) {
      out.new_line();
      buffer_.write(out);
      out.new_line().key("buffers").begin_array().begin_object().member("byteLength", whole(buffer_.bytes().size()));
      write_buffer(out, buffer_.bytes());
      out.end_object().end_array();
    }
    out.new_line().end_object();
    out_.text += '\n';
    name_losses();
    return std::move(out_);
  }
  const std::string& bytes() const { return buffer_.bytes(); }

 private:
  /// Triangles that are drawn together, as accessors.
  struct Primitive {
    std::size_t positions, indices;
    std::optional<std::size_t> normals{}, uv{};
    std::optional<std::uint32_t> material{};
  };
  struct WrittenNode {
    std::string_view group, mesh;
    std::vector<Primitive> primitives{};
  };

  void count_elements() {
    scene_.for_each_single([&]<class Shape>(scene::ElementRef element, const Shape& shape) {
      if (const scene::Body* const body = scene_.body(element))
        left_out_.add(*body);
      else if (!std::is_same_v<Shape, scene::Triangle>)
        left_out_.add(shape);
    });
  }

  void find_primitives() {
    std::map<std::pair<std::string_view, std::string_view>, std::size_t> known;
    for (TriangleSet& set : triangle_sets(scene_, groups_)) {
      beyond_ += std::erase_if(set.triangles, [&](scene::ElementRef e) { return !can_be_floats(e, set.has_uv); });
      if (set.triangles.empty()) continue;
      const auto [place, is_new] = known.try_emplace({set.group, set.mesh}, nodes_.size());
      if (is_new) nodes_.push_back({set.group, set.mesh});
      nodes_[place->second].primitives.push_back(primitive_of(set));
    }
  }
  bool can_be_floats(scene::ElementRef element, bool has_uv) const {
    bool can = true;
    const scene::Triangle triangle = scene_.shapes<scene::Triangle>()[element.index];
    for (const glm::dvec3& p : triangle.vertices)
      can = can && is_within_floats(p.x) && is_within_floats(p.y) && is_within_floats(p.z);
    const auto wrap = has_uv ? scene_.wrap(element) : std::nullopt;
    for (std::size_t i = 0; wrap && i < 3; ++i)
      can = can && is_within_floats(wrap->uv[i].x) && is_within_floats(1 - wrap->uv[i].y);
    return can;
  }

  Primitive primitive_of(const TriangleSet& set) {
    const IndexedMesh mesh = indexed_mesh(scene_, set.triangles, set.has_normals, set.has_uv);
    std::vector<float> positions, normals, uv;
    std::vector<std::uint32_t> indices;
    const auto append = [](std::vector<float>& to, std::size_t& rounded, double x) {
      to.push_back(static_cast<float>(x));
      rounded += static_cast<double>(to.back()) != x;
    };
    for (const auto& v : mesh.vertices) {
      for (std::size_t i = 0; i < 3; ++i) append(positions, rounded_, v[i]);
      const glm::dvec3 told(v[3], v[4], v[5]);
      const double greatest = std::max({std::abs(told.x), std::abs(told.y), std::abs(told.z)});
      const glm::dvec3 normal = glm::normalize(told / greatest);
      for (int i = 0; i < 3; ++i) normals.push_back(static_cast<float>(normal[i]));
      append(uv, rounded_uv_, v[6]);
      append(uv, rounded_uv_, 1 - v[7]);  // it grows downwards there
      if (set.has_uv && 1 - static_cast<double>(uv.back()) != v[7] && static_cast<double>(uv.back()) == 1 - v[7])
        ++rounded_uv_;
    }
    for (const auto& face : mesh.faces)
      for (const std::size_t corner : face) indices.push_back(static_cast<std::uint32_t>(corner));
    Primitive made{buffer_.add_vectors(positions, 3, true), buffer_.add_indices(indices)};
    if (set.has_normals) made.normals = buffer_.add_vectors(normals, 3, false);
    if (set.has_uv) made.uv = buffer_.add_vectors(uv, 2, false);
    made.material = set.material;
    return made;
  }

  /// Nodes: those of meshes, then those of groups, then the camera's and those of lights.
  void write_nodes(json::Writer& out) {
    const std::size_t first_group = nodes_.size();
    std::map<std::string_view, std::size_t> group_nodes;
    for (const std::string_view name : groups_.bottom_up()) group_nodes.emplace(name, first_group + group_nodes.size());
    std::map<std::string_view, std::vector<std::size_t>> children;
    for (std::size_t i = 0; i < nodes_.size(); ++i) children[nodes_[i].group].push_back(i);
    for (const auto& [name, number] : group_nodes) children[groups_.of_group(name)].push_back(number);
    std::vector<std::size_t> roots = children[""];
    const std::size_t first_of_stage = first_group + group_nodes.size();
    for (std::size_t i = 0; i < stage_nodes(); ++i) roots.push_back(first_of_stage + i);
    const auto write_list = [&](std::string_view key, const std::vector<std::size_t>& numbers) {
      if (numbers.empty()) return;
      out.key(key).begin_array();
      for (const std::size_t number : numbers) out.value(whole(number));
      out.end_array();
    };
    out.new_line().key("scenes").begin_array().begin_object();
    write_list("nodes", roots);
    out.end_object().end_array();
    if (first_of_stage + stage_nodes() == 0) return;
    out.new_line().key("nodes").begin_array();
    for (std::size_t i = 0; i < nodes_.size(); ++i) out.new_line().begin_object().member("mesh", whole(i)).end_object();
    for (const std::string_view name : groups_.bottom_up()) {
      out.new_line().begin_object().member("name", name);
      write_list("children", children[name]);
      out.end_object();
    }
    write_stage_nodes(out);
    out.end_array();
  }

  std::size_t stage_nodes() const {
    const scene::Stage& stage = scene_.stage();
    return stage.camera.has_value() + stage.lights.size() + stage.directional_lights.size();
  }
  void write_stage_nodes(json::Writer& out) {
    const scene::Stage& stage = scene_.stage();
    if (stage.camera) write_camera_node(out, *stage.camera);
    std::size_t number = 0;
    const auto write_light = [&](const glm::dvec3* at, const glm::dvec3* way) {
      out.new_line().begin_object();
      if (at != nullptr) out.member("translation", *at);
      if (way != nullptr) write_numbers(out, "rotation", turn_of_light(*way));
      out.key("extensions").begin_object().key("KHR_lights_punctual").begin_object().member("light", whole(number++));
      out.end_object().end_object().end_object();
    };
    for (const scene::Light& light : stage.lights) {
      const glm::dvec3 way = light.cone ? light.cone->towards - light.position : glm::dvec3(0);
      write_light(&light.position, light.cone ? &way : nullptr);
    }
    for (const scene::DirectionalLight& light : stage.directional_lights) write_light(nullptr, &light.direction);
  }
  /// The quaternion that brings −z, along which a light shines, into its way.
  static std::array<double, 4> turn_of_light(const glm::dvec3& way) {
    const double greatest = std::max({std::abs(way.x), std::abs(way.y), std::abs(way.z)});
    const TurnedAxis turn = turned_axis(-way / greatest);
    const double half = glm::radians(turn.degrees) / 2;
    return {turn.axis.x * std::sin(half), turn.axis.y * std::sin(half), 0, std::cos(half)};
  }
  /// A camera looks along −z, and +y points upwards.
  static void write_camera_node(json::Writer& out, const scene::Camera& camera) {
    const glm::dvec3 ahead = glm::normalize(camera.look_at - camera.eye),
                     right = glm::normalize(glm::cross(ahead, camera.up)), up = glm::cross(right, ahead);
    out.new_line().begin_object().member("camera", whole(0));
    write_numbers(out, "matrix",
                  std::array<double, 16>{right.x, right.y, right.z, 0, up.x, up.y, up.z, 0, -ahead.x, -ahead.y,
                                         -ahead.z, 0, camera.eye.x, camera.eye.y, camera.eye.z, 1});
    out.end_object();
  }

  void write_meshes(json::Writer& out) {
    if (nodes_.empty()) return;
    out.new_line().key("meshes").begin_array();
    for (const WrittenNode& node : nodes_) {
      out.new_line().begin_object();
      if (node.group.empty() && !node.mesh.empty()) out.member("name", name_of_mesh(node.mesh));
      out.key("primitives").begin_array();
      for (const Primitive& one : node.primitives) write_primitive(out, one);
      out.end_array().end_object();
    }
    out.end_array();
  }
  /// A name that no group has: else the triangles would be in that group.
  std::string name_of_mesh(std::string_view mesh) const {
    std::string name(mesh);
    while (groups_.table().contains(name)) name += '_';
    return name;
  }
  static void write_primitive(json::Writer& out, const Primitive& one) {
    out.begin_object().key("attributes").begin_object().member("POSITION", whole(one.positions));
    if (one.normals) out.member("NORMAL", whole(*one.normals));
    if (one.uv) out.member("TEXCOORD_0", whole(*one.uv));
    out.end_object().member("indices", whole(one.indices));
    if (one.material) out.member("material", whole(*one.material));
    out.end_object();
  }

  void write_materials(json::Writer& out) {
    const auto& materials = scene_.stage().materials;
    if (materials.empty()) return;
    out.new_line().key("materials").begin_array();
    for (const scene::Material& material : materials) write_material(out, material);
    out.end_array();
  }
  void write_material(json::Writer& out, const scene::Material& material) {
    const SimpleLook look = simple_look(material);
    const bool is_mirror = look.kind == SimpleKind::mirror, is_glass = look.kind == SimpleKind::glass;
    if (!is_look(look, material) || (is_glass && look.index < 1)) ++other_looks_;
    out.new_line().begin_object().member("name", material.name).key("pbrMetallicRoughness").begin_object();
    write_numbers(out, "baseColorFactor", std::array{look.color.x, look.color.y, look.color.z, 1.0});
    out.member("metallicFactor", is_mirror ? 1.0 : 0.0).member("roughnessFactor", is_mirror || is_glass ? 0.0 : 1.0);
    out.end_object();
    const auto [shown, strength] = bright(material.emission);
    const double beyond = std::max(strength, 1.0);
    if (strength > 0) out.member("emissiveFactor", beyond > 1 ? shown : material.emission);
    out.member("doubleSided", true);
    if (is_glass || beyond > 1) {
      out.key("extensions").begin_object();
      if (is_glass) {
        out.key("KHR_materials_transmission").begin_object().member("transmissionFactor", 1.0).end_object();
        out.key("KHR_materials_ior").begin_object().member("ior", std::max(look.index, 1.0)).end_object();
        uses_glass_ = true;
      }
      if (beyond > 1) {
        out.key("KHR_materials_emissive_strength").begin_object().member("emissiveStrength", beyond).end_object();
        uses_strength_ = true;
      }
      out.end_object();
    }
    out.end_object();
  }

  void write_stage(json::Writer& out) {
    const scene::Stage& stage = scene_.stage();
    if (stage.camera) {
      const scene::Resolution size = stage.resolution.value_or(scene::default_resolution);
      out.new_line().key("cameras").begin_array().begin_object().member("type", "perspective").key("perspective");
      out.begin_object().member("yfov", glm::radians(stage.camera->fov_y));
      out.member("aspectRatio", static_cast<double>(size.width) / size.height);
      out.member("znear", glm::length(stage.camera->look_at - stage.camera->eye) * nearest_share);
      out.end_object().end_object().end_array();
    }
    if (!stage.lights.empty() || !stage.directional_lights.empty()) write_lights(out);
    write_extensions(out);
  }
  /// Programs with depth buffers cut away all that is nearer to the camera, as a share of its distance to look_at.
  static constexpr double nearest_share = 0x1p-10;

  void write_lights(json::Writer& out) {
    const scene::Stage& stage = scene_.stage();
    out.new_line()
        .key("extensions")
        .begin_object()
        .key("KHR_lights_punctual")
        .begin_object()
        .key("lights")
        .begin_array();
    const auto begin = [&](std::string_view type, const glm::dvec3& told) {
      const auto [color, intensity] = bright(told);
      out.new_line().begin_object().member("type", type).member("color", color).member("intensity", intensity);
    };
    for (const scene::Light& light : stage.lights) {
      begin(light.cone ? "spot" : "point", light.color);
      if (light.cone) {
        if (light.cone->tightness != 0) ++tight_;
        const double outer = glm::radians(light.cone->outer), inner = glm::radians(light.cone->inner);
        out.key("spot").begin_object().member("innerConeAngle", inner < outer ? inner : std::nextafter(outer, 0.0));
        out.member("outerConeAngle", outer).end_object();
      }
      out.end_object();
    }
    for (const scene::DirectionalLight& light : stage.directional_lights) {
      begin("directional", light.color);
      out.end_object();
    }
    out.end_array().end_object().end_object();
    uses_lights_ = true;
  }

  void write_extensions(json::Writer& out) const {
    if (!uses_lights_ && !uses_glass_ && !uses_strength_) return;
    out.new_line().key("extensionsUsed").begin_array();
    if (uses_lights_) out.value("KHR_lights_punctual");
    if (uses_glass_) out.value("KHR_materials_transmission").value("KHR_materials_ior");
    if (uses_strength_) out.value("KHR_materials_emissive_strength");
    out.end_array();
  }

  void name_losses() {
    const scene::Stage& stage = scene_.stage();
    left_out_.name_losses(out_.lost, "glTF");
    add_loss(out_.lost, beyond_, "triangle", "triangles", "left out: a coordinate is beyond binary32");
    add_loss(out_.lost, rounded_, "coordinate", "coordinates", "rounded: glTF has binary32");
    add_loss(out_.lost, rounded_uv_, "coordinate of uv", "coordinates of uv", "rounded: glTF has binary32");
    add_wrap_losses(out_.lost, scene_, "glTF", true);
    const std::size_t triangles = scene_.singles<scene::Triangle>().size();
    add_loss(out_.lost, triangles, "name of an element", "names of elements", "left out: glTF has none of triangles");
    add_loss(out_.lost, other_looks_, "material", "materials",
             "written otherwise: of one colour, a mirror or glass, by the greatest share");
    add_loss(out_.lost, stage.lights.size(), "light", "lights", "fading with the distance, as those of glTF do");
    add_loss(out_.lost, tight_, "tightness of a light", "tightnesses of lights", "left out: not written to glTF");
    add_extent_losses(out_.lost, scene_, "glTF");
    add_loss(out_.lost, stage.camera && stage.camera->mirrored, "mirrored camera", "mirrored cameras",
             "written unmirrored: glTF has none");
    add_loss(out_.lost, stage.camera && stage.camera->aperture > 0, "lens", "lenses", "left out: not written to glTF");
    add_loss(out_.lost, stage.background.has_value(), "background", "backgrounds", "left out: not written to glTF");
    add_loss(out_.lost, stage.camera && stage.resolution, "resolution", "resolutions",
             "written as the form of the picture alone");
    add_stage_losses(out_.lost, scene_, "glTF");
    add_motion_losses(out_.lost, scene_, "glTF");
  }

  const scene::Scene& scene_;
  const scene::Groups& groups_;
  Exported out_;
  GltfBuffer buffer_;
  std::vector<WrittenNode> nodes_;  // of meshes, each of which is the mesh of its number
  LeftOutElements left_out_;
  bool uses_lights_ = false, uses_glass_ = false, uses_strength_ = false;
  std::size_t beyond_ = 0, rounded_ = 0, rounded_uv_ = 0, other_looks_ = 0, tight_ = 0;
};

void append_chunk(std::string& out, std::string_view type, std::string bytes, char filler) {
  while (bytes.size() % 4 != 0) bytes += filler;
  append_little_endian(out, bytes.size(), 4);
  out += type;
  out += bytes;
}

}  // namespace

Exported gltf_text(const scene::Scene& scene, const scene::Groups& groups) {
  return GltfWriter(scene, groups).write([](json::Writer& out, const std::string& bytes) {
    out.member("uri", "data:application/octet-stream;base64," + base64_text(bytes));
  });
}

Exported gltf_bytes(const scene::Scene& scene, const scene::Groups& groups) {
  GltfWriter writer(scene, groups);
  Exported out = writer.write([](json::Writer&, const std::string&) {});
  std::string chunks;
  append_chunk(chunks, "JSON", out.text, ' ');
  if (!writer.bytes().empty()) append_chunk(chunks, std::string_view("BIN\0", 4), writer.bytes(), '\0');
  out.text = "glTF";
  append_little_endian(out.text, 2, 4);
  append_little_endian(out.text, 12 + chunks.size(), 4);
  out.text += chunks;
  return out;
}

}  // namespace durero::io
