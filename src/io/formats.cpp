#include "durero/io/formats.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "durero/io/nff.hpp"
#include "durero/io/scene_file.hpp"

namespace durero::io {
namespace {

Imported read_json(const Source& source) { return {read_scene(source), {}}; }
Exported write_json(const scene::Scene& scene) { return {scene_text(scene), {}}; }

constexpr Format all[] = {{".json", read_json, write_json}, {".nff", read_nff, nff_text}};

}  // namespace

std::span<const Format> formats() { return all; }

const Format& format_of(const std::string& path) {
  const auto found = std::ranges::find_if(all, [&](const Format& format) { return path.ends_with(format.ending); });
  if (found == std::ranges::end(all)) {
    throw FileError(path, "a format that is not known by this name",
                    fmt::format("expected one that ends in {}", format_endings()));
  }
  return *found;
}

std::string format_endings() {
  std::vector<std::string_view> endings;
  for (const Format& format : all) endings.push_back(format.ending);
  return fmt::format("{}", fmt::join(endings, " or "));
}

}  // namespace durero::io
