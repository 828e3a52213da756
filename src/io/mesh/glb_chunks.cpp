#include "glb_chunks.hpp"

#include <fmt/format.h>

#include <cstdint>

#include "io/byte_order.hpp"

namespace durero::io {
namespace {

constexpr std::string_view glb_magic = "glTF", glb_json = "JSON", glb_bytes{"BIN\0", 4};
constexpr std::size_t glb_header = 12, glb_chunk_header = 8;  // bytes

class GlbReader {
 public:
  explicit GlbReader(const Source& source) : source_(source), text_(source.text()) {}

  GltfParts read() {
    check_header();
    const Chunk json = chunk();
    if (json.type != glb_json)
      source_.fail(0, fmt::format("the chunk at byte {} is not JSON", glb_header), "expected the JSON of a glTF file");
    GltfParts parts{json.begin, json.begin + json.bytes.size(), {}};
    if (next_ < text_.size())
      if (const Chunk second = chunk(); second.type == glb_bytes) parts.bytes = second.bytes;
    while (next_ < text_.size()) chunk();  // readers pass over chunks that are not known to them
    return parts;
  }

 private:
  struct Chunk {
    std::string_view type;
    std::size_t begin;
    std::string_view bytes;
  };

  void check_header() const {
    if (text_.size() < glb_header)
      source_.fail(0, "the file ends in the header of a GLB file", fmt::format("expected {} bytes", glb_header));
    if (number(4) != 2) source_.fail(0, fmt::format("version {} of GLB", number(4)), "expected 2");
    if (number(8) != text_.size())
      source_.fail(0, fmt::format("a GLB file of {} bytes says that it has {}", text_.size(), number(8)),
                   "expected the bytes that it says");
  }

  Chunk chunk() {
    const std::size_t left = text_.size() - next_;
    if (left < glb_chunk_header || left - glb_chunk_header < number(next_))
      source_.fail(0, fmt::format("the file ends in the chunk at byte {}", next_),
                   "expected a length, a type and as many bytes");
    const std::size_t begin = next_ + glb_chunk_header;
    const Chunk read{text_.substr(next_ + 4, 4), begin, text_.substr(begin, number(next_))};
    next_ = begin + read.bytes.size();
    return read;
  }

  std::size_t number(std::size_t at) const { return little_endian(text_.substr(at, 4)); }

  const Source& source_;
  std::string_view text_;
  std::size_t next_ = glb_header;
};

}  // namespace

GltfParts gltf_parts(const Source& source) {
  if (!source.text().starts_with(glb_magic)) return {0, source.text().size(), {}};
  return GlbReader(source).read();
}

}  // namespace durero::io
