#include "vertex_fields.hpp"

#include "two.hpp"

namespace durero::io {

glm::dvec2 read_vertex_uv(json::Reader& in) {
  const std::string_view what = vertex_keys[0];
  const auto [u, v] = read_two<double>(in, what, "expected two numbers, u and v", [&] { return in.number(what); });
  return {u, v};
}

glm::dvec3 read_vertex_normal(json::Reader& in) {
  const std::size_t at = in.offset();
  const glm::dvec3 normal = in.vec3(vertex_keys[2]);
  if (normal == glm::dvec3(0)) in.fail(at, "a normal is (0, 0, 0)", "expected a direction of any length but 0");
  return normal;
}

std::array<glm::dvec2, 3> read_uv(json::Reader& in) {
  return in.three<glm::dvec2>(vertex_keys[0], "expected [u,v] of three vertices", [&] { return read_vertex_uv(in); });
}

std::array<scene::VertexTangents, 3> read_vertex_tangents(json::Reader& in) {
  const std::string_view what = vertex_keys[1];
  return in.three<scene::VertexTangents>(what, "expected two tangents of three vertices", [&] {
    return read_two<glm::dvec3>(in, what, "expected two tangents, along u and v", [&] { return in.vec3(what); });
  });
}

scene::VertexNormals read_vertex_normals(json::Reader& in) {
  return in.three<glm::dvec3>(vertex_keys[2], "expected the normals of three vertices",
                              [&] { return read_vertex_normal(in); });
}

namespace {

void write_wrap(json::Writer& out, const scene::Wrap& wrap) {
  out.key(vertex_keys[0]).begin_array();
  for (const glm::dvec2& uv : wrap.uv) out.begin_array().value(uv.x).value(uv.y).end_array();
  out.end_array();
  if (!wrap.tangents) return;
  out.key(vertex_keys[1]).begin_array();
  for (const auto& [along_u, along_v] : *wrap.tangents) out.begin_array().value(along_u).value(along_v).end_array();
  out.end_array();
}

}  // namespace

void write_vertex_looks(json::Writer& out, const scene::Scene& scene, scene::ElementRef element) {
  if (const auto wrap = scene.wrap(element)) write_wrap(out, *wrap);
  if (const auto normals = scene.vertex_normals(element)) {
    out.key(vertex_keys[2]).begin_array();
    for (const glm::dvec3& normal : *normals) out.value(normal);
    out.end_array();
  }
}

}  // namespace durero::io
