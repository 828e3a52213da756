#include "mesh_files.hpp"

#include <fmt/format.h>

#include <charconv>

#include "durero/io/file_name.hpp"
#include "durero/io/mesh/obj.hpp"
#include "durero/io/mesh/ply.hpp"

namespace durero::io {

MeshTriangles MeshFiles::read(const std::string& path, bool with_normals) {
  const auto [known, is_new] = read_.try_emplace({path, with_normals});
  if (!is_new) return known->second;
  try {
    const bool is_ply = ends_in(path, ".ply");
    const Imported mesh = is_ply ? read_ply(read_source(path)) : read_obj(read_lines(path));
    known->second = triangles_of(mesh.scene, with_normals);
    for (const std::string& line : mesh.lost) {  // `N things fate`, or a sentence of the names that they have not here
      std::uint64_t things = 0;
      const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), things);
      if (error == std::errc()) lost_[std::string(end, line.data() + line.size())] += things;
    }
  } catch (...) {
    read_.erase(known);
    throw;
  }
  return known->second;
}

void MeshFiles::name_losses(std::vector<std::string>& lost) const {
  for (const auto& [fate, things] : lost_) lost.push_back(fmt::format("{}{}", things, fate));
}

}  // namespace durero::io
