#pragma once
/// A scene as parts with names, each a piece of the canonical text: what two scenes are compared and merged by.

#include <compare>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "durero/io/source.hpp"
#include "durero/scene/grouped_scene.hpp"

namespace durero::io {

/// The kinds of parts, in the order of the canonical text. Cameras have a part for each key; a value that stands by
/// name, or with an id, is a part of its own; the others are wholes.
enum class PartKind : std::uint8_t {
  camera,              ///< a key of the camera
  resolution,          ///< the whole
  background,          ///< the whole
  lights,              ///< all of them: a light has no name
  directional_lights,  ///< all of them
  environment,         ///< the whole
  textures,            ///< a texture
  materials,           ///< a material
  max_depth,           ///< the whole
  groups,              ///< a group
  elementos,           ///< an element by itself
  mallas               ///< a mesh
};

/// The key of the parts of a kind in a scene file.
std::string_view key_of(PartKind kind);

/// Which part of a scene it is.
struct PartKey {
  PartKind kind;       ///< what it is
  std::string name{};  ///< its key or id; empty of a whole
  auto operator<=>(const PartKey&) const = default;

  /// `/elementos/ball`: a pointer to it, as if elements and meshes stood by name.
  std::string pointer() const;
};

/// The parts of a scene, each with its value as the canonical text has it.
using SceneParts = std::map<PartKey, std::string>;

/// @{ The parts of a scene, and of a canonical text. Precondition: scene_text() gave it, in some form.
SceneParts scene_parts(const scene::GroupedScene& of);
SceneParts scene_parts(const Source& canonical);
/// @}

/// A scene file of these parts, whether or not they go together. Of the parts of a scene, the scene reads back from it.
std::string parts_text(const SceneParts& parts);

}  // namespace durero::io
