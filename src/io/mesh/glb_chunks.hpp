#pragma once
/// The chunks of a GLB file: the JSON of a glTF file, and bytes behind it.

#include <cstddef>
#include <optional>
#include <string_view>

#include "durero/io/source.hpp"

namespace durero::io {

/// The place of the JSON in a glTF file, and the bytes that a GLB file has behind it.
struct GltfParts {
  std::size_t json_begin, json_end;
  std::optional<std::string_view> bytes;  ///< valid as long as the source; nothing where no chunk has any
};

/// The parts of a file: of one that begins with `glTF` its chunks of JSON and of bytes, of any other the whole text.
/// Throws InputError; its place is then the beginning.
GltfParts gltf_parts(const Source& source);

}  // namespace durero::io
