#include <fmt/format.h>

#include <array>
#include <bit>

#include "durero/io/mesh/ply.hpp"
#include "io/byte_order.hpp"
#include "io/losses.hpp"
#include "ply_mesh.hpp"
#include "written_triangles.hpp"

namespace durero::io {
namespace {

/// The triangles of a scene, as PLY has them.
struct WrittenMesh {
  IndexedMesh mesh;
  std::size_t smooth = 0;    ///< triangles with normals
  bool has_normals = false;  ///< whether all are smooth
};

WrittenMesh written_mesh(const scene::Scene& scene) {
  std::vector<scene::ElementRef> triangles;
  std::size_t smooth = 0;
  for (const GroupedElement& triangle : triangles_by_group(scene, {})) {
    triangles.push_back(triangle.element);
    smooth += scene.vertex_normals(triangle.element).has_value();
  }
  const bool has_normals = smooth == triangles.size() && smooth > 0;
  return {indexed_mesh(scene, triangles, has_normals, false), smooth, has_normals};
}

std::string header_of(const IndexedMesh& mesh, bool with_normals, std::string_view format) {
  std::string text = fmt::format("ply\nformat {} 1.0\nelement vertex {}\n", format, mesh.vertices.size());
  for (const std::string_view name : {"x", "y", "z", "nx", "ny", "nz"})
    if (with_normals || name.size() == 1) text += fmt::format("property double {}\n", name);
  return text + fmt::format("element face {}\nproperty list uchar int vertex_indices\nend_header\n", mesh.faces.size());
}

std::string text_of(const WrittenMesh& written) {
  std::string text = header_of(written.mesh, written.has_normals, "ascii");
  for (const auto& [x, y, z, nx, ny, nz, u, v] : written.mesh.vertices) {
    text += fmt::format("{} {} {}", x, y, z);
    text += written.has_normals ? fmt::format(" {} {} {}\n", nx, ny, nz) : "\n";
  }
  for (const auto& [a, b, c] : written.mesh.faces) text += fmt::format("3 {} {} {}\n", a, b, c);
  return text;
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

std::string ply_mesh_bytes(const IndexedMesh& mesh, bool with_normals) {
  std::string bytes = header_of(mesh, with_normals, "binary_little_endian");
  for (const auto& vertex : mesh.vertices)
    for (std::size_t i = 0; i < (with_normals ? 6 : 3); ++i)
      append_little_endian(bytes, std::bit_cast<std::uint64_t>(vertex[i]), 8);
  for (const auto& face : mesh.faces) {
    append_little_endian(bytes, face.size(), 1);
    for (const std::size_t vertex : face) append_little_endian(bytes, vertex, 4);
  }
  return bytes;
}

Exported ply_text(const scene::Scene& scene, const scene::Groups& groups) {
  const WrittenMesh mesh = written_mesh(scene);
  return {text_of(mesh), losses_of(mesh, scene, groups)};
}

Exported ply_bytes(const scene::Scene& scene, const scene::Groups& groups) {
  const WrittenMesh mesh = written_mesh(scene);
  return {ply_mesh_bytes(mesh.mesh, mesh.has_normals), losses_of(mesh, scene, groups)};
}

}  // namespace durero::io
