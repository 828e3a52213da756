#include "durero/io/mesh/mesh_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <stdexcept>
#include <utility>

#include "durero/mesh/side.hpp"
#include "numbering.hpp"
#include "point_text.hpp"

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
    for (const std::uint32_t face : audit.degenerate) add_degenerate(face);
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
    out_.push_back({"discordes", names(faces), ends(edge), "these faces walk this edge the same way",
                    mended({faces.back()}, {removal(faces.back()), addition(mesh_.names[faces.back()], {j, i, k})})});
  }

  void add_repeated(std::uint32_t n) {
    out_.push_back(
        {"repetidas", names({n}), corners_of(n), "a face before has the same vertices", mended({n}, {removal(n)})});
  }

  void add_degenerate(std::uint32_t n) {
    out_.push_back({"degeneradas", names({n}), corners_of(n), "the corners of this face lie on one line",
                    mended({n}, {removal(n)})});
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

  std::vector<glm::dvec3> corners_of(std::uint32_t n) const {
    const auto [i, j, k] = mesh_.faces[n];
    return {mesh_.vertices[i], mesh_.vertices[j], mesh_.vertices[k]};
  }
  std::vector<glm::dvec3> ends(const EdgeEnds& edge) const {
    return {mesh_.vertices[edge[0]], mesh_.vertices[edge[1]]};
  }

  const SceneMesh& mesh_;
  std::vector<std::vector<std::uint32_t>> faces_;
  std::set<std::string> used_;
  std::vector<MeshDefect>& out_;
};

/// Makes one vertex of the points that are the same.
class MeshBuilder {
 public:
  void add(const std::array<glm::dvec3, 3>& corners, std::string name) {
    CornerNumbers face{};
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const glm::dvec3 p = corners[corner] + 0.0;  // so that −0 is the 0 that it equals
      const auto [number, is_new] = numbers_.number({p.x, p.y, p.z});
      if (is_new) mesh_.vertices.push_back(p);
      face[corner] = static_cast<std::uint32_t>(number);
    }
    mesh_.faces.push_back(face);
    mesh_.names.push_back(std::move(name));
  }
  SceneMesh mesh() && { return std::move(mesh_); }

 private:
  SceneMesh mesh_;
  Numbering<std::array<double, 3>> numbers_;
};

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

}  // namespace

SceneMesh mesh_of(const scene::Scene& scene) {
  MeshBuilder builder;
  const scene::Triangles triangles = scene.shapes<scene::Triangle>();
  for (std::uint32_t n = 0; n < triangles.size(); ++n)
    builder.add(triangles[n].vertices, scene.name({scene::Triangle::tipo, n}).name());
  SceneMesh mesh = std::move(builder).mesh();
  mesh.singles = scene.singles<scene::Triangle>().size();
  return mesh;
}

SceneMesh mesh_of(std::span<const glm::dvec3> vertices, std::span<const CornerNumbers> faces) {
  MeshBuilder builder;
  for (std::size_t n = 0; n < faces.size(); ++n) {
    const auto [i, j, k] = faces[n];
    if (std::max({i, j, k}) >= vertices.size()) throw std::out_of_range("a face names a vertex that there is not");
    builder.add({vertices[i], vertices[j], vertices[k]}, fmt::to_string(n));
  }
  SceneMesh mesh = std::move(builder).mesh();
  mesh.singles = faces.size();
  return mesh;
}

MeshCheck check_mesh(const std::string& file, const SceneMesh& mesh, const std::optional<glm::dvec3>& point) {
  const mesh::MeshAudit audit = mesh::audited(mesh.vertices, mesh.faces);
  MeshCheck check{file, mesh.faces.size(), mesh.vertices.size(), audit.pieces.size(), std::nullopt, std::nullopt, {}};
  MeshFindings(mesh, check.findings).add(audit);
  if (audit.open.empty() && audit.discordant.empty()) check.volume = audit.volume.str();
  if (point) check.point = {*point, side_name(mesh::side_of(mesh.vertices, mesh.faces, *point))};
  for (const mesh::MeshPiece& piece : audit.pieces) {
    AuditedPiece& listed = check.listed_pieces.emplace_back(AuditedPiece{mesh.names[piece.first], piece.faces, {}});
    if (piece.volume) listed.volume = piece.volume->str();
  }
  return check;
}

void list_at_most(std::size_t most, MeshCheck& check) {
  std::vector<MeshDefect> listed;
  std::size_t of_kind = 0;
  for (MeshDefect& finding : check.findings) {
    of_kind = !listed.empty() && listed.back().kind == finding.kind ? of_kind + 1 : 1;
    if (of_kind <= most) {
      listed.push_back(std::move(finding));
    } else if (check.unlisted.empty() || check.unlisted.back().kind != finding.kind) {
      check.unlisted.push_back({finding.kind, 1});
    } else {
      ++check.unlisted.back().count;
    }
  }
  check.findings = std::move(listed);
  if (check.listed_pieces.size() > most) check.listed_pieces.resize(most);
}

}  // namespace durero::io
