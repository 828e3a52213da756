#pragma once
/// One item of a scene file's `elementos`.

#include "durero/io/json.hpp"
#include "durero/scene/scene.hpp"

namespace durero::io {

/// A value as it stands in a file.
template <class Value>
struct Placed {
  Value value{};
  std::size_t offset = 0;
};

/// The material that an element names. Keys may stand in any order, so it is looked up when all of the file has been
/// read.
struct MaterialUse {
  std::string_view element;
  Placed<std::string_view> material;
};

/// Reads an element and adds it to the scene by its operation.
void read_element(json::Reader& in, scene::Scene& scene, std::vector<MaterialUse>& uses);

}  // namespace durero::io
