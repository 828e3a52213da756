#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>

#include "durero/io/mesh/obj.hpp"
#include "numbering.hpp"
#include "written_triangles.hpp"

namespace durero::io {
namespace {

using Pair = std::array<double, 2>;
using Triple = std::array<double, 3>;

Triple triple(const glm::dvec3& x) { return {x.x, x.y, x.z}; }

/// The number of a vector from 1, behind its line where it is new.
template <class Vector>
std::size_t written(std::string& text, std::string_view statement, Numbering<Vector>& numbers, const Vector& x) {
  const auto [number, is_new] = numbers.number(x);
  if (is_new) text += fmt::format("{} {}\n", statement, fmt::join(x, " "));
  return number + 1;
}

}  // namespace

Exported obj_text(const scene::Scene& scene, const scene::Groups& groups) {
  Exported out;
  std::string faces;
  Numbering<Triple> vertices, normals;
  Numbering<Pair> textures;
  std::string_view group;
  for (const GroupedElement& triangle : triangles_by_group(scene, groups)) {
    if (triangle.group != group) faces += fmt::format("g {}\n", group = triangle.group);
    faces += 'f';
    const auto corners = scene.shapes<scene::Triangle>()[triangle.element.index].vertices;
    const auto own = scene.vertex_normals(triangle.element);
    const auto wrap = scene.wrap(triangle.element);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      faces += fmt::format(" {}", written(out.text, "v", vertices, triple(corners[i])));
      if (wrap) faces += fmt::format("/{}", written(out.text, "vt", textures, Pair{wrap->uv[i].x, wrap->uv[i].y}));
      if (!own) continue;
      faces += fmt::format("{}/{}", wrap ? "" : "/", written(out.text, "vn", normals, triple((*own)[i])));
    }
    faces += '\n';
  }
  out.text += faces;
  add_nesting_loss(out.lost, groups, "a group of OBJ");
  add_mesh_losses(out.lost, scene, "OBJ", true);
  return out;
}

}  // namespace durero::io
