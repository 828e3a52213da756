#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <initializer_list>
#include <set>
#include <utility>

#include "durero/io/file_name.hpp"
#include "durero/io/mitsuba/mitsuba.hpp"
#include "durero/text/nearest.hpp"
#include "durero/text/shown.hpp"
#include "io/losses.hpp"
#include "io/placed/mesh_files.hpp"
#include "io/placed/placed_scene.hpp"
#include "mitsuba_look.hpp"
#include "mitsuba_stage.hpp"
#include "mitsuba_tree.hpp"

namespace durero::io {
namespace {

/// The properties of a shape that say where and what it is, by type; of an instance the shapes are its own.
struct ShapeType {
  std::string_view type;
  std::array<std::string_view, 4> properties{};
};
constexpr std::array<ShapeType, 9> shape_types{{{"sphere", {"center", "radius"}},
                                                {"cylinder", {"p0", "p1", "radius"}},
                                                {"disk"},
                                                {"rectangle"},
                                                {"cube"},
                                                {"obj", {"filename", "face_normals", "flip_tex_coords"}},
                                                {"ply", {"filename", "face_normals", "flip_tex_coords"}},
                                                {"shapegroup"},
                                                {"instance"}}};

/// Properties of all shapes that no picture here shows.
constexpr std::array<std::string_view, 2> unseen_properties{"flip_normals", "silhouette_sampling_weight"};
/// Tags of what a shape holds and a scene has none of.
constexpr std::array<std::string_view, 4> parts_left_out{"medium", "texture", "sensor", "volume"};

/// Instances of groups, of which none is in a group.
constexpr std::size_t deepest_reference = 16;

class MitsubaReader {
 public:
  explicit MitsubaReader(const Source& source)
      : tree_(read_mitsuba_tree(source)),
        looks_([this](const MitsubaNode& ref) -> const MitsubaNode& { return target(ref); }) {}

  Imported read() {
    for (const MitsubaNode& child : tree_.scene.children) number(child);
    scene::Group all;
    for (const MitsubaNode& child : tree_.scene.children) read_object(child, all);
    return made_.take(losses());
  }

 private:
  /// Remembers the elements that have an id.
  void number(const MitsubaNode& node) {
    const std::string_view id = node.value_of("id");
    if (!id.empty() && node.tag != "ref" && !ids_.try_emplace(std::string(id), &node).second)
      node.fail(fmt::format("a second id {}", text::shown(id)), "expected another", "id");
    for (const MitsubaNode& child : node.children) number(child);
  }

  /// The node that a ref names.
  const MitsubaNode& target(const MitsubaNode& ref) const {
    const MitsubaNode* node = &ref;
    for (std::size_t steps = 0; node->tag == "ref"; ++steps) {
      std::string_view id = node->required("id");
      const auto alias = tree_.aliases.find(id);
      if (alias != tree_.aliases.end()) id = alias->second;
      const auto found = ids_.find(id);
      if (found == ids_.end() || steps == deepest_reference)
        ref.fail(fmt::format("{} is the id of nothing", text::shown(id)), "expected the id of an element", "id");
      node = found->second;
    }
    return *node;
  }

  void read_object(const MitsubaNode& written, scene::Group& into) {
    const MitsubaNode& node = written.tag == "ref" ? target(written) : written;
    if (node.tag == "shape") {
      add_shape(node, into);
    } else if (node.tag == "sensor") {
      stage_.read_sensor(node);
    } else if (node.tag == "emitter") {
      stage_.read_emitter(node);
    } else if (node.tag != "bsdf" && node.tag != "texture") {  // these are of the shapes that name them
      ++others_[node.tag];
    }
  }

  /// Reads a shape, and adds it; a shapegroup is seen in its instances alone.
  void add_shape(const MitsubaNode& shape, scene::Group& into) {
    const std::string_view type = shape.required("type");
    if (type == "shapegroup") return check_properties(shape, {});
    if (type == "instance") return add_instance(shape, into);
    if (const auto thing = thing_of(shape)) put(shape, *thing, into);
  }

  void put(const MitsubaNode& shape, const PlacedThing& thing, scene::Group& into) {
    if (!made_.add(thing, into))
      shape.fail(fmt::format("more than {} elements", PlacedScene::most_elements),
                 "expected fewer, instances included");
  }

