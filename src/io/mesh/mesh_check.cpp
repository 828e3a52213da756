#include "durero/io/mesh/mesh_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "durero/io/json/json_writer.hpp"
#include "durero/io/number_text.hpp"
#include "durero/mesh/side.hpp"
#include "durero/text/shown.hpp"
#include "numbering.hpp"

namespace durero::io {
namespace {

using mesh::CornerNumbers;
using mesh::EdgeEnds;

/// The faces of each vertex.
std::vector<std::vector<std::uint32_t>> faces_of_vertices(const SceneMesh& mesh) {
  std::vector<std::vector<std::uint32_t>> faces(mesh.vertices.size());
  for (std::uint32_t n = 0; n < mesh.faces.size(); ++n)
    for (const std::uint32_t corner : mesh.faces[n]) faces[corner].push_back(n);
  return faces;
}

bool walks(const CornerNumbers& face, std::uint32_t from, std::uint32_t to) {
  return (face[0] == from && face[1] == to) || (face[1] == from && face[2] == to) || (face[2] == from && face[0] == to);
}

std::string point_text(const glm::dvec3& p) {
  return fmt::format("({},{},{})", number_text(p.x), number_text(p.y), number_text(p.z));
}

/// Writes the findings of one mesh.
class MeshFindings {
 public:
  MeshFindings(const SceneMesh& mesh, std::vector<MeshDefect>& out)
      : mesh_(mesh), faces_(faces_of_vertices(mesh)), out_(out) {}

  void add(const mesh::MeshAudit& audit) {
    for (const EdgeEnds& edge : audit.open) add_edge("abiertas", edge, "one face alone has this edge");
    for (const EdgeEnds& edge : audit.multiple) add_edge("multiples", edge, "more than two faces have this edge");
    for (const EdgeEnds& edge : audit.discordant) add_discordant(edge);
    for (const std::uint32_t face : audit.repeated) add_repeated(face);
    for (const mesh::TJunction& junction : audit.t_junctions) add_junction(junction);
    for (const mesh::CrossingFaces& crossing : audit.crossings) add_crossing(crossing);
    for (const mesh::SingularVertex& singular : audit.singular) add_singular(singular);
  }

 private:
  std::vector<std::uint32_t> faces_with(const EdgeEnds& edge, bool both_ways) const {
    std::vector<std::uint32_t> found;
    for (const std::uint32_t n : faces_[edge[0]])
      if (walks(mesh_.faces[n], edge[0], edge[1]) || (both_ways && walks(mesh_.faces[n], edge[1], edge[0])))
        found.push_back(n);
    return found;
  }

  std::vector<std::string> names(const std::vector<std::uint32_t>& faces) const {
    std::vector<std::string> all;
    for (const std::uint32_t n : faces) all.push_back(mesh_.names[n]);
    return all;
  }

  /// The operations, where each face is a triangle by itself: a face of a mesh is not edited alone.
  std::vector<std::string> mended(const std::vector<std::uint32_t>& faces, std::vector<std::string> operations) const {
    const bool are_single = std::ranges::all_of(faces, [&](std::uint32_t n) { return n < mesh_.singles; });
    return are_single ? std::move(operations) : std::vector<std::string>();
  }
  std::string removal(std::uint32_t n) const { return "Eliminar_Triangulo e?=" + mesh_.names[n]; }
  std::string addition(const std::string& name, const CornerNumbers& corners) const {
    return fmt::format("Agregar_Triangulo e?={} vertices?=({},{},{})", name, point_text(mesh_.vertices[corners[0]]),
                       point_text(mesh_.vertices[corners[1]]), point_text(mesh_.vertices[corners[2]]));
  }

  void add_edge(const char* kind, const EdgeEnds& edge, const char* message) {
    out_.push_back({kind, names(faces_with(edge, true)), ends(edge), message, {}});
  }

