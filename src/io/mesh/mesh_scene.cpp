#include "mesh_scene.hpp"

#include <fmt/format.h>

#include <ranges>

#include "file_as_name.hpp"
#include "io/losses.hpp"
#include "polygons.hpp"

namespace durero::io {
namespace {

/// How the names of elements begin: the file's name without folders. What may not stand in a name becomes `_`, and what
/// leaves no room for a number is cut off; a line says so.
std::string prefix_of(const Source& source, std::vector<std::string>& lost) {
  constexpr std::size_t longest = 128 - 11;  // without the colon and ten digits, of which a table's row has no more
  const std::string file = source.name().substr(source.name().rfind('/') + 1);
  const std::string prefix = file_as_name(file, longest);
  if (prefix != file) lost.push_back(fmt::format("elements are named {}: not every file's name can be theirs", prefix));
  return prefix + ":";
}

/// Of each group the names of its triangles. Those that were left out are in no scene.
class GroupMembers {
 public:
  GroupMembers(const FaceGroups& groups, const scene::Scene& scene)
      : groups_(groups), scene_(scene), elementos_(groups.numbers.size()) {}

  void add(std::size_t face, const Polygons& polygons, std::size_t before) {
    if (face >= groups_.of_face.size() || groups_.of_face[face] == FaceGroups::none) return;
    for (std::size_t number = before + 1; number <= polygons.number(); ++number)
      if (std::string name = polygons.name(number); scene_.find(name))
        elementos_[groups_.of_face[face]].insert(std::move(name));
  }

  /// Each triangle and each group is in one of them at most, each has its own name, and those within a group are made
  /// before it, so that none is refused.
  scene::Groups made(std::vector<std::string>& lost) {
    scene::Groups made;
    std::vector<scene::Names> inner(groups_.numbers.size());
    std::size_t empty = 0;
    for (const std::string& name : by_number() | std::views::reverse) {
      const FaceGroups::Number number = groups_.numbers.at(name), outer = groups_.within[number];
      if (elementos_[number].empty() && inner[number].empty()) {
        ++empty;
        continue;
      }
      made.apply_total(scene::Grouping{name, {std::move(elementos_[number]), std::move(inner[number])}}, scene_);
      if (outer != FaceGroups::none) inner[outer].insert(name);
    }
    add_loss(lost, empty, "group", "groups", "left out: no triangle is in it");
    return made;
  }

 private:
  std::vector<std::string> by_number() const {
    std::vector<std::string> names(groups_.numbers.size());
    for (const auto& [name, number] : groups_.numbers) names[number] = name;
    return names;
  }

  const FaceGroups& groups_;
  const scene::Scene& scene_;
  std::vector<scene::Names> elementos_;
};

}  // namespace

Imported mesh_scene(const Source& source, const PolygonSoup& soup, std::vector<std::string> lost,
                    const FaceGroups& groups, const FaceLooks& looks) {
  scene::Scene scene;
  scene.put_off_audits();
  Polygons polygons(scene, prefix_of(source, lost));
  GroupMembers members(groups, scene);
  std::vector<glm::dvec3> polygon;
  for (std::size_t i = 0; i < soup.faces.size(); ++i) {
    polygon.clear();
    CornerLooks corners{looks.textures.at_corners(i), looks.normals.at_corners(i)};
    for (const std::int64_t vertex : soup.faces[i]) {
      const auto number = static_cast<std::size_t>(vertex);
      polygon.push_back(soup.vertices[number]);
      if (!soup.normals.empty()) corners.normals.push_back(soup.normals[number]);
    }
    const std::size_t before = polygons.number();
    polygons.add(polygon, {}, corners);
    members.add(i, polygons, before);
  }
  scene.audit();
  polygons.name_losses(lost);
  scene::Groups made = members.made(lost);
  return {std::move(scene), std::move(lost), std::move(made)};
}

}  // namespace durero::io
