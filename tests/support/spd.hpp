#pragma once
/// The Standard Procedural Databases (Haines), which are not part of the project.

#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <optional>
#include <string>

#include "support/tree.hpp"

namespace durero::test {

/// Where a database lies: in the folder that DURERO_SPD names, or beside the sources where it names none. Nothing where
/// it is absent, which is said.
inline std::optional<std::string> spd_path(const std::string& name) {
  const char* const named = std::getenv("DURERO_SPD");
  std::string path =
      (named != nullptr ? std::string(named) : source_dir() + "/../shared/data/spd") + "/" + name + ".nff";
  if (std::filesystem::exists(path)) return path;
  std::cout << "skipped: absent: " << path << '\n';
  return std::nullopt;
}

}  // namespace durero::test