  /// The last of the faces is turned over.
  void add_discordant(const EdgeEnds& edge) {
    const std::vector<std::uint32_t> faces = faces_with(edge, false);
    const auto [i, j, k] = mesh_.faces[faces.back()];
    out_.push_back({"discordes",
                    names(faces),
                    ends(edge),
                    "these faces walk this edge the same way",
                    mended({faces.back()}, {removal(faces.back()), addition(mesh_.names[faces.back()], {j, i, k})})});
  }

  void add_repeated(std::uint32_t n) {
    std::vector<glm::dvec3> corners;
    for (const std::uint32_t corner : mesh_.faces[n]) corners.push_back(mesh_.vertices[corner]);
    out_.push_back({"repetidas", names({n}), corners, "a face before has the same vertices", mended({n}, {removal(n)})});
  }

  /// Each face that has the edge is cut in two at the vertex; the second part has a name of its own. A face that would
  /// have no area left is none: its vertices are not on one line.
  void add_junction(const mesh::TJunction& junction) {
    const std::vector<std::uint32_t> faces = faces_with(junction.edge, true);
    MeshDefect defect{"uniones_en_t",
                      names(faces),
                      {mesh_.vertices[junction.vertex]},
                      "a vertex of other faces lies within this edge",
                      {}};
    for (const glm::dvec3& end : ends(junction.edge)) defect.places.push_back(end);
    for (const std::uint32_t n : faces) {
      CornerNumbers first = mesh_.faces[n], second = first;
      std::ranges::replace(first, junction.edge[0], junction.vertex);
      std::ranges::replace(second, junction.edge[1], junction.vertex);
      defect.mended.push_back(removal(n));
      defect.mended.push_back(addition(mesh_.names[n], first));
      defect.mended.push_back(addition(unused_name(mesh_.names[n]), second));
    }
    defect.mended = mended(faces, std::move(defect.mended));
    out_.push_back(std::move(defect));
  }

  void add_crossing(const mesh::CrossingFaces& crossing) {
    out_.push_back({"cruzadas",
                    names({crossing.faces.begin(), crossing.faces.end()}),
                    {crossing.place},
                    "these faces meet in more than the corners that they share",
                    {}});
  }

  void add_singular(const mesh::SingularVertex& singular) {
    out_.push_back({"singulares",
                    names(singular.fans),
                    {mesh_.vertices[singular.vertex]},
                    "the fans of these faces touch in this vertex alone",
                    {}});
  }

  std::string unused_name(const std::string& name) {
    if (used_.empty()) used_.insert(mesh_.names.begin(), mesh_.names.end());
    for (std::size_t n = 2;; ++n)
      if (std::string made = fmt::format("{}.{}", name, n); used_.insert(made).second) return made;
  }

  std::vector<glm::dvec3> ends(const EdgeEnds& edge) const {
    return {mesh_.vertices[edge[0]], mesh_.vertices[edge[1]]};
  }

