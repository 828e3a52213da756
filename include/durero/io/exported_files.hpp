#pragma once
/// The files of an export, which appear all or none.

#include <string>

#include "durero/io/formats.hpp"
#include "durero/io/output_file.hpp"

namespace durero::io {

/// Writes a text and the files beside it that it names. Nothing is half-written: each is put in place once all are
/// written, the text last.
class ExportedFiles {
 public:
  /// Finds out whether the text can be written, so it is for the beginning of a work. `from` is the file that the scene
  /// comes from, which no file beside the text may replace.
  ExportedFiles(const std::string& path, std::string from);

  /// Writes all, once. Throws FileError.
  void write(const Exported& exported);

 private:
  std::string path_, from_;
  OutputFile text_;
};

}  // namespace durero::io
