#include "pov_patch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

namespace durero::io {
namespace {

using Patch = decltype(PovPatch::points);

/// How a text divides a patch.
struct PatchSteps {
  double flatness = 0;
  int u = 0, v = 0;
};

/// The sum of both steps, at most: each halving doubles the triangles.
constexpr int most_patch_steps = 20;

Patch transposed(const Patch& p) {
  Patch made;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t k = 0; k < 4; ++k) made.at(i).at(k) = p.at(k).at(i);
  return made;
}

/// Both halves of a patch along its second index, by de Casteljau's means.
std::array<Patch, 2> halves(const Patch& p) {
  std::array<Patch, 2> made;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto& [a, b, c, d] = p.at(i);
    const glm::dvec3 ab = (a + b) / 2.0, bc = (b + c) / 2.0, cd = (c + d) / 2.0;
    const glm::dvec3 left = (ab + bc) / 2.0, right = (bc + cd) / 2.0, middle = (left + right) / 2.0;
    made[0].at(i) = {a, ab, left, middle};
    made[1].at(i) = {middle, right, cd, d};
  }
  return made;
}

/// Points that POV-Ray takes for one are nearer to each other than this.
constexpr double one_point = 1e-10;

bool is_one_point(const glm::dvec3& a, const glm::dvec3& b) { return glm::length(a - b) < one_point; }

/// POV-Ray's measure of a patch: how far its points are from the plane of three corners, at most; nothing where these
/// give no plane. Such a patch is flat.
std::optional<double> unevenness(const Patch& p) {
  const glm::dvec3& first = p[0][0];
  const bool is_pointed = is_one_point(first, p[0][3]);
  const glm::dvec3 &second = is_pointed ? p[3][3] : p[0][3],
                   &third = !is_pointed && is_one_point(first, p[3][0]) ? p[3][3] : p[3][0];
  if (is_one_point(first, second) || is_one_point(first, third) || is_one_point(second, third)) return std::nullopt;
  const glm::dvec3 across = glm::cross(first - second, third - second);
  const double length = glm::length(across);
  if (length < one_point) return std::nullopt;
  double greatest = 0;
  for (const auto& row : p)
    for (const glm::dvec3& point : row)
      greatest = std::max(greatest, std::abs(glm::dot(across / length, point - first)));
  return greatest;
}

/// The normal at a corner; null where the sides there give none.
glm::dvec3 normal_at(const Patch& p, bool at_u, bool at_v) {
  const std::size_t i = at_u ? 3 : 0, k = at_v ? 3 : 0, beside_i = at_u ? 2 : 1, beside_k = at_v ? 2 : 1;
  const glm::dvec3 along_u = p.at(beside_i).at(k) - p.at(i).at(k), along_v = p.at(i).at(beside_k) - p.at(i).at(k);
  return (at_u == at_v ? 1.0 : -1.0) * glm::cross(along_u, along_v);
}

/// Adds both triangles of the corners of a patch.
void add_triangles(const Patch& p, std::vector<PovShape>& into) {
  struct PatchCorner {
    glm::dvec3 at, normal;
  };
  const PatchCorner a{p[0][0], normal_at(p, false, false)}, b{p[0][3], normal_at(p, false, true)},
      c{p[3][3], normal_at(p, true, true)}, d{p[3][0], normal_at(p, true, false)};
  for (const auto& [one, two, three] : {std::array{a, b, c}, std::array{a, c, d}}) {
    if (one.at == two.at || two.at == three.at || three.at == one.at) continue;
    PovShape shape{scene::Triangle{{one.at, two.at, three.at}}};
    const scene::VertexNormals normals{one.normal, two.normal, three.normal};
    if (scene::have_directions(normals)) shape.normals = normals;
    into.push_back(std::move(shape));
  }
}

void divide(const Patch& p, const PatchSteps& steps, std::vector<PovShape>& into) {
  const bool is_flat = unevenness(p).value_or(-1) < steps.flatness;
  if (is_flat || (steps.u == 0 && steps.v == 0)) return add_triangles(p, into);
  if (steps.u > 0) {
    for (const Patch& half : halves(transposed(p))) {
      const Patch whole = transposed(half);
      if (steps.v == 0) {
        divide(whole, {steps.flatness, steps.u - 1, 0}, into);
        continue;
      }
      for (const Patch& quarter : halves(whole)) divide(quarter, {steps.flatness, steps.u - 1, steps.v - 1}, into);
    }
    return;
  }
  for (const Patch& half : halves(p)) divide(half, {steps.flatness, 0, steps.v - 1}, into);
}

int patch_steps(PovWords& in, std::string_view word) {
  const std::size_t at = in.offset();
  const double steps = in.number(word);
  if (!(steps >= 0 && steps <= most_patch_steps && steps == std::floor(steps)))
    in.fail(at, fmt::format("{} {}", word, steps),
            fmt::format("expected a whole number from 0 to {}", most_patch_steps));
  return static_cast<int>(steps);
}

}  // namespace

std::optional<PovPatch> read_pov_patch(PovWords& in) {
  PovPatch patch;
  while (true) {
    if (in.take("type"))
      in.number("type");  // of how much POV-Ray keeps in memory
    else if (in.take("flatness"))
      patch.flatness = in.number("flatness");
    else if (in.take("u_steps"))
      patch.u_steps = patch_steps(in, "u_steps");
    else if (in.take("v_steps"))
      patch.v_steps = patch_steps(in, "v_steps");
    else if (!in.take("accuracy"))
      break;
    in.comma();
  }
  for (auto& row : patch.points)
    for (glm::dvec3& point : row) {
      in.comma();
      point = in.triple("bicubic_patch");
    }
  return patch.u_steps + patch.v_steps > most_patch_steps ? std::nullopt : std::optional(patch);
}

std::vector<PovShape> triangles_of(const PovPatch& patch, const PovTransform& by) {
  Patch moved = patch.points;
  if (!by.is_identity())
    for (auto& row : moved)
      for (glm::dvec3& point : row) point = by.point(point);
  std::vector<PovShape> triangles;
  divide(moved, {patch.flatness, patch.u_steps, patch.v_steps}, triangles);
  return triangles;
}

}  // namespace durero::io
