#pragma once
/// Scenes as git hands them to its drivers.

#include <string>

#include "durero/io/json/groups_file.hpp"
#include "durero/scene/grouped_scene.hpp"

namespace durero::cli {

/// The scene of a file; of an empty one the empty scene: so git hands over a version that is not there. Throws
/// io::InputError and io::FileError.
inline scene::GroupedScene git_scene(const std::string& file) {
  const io::Source source = io::read_source(file);
  return source.text().empty() ? scene::GroupedScene{} : io::read_grouped_scene(source, io::Bodies::read);
}

}  // namespace durero::cli
