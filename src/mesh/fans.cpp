#include "fans.hpp"

#include <algorithm>
#include <numeric>

#include "joined_sets.hpp"

namespace durero::mesh {
namespace {

/// A face at a vertex, and another vertex that it has.
struct Spoke {
  std::uint32_t other, place;  // the place of the face among those of the vertex
  auto operator<=>(const Spoke&) const = default;
};

/// The faces of each vertex, each once, in ascending order: those of vertex v stand from starts[v] to starts[v + 1].
struct FacesOfVertices {
  std::vector<std::size_t> starts;
  std::vector<std::uint32_t> faces;
  std::span<const std::uint32_t> of(std::uint32_t v) const {
    return std::span(faces).subspan(starts[v], starts[v + 1] - starts[v]);
  }
};

bool is_first(const CornerNumbers& face, std::size_t corner) {
  return std::find(face.begin(), face.begin() + corner, face[corner]) == face.begin() + corner;
}

FacesOfVertices faces_of_vertices(std::size_t vertex_count, std::span<const CornerNumbers> faces) {
  FacesOfVertices found{std::vector<std::size_t>(vertex_count + 1), {}};
  for (const CornerNumbers& face : faces)
    for (std::size_t corner = 0; corner < 3; ++corner) found.starts[face[corner] + 1] += is_first(face, corner);
  std::inclusive_scan(found.starts.begin(), found.starts.end(), found.starts.begin());
  found.faces.resize(found.starts.back());
  std::vector<std::size_t> next = found.starts;
  for (std::uint32_t n = 0; n < faces.size(); ++n)
    for (std::size_t corner = 0; corner < 3; ++corner)
      if (is_first(faces[n], corner)) found.faces[next[faces[n][corner]]++] = n;
  return found;
}

/// The least face of each fan: faces that have another vertex in common are joined.
std::vector<std::uint32_t> fans_of(std::uint32_t v, std::span<const std::uint32_t> numbers,
                                   std::span<const CornerNumbers> faces, std::vector<Spoke>& spokes) {
  spokes.clear();
  for (std::uint32_t place = 0; place < numbers.size(); ++place)
    for (const std::uint32_t corner : faces[numbers[place]])
      if (corner != v) spokes.push_back({corner, place});
  std::ranges::sort(spokes);
  JoinedSets sets(numbers.size());
  for (std::size_t i = 1; i < spokes.size(); ++i)
    if (spokes[i].other == spokes[i - 1].other) sets.join(spokes[i].place, spokes[i - 1].place);
  std::vector<std::uint32_t> fans;
  for (std::uint32_t place = 0; place < numbers.size(); ++place)
    if (sets.least(place) == place) fans.push_back(numbers[place]);
  return fans;
}

}  // namespace

std::vector<SingularVertex> singular_vertices(std::size_t vertex_count, std::span<const CornerNumbers> faces) {
  const FacesOfVertices of_vertices = faces_of_vertices(vertex_count, faces);
  std::vector<SingularVertex> found;
  std::vector<Spoke> spokes;
  for (std::uint32_t v = 0; v < vertex_count; ++v)
    if (std::vector<std::uint32_t> fans = fans_of(v, of_vertices.of(v), faces, spokes); fans.size() > 1)
      found.push_back({v, std::move(fans)});
  return found;
}

}  // namespace durero::mesh
