#pragma once
/// What a PLY file says of itself: its elements and their properties.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "durero/io/source.hpp"

namespace durero::io {

struct PlyProperty {
  std::string_view name, type;
  std::string_view counted_by;  ///< the type of a list's length; empty where there is no list
};

struct PlyElement {
  std::string_view name;
  std::uint64_t items = 0;
  std::size_t at = 0;  ///< where the header tells of it
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  bool is_text = false;
  bool is_little = false;  ///< whether the least byte of a number comes first, where it is no text
  std::vector<PlyElement> elements;
  std::size_t vertex = 0, face = 0;                     ///< which of the elements they are
  std::array<std::size_t, 3> axes{};                    ///< which properties of vertex are x, y and z
  std::optional<std::array<std::size_t, 3>> normals{};  ///< which are nx, ny and nz, if it has all of them
  std::size_t corners = 0;                              ///< which property of face is the list of its vertices
  std::size_t end = 0;                                  ///< where the data begin
};

/// Reads the header of a mesh: one with the elements vertex (float or double x, y, z, and perhaps nx, ny, nz) and face
/// (a list vertex_indices or vertex_index of int or uint), and perhaps others. Throws InputError.
PlyHeader read_ply_header(const Source& source);

}  // namespace durero::io
