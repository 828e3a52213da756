#pragma once
/// Textures, environments and what materials have of them: their parts of the scene format, read and written.

#include <vector>

#include "durero/io/json/json.hpp"
#include "durero/io/json/json_writer.hpp"
#include "durero/scene/stage.hpp"

namespace durero::io {

std::vector<scene::Texture> read_textures(json::Reader& in);
scene::Environment read_environment(json::Reader& in);

/// @{ Members of a material, as fields of its table.
void read_json(json::Reader& in, std::string_view what, scene::TextureUses& uses);
void read_json(json::Reader& in, std::string_view what, std::optional<scene::Bump>& bump);
void write_member(json::Writer& out, std::string_view key, const scene::TextureUses& uses);
void write_member(json::Writer& out, std::string_view key, const std::optional<scene::Bump>& bump);
/// @}

/// Whether it needs the coordinates (u, v) of what has it.
inline bool has_textures(const scene::Material& material) {
  return material.textures.any() || material.bump.has_value();
}

/// Fails where a material names a texture that the stage has not. Precondition: the stage is that of the document.
void check_texture_names(const json::Document& document, const scene::Stage& stage);

void write_texture(json::Writer& out, const scene::Texture& texture);
void write_environment(json::Writer& out, const scene::Environment& environment);

}  // namespace durero::io
