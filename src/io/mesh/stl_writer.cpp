#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>

#include "durero/io/mesh/stl.hpp"
#include "io/byte_order.hpp"
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

/// Whether each coordinate rounds to a finite binary32: those from half a step beyond the greatest on do not.
bool is_within_binary32(const glm::dvec3& x) {
  return std::max({std::abs(x.x), std::abs(x.y), std::abs(x.z)}) < 0x1.ffffffp127;
}

/// Appends the nearest binary32 of each coordinate; how many are another number.
std::size_t append_triple(std::string& out, const glm::dvec3& x) {
  std::size_t rounded = 0;
  for (int i = 0; i < 3; ++i) {
    const auto nearest = static_cast<float>(x[i]);
    append_little_endian(out, std::bit_cast<std::uint32_t>(nearest), 4);
    rounded += static_cast<double>(nearest) != x[i];
  }
  return rounded;
}

}  // namespace

Exported stl_text(const scene::Scene& scene, const scene::Groups& groups) {
  Exported out;
  const std::vector<GroupedElement> triangles = triangles_by_group(scene, groups);
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const auto& [element, group, name] = triangles[i];
    if (i == 0 || triangles[i - 1].group != group) out.text += solid_line("solid", group);
    const scene::Triangle triangle = scene.shapes<scene::Triangle>()[element.index];
    out.text += fmt::format("facet normal {}\nouter loop\n", triple_text(facet_normal(triangle)));
    for (const glm::dvec3& vertex : triangle.vertices) out.text += fmt::format("vertex {}\n", triple_text(vertex));
    out.text += "endloop\nendfacet\n";
    if (i + 1 == triangles.size() || triangles[i + 1].group != group) out.text += solid_line("endsolid", group);
  }
  if (triangles.empty()) out.text = "solid\nendsolid\n";
  add_nesting_loss(out.lost, groups, "a solid of STL");
  add_smoothness_loss(out.lost, scene, "STL has no normals of vertices");
  add_mesh_losses(out.lost, scene, "STL");
  return out;
}

Exported stl_bytes(const scene::Scene& scene, const scene::Groups& groups) {
  Exported out;
  std::string facets;
  std::size_t count = 0, rounded = 0, beyond = 0;
  for (const GroupedElement& triangle : triangles_by_group(scene, {})) {
    const scene::Triangle& shape = scene.shapes<scene::Triangle>()[triangle.element.index];
    if (!std::ranges::all_of(shape.vertices, is_within_binary32)) {
      ++beyond;
      continue;
    }
    ++count;
    append_triple(facets, facet_normal(shape));
    for (const glm::dvec3& vertex : shape.vertices) rounded += append_triple(facets, vertex);
    append_little_endian(facets, 0, 2);  // the attribute
  }
  out.text = fmt::format("{:80}", "binary STL");
  append_little_endian(out.text, count, 4);
  out.text += facets;
  add_loss(out.lost, beyond, "triangle", "triangles", "left out: a coordinate is beyond binary32");
  add_loss(out.lost, rounded, "coordinate", "coordinates", "rounded: binary STL has binary32");
  add_loss(out.lost, groups.table().size(), "group", "groups", "left out: binary STL has none");
  add_smoothness_loss(out.lost, scene, "STL has no normals of vertices");
  add_mesh_losses(out.lost, scene, "STL");
  return out;
}

}  // namespace durero::io
