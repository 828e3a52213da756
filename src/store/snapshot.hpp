#pragma once
/// Snapshots: the scene of an event in bytes that are read quickly.
///
/// Bytes stand in this order, numbers with their lowest byte first. The length of a scene file, 8 bytes, and the file:
/// the scene but for its plain elements, canonical. Then for each shape, in the order of Tipo, how many plain elements
/// it has, 8 bytes, and these, ascending by name: the length of the name, 1 byte; the name; the index of the material
/// among those of the file, 4 bytes, or 2³² − 1 for none; and each attribute, in the order of the text, as binary64.
///
/// A plain element is one by itself, in no mesh and no group, that has nothing beside its geometry and its material.
/// The same scene gives the same bytes. A scene of 10⁶ spheres takes some 50 bytes each, and is read three times as
/// fast as its scene file.

#include <string>
#include <string_view>

#include "durero/scene/grouped_scene.hpp"

namespace durero::store {

/// The snapshot of a scene.
std::string snapshot_of(const scene::GroupedScene& of);

/// The scene of a snapshot. `name` is that of its file in messages. Throws io::FileError where it is none.
scene::GroupedScene scene_of(std::string_view snapshot, const std::string& name);

}  // namespace durero::store
