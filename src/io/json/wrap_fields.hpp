#pragma once
/// How textures lie on a triangle, in scene files: `uv` and `tangents` of its vertices.

#include <array>
#include <string_view>

#include "durero/io/json/json.hpp"
#include "durero/io/json/json_writer.hpp"
#include "durero/scene/wrap.hpp"

namespace durero::io {

/// The keys of an element that only a triangle may have: the second only with the first.
inline constexpr std::array<std::string_view, 2> wrap_keys{"uv", "tangents"};

/// `[[u,v],[u,v],[u,v]]`
std::array<glm::dvec2, 3> read_uv(json::Reader& in);
/// `[[t_u,t_v],[t_u,t_v],[t_u,t_v]]`, each three numbers
std::array<scene::VertexTangents, 3> read_vertex_tangents(json::Reader& in);
/// The members of an element that say it.
void write_wrap(json::Writer& out, const scene::Wrap& wrap);

}  // namespace durero::io
