#pragma once
/// The triangles of a glTF file's primitives, placed in space.

#include <cstddef>
#include <optional>

#include "face_corners.hpp"
#include "face_groups.hpp"
#include "gltf_buffers.hpp"
#include "gltf_primitive.hpp"
#include "polygon_soup.hpp"
#include "rounded_map.hpp"

namespace durero::io {

/// A node as it places a mesh in the scene.
struct GltfPlace {
  std::size_t node, at;  ///< its number and its place in the file
  RoundedMap points;
  std::optional<RoundedMap> normals;  ///< nothing where it flattens space
  bool mirrors;                       ///< whether it turns right into left
  FaceGroups::Number group = FaceGroups::none;
};

/// A mesh in the making.
class GltfTriangles {
 public:
  /// The arguments must outlive it.
  GltfTriangles(const Source& source, const GltfJson& file, GltfBuffers& buffers)
      : source_(source), file_(file), buffers_(buffers) {}

  /// Adds the triangles of a primitive that has some, and positions. Their corners go round the outer side to the left,
  /// where the place turns right into left too. Throws InputError.
  void add(const GltfPrimitive& primitive, const GltfPlace& place);

  /// @{ What has been added. A texture grows upwards, as in OBJ.
  const PolygonSoup& soup() const { return soup_; }
  const FaceLooks& looks() const { return looks_; }
  FaceGroups& groups() { return groups_; }
  /// @}

 private:
  class Corners;

  const Source& source_;
  const GltfJson& file_;
  GltfBuffers& buffers_;
  PolygonSoup soup_;
  FaceLooks looks_;
  FaceGroups groups_;
};

}  // namespace durero::io
