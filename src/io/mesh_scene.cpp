#include "mesh_scene.hpp"

#include <fmt/format.h>

#include "polygons.hpp"

namespace durero::io {
namespace {

/// How the names of elements begin: the file's name without folders. What may not stand in a name becomes `_`, and what
/// leaves no room for a number is cut off; a line says so.
std::string prefix_of(const Source& source, std::vector<std::string>& lost) {
  constexpr std::size_t longest = 128 - 11;  // without the colon and ten digits, of which a table's row has no more
  const std::string file = source.name().substr(source.name().rfind('/') + 1);
  std::string prefix = file.substr(0, longest);
  for (char& c : prefix)
    if (!model::Elemento::is_name(std::string(1, c))) c = '_';
  if (prefix != file) lost.push_back(fmt::format("elements are named {}: not every file's name can be theirs", prefix));
  return prefix + ":";
}

}  // namespace

Imported mesh_scene(const Source& source, const PolygonSoup& soup, std::vector<std::string> lost) {
  scene::Scene scene;
  scene.put_off_audits();
  Polygons polygons(scene, prefix_of(source, lost));
  std::vector<glm::dvec3> polygon;
  for (const Face& face : soup.faces) {
    polygon.clear();
    for (const std::int64_t vertex : face) polygon.push_back(soup.vertices[static_cast<std::size_t>(vertex)]);
    polygons.add(polygon);
  }
  scene.audit();
  polygons.name_losses(lost);
  return {std::move(scene), std::move(lost)};
}

}  // namespace durero::io
