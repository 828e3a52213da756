#pragma once
/// The elements of a Mitsuba scene with their places, once its files are put together.

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "durero/io/source.hpp"
#include "io/scene_folder.hpp"

namespace durero::io {

/// An attribute of an element: its value, and where its name stands.
struct MitsubaAttribute {
  std::string value;
  std::size_t at;
};

/// An element of a file.
struct MitsubaNode {
  std::shared_ptr<const Source> file;
  std::size_t at;  ///< its <
  std::string tag;
  std::map<std::string, MitsubaAttribute, std::less<>> attributes{};
  std::string property{};  ///< its name as Mitsuba 2 and 3 write it: to_world for toWorld
  std::vector<MitsubaNode> children{};

  /// @{ The value of an attribute; empty where there is none.
  std::string_view value_of(std::string_view attribute) const;
  std::string_view type() const { return value_of("type"); }
  std::string_view name() const { return property; }
  /// @}
  /// The value of an attribute that must be there.
  std::string_view required(std::string_view attribute) const;
  /// Fails at the element, or at its attribute of that name where it has it.
  [[noreturn]] void fail(const std::string& wrong, const std::string& expected, std::string_view attribute = {}) const;
};

/// A whole scene, in which `default`, `include`, `path` and `alias` are carried out.
struct MitsubaTree {
  MitsubaNode scene;
  SceneFolder folder;
  std::map<std::string, std::string, std::less<>> aliases{};  ///< from a name to the id that it stands for
  std::size_t outer_paths = 0;  ///< folders out of that of the scene, in which nothing is searched
};

/// Reads the files of a scene. Throws InputError.
MitsubaTree read_mitsuba_tree(const Source& source);

}  // namespace durero::io
