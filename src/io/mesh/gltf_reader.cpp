#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "durero/io/mesh/gltf.hpp"
#include "durero/text/shown.hpp"
#include "glb_chunks.hpp"
#include "gltf_node.hpp"
#include "gltf_triangles.hpp"
#include "io/losses.hpp"
#include "mesh_scene.hpp"

namespace durero::io {
namespace {

constexpr std::size_t deepest_node = 256;  // the numbers of a map grow with each node that it goes through
constexpr std::string_view quantization = "KHR_mesh_quantization";

/// Reads an array of names at the top of a file; of none where there is no such array. Each is passed to see(name, at).
template <class See>
void for_each_name(const GltfJson& file, std::string_view array, See&& see) {
  auto in = file.root().member(array);
  if (!in) return;
  in->array(array, [&] {
    const std::size_t at = in->offset();
    see(in->string(array), at);
  });
}

class GltfReader {
 public:
  GltfReader(const Source& source, const GltfJson& file, std::optional<std::string_view> bytes)
      : source_(source),
        file_(file),
        buffers_(source, file, bytes),
        triangles_(source, file, buffers_),
        has_node_(file.size(GltfArray::nodes)),
        has_mesh_(file.size(GltfArray::meshes)) {}

  Imported read() {
    for_each_name(file_, "extensionsRequired", [&](std::string_view name, std::size_t at) {
      if (name != quantization)
        source_.fail(at, fmt::format("the file needs the extension {}", text::shown(name)),
                     fmt::format("expected none but {}: neither compressed meshes nor others are read", quantization));
    });
    for (const GltfReference& root : roots()) show(root, {}, FaceGroups::none, 1);
    if (triangles_.soup().faces.empty()) source_.fail(source_.text().size(), "no mesh", "expected triangles");
    return mesh_scene(source_, triangles_.soup(), losses(), triangles_.groups(), triangles_.looks());
  }

 private:
  /// How many things there are that no scene keeps.
  struct Counts {
    std::size_t names = 0, mesh_names = 0, other_places = 0, skins = 0, cameras = 0;
    std::size_t without_triangles = 0, without_positions = 0, attributes = 0, materials = 0, targets = 0;
  };

  /// The nodes of the scene that is read: of the one that the file names, or of the first. In a file without a scene
  /// they are the nodes that are in no other.
  std::vector<GltfReference> roots() const {
    std::size_t scene = 0;
    if (auto in = file_.root().member("scene")) scene = file_.reference(*in, "scene", GltfArray::scenes).number;
    if (file_.size(GltfArray::scenes) == 0) return free_nodes();
    std::vector<GltfReference> roots;
    json::Reader in = file_.item(GltfArray::scenes, scene);
    read_known(in, "an item of scenes", [&](std::string_view key) {
      if (key != "nodes") return false;
      roots = read_references(file_, in, key, GltfArray::nodes);
      return true;
    });
    return roots;
  }

  std::vector<GltfReference> free_nodes() const {
    std::vector<bool> is_child(has_node_.size());
    for (std::size_t i = 0; i < has_node_.size(); ++i)
      for (const GltfReference& child : read_gltf_node(file_, i).children) is_child[child.number] = true;
    std::vector<GltfReference> free;
    for (std::size_t i = 0; i < has_node_.size(); ++i)
      if (!is_child[i]) free.push_back({i, file_.item(GltfArray::nodes, i).offset()});
    return free;
  }

  /// Adds what a node and those in it show.
  void show(const GltfReference& reference, const AffineMap& above, FaceGroups::Number group, std::size_t depth) {
    if (has_node_[reference.number])
      source_.fail(reference.at, fmt::format("node {} stands a second time in the scene", reference.number),
                   "expected it once: nodes are a forest");
    if (depth > deepest_node)
      source_.fail(reference.at, fmt::format("node {} is in {} others", reference.number, depth - 1),
                   fmt::format("expected {} at most", deepest_node - 1));
    has_node_[reference.number] = true;
    const GltfNode node = read_gltf_node(file_, reference.number);
    const AffineMap map = node.map ? above.after(*node.map) : above;
    counts_.skins += node.is_skinned;
    const auto own = group_of(node.name, group);
    if (node.mesh) {
      const auto normals = map.normals();
      show(*node.mesh,
           {reference.number, node.at, RoundedMap(map), normals ? std::optional<RoundedMap>(*normals) : std::nullopt,
            map.orientation() < 0, own.value_or(group)},
           own.has_value());
    }
    for (const GltfReference& child : node.children) show(child, map, own.value_or(group), depth + 1);
  }

