#pragma once
/// Elements of types that the program has no shape for, in scene files: a Z text says what their points are.
/// read_scene(source, types, elements) of scene_file.hpp reads them.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "durero/scene/shape/attribute.hpp"
#include "durero/scene/shape/sphere.hpp"

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
  bool operator==(const WrittenAttribute&) const = default;
};

/// A type of elements, by its word in scene files.
struct WrittenType {
  std::string word;                          ///< the value of `tipo`
  std::vector<WrittenAttribute> attributes;  ///< all of them are required
  bool operator==(const WrittenType&) const = default;
};

/// An element of such a type, as it stands in a file, or in a script that adds it.
struct WrittenElement {
  std::string id;                    ///< its name
  std::size_t type;                  ///< its place among the types
  std::size_t offset;                ///< where the element stands
  std::vector<WrittenValue> values;  ///< in step with the attributes of its type
  std::vector<std::size_t> offsets;  ///< where these stand; none in a script
};
/// Elements by their names.
using WrittenByName = std::map<std::string, WrittenElement, std::less<>>;

/// The elements of such types that a scene has, and the types.
struct WrittenPart {
  std::span<const WrittenType> types{};    ///< what WrittenElement::type is a place of
  const WrittenByName* by_name = nullptr;  ///< not null where there are types
};

/// An addition of such an element, `Agregar_Toro`.
struct WrittenAddition {
  WrittenElement element;                   ///< what is added
  std::optional<std::uint32_t> material{};  ///< a place in the stage's materials
};
/// The removal of an element of one such type, `Eliminar_Toro`.
struct WrittenRemoval {
  std::string e;     ///< its name
  std::size_t type;  ///< which type it is to be of
};
/// An edit of elements of such types.
using WrittenEdit = std::variant<WrittenAddition, WrittenRemoval>;

/// @{ The names of these, of the type of that word.
std::string addition_name(std::string_view word);
std::string removal_name(std::string_view word);
/// @}

}  // namespace durero::io
