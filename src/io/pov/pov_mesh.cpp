#include "pov_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>

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

std::optional<std::vector<PovShape>> read_pov_polygon(PovWords& in) {
  const std::size_t at = in.offset();
  const double count = in.number("polygon");
  if (!(count >= 3 && count <= double(most)))
    in.fail(at, fmt::format("polygon of {} points", count), "expected 3 to 10,000,000");
  std::vector<glm::dvec3> outline;
  bool is_closed = false, is_one = true;
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    in.comma();
    const glm::dvec3 point = in.triple("polygon");
    is_one &= !is_closed;
    is_closed |= !outline.empty() && point == outline.front();  // an outline ends where it begins
    if (!is_closed) outline.push_back(point);
  }
  if (!is_one || outline.size() < 3) return std::nullopt;
  const auto triangles = triangulated(outline);
  if (!triangles) return std::nullopt;
  std::vector<PovShape> shapes;
  for (const auto& [a, b, c] : *triangles) shapes.push_back({scene::Triangle{{outline[a], outline[b], outline[c]}}});
  return shapes;
}

bool is_of_triangles(std::string_view word) { return word == "mesh" || word == "mesh2" || word == "polygon"; }

}  // namespace durero::io
