#include "scene_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>
#include <utility>

#include "durero/text/shown.hpp"

namespace durero::io {

namespace fs = std::filesystem;

namespace {

fs::path whole(const fs::path& path) { return fs::absolute(path.empty() ? "." : path).lexically_normal(); }
/// Whether a path leads to a folder, or to what lies in it or beneath it.
bool lies_within(const fs::path& root, const fs::path& path) {
  const fs::path from_root = whole(path).lexically_relative(whole(root));
  return !from_root.empty() && *from_root.begin() != "..";
}

/// The path of a name in a folder. Nothing where the name is absolute, or leads out of the root.
std::optional<fs::path> path_within(const fs::path& root, const fs::path& folder, std::string_view name) {
  if (name.empty() || name.find('\0') != name.npos || fs::path(name).is_absolute()) return std::nullopt;
  fs::path path = (folder / name).lexically_normal();
  return lies_within(root, path) ? std::optional(std::move(path)) : std::nullopt;
}

std::optional<std::string> file_within(const fs::path& root, const fs::path& folder, std::string_view name) {
  std::error_code error;
  const auto path = path_within(root, folder, name);
  return path && fs::is_regular_file(*path, error) ? std::optional(path->string()) : std::nullopt;
}

fs::path folder_of(const Source& file) { return fs::path(file.name()).parent_path(); }

}  // namespace

std::optional<std::string> file_below(std::string_view folder, std::string_view name) {
  return file_within(folder, folder, name);
}

SceneFolder::SceneFolder(const Source& scene)
    : own_(folder_of(scene)), given_(scene.root()), root_(given_.empty() ? own_ : fs::path(given_)) {}

bool SceneFolder::holds_scene() const { return lies_within(root_, own_); }

std::optional<std::string> SceneFolder::path(const Source& file, std::string_view name) const {
  const auto path = path_within(root_, folder_of(file), name);
  return path ? std::optional(path->string()) : std::nullopt;
}

bool SceneFolder::add(const Source& file, std::string_view folder) {
  auto path = path_within(root_, folder_of(file), folder);
  if (path) folders_.push_back(std::move(*path));
  return path.has_value();
}

std::optional<std::string> SceneFolder::find(const Source& file, std::string_view name) const {
  std::vector<fs::path> in{folder_of(file)};
  in.insert(in.end(), folders_.begin(), folders_.end());
  in.push_back(own_);
  for (const fs::path& folder : in)
    if (auto path = file_within(root_, folder, name)) return path;
  return std::nullopt;
}

std::string SceneFolder::expected() const {
  return given_.empty() ? "expected a file in the folder of the scene or beneath it"
                        : fmt::format("expected a file in {} or beneath it", text::shown(given_));
}

}  // namespace durero::io
