#include "durero/io/exported_files.hpp"

#include <deque>
#include <filesystem>
#include <system_error>
#include <utility>

namespace durero::io {

namespace fs = std::filesystem;

ExportedFiles::ExportedFiles(const std::string& path, std::string from)
    : path_(path), from_(std::move(from)), text_(path) {}

void ExportedFiles::write(const Exported& exported) {
  std::deque<OutputFile> beside;
  for (const FileBeside& file : exported.beside) {
    const std::string path = (fs::path(path_).parent_path() / file.name).string();
    std::error_code error;
    if (fs::equivalent(path, from_, error))
      throw FileError(path, "the scene itself is in the place of a file that goes with its export",
                      "expected another name to export to");
    beside.emplace_back(path).write(file.bytes);
  }
  text_.write(exported.text);
  for (OutputFile& file : beside) file.commit();
  text_.commit();
}

}  // namespace durero::io
