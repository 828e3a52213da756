#pragma once
/// The extent of a light in scene files: one of four members of the light.

#include <string_view>

#include "durero/io/json/json.hpp"
#include "durero/io/json/json_writer.hpp"
#include "durero/scene/stage.hpp"

namespace durero::io {

/// @{ The member of a light by which its shape goes: `disc`, `sphere`, `triangle` or `rectangle`.
void read_json(json::Reader& in, std::string_view shape, scene::LightExtent& extent);
/// Writes the member of the light's own shape, and no other.
void write_member(json::Writer& out, std::string_view shape, const scene::LightExtent& extent);
/// @}

}  // namespace durero::io
