#pragma once
/// The cone that a light shines into, in scene files.

#include <optional>
#include <string_view>

#include "durero/io/json/json.hpp"
#include "durero/io/json/json_writer.hpp"
#include "durero/scene/stage.hpp"

namespace durero::io {

/// @{ The member `spot` of a light.
void read_json(json::Reader& in, std::string_view what, std::optional<scene::LightCone>& cone);
void write_member(json::Writer& out, std::string_view key, const std::optional<scene::LightCone>& cone);
/// @}

}  // namespace durero::io
