#include <fmt/format.h>

#include "durero/io/mesh/ply.hpp"
#include "durero/text/shown.hpp"
#include "io/losses.hpp"
#include "mesh_scene.hpp"
#include "ply_data.hpp"
#include "ply_header.hpp"

namespace durero::io {
namespace {

std::vector<std::string> losses_of(const PlyHeader& header) {
  std::vector<std::string> lost;
  for (const PlyElement& element : header.elements) {
    const bool is_vertex = &element == &header.elements[header.vertex],
               is_face = &element == &header.elements[header.face];
    if (!is_vertex && !is_face) {
      add_loss(lost, element.items, fmt::format("item of element {}", text::shown(element.name)),
               fmt::format("items of element {}", text::shown(element.name)), "left out: a scene has none");
      continue;
    }
    const std::size_t kept = is_face ? 1 : header.normals ? 6 : 3;
    add_loss(lost, element.properties.size() - kept, fmt::format("property of element {}", element.name),
             fmt::format("properties of element {}", element.name), "left out: a triangle has its vertices alone");
  }
  return lost;
}

}  // namespace

Imported read_ply(const Source& source) {
  const PlyHeader header = read_ply_header(source);
  return mesh_scene(source, read_ply_data(source, header), losses_of(header));
}

}  // namespace durero::io
