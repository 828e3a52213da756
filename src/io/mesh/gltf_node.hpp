#pragma once
/// The nodes of a glTF file, which place meshes.

#include <optional>
#include <string_view>
#include <vector>

#include "affine_map.hpp"
#include "gltf_json.hpp"

namespace durero::io {

struct GltfNode {
  std::size_t at = 0;  ///< its place in the file
  std::string_view name{};
  std::optional<AffineMap> map{};  ///< from the node to the one that it is in; nothing where that is the identity
  std::optional<GltfReference> mesh{};
  std::vector<GltfReference> children{};
  bool is_skinned = false;
};

/// Throws InputError, also where the node has a matrix and parts of one.
GltfNode read_gltf_node(const GltfJson& file, std::size_t number);

/// Reads an array of references to items.
std::vector<GltfReference> read_references(const GltfJson& file, json::Reader& in, std::string_view what,
                                           GltfArray array);

}  // namespace durero::io
