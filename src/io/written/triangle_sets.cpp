#include "triangle_sets.hpp"

#include <map>
#include <tuple>

#include "by_group.hpp"
#include "io/mesh/numbering.hpp"

namespace durero::io {

std::vector<TriangleSet> triangle_sets(const scene::Scene& scene, const scene::Groups& groups) {
  std::vector<TriangleSet> sets;
  using Key = std::tuple<std::string_view, std::string_view, std::optional<std::uint32_t>, bool, bool>;
  std::map<Key, std::size_t> known;
  for (const GroupedElement& one : triangles_by_group(scene, groups)) {
    const auto face = scene.face(one.element);
    const std::string_view mesh = face ? std::string_view(face->mesh.m.name()) : std::string_view();
    const auto material = scene.material(one.element);
    const bool has_normals = scene.vertex_normals(one.element).has_value(),
               has_uv = scene.wrap(one.element).has_value();
    const auto [place, is_new] = known.try_emplace(Key{one.group, mesh, material, has_normals, has_uv}, sets.size());
    if (is_new) sets.push_back({one.group, mesh, material, has_normals, has_uv});
    sets[place->second].triangles.push_back(one.element);
  }
  return sets;
}

IndexedMesh indexed_mesh(const scene::Scene& scene, std::span<const scene::ElementRef> triangles, bool with_normals,
                         bool with_uv) {
  IndexedMesh mesh;
  Numbering<std::array<double, 8>> numbers;
  for (const scene::ElementRef element : triangles) {
    const auto corners = scene.shapes<scene::Triangle>()[element.index].vertices;
    const auto normals = with_normals ? scene.vertex_normals(element) : std::nullopt;
    const auto wrap = with_uv ? scene.wrap(element) : std::nullopt;
    std::array<std::size_t, 3>& face = mesh.faces.emplace_back();
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const glm::dvec3 &p = corners[i], n = normals ? (*normals)[i] : glm::dvec3(0);
      const glm::dvec2 uv = wrap ? wrap->uv[i] : glm::dvec2(0);
      const std::array<double, 8> vertex{p.x, p.y, p.z, n.x, n.y, n.z, uv.x, uv.y};
      const auto [number, is_new] = numbers.number(vertex);
      face[i] = number;
      if (is_new) mesh.vertices.push_back(vertex);
    }
  }
  return mesh;
}

}  // namespace durero::io
