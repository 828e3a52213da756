#pragma once
/// A bound on the files that one file may name.

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>

namespace durero::io {

/// Whether a name leads to nothing but files in a folder and beneath it.
inline bool stays_within(const std::filesystem::path& name) {
  return !name.empty() && name.is_relative() && std::ranges::find(name, "..") == name.end() &&
         name.native().find('\0') == std::string::npos;
}

/// The file of that name below a folder; nothing where there is none. A name that leads out of the folder is none.
inline std::optional<std::string> file_below(const std::filesystem::path& folder, const std::string& name) {
  if (!stays_within(name)) return std::nullopt;
  std::error_code error;
  const std::filesystem::path path = folder / name;
  return std::filesystem::is_regular_file(path, error) ? std::optional(path.string()) : std::nullopt;
}

}  // namespace durero::io
