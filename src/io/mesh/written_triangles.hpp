#pragma once
/// The triangles of a scene in the order in which the formats of meshes write them, and what these do not keep.

#include <cstdint>
#include <cstring>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "durero/io/formats.hpp"

namespace durero::io {

/// A triangle, and the group that it is directly in; the empty name where it is in none.
struct WrittenTriangle {
  scene::ElementRef element;
  std::string_view group;
};

/// The triangles by group, then by name; a number that ends a name counts as a number, so that `m:2` stands before
/// `m:10` and a file that was read and is written again has its order. They refer to the scene and its groups.
std::vector<WrittenTriangle> written_triangles(const scene::Scene& scene, const scene::Groups& groups);

/// Adds a line for each kind of thing but triangles, their normals and groups: a format of meshes has none of them.
void add_mesh_losses(std::vector<std::string>& lost, const scene::Scene& scene, std::string_view format);

/// Numbers vectors in the order in which they come, each once by its bits. `Vector` is an array of doubles.
template <class Vector>
class Numbering {
 public:
  /// The number of a vector, from 0, and whether it is new.
  std::pair<std::size_t, bool> number(const Vector& vector) {
    const auto [place, is_new] = numbers_.try_emplace(vector, numbers_.size());
    return {place->second, is_new};
  }

 private:
  struct Hash {
    std::size_t operator()(const Vector& vector) const {
      return std::hash<std::string_view>()(
          {reinterpret_cast<const char*>(vector.data()), vector.size() * sizeof(double)});
    }
  };
  struct SameBits {
    bool operator()(const Vector& a, const Vector& b) const {
      return std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
    }
  };
  std::unordered_map<Vector, std::size_t, Hash, SameBits> numbers_;
};

}  // namespace durero::io