  /// The things of a group, which its instances share.
  const std::vector<PlacedThing>& group_of(const MitsubaNode& group) {
    const auto [known, is_new] = groups_.try_emplace(&group);
    if (!is_new) return known->second;
    std::vector<PlacedThing> things;
    for (const MitsubaNode& child : group.children) {
      if (child.tag != "shape" && child.tag != "ref") continue;
      const MitsubaNode& shape = child.tag == "ref" ? target(child) : child;
      if (shape.tag != "shape") continue;
      if (shape.type() == "shapegroup" || shape.type() == "instance")
        child.fail("an instance or a group in a shapegroup", "expected shapes, as Mitsuba does");
      if (auto thing = thing_of(shape)) things.push_back(std::move(*thing));
    }
    return known->second = std::move(things);
  }

  void add_instance(const MitsubaNode& instance, scene::Group& into) {
    const AffinePlacement by = placement_of(instance);
    check_properties(instance, {});
    const MitsubaNode* group = nullptr;
    for (const MitsubaNode& child : instance.children) {
      if (child.tag != "ref" && child.tag != "shape") continue;
      const MitsubaNode& node = child.tag == "ref" ? target(child) : child;
      if (node.tag == "shape" && node.type() == "shapegroup") group = &node;
    }
    if (group == nullptr) instance.fail("an instance of nothing", "expected a ref to a shapegroup");
    scene::Group own;
    for (PlacedThing thing : group_of(*group)) {
      thing.by = by.after(thing.by);
      put(instance, thing, own);
    }
    made_.add_instance(std::move(own), into);
  }

  /// A shape as it stands; nothing where a scene has none such.
  std::optional<PlacedThing> thing_of(const MitsubaNode& shape) {
    const std::string type(shape.required("type"));
    const auto* const known = std::ranges::find(shape_types, type, &ShapeType::type);
    if (known == shape_types.end()) {
      ++left_out_[type];
      return std::nullopt;
    }
    check_properties(shape, *known);
    PlacedThing thing{surface_of(shape), placement_of(shape)};
    thing.material = material_of(shape);
    return thing;
  }

  static const MitsubaNode* property(const MitsubaNode& node, std::string_view name) {
    for (const MitsubaNode& child : node.children)
      if (child.name() == name) return &child;
    return nullptr;
  }

  static double number_or(const MitsubaNode& node, std::string_view name, double usual) {
    const MitsubaNode* const told = property(node, name);
    return told == nullptr ? usual : mitsuba_number(*told);
  }
  static glm::dvec3 point_or(const MitsubaNode& node, std::string_view name, const glm::dvec3& usual) {
    const MitsubaNode* const told = property(node, name);
    return told == nullptr ? usual : mitsuba_triple(*told);
  }

  SimpleSurface surface_of(const MitsubaNode& shape) {
    const std::string_view type = shape.type();
    if (type == "sphere") return scene::Sphere{point_or(shape, "center", glm::dvec3(0)), number_or(shape, "radius", 1)};
    if (type == "cylinder")
      return OpenCylinder{{point_or(shape, "p0", glm::dvec3(0)), point_or(shape, "p1", {0, 0, 1})},
                          number_or(shape, "radius", 1)};
    if (type == "disk") return scene::Disc{glm::dvec3(0), 1, {0, 0, 1}};
    if (type == "cube") return AxisBox{{glm::dvec3(-1), glm::dvec3(1)}};
    if (type == "rectangle") return rectangle_;
    return mesh_of(shape);
  }

  MeshTriangles mesh_of(const MitsubaNode& shape) {
    const MitsubaNode* const named = property(shape, "filename");
    if (named == nullptr) shape.fail(fmt::format("{} without filename", shape.type()), "expected the name of a file");
    const std::string_view name = named->required("value");
    const auto path = tree_.folder.find(*named->file, name);
    if (!path) named->fail(fmt::format("no file {}", text::shown(name)), tree_.folder.expected(), "value");
    if (!ends_in(*path, fmt::format(".{}", shape.type())))
      named->fail(fmt::format("{} in {}", text::shown(name), shape.type()),
                  fmt::format("expected a name that ends in .{}", shape.type()), "value");
    const MitsubaNode* const flat = property(shape, "face_normals");
    return meshes_.read(*path, flat == nullptr || !mitsuba_boolean(*flat));
  }

