#pragma once
/// Elements of types that the program has no shape for, in scene files: a Z text says what their points are.
/// read_scene(source, types, elements) of scene_file.hpp reads them.

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <variant>
#include <vector>

#include "durero/scene/shape/attribute.hpp"

namespace durero::io {

/// What an attribute of such an element is written as.
enum class WrittenKind : std::uint8_t {
  number,       ///< a number
  triple,       ///< three numbers, of a point or a vector
  three_points  ///< three triples
};
/// A value of that kind.
using WrittenValue = std::variant<double, glm::dvec3, scene::Corners>;

/// An attribute of a type.
struct WrittenAttribute {
  std::string word;  ///< its key
  WrittenKind kind;  ///< what stands behind it
};

/// A type of elements, by its word in scene files.
struct WrittenType {
  std::string word;                          ///< the value of `tipo`
  std::vector<WrittenAttribute> attributes;  ///< all of them are required
};

/// An element of such a type, as it stands in a file.
struct WrittenElement {
  std::string id;                    ///< its name
  std::size_t type;                  ///< its place among the types
  std::size_t offset;                ///< where the element stands
  std::vector<WrittenValue> values;  ///< in step with the attributes of its type
  std::vector<std::size_t> offsets;  ///< where these stand
};

}  // namespace durero::io
