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

/// A count, and so many points, of which each outline ends with its first one.
std::vector<PointList> read_outlines(PovWords& in, std::string_view word) {
  const std::size_t at = in.offset();
  const double count = in.number(word);
  if (!(count >= 3 && count <= double(most)))
    in.fail(at, fmt::format("{} of {} points", word, count), "expected 3 to 10,000,000");
  std::vector<PointList> outlines(1);
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    in.comma();
    const glm::dvec3 point = in.triple(word);
    if (!outlines.back().empty() && point == outlines.back().front())
      outlines.emplace_back();
    else
      outlines.back().push_back(point);
  }
  if (outlines.back().empty()) outlines.pop_back();
  return outlines;
}

bool is_line(const PointList& outline) { return outline.size() < 3; }

PovShape triangle_of(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  return {scene::Triangle{{a, b, c}}};
}

double height(PovWords& in) {
  const double height = in.number("prism");
  in.comma();
  return height;
}

/// The sweep of a prism: the place of (x, z) of an outline at the height y.
glm::dvec3 swept(const glm::dvec3& point, double height, bool is_conic) {
  const double times = is_conic ? height : 1;
  return {times * point.x, height, times * point.y};
}

}  // namespace

std::optional<std::vector<PovShape>> read_pov_polygon(PovWords& in) {
  std::vector<PointList> outlines = read_outlines(in, "polygon");
  if (std::ranges::any_of(outlines, is_line)) return std::nullopt;
  const PointList border = border_of(std::move(outlines));
  const auto triangles = triangulated(border);
  if (!triangles) return std::nullopt;
  std::vector<PovShape> shapes;
  for (const auto& [a, b, c] : *triangles) shapes.push_back(triangle_of(border[a], border[b], border[c]));
  return shapes;
}

std::optional<std::vector<PovShape>> read_pov_prism(PovWords& in) {
  bool is_conic = false, is_straight = true;
  while (true) {
    if (in.take("conic_sweep"))
      is_conic = true;
    else if (in.take("linear_sweep"))
      is_conic = false;
    else if (in.take("linear_spline"))
      is_straight = true;
    else if (in.take("quadratic_spline") || in.take("cubic_spline") || in.take("bezier_spline"))
      is_straight = false;
    else
      break;
    in.comma();
  }
  const double heights[] = {height(in), height(in)};
  const std::vector<PointList> outlines = read_outlines(in, "prism");
  in.comma();
  const bool is_closed = !in.take("open");
  if (!is_straight || std::ranges::any_of(outlines, is_line)) return std::nullopt;
  std::vector<PovShape> shapes;
  const auto add = [&](const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    if (a != b && b != c && c != a) shapes.push_back(triangle_of(a, b, c));
  };
  for (const PointList& outline : outlines)
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const glm::dvec3 &one = outline[i], &next = outline[(i + 1) % outline.size()];
      const glm::dvec3 a = swept(one, heights[0], is_conic), b = swept(next, heights[0], is_conic),
                       c = swept(next, heights[1], is_conic), d = swept(one, heights[1], is_conic);
      add(a, b, c);
      add(a, c, d);
    }
  if (!is_closed) return shapes;
  const PointList border = border_of(outlines);
  const auto triangles = triangulated(border);
  if (!triangles) return std::nullopt;
  for (const double height : heights)
    for (const auto& [a, b, c] : *triangles)
      add(swept(border[a], height, is_conic), swept(border[b], height, is_conic), swept(border[c], height, is_conic));
  return shapes;
}

bool is_of_triangles(std::string_view word) {
  return word == "mesh" || word == "mesh2" || word == "polygon" || word == "prism" || word == "bicubic_patch";
}

}  // namespace durero::io
