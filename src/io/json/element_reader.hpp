#pragma once
/// One item of a scene file's `elementos`.

#include <optional>
#include <span>

#include "durero/io/json/json.hpp"
#include "durero/io/json/written_elements.hpp"
#include "durero/scene/any_shape.hpp"
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

/// Elements of types that a Z text declares: the types, and where the elements go.
struct WrittenElements {
  std::span<const WrittenType> types{};
  std::vector<WrittenElement>* elements = nullptr;  // not null where there are types
  bool bodies = false;                              // whether elements with bodies may stand beside
};

/// Reads an element and adds it to the scene by its operation.
void read_element(json::Reader& in, scene::Scene& scene, std::vector<MaterialUse>& uses,
                  const WrittenElements& written);

/// The keys that a shape has beside its tipo and its attributes.
struct ShapeKeys {
  bool id, material;  // required; not
};
/// A shape as it stands in a file, outside the scene's elements.
struct WrittenShape {
  Placed<std::string_view> id{};
  std::optional<Placed<std::string_view>> material{};
  scene::AnyShape shape{};
};
/// Reads a shape that could be added by its operation.
WrittenShape read_shape(json::Reader& in, ShapeKeys has);

/// Adds a sphere in whose place another layer knows the points. Fails where the name is taken.
void add_stand_in(const json::Reader& in, scene::Scene& scene, const Placed<std::string_view>& name);

/// The name of an element.
std::string_view read_id(json::Reader& in);

/// The type of the element that stands here, among these; nothing where it is none of them.
std::optional<std::size_t> written_type(const json::Reader& in, std::span<const WrittenType> types);
/// Reads an element of that type. Precondition: it stands here.
void read_written_element(json::Reader& in, std::size_t type, scene::Scene& scene, std::vector<MaterialUse>& uses,
                          const WrittenElements& written);

}  // namespace durero::io
