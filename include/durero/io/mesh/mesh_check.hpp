#pragma once
/// The audit of the triangles of a file: what is found, where, and what mends it.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "durero/mesh/audit.hpp"
#include "durero/scene/scene.hpp"

namespace durero::io {

/// The triangles of a scene as one mesh: points that are the same are one vertex.
struct SceneMesh {
  std::vector<glm::dvec3> vertices;        ///< in the order in which triangles have them
  std::vector<mesh::CornerNumbers> faces;  ///< in the order of the scene
  std::vector<std::string> names;          ///< of the faces
  std::size_t singles = 0;                 ///< so many faces are triangles by themselves; the others are of meshes
};

/// The triangles of a scene. Elements of other types are passed over.
SceneMesh mesh_of(const scene::Scene& scene);
/// Faces by the numbers of their vertices; each is named by its own number, from 0. Throws std::out_of_range where a
/// corner is no vertex. Precondition: the vertices are finite.
SceneMesh mesh_of(std::span<const glm::dvec3> vertices, std::span<const mesh::CornerNumbers> faces);

/// Something wrong with a mesh.
struct MeshDefect {
  std::string kind;                ///< the name of the text: `abiertas`, …
  std::vector<std::string> faces;  ///< the triangles that have it
  std::vector<glm::dvec3>
      places;  ///< the points of it: a vertex, the ends of an edge, the corners of a face; or a crossing's, rounded
  std::string message;              ///< what is wrong, in words
  std::vector<std::string> mended;  ///< operations that mend it; none where none is known
};

/// A point that is asked about, and its side.
struct MeshPoint {
  glm::dvec3 place;  ///< the point
  std::string side;  ///< `inside`, `outside`, `surface`, or `none` where the triangles bound nothing
};

/// Triangles that share vertices with each other, and with no others.
struct AuditedPiece {
  std::string first;                  ///< the name of the first of them
  std::size_t faces;                  ///< how many there are
  std::optional<std::string> volume;  ///< a fraction; nothing where the piece is not closed, or its faces disagree
};

/// The findings of one kind that are not listed.
struct UnlistedFindings {
  std::string kind;   ///< the name of the text
  std::size_t count;  ///< how many there are
};

/// The findings of the triangles of a file.
struct MeshCheck {
  std::string file;                   ///< its name
  std::size_t faces, vertices;        ///< how many there are
  std::size_t pieces;                 ///< how many there are that share no vertex
  std::optional<std::string> volume;  ///< a fraction; nothing where the mesh is not closed, or its faces disagree
  std::optional<MeshPoint> point;     ///< where one was asked about
  std::vector<MeshDefect> findings;   ///< by kinds, in the order of the text
  std::vector<AuditedPiece> listed_pieces{};  ///< in the order of the triangles: all, or the first
  std::vector<UnlistedFindings> unlisted{};   ///< by kinds; none where all findings are listed
};

/// Audits a mesh that a file gave, and says the side of a point. Precondition: the point is finite.
MeshCheck check_mesh(const std::string& file, const SceneMesh& mesh,
                     const std::optional<glm::dvec3>& point = std::nullopt);

/// Leaves the first findings of each kind and the first pieces, so many of each; the others are counted.
void list_at_most(std::size_t most, MeshCheck& check);

}  // namespace durero::io