  void show(const GltfReference& reference, GltfPlace place, bool has_name) {
    const GltfMesh mesh = read_gltf_mesh(file_, reference.number);
    if (has_name)
      counts_.mesh_names += !mesh.name.empty();
    else
      place.group = group_of(mesh.name, place.group).value_or(place.group);
    const bool is_first = !has_mesh_[reference.number];
    has_mesh_[reference.number] = true;
    for (const GltfPrimitive& primitive : mesh.primitives) {
      if (is_first) count(primitive);
      if (primitive.mode != GltfMode::none && primitive.positions) triangles_.add(primitive, place);
    }
  }

  void count(const GltfPrimitive& primitive) {
    counts_.without_triangles += primitive.mode == GltfMode::none;
    counts_.without_positions += primitive.mode != GltfMode::none && !primitive.positions;
    counts_.attributes += primitive.other_attributes;
    counts_.materials += primitive.has_material;
    counts_.targets += primitive.targets;
  }

  /// The group of that name, within the one of what is above; nothing where there is no name, or none that a group can
  /// have, which is counted. What has a name a second time is in the same group, and its own place is counted.
  std::optional<FaceGroups::Number> group_of(std::string_view name, FaceGroups::Number above) {
    if (!model::Elemento::is_name(std::string(name))) {
      counts_.names += !name.empty();
      return std::nullopt;
    }
    const FaceGroups::Number number = triangles_.groups().group(name, above);
    counts_.other_places += number != above && triangles_.groups().within[number] != above;
    return number;
  }

  /// How many of the things at hand have a mark of false.
  static std::size_t unseen(const std::vector<bool>& marks) {
    return static_cast<std::size_t>(std::ranges::count(marks, false));
  }

  std::vector<std::string> losses() const {
    std::vector<std::string> lost;
    const auto add = [&](std::size_t n, std::string_view one, std::string_view many, std::string_view why) {
      add_loss(lost, n, one, many, fmt::format("left out: {}", why));
    };
    const std::size_t scenes = file_.size(GltfArray::scenes);
    add(scenes - (scenes > 0), "scene", "scenes", "one of a file is read");
    add(unseen(has_node_), "node", "nodes", "the scene has none of them");
    add(unseen(has_mesh_), "mesh", "meshes", "no node of the scene shows it");
    add(counts_.without_triangles, "primitive of points or lines", "primitives of points or lines", "no triangles");
    add(counts_.without_positions, "primitive", "primitives", "without positions");
    add(counts_.attributes, "attribute of a primitive", "attributes of primitives",
        "a triangle has positions, normals and one uv");
    add(counts_.materials, "use of a material", "uses of materials", "a scene has none of this kind");
    add(counts_.targets, "morph target", "morph targets", "a triangle keeps its form");
    add(counts_.skins, "skin of a node", "skins of nodes", "a mesh stands as its node places it");
    add(file_.count("animations"), "animation", "animations", "nothing moves");
    add(file_.count("cameras"), "camera", "cameras", "a mesh has none");
    add(counts_.names, "name of a node or a mesh", "names of nodes or meshes",
        "expected 1 to 128 of A-Z a-z 0-9 _ . : -");
    add(counts_.mesh_names, "name of a mesh", "names of meshes", "the triangles are in the group of its node");
    add(counts_.other_places, "place of a node", "places of nodes", "another of the same name is elsewhere");
    std::vector<std::string> extensions;
    for_each_name(file_, "extensionsUsed", [&](std::string_view name, std::size_t) {
      if (name != quantization) extensions.push_back(text::shown(name));
    });
    add(extensions.size(), "extension", "extensions", fmt::format("{}", fmt::join(extensions, ", ")));
    return lost;
  }

  const Source& source_;
  const GltfJson& file_;
  GltfBuffers buffers_;
  GltfTriangles triangles_;
  std::vector<bool> has_node_, has_mesh_;  ///< whether the scene has it
  Counts counts_;
};

}  // namespace

Imported read_gltf(const Source& source) {
  const GltfParts parts = gltf_parts(source);
  const json::Document document(source, parts.json_begin, parts.json_end);
  const GltfJson file(document);
  return GltfReader(source, file, parts.bytes).read();
}

}  // namespace durero::io
