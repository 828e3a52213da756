#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "durero/io/mesh/ply.hpp"
#include "io/losses.hpp"
#include "numbering.hpp"
#include "written_triangles.hpp"

namespace durero::io {

Exported ply_text(const scene::Scene& scene, const scene::Groups& groups) {
  const std::vector<WrittenTriangle> triangles = written_triangles(scene, {});
  const auto smooth = static_cast<std::size_t>(std::ranges::count_if(
      triangles, [&](const WrittenTriangle& triangle) { return scene.vertex_normals(triangle.element).has_value(); }));
  const bool has_normals = smooth == triangles.size() && smooth > 0;
  Numbering<std::array<double, 6>> numbers;
  std::string vertices, faces;
  std::size_t count = 0;
  for (const WrittenTriangle& triangle : triangles) {
    faces += '3';
    const auto corners = scene.shapes<scene::Triangle>()[triangle.element.index].vertices;
    const auto normals = scene.vertex_normals(triangle.element);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const glm::dvec3 &p = corners[i], n = has_normals ? (*normals)[i] : glm::dvec3(0);
      const auto [number, is_new] = numbers.number({p.x, p.y, p.z, n.x, n.y, n.z});
      faces += fmt::format(" {}", number);
      if (!is_new) continue;
      ++count;
      vertices += fmt::format("{} {} {}", p.x, p.y, p.z);
      vertices += has_normals ? fmt::format(" {} {} {}\n", n.x, n.y, n.z) : "\n";
    }
    faces += '\n';
  }
  Exported out;
  out.text = fmt::format("ply\nformat ascii 1.0\nelement vertex {}\n", count);
  for (const std::string_view name : {"x", "y", "z", "nx", "ny", "nz"})
    if (has_normals || name.size() == 1) out.text += fmt::format("property double {}\n", name);
  out.text += fmt::format("element face {}\nproperty list uchar int vertex_indices\nend_header\n", triangles.size());
  out.text += vertices + faces;
  if (!has_normals)
    add_loss(out.lost, smooth, "smooth triangle", "smooth triangles",
             "written flat: PLY has normals of all vertices, or of none");
  add_loss(out.lost, groups.table().size(), "group", "groups", "left out: PLY has none");
  add_mesh_losses(out.lost, scene, "PLY");
  return out;
}

}  // namespace durero::io
