#include "mesh_fields.hpp"

#include <fmt/format.h>

#include <array>
#include <limits>

#include "durero/io/json/whole_number.hpp"
#include "durero/model/malla.hpp"
#include "durero/model/operaciones.hpp"
#include "durero/scene/attributes.hpp"
#include "durero/scene/mesh_edit.hpp"
#include "durero/scene/stage.hpp"
#include "durero/text/shown.hpp"
#include "durero/text/spanish.hpp"
#include "vertex_fields.hpp"

namespace durero::io {
namespace {

enum class MeshKey : std::size_t { id, puntos, caras, material, normals, uv };
constexpr std::string_view mesh_keys[] = {"id", "puntos", "caras", "material", "normals", "uv"};
constexpr std::size_t required_mesh_keys = 3;

/// Fails where there are looks, and not one for each point.
template <class Look>
void require_one_each(const json::Reader& in, std::string_view what, const std::optional<Placed<Look>>& looks,
                      std::size_t points) {
  if (looks && looks->value.size() != points)
    in.fail(looks->offset, fmt::format("{} has {} items", what, looks->value.size()),
            fmt::format("expected one for each of {} points", points));
}

/// Calls visit(offset, face) at each face of the mesh that stands at `at`.
template <class Visit>
void for_each_face(const json::Reader& at, Visit&& visit) {
  json::Reader in = at.member("caras").value();
  in.array("caras", [&] {
    const std::size_t offset = in.offset();
    visit(offset, read_face(in, "caras"));
  });
}

/// Fails at the first face that names no point.
void fail_incomplete(const json::Reader& at, std::size_t points) {
  for_each_face(at, [&](std::size_t offset, const model::Cara& face) {
    for (const model::Ordinal n : {face.i, face.j, face.k})
      if (n >= points)
        at.fail(offset, fmt::format("a face has point {} of {}", n, points),
                fmt::format("expected {} ({})", model::Completa_inv_1.predicate, model::Completa_inv_1.label),
                &model::Completa_inv_1);
  });
}

/// Fails at the first face that is a line.
void fail_aligned(const json::Reader& at, const scene::MeshPoints& points) {
  for_each_face(at, [&](std::size_t offset, const model::Cara& face) {
    if (!model::Vertices::contains(
            scene::input_of<model::Terna>(scene::Corners{points[face.i], points[face.j], points[face.k]})))
      at.fail(offset, "a face has three points on one line",
              fmt::format("expected the corners of a triangle ({})", model::Malla_inv_1.label), &model::Malla_inv_1);
  });
}

}  // namespace

model::Cara read_face(json::Reader& in, std::string_view what) {
  constexpr std::int64_t most = std::numeric_limits<model::Ordinal>::max();
  const auto numbers = in.three<std::int64_t>(what, "expected the numbers of three points", [&] {
    return json::whole_number(in, what, 0, most, "the number of a point, from 0");
  });
  const auto ordinal = [&](std::size_t i) { return static_cast<model::Ordinal>(numbers[i]); };
  return {ordinal(0), ordinal(1), ordinal(2)};
}

FileMesh read_mesh(json::Reader& in) {
  FileMesh read{scene::Mesh{model::Elemento("-")}};
  std::optional<Placed<std::vector<glm::dvec3>>> of_normals;
  std::optional<Placed<std::vector<glm::dvec2>>> of_uv;
  scene::Mesh& mesh = read.mesh;
  in.object("a mesh", mesh_keys, required_mesh_keys, [&](std::size_t key) {
    switch (static_cast<MeshKey>(key)) {
      case MeshKey::id:
        mesh.m = model::Elemento(std::string(read_id(in)));
        return;
      case MeshKey::puntos:
        return in.array("puntos", [&] { mesh.puntos.push_back(in.vec3("puntos")); });
      case MeshKey::caras:
        return in.array("caras", [&] { mesh.caras.push_back(read_face(in, "caras")); });
      case MeshKey::material: {
        const std::size_t at = in.offset();
        read.material = {in.string("material"), at};
        return;
      }
      case MeshKey::normals:
        of_normals.emplace(std::vector<glm::dvec3>(), in.key_offset());
        return in.array("normals", [&] { of_normals->value.push_back(read_vertex_normal(in)); });
      case MeshKey::uv:
        of_uv.emplace(std::vector<glm::dvec2>(), in.key_offset());
        return in.array("uv", [&] { of_uv->value.push_back(read_vertex_uv(in)); });
    }
  });
  require_one_each(in, "normals", of_normals, mesh.puntos.size());
  require_one_each(in, "uv", of_uv, mesh.puntos.size());
  if (of_normals) mesh.normals = std::move(of_normals->value);
  if (of_uv) mesh.uv = std::move(of_uv->value);
  return read;
}

void add_mesh(const json::Reader& at, scene::Scene& scene, scene::Mesh mesh) {
  const model::Answer answer = scene.apply_total(scene::MeshAddition{std::move(mesh)});
  if (answer.ok()) return;
  json::Reader again = at;  // only a mesh that is refused is read twice
  const scene::Mesh refused = read_mesh(again).mesh;
  if (answer.r == model::Respuesta::cara_incompleta) fail_incomplete(at, refused.puntos.size());
  if (answer.r == model::Respuesta::vertices_alineados) fail_aligned(at, refused.puntos);
  at.fail(at.member("id")->offset(),
          fmt::format("id is {}: {}", text::shown(refused.m.name()), text::with_english(model::name(answer.r))),
          fmt::format("expected {} ({})", answer.violated->predicate, answer.violated->label), answer.violated);
}

void write_mesh(json::Writer& out, const scene::Mesh& mesh, const scene::Stage& stage) {
  out.begin_object().member("id", mesh.m.name());
  if (mesh.material != scene::no_material) out.member("material", stage.materials[mesh.material].name);
  out.key("puntos").begin_array();
  for (const glm::dvec3 p : mesh.puntos) out.new_line().value(p);
  out.end_array().key("caras").begin_array();
  for (const auto [i, j, k] : mesh.caras)
    out.new_line().begin_array().value(std::uint64_t{i}).value(std::uint64_t{j}).value(std::uint64_t{k}).end_array();
  out.end_array();
  if (!mesh.normals.empty()) {
    out.key("normals").begin_array();
    for (const glm::dvec3& n : mesh.normals) out.new_line().value(n);
    out.end_array();
  }
  if (!mesh.uv.empty()) {
    out.key("uv").begin_array();
    for (const glm::dvec2& at : mesh.uv) out.new_line().begin_array().value(at.x).value(at.y).end_array();
    out.end_array();
  }
  out.end_object();
}

}  // namespace durero::io
