#pragma once
/// The mesh files that a scene names, each read once.

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "placed_scene.hpp"

namespace durero::io {

class MeshFiles {
 public:
  /// The triangles of an OBJ or a PLY file. Throws FileError and InputError, which is of that file.
  MeshTriangles read(const std::string& path, bool with_normals);
  /// Of all files together what is left out.
  void name_losses(std::vector<std::string>& lost) const;

 private:
  std::map<std::pair<std::string, bool>, MeshTriangles> read_;
  std::map<std::string, std::uint64_t> lost_;  ///< things of each fate
};

}  // namespace durero::io
