#include "gltf_json.hpp"

#include <fmt/format.h>

#include "durero/io/json/whole_number.hpp"
#include "durero/text/shown.hpp"

namespace durero::io {
namespace {

constexpr std::array<std::string_view, 6> gltf_arrays{"scenes",    "nodes",       "meshes",
                                                      "accessors", "bufferViews", "buffers"};

/// Whether a version, MAJOR.MINOR, is one of those that have a number as the first part.
bool has_major(std::string_view version, std::string_view major) {
  return version.starts_with(major) && version.substr(major.size()).starts_with('.');
}

}  // namespace

GltfJson::GltfJson(const json::Document& document) : document_(document) {
  check_version();
  for (std::size_t i = 0; i < gltf_arrays.size(); ++i) {
    auto in = root().member(gltf_arrays[i]);
    if (!in) continue;
    in->array(gltf_arrays[i], [&] {
      items_[i].push_back(*in);
      in->skip();
    });
  }
}

void GltfJson::check_version() const {
  json::Reader file = root();
  const std::size_t at = file.offset();
  auto asset = file.member("asset");
  auto version = asset ? asset->member("version") : std::nullopt;
  if (!version) {
    file.members("a glTF file", [&](const json::Key&) { file.skip(); });  // the error of what is no object
    file.fail(at, "no version in the asset of a glTF file", "expected \"asset\":{\"version\":\"2.0\"}");
  }
  const std::size_t version_at = version->offset();
  if (const std::string_view text = version->string("version"); !has_major(text, "2"))
    file.fail(version_at, fmt::format("version {} of glTF", text::shown(text)), "expected \"2.0\"");
  auto least = asset->member("minVersion");
  if (!least) return;
  const std::size_t least_at = least->offset();
  if (const std::string_view text = least->string("minVersion"); text != "2.0")
    file.fail(least_at, fmt::format("minVersion is {}", text::shown(text)), "expected \"2.0\"");
}

GltfReference GltfJson::reference(json::Reader& in, std::string_view what, GltfArray array) const {
  const std::size_t at = in.offset();
  const auto count = static_cast<std::int64_t>(size(array));
  const std::string_view name = gltf_arrays[static_cast<std::size_t>(array)];
  if (count == 0) in.fail(at, fmt::format("{} names an item of {}", what, name), "expected some: there are none");
  const std::int64_t number =
      json::whole_number(in, what, 0, count - 1, fmt::format("one of {}, counted from 0", count));
  return {static_cast<std::size_t>(number), at};
}

std::size_t GltfJson::count(std::string_view array) const {
  std::size_t count = 0;
  if (auto in = root().member(array)) {
    in->array(array, [&] {
      in->skip();
      ++count;
    });
  }
  return count;
}

}  // namespace durero::io
