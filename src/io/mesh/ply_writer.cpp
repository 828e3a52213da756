#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>

#include "durero/io/mesh/ply.hpp"
#include "io/byte_order.hpp"
#include "io/losses.hpp"
#include "numbering.hpp"
#include "written_triangles.hpp"

namespace durero::io {
namespace {

/// The vertices of a scene's triangles, each once, with its normal; and which of them each triangle has.
struct WrittenMesh {
  std::vector<std::array<double, 6>> vertices;
  std::vector<std::array<std::size_t, 3>> faces;
  std::size_t smooth = 0;    ///< triangles with normals
  bool has_normals = false;  ///< whether all are smooth; the normals of vertices are 0 otherwise
};

WrittenMesh written_mesh(const scene::Scene& scene) {
  const std::vector<GroupedElement> triangles = triangles_by_group(scene, {});
  WrittenMesh mesh;
  mesh.smooth = static_cast<std::size_t>(std::ranges::count_if(
      triangles, [&](const GroupedElement& triangle) { return scene.vertex_normals(triangle.element).has_value(); }));
  mesh.has_normals = mesh.smooth == triangles.size() && mesh.smooth > 0;
  Numbering<std::array<double, 6>> numbers;
  for (const GroupedElement& triangle : triangles) {
    const auto corners = scene.shapes<scene::Triangle>()[triangle.element.index].vertices;
    const auto normals = scene.vertex_normals(triangle.element);
    std::array<std::size_t, 3>& face = mesh.faces.emplace_back();
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const glm::dvec3 &p = corners[i], n = mesh.has_normals ? (*normals)[i] : glm::dvec3(0);
      const std::array<double, 6> vertex{p.x, p.y, p.z, n.x, n.y, n.z};
      const auto [number, is_new] = numbers.number(vertex);
      face[i] = number;
      if (is_new) mesh.vertices.push_back(vertex);
    }
  }
  return mesh;
}

std::string header_of(const WrittenMesh& mesh, std::string_view format) {
  std::string text = fmt::format("ply\nformat {} 1.0\nelement vertex {}\n", format, mesh.vertices.size());
  for (const std::string_view name : {"x", "y", "z", "nx", "ny", "nz"})
    if (mesh.has_normals || name.size() == 1) text += fmt::format("property double {}\n", name);
  return text + fmt::format("element face {}\nproperty list uchar int vertex_indices\nend_header\n", mesh.faces.size());
}

std::string text_of(const WrittenMesh& mesh) {
  std::string text = header_of(mesh, "ascii");
  for (const auto& [x, y, z, nx, ny, nz] : mesh.vertices) {
    text += fmt::format("{} {} {}", x, y, z);
    text += mesh.has_normals ? fmt::format(" {} {} {}\n", nx, ny, nz) : "\n";
  }
  for (const auto& [a, b, c] : mesh.faces) text += fmt::format("3 {} {} {}\n", a, b, c);
  return text;
}

std::string bytes_of(const WrittenMesh& mesh) {
  std::string bytes = header_of(mesh, "binary_little_endian");
  for (const auto& vertex : mesh.vertices)
    for (std::size_t i = 0; i < (mesh.has_normals ? 6 : 3); ++i)
      append_little_endian(bytes, std::bit_cast<std::uint64_t>(vertex[i]), 8);
  for (const auto& face : mesh.faces) {
    append_little_endian(bytes, face.size(), 1);
    for (const std::size_t vertex : face) append_little_endian(bytes, vertex, 4);
  }
  return bytes;
}

std::vector<std::string> losses_of(const WrittenMesh& mesh, const scene::Scene& scene, const scene::Groups& groups) {
  std::vector<std::string> lost;
  if (!mesh.has_normals)
    add_loss(lost, mesh.smooth, "smooth triangle", "smooth triangles",
             "written flat: PLY has normals of all vertices, or of none");
  add_loss(lost, groups.table().size(), "group", "groups", "left out: PLY has none");
  add_mesh_losses(lost, scene, "PLY");
  return lost;
}

}  // namespace

Exported ply_text(const scene::Scene& scene, const scene::Groups& groups) {
  const WrittenMesh mesh = written_mesh(scene);
  return {text_of(mesh), losses_of(mesh, scene, groups)};
}

Exported ply_bytes(const scene::Scene& scene, const scene::Groups& groups) {
  const WrittenMesh mesh = written_mesh(scene);
  return {bytes_of(mesh), losses_of(mesh, scene, groups)};
}

}  // namespace durero::io
