#pragma once
/// The folder of a scene's text, and the files below it that the text names.

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "durero/io/source.hpp"

namespace durero::io {

/// Finds files in a folder and beneath it, and no other.
class SceneFolder {
 public:
  explicit SceneFolder(const Source& scene) : root_(std::filesystem::path(scene.name()).parent_path()) {}

  /// Searches also in that folder, as a file of the scene names it. False where it leads out of the scene's folder.
  bool add(const Source& file, std::string_view folder);
  /// The path of the file of that name: beside the file that names it, then in the folders of add(), then in the
  /// scene's own. Nothing where there is none, or the name leads out of the scene's folder.
  std::optional<std::string> find(const Source& file, std::string_view name) const;

 private:
  std::filesystem::path within(const Source& file) const;

  std::filesystem::path root_;
  std::vector<std::filesystem::path> folders_{};  ///< from the root
};

/// What a message expects where find() finds nothing.
inline constexpr std::string_view file_of_scene = "expected a file in the folder of the scene or beneath it";

}  // namespace durero::io
