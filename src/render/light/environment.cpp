#include "durero/render/light/environment.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>
#include <stdexcept>

#include "durero/render/light/directions.hpp"
#include "durero/render/texture/texture.hpp"
#include "durero/scene/stage.hpp"

namespace durero::render {
namespace {

using scene::Environment;
using scene::Surroundings;
using std::numbers::pi;

/// The camera of a face of the box: the direction of its view, and its right and upper sides.
struct Face {
  glm::dvec3 forward, right, up;
};
const std::array<Face, 6> faces{{{{1, 0, 0}, {0, 0, 1}, {0, 1, 0}},
                                 {{-1, 0, 0}, {0, 0, -1}, {0, 1, 0}},
                                 {{0, 1, 0}, {1, 0, 0}, {0, 0, 1}},
                                 {{0, -1, 0}, {1, 0, 0}, {0, 0, -1}},
                                 {{0, 0, 1}, {-1, 0, 0}, {0, 1, 0}},
                                 {{0, 0, -1}, {1, 0, 0}, {0, 1, 0}}}};

std::size_t face_of(const glm::dvec3& d) {
  int axis = 0;
  for (int i = 1; i < 3; ++i)
    if (std::abs(d[i]) > std::abs(d[axis])) axis = i;
  return static_cast<std::size_t>(2 * axis + (d[axis] < 0 ? 1 : 0));
}

PictureSpot spot_on_box(const glm::dvec3& d) {
  const std::size_t face = face_of(d);
  const Face& f = faces[face];
  const double depth = glm::dot(d, f.forward);
  return {face, {0.5 + 0.5 * glm::dot(d, f.right) / depth, 0.5 + 0.5 * glm::dot(d, f.up) / depth}};
}

PictureSpot spot_on_ball(const glm::dvec3& d) {
  const glm::dvec3 between = d + glm::dvec3(0, 0, 1);  // as far from d as from +z
  if (between == glm::dvec3(0)) return {0, {1, 0.5}};
  const glm::dvec3 n = unit(between);
  return {0, {0.5 + 0.5 * n.x, 0.5 + 0.5 * n.y}};
}

glm::dvec3 direction_on_ball(const glm::dvec2& at) {
  const double x = 2 * at.x - 1, y = 2 * at.y - 1, square = x * x + y * y;
  if (square >= 1) return {0, 0, -1};
  const glm::dvec3 n(x, y, std::sqrt(1 - square));
  return 2 * n.z * n - glm::dvec3(0, 0, 1);
}

const scene::TexelImage& picture_of(const Environment& environment, std::size_t i) {
  if (!environment.pictures.at(i).levels) throw std::domain_error("the pictures of the scene have not been read");
  return environment.pictures[i].levels->front();
}

/// The continuation beyond the edges: a panorama ends where it begins, and no other picture goes on.
WrapModes beyond(Surroundings kind) {
  using enum scene::Edges;
  return kind == Surroundings::equirectangular ? WrapModes{repeat, clamp} : WrapModes{clamp, clamp};
}

}  // namespace

PictureSpot spot_of(Surroundings kind, const glm::dvec3& direction) {
  const glm::dvec3 d = unit(direction);
  switch (kind) {
    case Surroundings::box:
      return spot_on_box(d);
    case Surroundings::spherical:
      return spot_on_ball(d);
    case Surroundings::equirectangular:
      return {0, {0.5 + std::atan2(d.x, -d.z) / (2 * pi), 0.5 + std::atan2(d.y, std::hypot(d.x, d.z)) / pi}};
    case Surroundings::gradient:
      break;
  }
  throw std::domain_error("a gradient has no picture");
}

glm::dvec3 direction_of(Surroundings kind, const PictureSpot& spot) {
  switch (kind) {
    case Surroundings::box: {
      const Face& f = faces.at(spot.picture);
      return unit(f.forward + (2 * spot.at.x - 1) * f.right + (2 * spot.at.y - 1) * f.up);
    }
    case Surroundings::spherical:
      return direction_on_ball(spot.at);
    case Surroundings::equirectangular: {
      const double longitude = (2 * spot.at.x - 1) * pi, latitude = (spot.at.y - 0.5) * pi;
      return {std::cos(latitude) * std::sin(longitude), std::sin(latitude), -std::cos(latitude) * std::cos(longitude)};
    }
    case Surroundings::gradient:
      break;
  }
  throw std::domain_error("a gradient has no picture");
}

glm::dvec3 environment_at(const Environment& environment, const glm::dvec3& direction) {
  if (environment.kind == Surroundings::gradient) {
    const double share = 0.5 + 0.5 * unit(direction).y;
    return environment.colors[0] * (1 - share) + environment.colors[1] * share;
  }
  const PictureSpot spot = spot_of(environment.kind, direction);
  return linear_texels(picture_of(environment, spot.picture), spot.at, beyond(environment.kind));
}

glm::dvec3 most_of(const Environment& environment) {
  if (environment.kind == Surroundings::gradient) return glm::max(environment.colors[0], environment.colors[1]);
  return glm::dvec3(1);  // no texel is brighter, whichever it is
}

}  // namespace durero::render
