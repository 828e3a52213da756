#pragma once
/// The triangles of a scene in sets that other programs have as one mesh each.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "durero/scene/groups.hpp"
#include "durero/scene/scene.hpp"

namespace durero::io {

/// Triangles of one group and one mesh of the scene, of one material, all with normals or none, and all with uv or
/// none.
struct TriangleSet {
  std::string_view group;  ///< that they are directly in; empty where they are in none
  std::string_view mesh;   ///< whose faces they are; empty where they are elements by themselves
  std::optional<std::uint32_t> material;
  bool has_normals, has_uv;
  std::vector<scene::ElementRef> triangles{};
};

/// All triangles, in the order of triangles_by_group(): a set stands where its first does. They refer to the scene and
/// its groups.
std::vector<TriangleSet> triangle_sets(const scene::Scene& scene, const scene::Groups& groups);

/// A mesh whose vertices stand once each.
struct IndexedMesh {
  /// Three numbers of a point, three of its normal, two of its uv; 0 where the mesh has none.
  std::vector<std::array<double, 8>> vertices{};
  std::vector<std::array<std::size_t, 3>> faces{};
};

/// The mesh of triangles, with normals or uv where it is told so. Precondition: they all have what is told.
IndexedMesh indexed_mesh(const scene::Scene& scene, std::span<const scene::ElementRef> triangles, bool with_normals,
                         bool with_uv);

}  // namespace durero::io
