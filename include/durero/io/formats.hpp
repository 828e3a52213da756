#pragma once
/// The scene formats, each a row of one table, told apart by how a file's name ends.

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "durero/io/json/written_elements.hpp"
#include "durero/io/source.hpp"
#include "durero/scene/groups.hpp"
#include "durero/scene/scene.hpp"

namespace durero::io {

/// A scene read from a format with its groups, and one line for each kind of thing that it does not keep.
struct Imported {
  scene::Scene scene;             ///< what could be kept
  std::vector<std::string> lost;  ///< to be shown to the user; empty where all was kept
  scene::Groups groups = {};      ///< of its elements; JSON, glTF, OBJ, STL and POV-Ray have some
  WrittenByName surfaces = {};    ///< those of algebraic_types(), which a Z text says the points of
};

/// The choices of a reader that no file tells.
struct Reading {
  std::string root = {};        ///< the folder that holds the files which it may name; without one its own
  bool keeps_surfaces = false;  ///< whether elements of types that a Z text declares are kept
};

/// A file that a text names, to stand in the same folder.
struct FileBeside {
  std::string name;   ///< in that folder
  std::string bytes;  ///< of the whole file
};

/// A text in a format, or its bytes, and one line for each kind of thing of the scene that it does not keep.
struct Exported {
  std::string text;                  ///< of the whole file
  std::vector<std::string> lost;     ///< to be shown to the user; empty where all was kept
  std::vector<FileBeside> beside{};  ///< what the text names
};

/// A row of the table: how a scene format is known by a name, read and written.
struct Format {
  std::string_view ending;  ///< of the file's name: ".nff"
  /// Throws InputError. Null where the format is only written.
  Imported (*read)(const Source& source);
  /// Writes a scene and groups of its elements. Null where the format is only read, and where write_with_files is not.
  Exported (*write)(const scene::Scene&, const scene::Groups&){};
  /// Whether its texts are lines, none of which is longer than longest_line.
  bool has_lines = false;
  /// Whether it is a format of meshes, which is read triangle by triangle.
  bool is_mesh = false;
  /// Writes them as bytes and not as a text. Null where the format has no such form.
  Exported (*write_bytes)(const scene::Scene&, const scene::Groups&){};
  /// Writes them, in the place of `write`, where the text names files beside it: their names begin with `stem`.
  Exported (*write_with_files)(const scene::Scene&, const scene::Groups&, const std::string& stem){};
};

/// The table, which lives as long as the program.
std::span<const Format> formats();

/// @{ The format of a file that is to be read or written, by its name. Throws FileError where none has that ending.
const Format& format_to_read(const std::string& path);
const Format& format_to_write(const std::string& path);
/// @}
/// The format of a file that is to be written as bytes. Throws FileError where none has that ending and such a form.
const Format& format_to_write_bytes(const std::string& path);

/// The scene and its groups in the format that a path tells, as a text or as bytes, for a file that is not written yet.
/// Throws FileError where none has that ending and such a form.
Exported exported_scene(const std::string& path, const scene::Scene& scene, const scene::Groups& groups,
                        bool as_bytes = false);

/// Reads a file in the format that its name tells. The files that it names lie in the root or beneath it. Throws
/// InputError, and FileError, also where the root is no folder or does not hold the file.
Imported read_any_format(const std::string& path, const Reading& how = {});

/// The same with its triangles gathered into meshes, or each an element; without the choice as its format has them: a
/// format of meshes gives meshes.
Imported import_file(const std::string& path, const Reading& how = {}, std::optional<bool> in_meshes = {});

/// @{ The endings of those formats, as a sentence lists them: ".json or .nff".
std::string endings_to_read();
std::string endings_to_write();
/// @}

}  // namespace durero::io
