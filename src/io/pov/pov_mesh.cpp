#include "pov_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "io/mesh/triangulation.hpp"

namespace durero::io {
namespace {

constexpr std::size_t most = 10'000'000;  // entries of a list

/// { count, entry, entry, … }, each by read().
template <class Read>
void read_list(PovWords& in, std::string_view word, Read read) {
  in.expect("{", fmt::format("behind {}", word));
  const std::size_t at = in.offset();
  const double count = in.number(word);
  if (!(count >= 0 && count <= double(most)))
    in.fail(at, fmt::format("{} of {} entries", word, count), "expected 0 to 10,000,000");
  in.comma();
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    read();
    in.comma();
  }
  in.expect("}", fmt::format("behind the entries of {}", word));
}

PovMesh::Corners corners(PovWords& in, std::size_t vertices) {
  const std::size_t at = in.offset();
  const glm::dvec3 numbers = in.triple("face_indices");
  PovMesh::Corners corners{};
  for (int k = 0; k < 3; ++k) {
    if (!(numbers[k] >= 0 && numbers[k] < double(vertices)))
      in.fail(at, fmt::format("a face with the vertex {}", numbers[k]),
              fmt::format("expected 0 to {}", double(vertices) - 1));
    corners[static_cast<std::size_t>(k)] = static_cast<std::uint32_t>(numbers[k]);
  }
  return corners;
}

}  // namespace

PovMesh read_pov_mesh(PovWords& in) {
  PovMesh mesh;
  while (true) {
    if (in.take("vertex_vectors")) {
      read_list(in, "vertex_vectors", [&] { mesh.vertices.push_back(in.triple("vertex_vectors")); });
    } else if (in.take("normal_vectors")) {
      read_list(in, "normal_vectors", [&] { mesh.normals.push_back(in.triple("normal_vectors")); });
    } else if (in.take("face_indices")) {
      read_list(in, "face_indices", [&] {
        mesh.faces.push_back(corners(in, mesh.vertices.size()));
        // The numbers of its textures, each a number alone.
        for (in.comma(); in.here() != nullptr && in.here()->is_number(); in.comma()) in.number("face_indices");
      });
    } else if (in.take("normal_indices")) {
      read_list(in, "normal_indices", [&] { mesh.faces_of_normals.push_back(corners(in, mesh.normals.size())); });
    } else if (in.word() == "uv_vectors" || in.word() == "uv_indices" || in.word() == "texture_list") {
      ++mesh.left_out;
      in.pass();
      in.expect("{", "behind a list of mesh2");
      in.skip_block();
    } else {
      return mesh;
    }
  }
}

std::vector<PovShape> PovMesh::triangles() const {
  std::vector<PovShape> all;
  all.reserve(faces.size());
  const bool by_vertex = normals.size() == vertices.size() && faces_of_normals.empty();
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const auto [a, b, c] = faces[i];
    PovShape shape{scene::Triangle{{vertices[a], vertices[b], vertices[c]}}};
    const bool has_own = i < faces_of_normals.size();
    if (has_own || (by_vertex && !normals.empty())) {
      const auto [l, m, n] = has_own ? faces_of_normals[i] : faces[i];
      const scene::VertexNormals of_corners{normals[l], normals[m], normals[n]};
      if (scene::have_directions(of_corners)) shape.normals = of_corners;
    }
    all.push_back(std::move(shape));
  }
  return all;
}

namespace {

using PointList = std::vector<glm::dvec3>;

/// Twice the area of an outline, across it.
glm::dvec3 area_of(const PointList& outline) {
  glm::dvec3 sum(0);
  for (std::size_t i = 1; i + 1 < outline.size(); ++i)
    sum += glm::cross(outline[i] - outline[0], outline[i + 1] - outline[0]);
  return sum;
}

/// One border around the first outline, which goes to each of the others by a seam and around it the other way. An area
/// so small that rounding turns it makes a polygon that is refused.
PointList border_of(std::vector<PointList> outlines) {
  const glm::dvec3 start = outlines[0][0], area = area_of(outlines[0]);
  PointList border = outlines[0];
  for (std::size_t i = 1; i < outlines.size(); ++i) {
    PointList& hole = outlines[i];
    if (glm::dot(area_of(hole), area) > 0) std::ranges::reverse(hole);
    border.push_back(start);
    border.insert(border.end(), hole.begin(), hole.end());
    border.push_back(hole.front());
  }
  return border;
}

}  // namespace

std::optional<std::vector<PovShape>> read_pov_polygon(PovWords& in) {
  const std::size_t at = in.offset();
  const double count = in.number("polygon");
  if (!(count >= 3 && count <= double(most)))
    in.fail(at, fmt::format("polygon of {} points", count), "expected 3 to 10,000,000");
  std::vector<PointList> outlines(1);
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    in.comma();
    const glm::dvec3 point = in.triple("polygon");
    if (!outlines.back().empty() && point == outlines.back().front())  // an outline ends where it begins
      outlines.emplace_back();
    else
      outlines.back().push_back(point);
  }
  if (outlines.back().empty()) outlines.pop_back();
  if (std::ranges::any_of(outlines, [](const PointList& outline) { return outline.size() < 3; })) return std::nullopt;
  const PointList border = border_of(std::move(outlines));
  const auto triangles = triangulated(border);
  if (!triangles) return std::nullopt;
  std::vector<PovShape> shapes;
  for (const auto& [a, b, c] : *triangles) shapes.push_back({scene::Triangle{{border[a], border[b], border[c]}}});
  return shapes;
}

bool is_of_triangles(std::string_view word) { return word == "mesh" || word == "mesh2" || word == "polygon"; }

}  // namespace durero::io