  static AffinePlacement placement_of(const MitsubaNode& shape) {
    const MitsubaNode* const told = property(shape, "to_world");
    return told == nullptr ? AffinePlacement() : mitsuba_placement(*told);
  }

  /// Fails at a property that the shape has not: a slip would be another shape.
  void check_properties(const MitsubaNode& shape, const ShapeType& type) {
    static constexpr std::array<std::string_view, 6> values{"float", "integer", "string", "boolean", "point", "vector"};
    std::set<std::string_view> seen;
    for (const MitsubaNode& child : shape.children) {
      const std::string_view name = child.name();
      others_[child.tag] += std::ranges::count(parts_left_out, child.tag);
      const bool is_value = std::ranges::count(values, child.tag) > 0;
      if (!is_value && child.tag != "transform") continue;
      if (!seen.insert(name).second) child.fail(fmt::format("a second {}", text::shown(name)), "expected one", "name");
      if (child.tag == "transform" ? name == "to_world" : std::ranges::count(type.properties, name) > 0) continue;
      if (std::ranges::count(unseen_properties, name) > 0) {
        ++unseen_;
        continue;
      }
      std::vector<std::string> known(unseen_properties.begin(), unseen_properties.end());
      if (!is_value) known = {"to_world"};
      for (const std::string_view one : type.properties)
        if (!one.empty() && is_value) known.emplace_back(one);
      child.fail(fmt::format("{} in {}", text::shown(child.value_of("name")), shape.type()),
                 "expected " + text::expected_of(std::string(name), known), "name");
    }
  }

  /// The look of a shape, and what it shines where an area emitter is on it.
  std::uint32_t material_of(const MitsubaNode& shape) {
    const MitsubaNode *bsdf = nullptr, *emitter = nullptr;
    for (const MitsubaNode& child : shape.children) {
      const MitsubaNode& node = child.tag == "ref" ? target(child) : child;
      if (node.tag == "bsdf") bsdf = &node;
      if (node.tag == "emitter") emitter = &node;
      others_[node.tag] += child.tag == "ref" && node.tag != "bsdf" && node.tag != "emitter";
    }
    scene::Material look = bsdf == nullptr ? looks_.usual() : looks_.material(*bsdf);
    if (emitter != nullptr) {
      look.emission = looks_.light(*emitter, "radiance", 1);
      ++emitters_;
    }
    return made_.material(std::move(look));
  }

  std::vector<std::string> losses() const {
    std::vector<std::string> lost;
    stage_.name_losses(lost);
    looks_.name_losses(lost);
    meshes_.name_losses(lost);
    for (const auto& [type, count] : left_out_)
      add_loss(lost, count, fmt::format("shape {}", text::shown(type)), fmt::format("shapes {}", text::shown(type)),
               "left out: a scene has none");
    for (const auto& [tag, count] : others_) add_loss(lost, count, tag, tag, "left out: a scene has none");
    add_loss(lost, emitters_, "surface", "surfaces", "with a light: it shines on both of its sides");
    add_loss(lost, unseen_, "property of a shape", "properties of shapes", "left out: no picture shows it");
    add_loss(lost, tree_.outer_paths, "path", "paths", "out of the scene's folder: nothing is read there");
    return lost;
  }

  MitsubaTree tree_;
  PlacedScene made_;
  MitsubaLooks looks_;
  MitsubaStage stage_{made_.stage(), looks_};
  MeshFiles meshes_;
  std::map<std::string, const MitsubaNode*, std::less<>> ids_;
  std::map<const MitsubaNode*, std::vector<PlacedThing>> groups_;
  std::map<std::string, std::size_t> left_out_, others_;  // shapes by type, and other elements by tag
  std::size_t emitters_ = 0, unseen_ = 0;
  /// The square from −1 to 1 in the plane of x and y.
  MeshTriangles rectangle_ = std::make_shared<const std::vector<MeshTriangle>>(
      std::vector<MeshTriangle>{{scene::Triangle{{{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}}}}},
                                {scene::Triangle{{{{-1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}}}}});
};

}  // namespace

Imported read_mitsuba(const Source& source) { return MitsubaReader(source).read(); }

}  // namespace durero::io
