#pragma once
/// The audit of a mesh: what spec/auditoria.tex says may be wrong with points and faces, in O(n log n) for faces of one
/// size, more or less: an edge asks the vertices near it, and a face the faces whose boxes meet its own. No tolerance
/// decides anything: points are the same where their coordinates are, and a point lies on an edge exactly or not at
/// all.

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "durero/number/rational.hpp"

namespace durero::mesh {

/// The numbers of the three vertices of a face, in the order in which they are walked.
using CornerNumbers = std::array<std::uint32_t, 3>;
/// The numbers of the two ends of an edge.
using EdgeEnds = std::array<std::uint32_t, 2>;

/// A vertex that lies between the ends of an edge.
struct TJunction {
  std::uint32_t vertex;  ///< its number
  EdgeEnds edge;         ///< the lesser number first
  auto operator<=>(const TJunction&) const = default;
};

/// Two faces that have more points in common than the corners that they share, or the edge between these.
struct CrossingFaces {
  std::array<std::uint32_t, 2> faces;  ///< the lesser number first
  /// Of the corners of what they have in common, without what they share, the first by x, y and z; each coordinate is
  /// rounded to the nearest binary64.
  glm::dvec3 place;
};

/// A vertex whose faces fall into fans that share it alone.
struct SingularVertex {
  std::uint32_t vertex;             ///< its number
  std::vector<std::uint32_t> fans;  ///< the least face of each, in ascending order; two or more
};

/// Faces that are joined to each other by shared vertices, and to no other.
struct MeshPiece {
  std::uint32_t first;  ///< the least of them
  std::size_t faces;    ///< how many there are
  /// The volume that they enclose, exact; nothing where some edge of them is open or discordant.
  std::optional<number::Rational> volume{};
};

/// The findings, each list in ascending order. The names of the text are those of model/auditoria.hpp.
struct MeshAudit {
  std::vector<EdgeEnds> open;             ///< edges of one face, the lesser number first (abiertas)
  std::vector<EdgeEnds> multiple;         ///< edges of more than two faces, likewise (multiples)
  std::vector<EdgeEnds> discordant;       ///< edges that two faces walk this way (discordes)
  std::vector<std::uint32_t> repeated;    ///< faces that have the vertices of one before (repetidas)
  std::vector<std::uint32_t> degenerate;  ///< faces whose points lie on one line (degeneradas)
  std::vector<TJunction> t_junctions;     ///< vertices between the ends of an edge (uniones_en_t)
  std::vector<CrossingFaces> crossings;   ///< faces that cut through each other, touch or overlap (cruzadas)
  std::vector<SingularVertex> singular;   ///< vertices where fans touch (singulares)
  /// For each face the least face that is joined to it by shared vertices: one number a piece (piezas).
  std::vector<std::uint32_t> piece_of;
  std::vector<MeshPiece> pieces;  ///< in the order of their least faces
  number::Rational volume;        ///< exact; what the faces enclose where they are closed (volumen)
};

/// The audit. Precondition: the vertices are finite, and each corner of a face is the number of one of them; throws
/// std::out_of_range otherwise.
MeshAudit audited(std::span<const glm::dvec3> vertices, std::span<const CornerNumbers> faces);

}  // namespace durero::mesh
