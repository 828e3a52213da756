#include "durero/mesh/audit.hpp"

#include <algorithm>
#include <ranges>

#include "crossings.hpp"
#include "fans.hpp"
#include "joined_sets.hpp"
#include "orientation.hpp"
#include "require_vertices.hpp"
#include "vertex_tree.hpp"

namespace durero::mesh {
namespace {

using Vertices = std::span<const glm::dvec3>;
using Faces = std::span<const CornerNumbers>;

/// An edge as one face walks it.
struct EdgeWalk {
  EdgeEnds ends;       // the lesser number first
  std::uint32_t face;  // its number
  bool backwards;      // from the greater number to the lesser
  auto operator<=>(const EdgeWalk&) const = default;
};

/// The walks of all faces, each once a face, sorted. An edge from a vertex to itself is none.
std::vector<EdgeWalk> walks_of(Faces faces) {
  std::vector<EdgeWalk> walks;
  walks.reserve(3 * faces.size());
  for (std::uint32_t n = 0; n < faces.size(); ++n)
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const std::uint32_t from = faces[n][corner], to = faces[n][(corner + 1) % 3];
      if (from != to) walks.push_back({{std::min(from, to), std::max(from, to)}, n, from > to});
    }
  std::ranges::sort(walks);
  return walks;
}

/// The number of faces that walk one edge. Precondition: the walks are sorted.
std::size_t count_faces(std::span<const EdgeWalk> walks) {
  std::size_t count = 1;
  for (std::size_t i = 1; i < walks.size(); ++i) count += walks[i].face != walks[i - 1].face;
  return count;
}

/// Judges the walks of one edge.
void judge_edge(std::span<const EdgeWalk> walks, MeshAudit& audit) {
  const EdgeEnds ends = walks.front().ends;
  const std::size_t faces = count_faces(walks);
  if (faces == 1) audit.open.push_back(ends);
  if (faces > 2) audit.multiple.push_back(ends);
  const auto back = std::ranges::count(walks, true, &EdgeWalk::backwards);
  if (std::ssize(walks) - back > 1) audit.discordant.push_back(ends);
  if (back > 1) audit.discordant.push_back({ends[1], ends[0]});
}

/// Judges each edge, and leaves one walk of each.
void judge_edges(std::vector<EdgeWalk>& walks, MeshAudit& audit) {
  for (auto begin = walks.begin(); begin != walks.end();) {
    const auto end = std::find_if(begin, walks.end(), [&](const EdgeWalk& walk) { return walk.ends != begin->ends; });
    judge_edge({begin, end}, audit);
    begin = end;
  }
  std::ranges::sort(audit.discordant);
  walks.erase(
      std::unique(walks.begin(), walks.end(), [](const EdgeWalk& a, const EdgeWalk& b) { return a.ends == b.ends; }),
      walks.end());
}

/// The vertices of a face as a set: sorted, and one that stands twice is told apart from two others.
CornerNumbers as_set(CornerNumbers corners) {
  std::ranges::sort(corners);
  if (corners[0] == corners[1]) corners[1] = corners[2];
  return corners;
}

std::vector<std::uint32_t> repeated_faces(Faces faces) {
  std::vector<std::pair<CornerNumbers, std::uint32_t>> sets;
  sets.reserve(faces.size());
  for (std::uint32_t n = 0; n < faces.size(); ++n) sets.emplace_back(as_set(faces[n]), n);
  std::ranges::sort(sets);
  std::vector<std::uint32_t> found;
  for (std::size_t i = 1; i < sets.size(); ++i)
    if (sets[i].first == sets[i - 1].first) found.push_back(sets[i].second);
  std::ranges::sort(found);
  return found;
}

std::vector<std::uint32_t> used_vertices(Faces faces) {
  std::vector<std::uint32_t> used;
  used.reserve(3 * faces.size());
  for (const CornerNumbers& face : faces) used.insert(used.end(), face.begin(), face.end());
  std::ranges::sort(used);
  used.erase(std::ranges::unique(used).begin(), used.end());
  return used;
}

std::vector<TJunction> t_junctions(Vertices vertices, Faces faces, const std::vector<EdgeWalk>& edges) {
  const VertexTree tree(vertices, used_vertices(faces));
  std::vector<TJunction> found;
  for (const EdgeWalk& edge : edges) {
    const glm::dvec3 &a = vertices[edge.ends[0]], &b = vertices[edge.ends[1]];
    tree.along(a, b, [&](std::uint32_t v) {
      if (v != edge.ends[0] && v != edge.ends[1] && lies_between(vertices[v], a, b)) found.push_back({v, edge.ends});
    });
  }
  std::ranges::sort(found);
  return found;
}

std::vector<std::uint32_t> pieces(std::size_t vertex_count, Faces faces) {
  constexpr std::uint32_t none = ~0U;
  std::vector<std::uint32_t> first(vertex_count, none);  // the first face of each vertex
  JoinedSets sets(faces.size());
  for (std::uint32_t n = 0; n < faces.size(); ++n)
    for (const std::uint32_t corner : faces[n]) {
      if (first[corner] == none) first[corner] = n;
      sets.join(first[corner], n);
    }
  std::vector<std::uint32_t> piece_of(faces.size());
  for (std::uint32_t n = 0; n < faces.size(); ++n) piece_of[n] = sets.least(n);
  return piece_of;
}

/// The faces whose points lie on one line.
std::vector<std::uint32_t> degenerate_faces(Vertices vertices, Faces faces) {
  std::vector<std::uint32_t> found;
  for (std::uint32_t n = 0; n < faces.size(); ++n)
    if (are_collinear(vertices[faces[n][0]], vertices[faces[n][1]], vertices[faces[n][2]])) found.push_back(n);
  return found;
}

/// Tells the pieces apart, and adds up what each and all of them enclose. Precondition: edges and piece_of are audited.
void judge_pieces(Vertices vertices, Faces faces, MeshAudit& audit) {
  std::vector<std::uint32_t> of_face(faces.size()), of_vertex(vertices.size());  // the place of each one's piece
  std::vector<number::Dyadic> sums;                                              // six times the volume of each piece
  for (std::uint32_t n = 0; n < faces.size(); ++n) {
    if (audit.piece_of[n] == n) {
      of_face[n] = static_cast<std::uint32_t>(audit.pieces.size());
      audit.pieces.push_back({n, 0});
      sums.emplace_back();
    }
    const std::uint32_t place = of_face[n] = of_face[audit.piece_of[n]];
    ++audit.pieces[place].faces;
    sums[place] += determinant(vertices[faces[n][0]], vertices[faces[n][1]], vertices[faces[n][2]]);
    for (const std::uint32_t corner : faces[n]) of_vertex[corner] = place;
  }
  std::vector<bool> bounds(audit.pieces.size(), true);
  for (const EdgeEnds& edge : audit.open) bounds[of_vertex[edge[0]]] = false;
  for (const EdgeEnds& edge : audit.discordant) bounds[of_vertex[edge[0]]] = false;
  number::Dyadic sum;
  for (std::size_t place = 0; place < sums.size(); ++place) {
    sum += sums[place];
    if (bounds[place]) audit.pieces[place].volume = sums[place].rational() / 6;
  }
  audit.volume = sum.rational() / 6;
}

}  // namespace

MeshAudit audited(std::span<const glm::dvec3> vertices, std::span<const CornerNumbers> faces) {
  require_vertices(vertices.size(), faces);
  MeshAudit audit;
  std::vector<EdgeWalk> walks = walks_of(faces);
  judge_edges(walks, audit);
  audit.repeated = repeated_faces(faces);
  audit.degenerate = degenerate_faces(vertices, faces);
  audit.t_junctions = t_junctions(vertices, faces, walks);
  audit.crossings = crossings(vertices, faces);
  audit.singular = singular_vertices(vertices.size(), faces);
  audit.piece_of = pieces(vertices.size(), faces);
  judge_pieces(vertices, faces, audit);
  return audit;
}

}  // namespace durero::mesh
