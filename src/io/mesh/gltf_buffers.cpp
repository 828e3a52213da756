#include "gltf_buffers.hpp"

#include <fmt/format.h>

#include "buffer_uri.hpp"
#include "durero/io/json/whole_number.hpp"

namespace durero::io {

GltfView GltfBuffers::view(const GltfReference& reference) {
  json::Reader in = file_.item(GltfArray::buffer_views, reference.number);
  const std::size_t at = in.offset();
  std::optional<GltfReference> of;
  std::uint64_t begin = 0, size = 0, stride = 0;
  read_known(in, "an item of bufferViews", [&](std::string_view key) {
    if (key == "buffer")
      of = file_.reference(in, key, GltfArray::buffers);
    else if (key == "byteOffset")
      begin = json::whole_number(in, key);
    else if (key == "byteLength")
      size = json::whole_number(in, key);
    else if (key == "byteStride")
      stride = static_cast<std::uint64_t>(json::whole_number(in, key, 4, 252, "4 to 252"));
    else
      return false;
    return true;
  });
  if (!of) source_.fail(at, "an item of bufferViews without buffer", "expected one");
  const std::string_view bytes = buffer(*of);
  if (begin > bytes.size() || size > bytes.size() - begin)
    source_.fail(at,
                 fmt::format("a view of bytes {} to {} of buffer {}, which has {}", begin, begin + size, of->number,
                             bytes.size()),
                 "expected one within its buffer");
  return {bytes.substr(begin, size), stride};
}

std::string_view GltfBuffers::buffer(const GltfReference& reference) {
  json::Reader in = file_.item(GltfArray::buffers, reference.number);
  const std::size_t at = in.offset();
  std::size_t uri_at = 0;
  std::optional<std::string_view> uri;
  std::uint64_t size = 0;
  read_known(in, "an item of buffers", [&](std::string_view key) {
    if (key == "uri")
      uri_at = in.offset(), uri = in.string(key);
    else if (key == "byteLength")
      size = json::whole_number(in, key);
    else
      return false;
    return true;
  });
  std::optional<std::string>& read = read_[reference.number];
  if (uri && !read) read = buffer_bytes(source_, *uri, uri_at, size);
  const bool is_inner = !uri && reference.number == 0 && inner_;
  if (!uri && !is_inner)
    source_.fail(at, fmt::format("buffer {} without bytes", reference.number),
                 "expected a uri, or in a GLB file the chunk behind the JSON for the first");
  const std::string_view bytes = uri ? std::string_view(*read) : *inner_;
  if (bytes.size() < size)
    source_.fail(at, fmt::format("buffer {} has {} bytes", reference.number, bytes.size()),
                 fmt::format("expected the {} of its byteLength", size));
  return bytes.substr(0, size);
}

}  // namespace durero::io
