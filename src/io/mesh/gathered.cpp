#include "durero/io/mesh/gathered.hpp"

#include <fmt/format.h>

#include <array>
#include <map>
#include <stdexcept>
#include <string>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <vector>

#include "durero/model/operaciones.hpp"
#include "durero/scene/edit.hpp"
#include "durero/scene/mesh_edit.hpp"
#include "file_as_name.hpp"
#include "numbering.hpp"

namespace durero::io {
namespace {

/// The file's name as that of a mesh, with room for the numbers of faces.
std::string mesh_name(std::string_view file) {
  constexpr std::size_t longest = 128 - 16;
  const std::string name = file_as_name(file, longest);
  return name.empty() ? "mesh" : name;
}

/// Triangles of one mesh have these in common: the material, and whether there are uv and normals.
using Kind = std::tuple<std::uint32_t, bool, bool>;

/// A mesh while its faces come.
class MeshInMaking {
 public:
  explicit MeshInMaking(scene::Mesh mesh) : mesh_(std::move(mesh)) {}

  /// Adds a face, and answers its name.
  std::string add(const scene::Triangle& triangle, const std::optional<scene::Wrap>& wrap,
                  const std::optional<scene::VertexNormals>& normals) {
    std::array<model::Ordinal, 3> numbers{};
    for (std::size_t i = 0; i < 3; ++i)
      numbers[i] = number(triangle.vertices[i], wrap ? wrap->uv[i] : glm::dvec2(0),
                          normals ? (*normals)[i] : glm::dvec3(0), wrap.has_value(), normals.has_value());
    mesh_.caras.push_back({numbers[0], numbers[1], numbers[2]});
    return fmt::format("{}:{}", mesh_.m.name(), mesh_.caras.size() - 1);
  }

  scene::Mesh take() { return std::move(mesh_); }

 private:
  model::Ordinal number(const glm::dvec3& p, const glm::dvec2& uv, const glm::dvec3& n, bool has_uv, bool has_normals) {
    const auto [number, is_new] = numbers_.number({p.x, p.y, p.z, uv.x, uv.y, n.x, n.y, n.z});
    if (is_new) {
      mesh_.puntos.push_back(p);
      if (has_uv) mesh_.uv.push_back(uv);
      if (has_normals) mesh_.normals.push_back(n);
    }
    return static_cast<model::Ordinal>(number);
  }

  scene::Mesh mesh_;
  Numbering<std::array<double, 8>> numbers_;
};

/// The meshes of a scene, and the faces that its triangles become.
class Gathering {
 public:
  Gathering(const scene::Scene& scene, std::string name) : scene_(scene), name_(std::move(name)) {
    const auto triangles = scene.singles<scene::Triangle>();
    for (std::uint32_t i = 0; i < triangles.size(); ++i) add({scene::Triangle::tipo, i}, triangles[i]);
  }

  /// From the names of the triangles to those of their faces.
  const std::unordered_map<std::string, std::string>& faces() const { return faces_; }
  std::vector<MeshInMaking>& meshes() { return meshes_; }

 private:
  void add(scene::ElementRef e, const scene::Triangle& triangle) {
    const auto wrap = scene_.wrap(e);
    if (scene_.motion(e) != nullptr || (wrap && wrap->tangents)) return;
    const auto normals = scene_.vertex_normals(e);
    const std::uint32_t material = scene_.material(e).value_or(scene::no_material);
    const auto [at, is_new] =
        places_.try_emplace(Kind(material, wrap.has_value(), normals.has_value()), meshes_.size());
    if (is_new) {
      scene::Mesh mesh{model::Elemento(meshes_.empty() ? name_ : fmt::format("{}.{}", name_, meshes_.size() + 1))};
      mesh.material = material;
      meshes_.emplace_back(std::move(mesh));
    }
    faces_.emplace(scene_.name(e).name(), meshes_[at->second].add(triangle, wrap, normals));
  }

  const scene::Scene& scene_;
  std::string name_;
  std::map<Kind, std::size_t> places_;
  std::vector<MeshInMaking> meshes_;
  std::unordered_map<std::string, std::string> faces_;
};

/// Groups with the same structure, whose members have other names.
scene::Groups renamed(const scene::Groups& groups, const std::unordered_map<std::string, std::string>& names,
                      const scene::Scene& scene) {
  scene::Groups made;
  for (const std::string_view name : groups.bottom_up()) {
    const scene::Group& group = groups.table().find(name)->second;
    scene::Grouping grouping{std::string(name), {{}, group.groups}};
    for (const std::string& member : group.elementos) {
      const auto face = names.find(member);
      grouping.of.elementos.insert(face == names.end() ? member : face->second);
    }
    made.apply_total(scene::GroupEdit(std::move(grouping)), scene);
  }
  return made;
}

}  // namespace

Imported gathered(Imported from, std::string_view file) {
  scene::Scene& scene = from.scene;
  scene.put_off_audits();
  Gathering gathering(scene, mesh_name(file));
  for (const auto& [name, face] : gathering.faces())
    scene.apply_total(model::Operation(model::Eliminar_Triangulo{model::Elemento(name)}));
  for (MeshInMaking& made : gathering.meshes()) {
    const model::Answer answer = scene.apply_total(scene::MeshEdit(scene::MeshAddition{made.take()}));
    if (!answer.ok())
      throw std::invalid_argument(fmt::format("a face would have the name of another element: {}; expected other names",
                                              model::name(answer.r)));
  }
  scene.audit();
  from.groups = renamed(from.groups, gathering.faces(), scene);
  return from;
}

}  // namespace durero::io