  const SceneMesh& mesh_;
  std::vector<std::vector<std::uint32_t>> faces_;
  std::set<std::string> used_;
  std::vector<MeshDefect>& out_;
};

template <class Values, class Text>
std::string listed(const Values& values, const char* between, const Text& text) {
  std::string all;
  for (const auto& value : values) all += (all.empty() ? "" : between) + text(value);
  return all;
}

std::string line_of(const MeshDefect& defect) {
  const auto same = [](const std::string& text) { return text; };
  std::string line = fmt::format("{}: {}: {}: {}", defect.kind, listed(defect.faces, ", ", same),
                                 listed(defect.places, " ", point_text), defect.message);
  if (!defect.mended.empty()) line += "; mended by " + listed(defect.mended, ", then ", same);
  return line + '\n';
}

void write_texts(json::Writer& out, std::string_view name, const std::vector<std::string>& texts) {
  out.key(name).begin_array();
  for (const std::string& text : texts) out.value(text);
  out.end_array();
}

void write_defect(json::Writer& out, const MeshDefect& defect) {
  out.new_line().begin_object().member("kind", defect.kind);
  write_texts(out, "faces", defect.faces);
  out.key("places").begin_array();
  for (const glm::dvec3& place : defect.places) out.value(place);
  out.end_array().member("message", defect.message);
  write_texts(out, "mended", defect.mended);
  out.end_object();
}

std::string side_name(const std::optional<mesh::Side>& side) {
  if (!side) return "none";
  switch (*side) {
    case mesh::Side::inside:
      return "inside";
    case mesh::Side::outside:
      return "outside";
    case mesh::Side::on_surface:
      return "surface";
  }
  return "none";
}

std::string point_line(const MeshPoint& point) {
  const std::string side = point.side == "none"      ? "on no side, as the triangles bound nothing"
                           : point.side == "surface" ? "on the surface"
                                                     : point.side;
  return fmt::format("{}: {}\n", point_text(point.place), side);
}

}  // namespace

SceneMesh mesh_of(const scene::Scene& scene) {
  SceneMesh mesh;
  Numbering<std::array<double, 3>> numbers;
  const scene::Triangles triangles = scene.shapes<scene::Triangle>();
  mesh.singles = scene.singles<scene::Triangle>().size();
  for (std::uint32_t n = 0; n < triangles.size(); ++n) {
    CornerNumbers face{};
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const glm::dvec3 p = triangles[n].vertices[corner] + 0.0;  // so that −0 is the 0 that it equals
      const auto [number, is_new] = numbers.number({p.x, p.y, p.z});
      if (is_new) mesh.vertices.push_back(p);
      face[corner] = static_cast<std::uint32_t>(number);
    }
    mesh.faces.push_back(face);
    mesh.names.push_back(scene.name({scene::Triangle::tipo, n}).name());
  }
  return mesh;
}

MeshCheck check_mesh(const std::string& file, const scene::Scene& scene, const std::optional<glm::dvec3>& point) {
  const SceneMesh mesh = mesh_of(scene);
  mesh::MeshAudit audit = mesh::audited(mesh.vertices, mesh.faces);
  MeshCheck check{file, mesh.faces.size(), mesh.vertices.size(), 0, std::nullopt, std::nullopt, {}};
  MeshFindings(mesh, check.findings).add(audit);
  if (audit.open.empty() && audit.discordant.empty()) check.volume = audit.volume.str();
  if (point) check.point = {*point, side_name(mesh::side_of(mesh.vertices, mesh.faces, *point))};
  std::ranges::sort(audit.piece_of);
  check.pieces = audit.piece_of.size() - std::ranges::unique(audit.piece_of).size();
  return check;
}

std::string mesh_check_text(const MeshCheck& check) {
  std::string text =
      fmt::format("{}: {} triangles, {} vertices, {}, volume {}\n", text::escaped(check.file), check.faces,
                  check.vertices, check.pieces == 1 ? "1 piece" : fmt::format("{} pieces", check.pieces),
                  check.volume.value_or("none, as they bound none"));
  if (check.point) text += point_line(*check.point);
  for (const MeshDefect& defect : check.findings) text += line_of(defect);
  return text;
}

std::string mesh_check_json(const MeshCheck& check) {
  std::string text;
  json::Writer out(text);
  write_version(out.begin_object(), mesh_check_format);
  out.member("file", text::escaped(check.file)).member("ok", check.findings.empty());
  out.member("triangles", std::uint64_t{check.faces}).member("vertices", std::uint64_t{check.vertices});
  out.member("pieces", std::uint64_t{check.pieces});
  if (check.volume) out.member("volume", *check.volume);
  if (check.point)
    out.key("point").begin_object().member("place", check.point->place).member("side", check.point->side).end_object();
  out.key("findings").begin_array();
  for (const MeshDefect& defect : check.findings) write_defect(out, defect);
  out.end_array().end_object();
  return text + '\n';
}

}  // namespace durero::io
