#pragma once
/// The JSON of a glTF file, which is a database: the items of its arrays name each other by their numbers.

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "durero/io/json/json.hpp"

namespace durero::io {

/// The arrays that a reader of meshes looks into.
enum class GltfArray { scenes, nodes, meshes, accessors, buffer_views, buffers };

/// An item of one of the arrays: its number from 0, and where the file names it.
struct GltfReference {
  std::size_t number = 0, at = 0;
};

/// The arrays of a file, and readers of their items.
class GltfJson {
 public:
  /// Notes where each item stands. The document must outlive it. Throws InputError, also where the file has another
  /// version than 2.
  explicit GltfJson(const json::Document& document);

  /// The whole file, an object.
  json::Reader root() const { return json::Reader(document_); }
  std::size_t size(GltfArray array) const { return items_[static_cast<std::size_t>(array)].size(); }
  /// Stands on the item. Precondition: there is one.
  json::Reader item(GltfArray array, std::size_t number) const {
    return items_[static_cast<std::size_t>(array)][number];
  }
  /// Reads a number that refers to an item. Throws InputError where there is none.
  GltfReference reference(json::Reader& in, std::string_view what, GltfArray array) const;
  /// How many items an array of the file has, whatever they are; 0 where it is not there.
  std::size_t count(std::string_view array) const;

 private:
  void check_version() const;

  const json::Document& document_;
  std::array<std::vector<json::Reader>, 6> items_;
};

/// Reads an object of a glTF file: calls member(key) for each member, which reads its value, or answers that it does
/// not by false; the value is then passed over. The format lets any key stand anywhere.
template <class Member>
void read_known(json::Reader& in, std::string_view what, Member&& member) {
  in.members(what, [&](const json::Key& key) {
    if (!member(key.name)) in.skip();
  });
}

}  // namespace durero::io
