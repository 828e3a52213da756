#pragma once
/// The bytes of a glTF file: its buffers, and the views into them.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gltf_json.hpp"

namespace durero::io {

/// Part of a buffer.
struct GltfView {
  std::string_view bytes;    ///< valid as long as the buffers
  std::uint64_t stride = 0;  ///< bytes from one element to the next; 0 where they follow each other
};

/// The buffers of a file. Each is read when a view into it is asked for, so that what belongs to pictures alone is not.
class GltfBuffers {
 public:
  /// `inner` are the bytes behind the JSON of a GLB file. The arguments must outlive it.
  GltfBuffers(const Source& source, const GltfJson& file, std::optional<std::string_view> inner)
      : source_(source), file_(file), inner_(inner), read_(file.size(GltfArray::buffers)) {}

  /// Throws InputError at what is wrong with the view or its buffer.
  GltfView view(const GltfReference& reference);

 private:
  std::string_view buffer(const GltfReference& reference);

  const Source& source_;
  const GltfJson& file_;
  std::optional<std::string_view> inner_;
  std::vector<std::optional<std::string>> read_;  ///< of the buffers with a URI
};

}  // namespace durero::io
