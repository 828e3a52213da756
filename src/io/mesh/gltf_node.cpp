#include "gltf_node.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace durero::io {
namespace {

/// An array of so many numbers.
template <std::size_t count>
std::array<double, count> read_numbers(json::Reader& in, std::string_view what) {
  const std::size_t at = in.offset();
  std::array<double, count> numbers{};
  std::size_t items = 0;
  in.array(what, [&] {
    const double number = in.number(what);
    if (items < count) numbers[items] = number;
    ++items;
  });
  if (items != count)
    in.fail(at, fmt::format("{} has {} items", what, items), fmt::format("expected {} numbers", count));
  return numbers;
}

/// The parts of a node's map, and where one of each kind stands.
struct NodeParts {
  std::optional<std::size_t> matrix_at{}, part_at{};
  std::array<double, 16> matrix{};
  glm::dvec3 translation{0}, scale{1};
  std::array<double, 4> rotation{0, 0, 0, 1};

  bool read(json::Reader& in, std::string_view key) {
    const std::size_t at = in.offset();
    if (key == "matrix") {
      matrix = read_numbers<16>(in, key);
      matrix_at = at;
      if (matrix[3] != 0 || matrix[7] != 0 || matrix[11] != 0 || matrix[15] != 1)
        in.fail(at, "the last row of matrix is not 0 0 0 1", "expected that of an affine map");
      return true;
    }
    if (key == "rotation") {
      rotation = read_numbers<4>(in, key);
      if (std::ranges::count(rotation, 0) == 4) in.fail(at, "rotation is 0", "expected a quaternion x y z w");
    } else if (key == "translation") {
      translation = in.vec3(key);
    } else if (key == "scale") {
      scale = in.vec3(key);
    } else {
      return false;
    }
    part_at = at;
    return true;
  }

  std::optional<AffineMap> map(const json::Reader& in) const {
    if (matrix_at && part_at)
      in.fail(std::max(*matrix_at, *part_at), "a node with a matrix and parts of one",
              "expected matrix, or translation, rotation and scale");
    if (matrix_at) return AffineMap::of_matrix(matrix);
    if (part_at) return AffineMap::of_parts(translation, rotation, scale);
    return std::nullopt;
  }
};

}  // namespace

std::vector<GltfReference> read_references(const GltfJson& file, json::Reader& in, std::string_view what,
                                           GltfArray array) {
  std::vector<GltfReference> all;
  in.array(what, [&] { all.push_back(file.reference(in, what, array)); });
  return all;
}

GltfNode read_gltf_node(const GltfJson& file, std::size_t number) {
  json::Reader in = file.item(GltfArray::nodes, number);
  GltfNode node{.at = in.offset()};
  NodeParts parts;
  read_known(in, "an item of nodes", [&](std::string_view key) {
    if (parts.read(in, key)) return true;
    if (key == "name") {
      node.name = in.string(key);
    } else if (key == "mesh") {
      node.mesh = file.reference(in, key, GltfArray::meshes);
    } else if (key == "children") {
      node.children = read_references(file, in, key, GltfArray::nodes);
    } else {
      node.is_skinned = node.is_skinned || key == "skin";
      return false;
    }
    return true;
  });
  node.map = parts.map(in);
  return node;
}

}  // namespace durero::io
