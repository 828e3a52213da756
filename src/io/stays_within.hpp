#pragma once
/// A bound on the files that one file may name.

#include <algorithm>
#include <filesystem>
#include <string>

namespace durero::io {

/// Whether a name leads to nothing but files in a folder and beneath it.
inline bool stays_within(const std::filesystem::path& name) {
  return !name.empty() && name.is_relative() && std::ranges::find(name, "..") == name.end() &&
         name.native().find('\0') == std::string::npos;
}

}  // namespace durero::io
