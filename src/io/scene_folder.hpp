#pragma once
/// The folder of a scene's text, and the files below it that the text names.

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "durero/io/source.hpp"

namespace durero::io {

/// The file of that name in a folder or beneath it. Nothing where there is none, or the name leads out of the folder.
std::optional<std::string> file_below(std::string_view folder, std::string_view name);

/// Finds files in the root of a scene's text and beneath it, and no other.
class SceneFolder {
 public:
  explicit SceneFolder(const Source& scene);

  /// Whether the scene lies in the root or beneath it, by the names alone.
  bool holds_scene() const;
  /// Where a file of that name would lie, beside the file that names it. Nothing where the name is absolute or leads
  /// out of the root.
  std::optional<std::string> path(const Source& file, std::string_view name) const;
  /// Searches also in that folder, as a file of the scene names it. False where it leads out of the root.
  bool add(const Source& file, std::string_view folder);
  /// The path of the file of that name: beside the file that names it, then in the folders of add(), then beside the
  /// scene. Nothing where there is none, or the name leads out of the root.
  std::optional<std::string> find(const Source& file, std::string_view name) const;
  /// What a message expects where find() finds nothing.
  std::string expected() const;

 private:
  std::filesystem::path own_;  ///< of the scene
  std::string given_;          ///< the root, where it is not the scene's own folder
  std::filesystem::path root_;
  std::vector<std::filesystem::path> folders_{};
};

}  // namespace durero::io
