#pragma once
/// The meshes of a glTF file: primitives, each with the accessors of its vertices.

#include <optional>
#include <string_view>
#include <vector>

#include "gltf_json.hpp"

namespace durero::io {

/// The ways in which corners follow each other to triangles; `none` gives points or lines.
enum class GltfMode { none, triangles, strip, fan };

struct GltfPrimitive {
  std::size_t at = 0;  ///< its place in the file
  GltfMode mode = GltfMode::triangles;
  std::optional<GltfReference> indices{}, positions{}, normals{}, uv{};
  std::optional<std::size_t> compressed_at{};  ///< the place of what says that it is compressed by Draco
  bool has_material = false;
  std::size_t other_attributes = 0, targets = 0;  ///< how many there are
};

struct GltfMesh {
  std::string_view name{};
  std::vector<GltfPrimitive> primitives{};
};

/// Throws InputError.
GltfMesh read_gltf_mesh(const GltfJson& file, std::size_t number);

}  // namespace durero::io
