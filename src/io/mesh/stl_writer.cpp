#include <fmt/format.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "durero/io/mesh/stl.hpp"
#include "io/losses.hpp"
#include "written_triangles.hpp"

namespace durero::io {
namespace {

/// The unit normal of the plane, rounded, by the right-hand rule; null where it underflows or overflows.
glm::dvec3 facet_normal(const scene::Triangle& triangle) {
  const auto& [a, b, c] = triangle.vertices;
  const glm::dvec3 normal = glm::normalize(glm::cross(b - a, c - a));
  return std::isfinite(normal.x + normal.y + normal.z) ? normal + 0.0 : glm::dvec3(0);  // -0 becomes 0
}

std::string triple_text(const glm::dvec3& x) { return fmt::format("{} {} {}", x.x, x.y, x.z); }

std::string solid_line(std::string_view word, std::string_view name) {
  return name.empty() ? fmt::format("{}\n", word) : fmt::format("{} {}\n", word, name);
}

}  // namespace

Exported stl_text(const scene::Scene& scene, const scene::Groups& groups) {
  Exported out;
  const std::vector<WrittenTriangle> triangles = written_triangles(scene, groups);
  std::size_t smooth = 0;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const auto& [element, group, name] = triangles[i];
    if (i == 0 || triangles[i - 1].group != group) out.text += solid_line("solid", group);
    const scene::Triangle triangle = scene.shapes<scene::Triangle>()[element.index];
    out.text += fmt::format("facet normal {}\nouter loop\n", triple_text(facet_normal(triangle)));
    for (const glm::dvec3& vertex : triangle.vertices) out.text += fmt::format("vertex {}\n", triple_text(vertex));
    out.text += "endloop\nendfacet\n";
    if (i + 1 == triangles.size() || triangles[i + 1].group != group) out.text += solid_line("endsolid", group);
    smooth += scene.vertex_normals(element).has_value();
  }
  if (triangles.empty()) out.text = "solid\nendsolid\n";
  add_nesting_loss(out.lost, groups, "a solid of STL");
  add_loss(out.lost, smooth, "smooth triangle", "smooth triangles", "written flat: STL has no normals of vertices");
  add_mesh_losses(out.lost, scene, "STL");
  return out;
}

}  // namespace durero::io
