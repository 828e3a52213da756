#include "scene_folder.hpp"

#include <system_error>

#include "io/stays_within.hpp"

namespace durero::io {

namespace fs = std::filesystem;

/// The folder of a file of the scene, from the root.
fs::path SceneFolder::within(const Source& file) const {
  return fs::path(file.name()).parent_path().lexically_relative(root_);
}

bool SceneFolder::add(const Source& file, std::string_view folder) {
  fs::path from_root = (within(file) / folder).lexically_normal();
  if (!stays_within(from_root)) return false;
  folders_.push_back(std::move(from_root));
  return true;
}

std::optional<std::string> SceneFolder::find(const Source& file, std::string_view name) const {
  std::vector<fs::path> in{within(file)};
  in.insert(in.end(), folders_.begin(), folders_.end());
  in.emplace_back();
  for (const fs::path& folder : in) {
    const fs::path from_root = (folder / name).lexically_normal();
    std::error_code error;
    if (stays_within(from_root) && fs::is_regular_file(root_ / from_root, error)) return (root_ / from_root).string();
  }
  return std::nullopt;
}

}  // namespace durero::io
