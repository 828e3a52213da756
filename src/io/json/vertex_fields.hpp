#pragma once
/// The looks of a triangle's vertices, in scene files: how textures lie on it (`uv`, `tangents`), and `normals`.

#include <array>
#include <optional>
#include <string_view>

#include "durero/io/json/json.hpp"
#include "durero/io/json/json_writer.hpp"
#include "durero/scene/scene.hpp"

namespace durero::io {

/// The keys of an element that only a triangle may have: the second only with the first.
inline constexpr std::array<std::string_view, 3> vertex_keys{"uv", "tangents", "normals"};

/// `[u,v]` of a vertex
glm::dvec2 read_vertex_uv(json::Reader& in);
/// The normal of a vertex, three numbers, not all 0
glm::dvec3 read_vertex_normal(json::Reader& in);
/// `[[u,v],[u,v],[u,v]]`
std::array<glm::dvec2, 3> read_uv(json::Reader& in);
/// `[[t_u,t_v],[t_u,t_v],[t_u,t_v]]`, each three numbers
std::array<scene::VertexTangents, 3> read_vertex_tangents(json::Reader& in);
/// `[n,n,n]`, each three numbers, not all 0
scene::VertexNormals read_vertex_normals(json::Reader& in);
/// The members of an element that say them; none if it has none.
void write_vertex_looks(json::Writer& out, const scene::Scene& scene, scene::ElementRef element);

}  // namespace durero::io
