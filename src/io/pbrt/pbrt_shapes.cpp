#include "pbrt_shapes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>

#include "durero/io/file_name.hpp"
#include "durero/io/json/whole_number.hpp"
#include "durero/number/dyadic.hpp"
#include "durero/text/shown.hpp"
#include "io/losses.hpp"

namespace durero::io {
namespace {

using number::Dyadic;
using ExactWay = std::array<Dyadic, 3>;

bool goes_round(const PbrtParameters& parameters) { return parameters.number("phimax", 360) >= 360; }

/// The points of a parameter, three numbers each.
std::vector<glm::dvec3> points_of(const PbrtPlace& at, const PbrtParameters& parameters, std::string_view name) {
  const PbrtParameter* const told = parameters.find(name);
  if (told == nullptr) at.fail(fmt::format("a mesh without {}", name), "expected its points");
  if (told->numbers.size() % 3 != 0)
    told->place.fail(fmt::format("{} of {} numbers", name, told->numbers.size()), "expected three for each point");
  std::vector<glm::dvec3> points;
  for (std::size_t i = 0; i + 2 < told->numbers.size(); i += 3)
    points.emplace_back(told->numbers[i], told->numbers[i + 1], told->numbers[i + 2]);
  return points;
}

/// The numbers of the corners of faces, so many each. Without `indices` there is one face, of all points.
std::vector<std::size_t> corners_of_faces(const PbrtPlace& at, const PbrtParameters& parameters, std::size_t points,
                                          std::size_t corners) {
  const PbrtParameter* const told = parameters.find("indices");
  if (told == nullptr) {
    if (points != corners) at.fail("a mesh without indices", fmt::format("expected them, or {} points", corners));
    std::vector<std::size_t> all;
    for (std::size_t i = 0; i < corners; ++i) all.push_back(i);
    return all;
  }
  if (told->numbers.size() % corners != 0)
    told->place.fail(fmt::format("indices of {} numbers", told->numbers.size()),
                     fmt::format("expected {} for each face", corners));
  std::vector<std::size_t> made;
  for (const double index : told->numbers) {
    if (points == 0 || !is_whole(index, 0, static_cast<double>(points - 1)))
      told->place.fail(fmt::format("{} in indices", index), fmt::format("expected one of {} points, from 0", points));
    made.push_back(static_cast<std::size_t>(index));
  }
  return made;
}

ExactWay way_between(const glm::dvec3& a, const glm::dvec3& b) {
  return {Dyadic(b.x) - Dyadic(a.x), Dyadic(b.y) - Dyadic(a.y), Dyadic(b.z) - Dyadic(a.z)};
}
Dyadic dot_of(const ExactWay& a, const ExactWay& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
ExactWay cross_of(const ExactWay& a, const ExactWay& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Whether four points, one after another, go round a convex region of a plane: a bilinear patch between them is that
/// region then, and elsewhere it is curved or overlaps itself. All turns have exactly one direction.
bool is_convex(const std::array<glm::dvec3, 4>& ring) {
  std::array<ExactWay, 4> turns;
  for (std::size_t i = 0; i < 4; ++i) {
    const ExactWay in = way_between(ring[i], ring[(i + 1) % 4]),
                   out = way_between(ring[(i + 1) % 4], ring[(i + 2) % 4]);
    turns[i] = cross_of(in, out);
  }
  const Dyadic height = dot_of(turns[0], way_between(ring[1], ring[3]));
  return number::sign(height) == 0 &&
         std::ranges::all_of(turns, [&](const ExactWay& turn) { return number::sign(dot_of(turns[0], turn)) > 0; });
}

}  // namespace

std::optional<SimpleSurface> PbrtShapes::read(const PbrtPlace& at, const std::string& type,
                                              const PbrtParameters& parameters) {
  if (type == "sphere") return sphere(parameters);
  if (type == "cylinder") return cylinder(parameters);
  if (type == "cone") return cone(parameters);
  if (type == "disk") return disk(parameters);
  if (type == "trianglemesh") return triangles(at, parameters);
  if (type == "bilinearmesh") return patches(at, parameters);
  if (type == "plymesh") return file(at, parameters);
  return leave_out(type);
}

std::nullopt_t PbrtShapes::leave_out(const std::string& what) {
  ++left_out_[what];
  return std::nullopt;
}

std::optional<SimpleSurface> PbrtShapes::sphere(const PbrtParameters& parameters) {
  const double radius = parameters.number("radius", 1);
  const bool is_whole = goes_round(parameters) && parameters.number("zmin", -radius) <= -radius &&
                        parameters.number("zmax", radius) >= radius;
  if (!is_whole) return leave_out("sphere in part");
  return scene::Sphere{glm::dvec3(0), radius};
}

std::optional<SimpleSurface> PbrtShapes::cylinder(const PbrtParameters& parameters) {
  if (!goes_round(parameters)) return leave_out("cylinder in part");
  const double low = parameters.number("zmin", -1), high = parameters.number("zmax", 1);
  return OpenCylinder{{glm::dvec3(0, 0, low), glm::dvec3(0, 0, high)}, parameters.number("radius", 1)};
}

std::optional<SimpleSurface> PbrtShapes::cone(const PbrtParameters& parameters) {
  if (!goes_round(parameters)) return leave_out("cone in part");
  const glm::dvec3 apex(0, 0, parameters.number("height", 1));
  return OpenCylinder{{glm::dvec3(0), apex}, parameters.number("radius", 1), true};
}

std::optional<SimpleSurface> PbrtShapes::disk(const PbrtParameters& parameters) {
  if (!goes_round(parameters)) return leave_out("disk in part");
  if (parameters.number("innerradius", 0) != 0) return leave_out("disk with a hole");
  return scene::Disc{{0, 0, parameters.number("height", 0)}, parameters.number("radius", 1), {0, 0, 1}};
}

std::optional<SimpleSurface> PbrtShapes::triangles(const PbrtPlace& at, const PbrtParameters& parameters) {
  const std::vector<glm::dvec3> points = points_of(at, parameters, "P");
  const std::vector<std::size_t> corners = corners_of_faces(at, parameters, points.size(), 3);
  std::vector<glm::dvec3> normals;
  if (const PbrtParameter* const told = parameters.find("N")) {
    normals = points_of(at, parameters, "N");
    if (normals.size() != points.size())
      told->place.fail(fmt::format("{} normals", normals.size()),
                       fmt::format("expected one for each of {} points", points.size()));
  }
  auto made = std::make_shared<std::vector<MeshTriangle>>();
  for (std::size_t i = 0; i < corners.size(); i += 3) {
    const std::array<std::size_t, 3> face{corners[i], corners[i + 1], corners[i + 2]};
    MeshTriangle& one = made->emplace_back();
    one.triangle = {{points[face[0]], points[face[1]], points[face[2]]}};
    if (!normals.empty()) one.normals = scene::VertexNormals{normals[face[0]], normals[face[1]], normals[face[2]]};
  }
  return MeshTriangles(std::move(made));
}

/// Flat and convex patches are two triangles each; others are left out.
std::optional<SimpleSurface> PbrtShapes::patches(const PbrtPlace& at, const PbrtParameters& parameters) {
  const std::vector<glm::dvec3> points = points_of(at, parameters, "P");
  const std::vector<std::size_t> corners = corners_of_faces(at, parameters, points.size(), 4);
  auto made = std::make_shared<std::vector<MeshTriangle>>();
  for (std::size_t i = 0; i < corners.size(); i += 4) {
    // A patch has its corners in rows: 0 1, 2 3.
    const std::array<glm::dvec3, 4> ring{points[corners[i]], points[corners[i + 1]], points[corners[i + 3]],
                                         points[corners[i + 2]]};
    if (!is_convex(ring)) {
      leave_out("bilinear patch that is not flat and convex");
      continue;
    }
    made->push_back({{{ring[0], ring[1], ring[2]}}});
    made->push_back({{{ring[0], ring[2], ring[3]}}});
  }
  return MeshTriangles(std::move(made));
}

std::optional<SimpleSurface> PbrtShapes::file(const PbrtPlace& at, const PbrtParameters& parameters) {
  const std::string name = parameters.word("filename", "");
  if (name.empty()) at.fail("a plymesh without filename", "expected the name of a file");
  if (name.ends_with(".gz")) return leave_out("plymesh of a packed file");
  const std::string path = words_.path(parameters.find("filename")->place, name);
  if (!ends_in(path, ".ply"))
    at.fail(fmt::format("{} in plymesh", text::shown(name)), "expected a name that ends in .ply");
  return files_.read(path, true);
}

void PbrtShapes::name_losses(std::vector<std::string>& lost) const {
  files_.name_losses(lost);
  for (const auto& [what, count] : left_out_)
    add_loss(lost, count, fmt::format("shape {}", text::shown(what)), fmt::format("shapes {}", text::shown(what)),
             "left out: a scene has none");
}

}  // namespace durero::io
