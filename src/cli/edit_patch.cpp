#include "edit_patch.hpp"

#include <optional>

#include "durero/io/file_lock.hpp"
#include "durero/io/file_name.hpp"
#include "durero/io/json/groups_file.hpp"
#include "durero/io/json/scene_patch.hpp"
#include "durero/io/output_file.hpp"
#include "durero/io/pictures/picture_file.hpp"
#include "durero/scene/stage.hpp"

namespace durero::cli {

int edit_by_patch(const std::string& scene, const std::string& patch, const std::string& out) {
  std::optional<io::FileLock> lock;  // until the edited scene is in place
  if (io::is_same_file(scene, out)) lock.emplace(out);
  std::optional<io::OutputFile> file;
  if (!out.empty()) {
    io::require_ending(out, io::json_endings, "a scene");
    file.emplace(out);
  }
  const scene::GroupedScene read = io::read_grouped_scene(io::read_source(scene), io::Bodies::read);
  scene::GroupedScene edited = io::patched_scene(read, io::read_source(patch));
  if (file) {
    io::rename_pictures(edited.scene.stage(), scene, out);
    file->write(io::scene_text(edited.scene, edited.groups));
    file->commit();
  }
  return 0;
}

}  // namespace durero::cli
